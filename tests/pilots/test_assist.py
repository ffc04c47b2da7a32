"""The assist: the kite turns as the stick asks, hands off it comes home, and it refuses dives."""

from collections import deque
from collections.abc import Callable
from dataclasses import replace
from math import degrees
from random import Random

import numpy as np
import pytest

from kitemj.dynamics.motion import Motion, State
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.pilots.assist import FULL, Assist, level, wind
from kitemj.pilots.crash import FirstTouch
from kitemj.pilots.sight import LEFT, RIGHT, Sight, Twist, sight

KITES, WINDS = ("sport", "trainer"), (5.0, 6.5, 8.0)
STEP = 0.005
"""s."""
FRAME, OLD = 3, 6
"""Ticks: between two frames at 30 a second, and how old news is by the slowest way to a pilot."""

Hand = Callable[[float], float]


def flight_of(kite: str, speed: float, aside: float = 0.0) -> SteeredFlight:
    """At the top, or `aside` [rad] of it."""
    tables = {"set": kite, "duration": 60.0, "wind": {"speed": speed}}
    scenario = scenario_of(tables, "test")
    q, q_dot = scenario.start
    start = State(q._replace(eta=q.eta - aside), q_dot)
    return SteeredFlight(replace(scenario, start=start), step=STEP)


def flown(flight: SteeredFlight, hand: Hand, duration: float, late: bool = False) -> list[Motion]:
    """All motions until the ground; asked at every tick, or `late`: at frames, with old news."""
    assist, ground, command = Assist(), FirstTouch(flight.parameters), Command()
    motions, seen = [flight.result.motion], deque([flight.result.motion], OLD)
    for k in range(round(duration / TICK)):
        if k % (FRAME if late else 1) == 0:
            assist.hand = hand(motions[-1].t)
            command = assist.command(seen[0] if late else motions[-1])
        motions.append(flight.tick(command).motion)
        seen.append(motions[-1])
        if ground.watch(motions[-1]):
            break
    return motions


@pytest.mark.parametrize("side", [LEFT, RIGHT])
def test_a_nose_that_points_up_leans_to_the_middle(side: float) -> None:
    aside, above = Sight(0.5 * side, 0.8, 0.0, 0.0), Sight(0.0, 0.8, 0.0, 0.0)
    assert level(aside, RIGHT) * side < -0.1, "rad/s"
    assert level(above, RIGHT) == 0.0


@pytest.mark.parametrize("late", [False, True], ids=["each tick", "at frames"])
@pytest.mark.parametrize("speed", WINDS)
@pytest.mark.parametrize("kite", KITES)
def test_hands_off_it_comes_home_and_stays(kite: str, speed: float, late: bool) -> None:
    motions = flown(flight_of(kite, speed, aside=0.4), lambda t: 0.0, 20.0, late)
    azimuths = np.abs([degrees(sight(motion).azimuth) for motion in motions])
    assert azimuths[0] > 30.0
    assert azimuths[round(10.0 / TICK) :].max() < 10.0, "deg"
    assert max(abs(degrees(sight(motion).heading)) for motion in motions[-500:]) < 15.0


@pytest.mark.parametrize("hand", [-0.3, 0.2])
@pytest.mark.parametrize("kite", KITES)
def test_the_stick_asks_for_a_rate_of_turn(kite: str, hand: float) -> None:
    """From a second on, once the hands have answered, until the nose points to the side."""
    motions = flown(flight_of(kite, 6.5), lambda t: hand, 2.0)
    turning = [sight(motion).turning for motion in motions[100:]]
    assert np.mean(turning) == pytest.approx(hand * FULL, rel=0.35)


@pytest.mark.parametrize("side", [-1.0, 1.0])
@pytest.mark.parametrize("speed", WINDS)
@pytest.mark.parametrize("kite", KITES)
def test_full_stick_still_loops(kite: str, speed: float, side: float) -> None:
    twist = Twist()
    for motion in flown(flight_of(kite, speed), lambda t: side, 4.5):
        twist.look(motion)
    assert side * twist.angle > 5.0, "rad, of the 6.3 of a whole turn"


@pytest.mark.parametrize("speed", WINDS)
@pytest.mark.parametrize("kite", KITES)
def test_a_key_that_is_held_flies_into_no_ground(kite: str, speed: float) -> None:
    for late in (0.09, 0.18):  # two that once went into the ground
        held = flown(flight_of(kite, speed), lambda t, late=late: min(0.4, 1.3 * (t + late)), 9.0)
        assert held[-1].t == pytest.approx(9.0)
    without = flight_of(kite, speed)
    low = min(-without.tick(Command(0.4)).motion.body.p_G_E.z for _ in range(1400))
    assert low < 1.0 or kite == "trainer", "the same key alone"


@pytest.mark.parametrize("speed", [6.5, 8.0])
@pytest.mark.parametrize("kite", KITES)
def test_keys_that_are_thrown_about_fly_into_no_ground(kite: str, speed: float) -> None:
    random = Random(4)
    keys = [random.choice((-0.4, 0.0, 0.4)) for _ in range(40)]
    motions = flown(flight_of(kite, speed), lambda t: keys[int(t / 0.8)], 30.0)
    assert motions[-1].t == pytest.approx(30.0)


@pytest.mark.parametrize("speed", WINDS)
def test_it_feels_the_wind(speed: float) -> None:
    motions = flown(flight_of("sport", speed), lambda t: 1.0, 2.0)
    assert [wind(motion) for motion in motions[::50]] == pytest.approx([speed] * 5)
