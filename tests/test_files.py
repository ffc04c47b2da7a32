"""Files appear whole or not at all, in place of no other, whatever stands at their name."""

import errno
import os
import resource
import stat
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from kitemj import files
from kitemj.errors import InputError
from kitemj.files import NewFile, check_new, new_file

MINE = "a person's own"


def write(path: Path, text: str = "new", overwrite: bool = False) -> None:
    with new_file(path, overwrite) as part:
        part.write_text(text)


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


@contextmanager
def disk_of(size: int) -> Iterator[None]:
    """Meanwhile no file grows beyond `size` bytes: what writes more is refused, EFBIG."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def test_a_file_called_part_is_a_persons_own(tmp_path: Path) -> None:
    (tmp_path / "a.csv.part").write_text(MINE)
    (tmp_path / "mine").write_text(MINE)
    (tmp_path / "b.csv.part").symlink_to("mine")
    for name in ("a.csv", "b.csv"):
        write(tmp_path / name)
        assert (tmp_path / name).read_text() == "new"
    assert (tmp_path / "a.csv.part").read_text() == MINE
    assert (tmp_path / "mine").read_text() == MINE


def test_a_link_stays_and_what_it_leads_to_is_replaced(tmp_path: Path) -> None:
    target, link = tmp_path / "target", tmp_path / "link"
    target.write_text(MINE)
    target.chmod(0o604)
    link.symlink_to("target")
    with pytest.raises(InputError, match="link exists"):
        write(link)
    write(link, overwrite=True)
    assert link.is_symlink()
    assert target.read_text() == "new"
    assert stat.S_IMODE(target.stat().st_mode) == 0o604


def test_a_link_that_leads_nowhere_is_not_followed_unasked(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to("nothing")
    (tmp_path / "ring").symlink_to("ring")
    for name in ("link", "ring"):
        with pytest.raises(InputError, match="exists"):
            write(tmp_path / name)
    with pytest.raises(InputError):
        write(tmp_path / "ring", overwrite=True)
    assert names(tmp_path) == ["link", "ring"]


def test_a_stream_is_written_into_and_stays(tmp_path: Path) -> None:
    write(Path("/dev/null"), overwrite=True)
    assert stat.S_ISCHR(Path("/dev/null").stat().st_mode)
    pipe, taken = tmp_path / "pipe", []
    os.mkfifo(pipe)
    reader = threading.Thread(target=lambda: taken.append(pipe.read_text()))
    reader.start()
    write(pipe)
    reader.join()
    assert taken == ["new"]
    assert pipe.is_fifo()


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such pipes")
def test_a_pipe_that_nobody_reads_is_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(files, "PATIENCE", 0.1)
    os.mkfifo(pipe := tmp_path / "pipe")
    with pytest.raises(InputError, match="pipe that nobody reads"), new_file(pipe) as part:
        part.write_text("x")


def test_standard_output_goes_on_behind_what_is_written_into_it(tmp_path: Path) -> None:
    script = (
        "from pathlib import Path; from kitemj.files import new_file\n"
        "print('before')\n"
        "with new_file(Path('/dev/stdout')) as part: part.write_text('new ')\n"
        "print('after')"
    )
    with (tmp_path / "out").open("wb") as out:
        subprocess.run([sys.executable, "-c", script], stdout=out, check=True)
    assert (tmp_path / "out").read_text() == "before\nnew after\n"


def test_a_socket_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import socket

    monkeypatch.chdir(tmp_path)  # names of sockets must be short
    with socket.socket(socket.AF_UNIX) as server:
        server.bind("s")
        with pytest.raises(InputError, match="s is not a file"):
            check_new(Path("s"), overwrite=True)


def test_what_appears_meanwhile_is_not_replaced(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    new = NewFile(path)
    path.write_text(MINE)
    with pytest.raises(InputError, match="exists"):
        new.keep()
    new.discard()
    assert path.read_text() == MINE
    assert names(tmp_path) == ["a.csv"]


def test_permissions_are_the_umasks_or_those_of_the_file_before(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        write(tmp_path / "a")
        assert stat.S_IMODE((tmp_path / "a").stat().st_mode) == 0o640
        (tmp_path / "a").chmod(0o600)
        write(tmp_path / "a", overwrite=True)
        assert stat.S_IMODE((tmp_path / "a").stat().st_mode) == 0o600
    finally:
        os.umask(before)


@pytest.mark.parametrize("size", [0, 1, 99])
def test_a_disk_that_ends_leaves_nothing_and_the_error_names_the_file(
    tmp_path: Path, size: int
) -> None:
    with disk_of(size), pytest.raises(OSError, match="nothing of it is kept") as refused:
        write(tmp_path / "a.csv", "x" * 100)
    assert refused.value.errno == errno.EFBIG
    assert refused.value.filename == str(tmp_path / "a.csv")
    assert names(tmp_path) == []


@pytest.mark.parametrize("call", ["fsync", "replace"])
@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EIO])
def test_what_the_disk_says_at_the_end_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: str, number: int
) -> None:
    def refuse(*arguments: object, **options: object) -> None:
        raise OSError(number, os.strerror(number))

    path = tmp_path / "a.csv"
    path.write_text(MINE)
    monkeypatch.setattr(os, call, refuse)
    with pytest.raises(OSError, match="nothing of it is kept") as refused:
        write(path, overwrite=True)
    monkeypatch.undo()
    assert (refused.value.errno, refused.value.filename) == (number, str(path))
    assert path.read_text() == MINE
    assert names(tmp_path) == ["a.csv"]


def an_mp4(path: Path) -> None:
    import numpy as np

    from kitemj.cockpit.film import Film

    dice = np.random.default_rng(1)
    with Film(path.with_suffix(".mp4"), 64, 48) as film:
        for _ in range(40):
            film.add(dice.integers(0, 255, (48, 64, 3), dtype=np.uint8))


def figures(path: Path) -> None:
    from matplotlib.figure import Figure

    from kitemj.plots.figure_output import save_figures

    figure = Figure()
    figure.subplots().plot([0, 1])
    save_figures({"a": figure}, path.with_suffix(".pdf"))
    save_figures({"a": figure, "b": figure}, path.with_suffix(".svg"))


@pytest.mark.parametrize("make", [an_mp4, figures])
@pytest.mark.parametrize("size", [0, 10, 3000])
def test_films_and_figures_say_that_the_disk_is_full(
    tmp_path: Path, make: Callable[[Path], None], size: int
) -> None:
    with disk_of(size), pytest.raises(OSError, match="nothing of it is kept") as refused:
        make(tmp_path / "a")
    assert refused.value.errno == errno.EFBIG
    assert names(tmp_path) == []


def test_a_new_file_that_is_given_up_leaves_nothing(tmp_path: Path) -> None:
    new = NewFile(tmp_path / "a.csv")
    new.part.write_text("half")
    new.discard()
    new.discard()
    assert names(tmp_path) == []
