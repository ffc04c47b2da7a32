"""How the program ends, whatever was not foreseen, and whatever its streams are."""

import errno
import io
import os
import sys
import threading

import pytest

from kitemj.cli import main
from kitemj.commands import reach
from kitemj.console import printable


@pytest.fixture
def stdout(monkeypatch):
    """Makes standard output write to a file descriptor, in an encoding."""
    streams = []

    def replace(descriptor, encoding="utf-8"):
        streams.append(os.fdopen(descriptor, "w", encoding=encoding))
        monkeypatch.setattr(sys, "stdout", streams[-1])

    yield replace
    for stream in streams:
        stream.close()


@pytest.mark.parametrize("words", [["reach"], ["--help"], ["trim", "--help"], ["limits", "gust"]])
def test_a_reader_who_has_seen_enough_is_no_fault(words, stdout, capsys):
    reader, writer = os.pipe()
    os.close(reader)
    stdout(writer)
    wanted = 2 if words == ["limits", "gust"] else 0
    assert main(words) == wanted
    assert capsys.readouterr().err.count("\n") == (1 if wanted else 0)


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="a device of Linux")  # noqa: PTH110
@pytest.mark.parametrize("words", [["reach"], ["trim", "--help"]])
def test_a_full_disk_is_status_74(words, stdout, capsys):
    stdout(os.open("/dev/full", os.O_WRONLY))
    assert main(words) == 74
    assert (
        capsys.readouterr().err == "kitemj: cannot write standard output: No space left on device\n"
    )


@pytest.mark.parametrize("encoding", ["ascii", "cp1252", "koi8-r"])
def test_letters_that_an_encoding_lacks_are_spelt(encoding, stdout, tmp_path, capsys):
    path = tmp_path / "out"
    stdout(os.open(path, os.O_WRONLY | os.O_CREAT), encoding)
    assert main(["reach"]) == 0
    text = path.read_bytes().decode(encoding)
    assert "delta_max" in text if encoding == "ascii" else "_max" in text
    assert capsys.readouterr().err == ""


def test_spelling(monkeypatch):
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(io.BytesIO(), "ascii"))
    assert printable("T₊/T₋ α δ̇ µm Ω m² ½ 漢 \udcff") == "T+/T- alpha delta_dot um Omega m2 12 ? ?"


def _raise(error):
    def run(args):
        raise error

    return run


def test_what_was_not_foreseen_is_a_sentence_and_a_file(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setattr(reach, "run", _raise(KeyError("odd")))
    assert main(["reach", "sport"]) == 70
    [path] = tmp_path.iterdir()
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert str(path) in told
    text = path.read_text()
    assert all(each in text for each in ("KeyError: 'odd'", "['reach', 'sport']", "Python 3"))


def test_a_fault_where_no_file_can_be_written_is_told_too(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "none"))
    monkeypatch.setattr(reach, "run", _raise(KeyError("odd")))
    assert main(["reach"]) == 70
    assert "could not be written" in capsys.readouterr().err


def test_a_fault_in_a_thread_is_a_sentence_too(monkeypatch, tmp_path, capsys):
    def run(args):
        thread = threading.Thread(target=_raise(KeyError("odd")), args=(args,))
        thread.start()
        thread.join()

    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setattr(reach, "run", run)
    assert main(["reach"]) == 0
    assert "Traceback" not in (told := capsys.readouterr().err)
    assert told.count("\n") == 1
    assert len([*tmp_path.iterdir()]) == 1


@pytest.mark.parametrize(
    ("error", "status", "says"),
    [
        (OSError(errno.ENOSPC, "No space", "a.csv"), 74, "cannot write a.csv: No space"),
        (OSError(errno.EIO, "Input/output error", "a.csv"), 74, "cannot write a.csv: Input"),
        (OSError(errno.EROFS, "Read-only", "a.csv"), 74, "cannot write a.csv: Read-only"),
        (PermissionError(errno.EACCES, "Permission denied", "a"), 2, "a: Permission denied"),
        (FileNotFoundError("models/kite.xml is missing"), 2, "models/kite.xml is missing"),
        (OSError(errno.ENAMETOOLONG, "File name too long", "n"), 2, "n: File name too long"),
        (MemoryError(), 70, "not enough memory: a flight takes"),
        (ValueError("engine error: Could not allocate memory"), 70, "not enough memory (engine"),
        (ImportError("x.so: failed to map segment from shared object"), 70, "not enough memory (x"),
        (OSError(errno.ENOMEM, "Cannot allocate memory", "x"), 70, "not enough memory ("),
        (ValueError("several\nlines " + "x" * 9999), 70, "several lines x"),
    ],
)
def test_refusals_of_the_system(error, status, says, monkeypatch, tmp_path, capsys):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setattr(reach, "run", _raise(error))
    assert main(["reach"]) == status
    told = capsys.readouterr().err
    assert says in told
    assert told.count("\n") == 1
    assert len(told) < 1100
