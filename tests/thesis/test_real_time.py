"""Real time: what is measured is what happened; what is said of it follows from the numbers."""

import subprocess
import sys
from typing import ClassVar

import numpy as np
import pytest

from kitemj.errors import NoGraphics
from kitemj.flight.live import TICK
from kitemj.thesis import real_time
from kitemj.thesis.answers import not_shown
from kitemj.thesis.real_time import ANSWERS, CASES, Case, Run, flown, section, the_flight
from kitemj.thesis.section import Verdict

SHORT = 0.2  # s
PAINTING = Case("display", "a picture every 0.05 s", 0.05)
MOVING = Case("input", "stick moved every 1 ms", None, 0.001)


@pytest.fixture(scope="module")
def flight():
    return the_flight()


def run_of(late, case=MOVING, lost=0.0):
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


def test_every_tick_is_counted_and_the_stick_moves_while_it_flies(flight):
    run = flown(MOVING, SHORT, flight, None)
    assert len(run.late) == round(SHORT / TICK)
    assert run.frames == []
    assert run.late.min() > 0  # nothing is done before it is due
    assert run.moves > 1


def test_the_stick_goes_from_side_to_side(flight):
    class Still:
        sides: ClassVar[list[float]] = []
        alive = 7

        def is_alive(self):
            self.alive -= 1
            return self.alive > 0

        def __setattr__(self, name, value):
            if name == "command":
                self.sides.append(value.delta)
            super().__setattr__(name, value)

    pacer = Still()
    hand = real_time.Hand(pacer, 0.0)
    hand.run()
    assert pacer.sides == [1.0, -1.0] * 3
    assert hand.moves == 6


def test_frames_are_painted_at_their_interval(flight):
    class Picture:
        seen: ClassVar[list[float]] = []

        def paint(self, motion, ghost, readings):
            self.seen.append(motion.t)

    picture = Picture()
    run = flown(PAINTING, SHORT, flight, lambda: picture)
    assert len(run.frames) == len(picture.seen) >= 1
    starts = np.array([frame.t for frame in run.frames])
    assert (np.diff(starts) > 0.9 * PAINTING.frames).all()  # the clocks of sleep and measure differ


def test_the_file_of_the_cold_start_loads_nothing_that_paints():
    code = (
        "import sys, kitemj.thesis.real_time as r; r.the_flight();"
        "print([m for m in sys.modules if m.startswith(('OpenGL', 'mujoco.egl'))"
        " or m == 'kitemj.cockpit.picture'])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_each_figure_of_the_thesis_is_one_flight():
    figures = sorted(case.thesis[0] for case in CASES if case.thesis)
    assert figures == [f"Figure {n}" for n in range(38, 47)]
    assert [a.item for a in ANSWERS] == ["Figure 25", *figures]
    assert len({case.name for case in CASES}) == len(CASES)


def few(monkeypatch):
    kept = ("no picture", "a picture every 0.5 s", "cold start", "stick moved every 0.1 s")
    monkeypatch.setattr(real_time, "SECONDS", SHORT)
    monkeypatch.setattr(real_time, "CASES", [c for c in CASES if c.name in kept])


def test_the_section_says_what_was_measured(tmp_path, monkeypatch):
    few(monkeypatch)
    try:
        real_time._renderer()
    except NoGraphics as reason:
        pytest.skip(str(reason))
    found = section(tmp_path)
    assert found.answers == ANSWERS
    assert not not_shown(found)
    assert not found.tables  # all of it is timed
    runs = found.timed[0].table.records()
    assert [row["flight"] for row in runs] == [case.name for case in real_time.CASES]
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
    assert not not_shown(found)
    assert "install what is missing" in found.here[0]
    flights = [row["flight"] for row in found.timed[0].table.records()]
    assert flights == ["no picture", "stick moved every 0.1 s"]
    without = [a.item for a in found.answers if a.verdict is Verdict.NOT_APPLICABLE]
    assert set(without) == real_time.NEED_PICTURE
