"""One writer of a recording, however its name is spelt; readers are kept from nothing."""

import os
from pathlib import Path

import pytest

from kitemj.errors import InputError
from kitemj.flight.live import Command
from kitemj.recording.file import read_recording
from tests.recording.flights import SPORT, live_flight


@pytest.mark.parametrize("spelt", ["same", "relative", "symbolic link", "hard link"])
def test_the_second_writer_is_told_so_and_harms_nothing(tmp_path, monkeypatch, spelt):
    path = other = tmp_path / "kite.arrows"
    with live_flight(SPORT, reference=None, record=path) as flight:
        flight.tick(Command(0.5))
        before = path.read_bytes()
        if spelt == "relative":
            monkeypatch.chdir(tmp_path)
            other = Path("..") / tmp_path.name / "kite.arrows"
        elif spelt != "same":
            other = tmp_path / "other.arrows"
            make = other.symlink_to if spelt == "symbolic link" else other.hardlink_to
            make(path)
        with pytest.raises(InputError, match="another program is recording into"):
            live_flight(SPORT, record=other, overwrite=True)
        assert path.read_bytes() == before
    recording = read_recording(path)
    assert recording.columns["tick"].tolist() == [0, 1]
    assert recording.ending == "closed by its program"
    live_flight(SPORT, record=other, overwrite=True).close()  # it ended with the first flight
    assert len(read_recording(path)) == 1


def test_only_a_file_can_be_recorded_into(tmp_path):
    pipe = tmp_path / "pipe.arrows"
    os.mkfifo(pipe)
    for path in (pipe, Path(os.devnull)):
        with pytest.raises(InputError):
            live_flight(SPORT, record=path, overwrite=True)
        assert not path.is_file()
