"""What is remembered of the lessons: kept, and never a reason not to fly."""

import os
from pathlib import Path

import pytest

from kitemj.pilots.progress import progress_path, read_progress, write_progress


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "new" / "lessons.json"


def test_what_is_written_is_read(path: Path) -> None:
    assert read_progress(path) == (frozenset(), "")
    assert write_progress({"top", "eight"}, path) == ""
    assert read_progress(path) == ({"top", "eight"}, "")
    assert write_progress({"land"}, path) == ""
    assert read_progress(path).passed == {"land"}
    assert [file.name for file in path.parent.iterdir()] == ["lessons.json"]


@pytest.mark.parametrize(
    "damage",
    [b"", b"{", b"\xff\xfe", b"[]", b"{}", b"3", b'{"passed": 3}', b'{"passed": [1]}'],
)
def test_a_damaged_file_is_told_of_and_replaced(path: Path, damage: bytes) -> None:
    path.parent.mkdir()
    path.write_bytes(damage)
    passed, message = read_progress(path)
    assert passed == frozenset()
    assert message == f"{path} is damaged: the lessons begin anew"
    assert write_progress({"top"}, path) == ""
    assert read_progress(path) == ({"top"}, "")


def test_a_file_that_cannot_be_read_is_told_of(path: Path) -> None:
    path.mkdir(parents=True)
    assert read_progress(path).passed == frozenset()
    assert "cannot be read" in read_progress(path).message


def test_a_file_that_cannot_be_written_is_told_of_and_nothing_is_left(tmp_path: Path) -> None:
    blocked = tmp_path / "a file"
    blocked.touch()
    message = write_progress({"top"}, blocked / "lessons.json")
    assert "cannot be written" in message
    folder = tmp_path / "lessons.json"
    (folder / "not empty").mkdir(parents=True)
    assert "cannot be written" in write_progress({"top"}, folder)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["a file", "lessons.json"]


@pytest.mark.skipif(os.name != "posix" or os.uname().sysname != "Linux", reason="XDG is Linux's")
def test_the_file_is_in_the_users_state_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    assert progress_path() == tmp_path / "kitemj" / "lessons.json"
    assert write_progress({"top"}) == ""
    assert read_progress().passed == {"top"}
