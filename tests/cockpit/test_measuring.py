"""What `kitemj realtime` counts; how fast a machine is cannot be tested, only measured."""

import numpy as np
import pygame
import pytest

from kitemj.cockpit.measuring import (
    PointerScreen,
    Step,
    SteppingStick,
    StickTimingProcess,
    TimedScreen,
)
from kitemj.cockpit.screens import Screen
from kitemj.drawing.instruments import Instruments
from kitemj.drawing.readings import Readings
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.realtime.messages import FRAME, TickNews, Timekeeping
from kitemj.realtime.process import FlightProcess
from kitemj.recording.live import FlightSetup

SCENARIO = scenario_of({"set": "sport", "duration": 60.0}, "test")
PARAMETERS = SCENARIO.parameters
SIZES = [(1280, 720), (640, 360)]


def frame_with(stick, size):
    """Instruments over grey, the knob's pointer where the stick is."""
    frame = np.full((size[1], size[0], 3), 128, np.uint8)
    surface = pygame.image.frombuffer(frame.data, size, "RGB")
    readings = Readings(delta_command=stick * PARAMETERS.stick.delta)
    motion = SteeredFlight(SCENARIO).result.motion
    Instruments(PARAMETERS, *size).paint(surface, motion, readings, "engineer", {"knob"})
    return frame


class Mute:
    """In the place of a flight's process."""

    memory = 0.0


@pytest.mark.parametrize("size", SIZES)
def test_a_move_of_the_stick_is_seen_in_the_frame_that_shows_it(size):
    stick = SteppingStick()
    stick.steps.append(Step(polled=0.0, side=1.0))
    screen = PointerScreen(Screen(stick), stick, Mute(), Instruments(PARAMETERS, *size))
    for deflection in (0.0, -0.2, -0.2, 0.2, 0.2):
        screen.show(frame_with(deflection, size), 0.0)
    step = stick.steps[0]
    assert step.seen
    assert step.frames == 4


def test_one_slow_second_is_not_hidden_by_the_others():
    stick = SteppingStick()
    screen = TimedScreen(Screen(stick), stick, Mute())
    seconds = (10, 30, 12, 30, 7)  # frames in each: loading, flying, slow, flying, cut off
    screen.times = [100.0 + k + i / n for k, n in enumerate(seconds) for i in range(n)]
    assert screen.slowest_rate == 12
    assert screen.median_rate == pytest.approx(30)


def news(begun, delta):
    command, result = Command(delta), SteeredFlight(SCENARIO).result
    return TickNews(begun, begun, command, result, 0.0, Timekeeping(), None, "", 0.0)


def test_only_ticks_that_began_after_the_move_are_counted(monkeypatch):
    heard = [news(1.0, -0.2), news(2.0, -0.2), news(3.0, 0.2), news(4.0, 0.2)]
    monkeypatch.setattr(FlightProcess, "__init__", lambda self, setup, launched=None: None)
    monkeypatch.setattr(FlightProcess, "update", lambda self: heard)
    stick = SteppingStick()
    stick.steps.append(Step(polled=1.5, side=1.0))
    StickTimingProcess(FlightSetup(SCENARIO), stick).update()
    assert stick.steps[0].ticks == 2
    assert stick.steps[0].flown


def test_timekeeping_counts_what_was_missed_and_what_came_a_frame_late():
    times = Timekeeping()
    for lateness in (0.1 * TICK, 0.9 * TICK, 1.1 * TICK, 1.1 * FRAME):
        times = times.noted(lateness, TICK, gap=0.0, lost=0.0)
    assert (times.ticks, times.missed, times.late) == (4, 2, 1)
    assert times.worst == 1.1 * FRAME
