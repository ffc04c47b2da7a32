"""Real time: what is measured is what happened; what is said of it follows from the numbers."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from kitemj.errors import NoGraphics
from kitemj.flight.live import TICK
from kitemj.realtime.messages import TickNews
from thesis import real_time, real_time_flights
from thesis.answers import dangling
from thesis.observed_flight import FrameTime, ObservedFlight
from thesis.real_time import ANSWERS, section
from thesis.real_time_flights import CASES, Case, Run, measure
from thesis.section import Verdict

SHORT = 0.2  # s
STILL = Case("display", "no picture")


def run_of(late, case=STILL, lost=0.0):
    return Run(case, TICK * np.array(late), [], 0, lost, 0.0)


def test_a_tick_is_missed_when_it_is_done_a_tick_late():
    run = run_of([0.5, 1.5, 0.9, 3.0] + [0.1] * 396)
    assert run.missed.tolist()[:4] == [False, True, False, True]
    assert run.last_missed == pytest.approx(4 * TICK)
    assert "2 of 400, at worst 30.0 ms late" in str(run)


def test_real_time_is_kept_or_not():
    assert run_of([0.1] * 400).kept
    assert run_of([2.0] * 4 + [0.1] * 396).kept
    assert not run_of([2.0] * 5 + [0.1] * 395).kept
    assert not run_of([0.1] * 400, lost=0.3).kept
    assert run_of([0.1]).last_missed == 0.0


def test_what_was_watched_is_what_is_told(monkeypatch):
    ticks = [TickNews(0.0, 0.0, None, None, late, None, None, "", 0.0) for late in (0.001, 0.02)]
    frames = [FrameTime(0.1, 0.03)]
    asked = {}

    def observe(physics, count, open_picture=None, interval=None, mover=None):
        asked.update(count=count, open_picture=open_picture, interval=interval)
        return ObservedFlight(ticks, frames, 0.25)

    monkeypatch.setattr(real_time_flights, "observe", observe)
    case = Case("display", "a picture every 2 s", 2.0)
    run = measure(case, SHORT, None, lambda: None)
    assert (asked["count"], asked["interval"]) == (round(SHORT / TICK), 2.0)
    assert run.late.tolist() == [0.001, 0.02]
    assert (run.frames, run.lost, run.moves) == (frames, 0.25, 0)
    measure(case, SHORT, None, None)
    assert asked["open_picture"] is None


def test_the_file_of_the_cold_start_loads_nothing_that_paints():
    code = (
        "import sys, thesis.real_time_flights, kitemj.realtime.process;"
        "print([m for m in sys.modules if m.startswith(('OpenGL', 'mujoco.egl'))"
        " or m == 'kitemj.drawing.picture'])"
    )
    scripts = Path(__file__).parents[2] / "scripts"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=scripts, capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"


def test_each_figure_of_the_thesis_is_one_flight():
    figures = sorted(case.thesis[0] for case in CASES if case.thesis)
    assert figures == [f"Figure {n}" for n in range(38, 47)]
    assert [a.item for a in ANSWERS] == ["Figure 25", *figures]
    assert len({case.name for case in CASES}) == len(CASES)


def few(monkeypatch):
    kept = ("no picture", "a picture every 0.5 s", "cold start", "stick moved every 0.1 s")
    monkeypatch.setattr(real_time, "SECONDS", SHORT)
    monkeypatch.setattr(real_time_flights, "CASES", [c for c in CASES if c.name in kept])


def test_the_section_says_what_was_measured(tmp_path, monkeypatch):
    few(monkeypatch)
    try:
        real_time._renderer()
    except NoGraphics as reason:
        pytest.skip(str(reason))
    found = section(tmp_path)
    assert found.answers == ANSWERS
    assert not dangling(found)
    assert not found.tables  # all of it is timed
    runs = found.timed[0].table.records()
    assert [row["flight"] for row in runs] == [case.name for case in real_time_flights.CASES]
    told = " ".join(found.here)
    for row in runs:
        assert f"{row['flight']}: {row['missed']} of {row['ticks']}" in told
    late = found.timed[1].table
    assert len(late.rows) == round(SHORT / TICK)
    assert max(row[1] for row in late.rows) == runs[0]["late_worst_ms"]


def test_without_opengl_the_stick_is_still_measured(tmp_path, monkeypatch):
    def none():
        raise NoGraphics("cannot draw: install what is missing")

    few(monkeypatch)
    monkeypatch.setattr(real_time, "_renderer", none)
    found = section(tmp_path)
    assert not dangling(found)
    assert "install what is missing" in found.here[0]
    flights = [row["flight"] for row in found.timed[0].table.records()]
    assert flights == ["no picture", "stick moved every 0.1 s"]
    without = [a.item for a in found.answers if a.verdict is Verdict.NOT_APPLICABLE]
    assert set(without) == real_time.NEED_PICTURE
