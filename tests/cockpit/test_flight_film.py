"""The film of a flight: painted from its recording when it is over, however fast that goes."""

import os
import re
import signal
import tempfile
import time
from pathlib import Path

import pytest

from kitemj.cli import main
from kitemj.cockpit.filming import FilmStyle
from kitemj.cockpit.flight_film import film_of_flight
from kitemj.cockpit.parallel_painting import Painter
from kitemj.cockpit.screens import FRAME_RATE, Screen
from kitemj.recording.file import read_recording
from tests.cockpit.test_film import frames_of
from tests.recording.flights import recorded

SHORT = ["fly", "--headless", "--size", "320x180", "--film", "a.mp4"]
TICK = 0.01


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The present folder; the one for temporary files is in it."""
    (tmp_path / "temporary").mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def frames_for(ticks: int) -> int:
    """One at the start, then 30 for each second."""
    return int(ticks * TICK * FRAME_RATE + 1e-6) + 1


def files(folder: Path) -> set[str]:
    return {path.name for path in folder.rglob("*") if path.is_file()}


def painting(monkeypatch, before):
    """Has `before` done, with the number of frames so far, before each frame is painted."""
    paint, painted = Painter.paint, []

    def painting_late(self, shots):
        before(len(painted))
        painted.append(shots[0].motion)
        return paint(self, shots)

    monkeypatch.setattr(Painter, "paint", painting_late)
    return painted


def interrupt():
    os.kill(os.getpid(), signal.SIGINT)


def test_a_slow_painter_leaves_out_no_frame_and_no_tick(folder, monkeypatch, capsys):
    """20 frames a second, at most, are painted of a film that shows 30."""
    motions = painting(monkeypatch, lambda count: time.sleep(0.05))
    assert main([*SHORT, "--duration", "0.4", "--no-record"]) == 0
    said = capsys.readouterr().out
    ticks = int(re.search("ticks +([0-9]+) of", said)[1])
    assert len(frames_of(folder / "a.mp4")) == len(motions) == frames_for(ticks) > 2
    assert [m.t for m in motions] == pytest.approx([i / FRAME_RATE for i in range(len(motions))])
    assert files(folder) == {"a.mp4"}, "the temporary recording is gone"
    assert "recording    none" in said
    assert "frames, painted in" in said
    assert "a second" not in said, "no frames are told of a flight that nobody saw"


@pytest.mark.usefixtures("obeyed")
@pytest.mark.skipif(os.name == "nt", reason="Windows has no such signals")
def test_ctrl_c_in_flight_leaves_a_film_of_what_was_flown(folder, monkeypatch):
    motions, polled = painting(monkeypatch, lambda count: None), []
    monkeypatch.setattr(Screen, "poll", lambda screen: polled.append(0) or late(len(polled)))
    late = lambda count: interrupt() if count == 12 else None  # noqa: E731
    assert main([*SHORT, "--duration", "60", "--record", "a.arrows"]) == 130
    recording = read_recording(folder / "a.arrows")
    assert recording.ending == "interrupted"
    frames = frames_of(folder / "a.mp4")
    assert len(frames) == frames_for(len(recording) - 1) > 5
    assert motions[-1].t == pytest.approx((len(recording) - 1) * TICK, abs=1 / FRAME_RATE)


@pytest.mark.parametrize("painted", [4, 0])
def test_ctrl_c_in_painting_leaves_the_frames_until_then(folder, monkeypatch, painted):
    def interrupted(count):
        if count == painted:
            raise KeyboardInterrupt

    painting(monkeypatch, interrupted)
    recording = recorded(folder / "a.arrows", 30)
    told = film_of_flight(recording, folder / "a.mp4", FilmStyle((320, 180)))
    if painted:
        assert len(frames_of(folder / "a.mp4")) == painted
        assert f"a.mp4 has the first {painted} of 10 frames" in told
    else:
        assert files(folder) == {"a.arrows"}
        assert f"{recording} can still be filmed" in told


def test_a_flight_in_a_window_is_filmed_when_asked(folder, monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    words = ["fly", "--size", "320x180", "--no-lessons", "--duration", "0.3", "--film", "a.mp4"]
    assert main([*words, "--record", "a.arrows"]) == 0
    ticks = len(read_recording(folder / "a.arrows")) - 1
    assert len(frames_of(folder / "a.mp4")) == frames_for(ticks)
    assert main([*words, "--no-record"]) == 2, "what exists is told before the flight"
