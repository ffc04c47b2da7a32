"""An observed flight: from its start, every tick once, frames at their interval."""

from typing import ClassVar

import numpy as np
import pytest

from kitemj.controls.programmed import ProgrammedStick, Row
from kitemj.flight.live import TICK
from kitemj.flight.scenario import scenario_of
from thesis.observed_flight import StickMover, flight_process, observe

TICKS = 30
INTERVAL = 0.05
"""s; between the frames that are asked for."""


class Picture:
    """Remembers what it was told to paint."""

    def __init__(self):
        self.times = []

    def paint(self, motion, reference, readings):
        self.times.append(motion.t)


@pytest.fixture(scope="module")
def physics():
    with flight_process(scenario_of({"set": "thesis", "duration": 1.0}, "test")) as process:
        yield process


def times_of(seen):
    return [tick.result.motion.t for tick in seen.ticks]


def test_each_flight_begins_at_the_start_and_has_every_tick_once(physics):
    expected = TICK * np.arange(1, TICKS + 1)
    for _ in range(2):
        seen = observe(physics, TICKS)
        np.testing.assert_allclose(times_of(seen), expected, atol=1e-12)
        assert seen.frames == []
        assert all(tick.lateness > 0 for tick in seen.ticks)  # none is done before it is due
        assert {tick.command.delta for tick in seen.ticks} == {0.0}


def test_frames_keep_their_interval_and_the_picture_is_opened_in_flight(physics):
    opened, picture = [], Picture()

    def open_picture():
        opened.append(physics.result.motion.t)
        return picture

    seen = observe(physics, TICKS, open_picture, INTERVAL)
    assert len(opened) == 1
    assert opened[0] > 0  # in flight
    wall = seen.ticks[-1].done - seen.ticks[0].begun
    assert 1 <= len(seen.frames) == len(picture.times) <= wall / INTERVAL + 2
    assert all(frame.duration > 0 for frame in seen.frames)


def test_the_stick_is_read_before_each_frame(physics):
    stick = ProgrammedStick([Row(0.0, 1.0)], physics.parameters)
    seen = observe(physics, TICKS, Picture, 0.0, stick)
    assert abs(seen.ticks[-1].command.delta) == 1.0
    assert seen.ticks[-1].result.motion.control.delta != 0.0


def test_the_hand_moves_the_stick_while_it_is_flown(physics):
    mover = StickMover(physics, 0.03)
    seen = observe(physics, TICKS, mover=mover)
    assert mover.moves > 1
    assert not mover.is_alive()
    assert len({tick.command.delta for tick in seen.ticks}) > 1


def test_the_hand_goes_from_side_to_side():
    class Still:
        sides: ClassVar[list[float]] = []

        def ask(self, command):
            self.sides.append(command.delta)
            if len(self.sides) == 6:
                mover._over.set()

    still = Still()
    mover = StickMover(still, 0.0)
    mover.run()
    assert still.sides == [1.0, -1.0] * 3
    assert mover.moves == 6
