"""Line lengths and their derivatives; a stick's wish shaped within limits."""

import itertools
from math import pi

import numpy as np
import pytest

from kitemj.flight.live import TICK
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.shaping import StickLaw, asked, shaped
from kitemj.physics.steering import (
    Control,
    Sines,
    control,
    ell_delta,
    line_motion,
    rest_ell,
    segment_control,
)

MOVING = Sines(ell=20.0, delta=0.1, delta_amplitude=0.4, delta_frequency=1.3, ell_amplitude=2.0)
MOVING = MOVING._replace(ell_frequency=0.7)
Y_A = 0.3
H = 1e-4
"""s; central differences of second order are then exact to 1e-7 of these values."""


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("t", np.linspace(0.3, 9.0, 7))
def test_line_rates_are_the_derivatives_of_line_lengths(side, t):
    before, now, after = (line_motion(Y_A, control(MOVING, t + d), side) for d in (-H, 0.0, H))
    assert now.rate == pytest.approx((after.length - before.length) / (2 * H), abs=1e-6)
    assert now.acceleration == pytest.approx((after.rate - before.rate) / (2 * H), abs=1e-6)


def test_lengths_and_ell_delta_are_inverse():
    c = Control(20.0, 0.0, 0.0, 0.3, 0.0, 0.0)
    lengths = (line_motion(Y_A, c, 1.0).length, line_motion(Y_A, c, -1.0).length)
    assert ell_delta(*lengths, Y_A) == pytest.approx((20.0, 0.3), abs=1e-13)


def test_arms_of_the_thesis_reach_less_than_its_printed_delta():
    """ΔL = 0.25 m for each arm at 2 Y_A = 5.8 m is 0.0863 rad, not 0.1 (a misprint)."""
    assert ell_delta(80.25, 79.75, 2.9)[1] == pytest.approx(
        0.0863, abs=1e-4
    )  # printed cut, not rounded
    with pytest.raises(ValueError, match="do not reach"):
        ell_delta(90.0, 70.0, 2.9)


def restless(seconds, seed=3):
    """(wish, control, segment) of each tick of a stick that jumps about and then rests."""
    limits, rest = parameter_set("thesis").stick, rest_ell(80.0, 2.9)
    random = np.random.default_rng(seed)
    now, rows = Control(rest, 0.0, 0.0, 0.0, 0.0, 0.0), []
    wish, reach = 0.0, rest
    for k in range(int(seconds / TICK)):
        if random.random() < TICK and k * TICK < seconds - 60.0:
            wish, reach = random.uniform(-0.13, 0.13), rest + random.uniform(-12.0, 12.0)
        segment = shaped(limits, now, k * TICK, TICK, wish, reach, rest)
        rows.append((wish, reach, segment))
        now = segment_control(segment, (k + 1) * TICK)
    return limits, rest, rows, now


def test_shaped_stick_stays_within_all_limits():
    limits, _, rows, _ = restless(600.0)
    c = np.array([segment.control for _, _, segment in rows])
    rounding = 1e-12  # relative; the limits are reached, not approached
    past = limits.delta_ddot * TICK**2 / 4  # rad; what a tick's mean acceleration leaves
    assert np.abs(c[:, 5]).max() <= limits.delta_ddot * (1 + rounding)
    assert np.abs(c[:, 4]).max() <= limits.delta_dot * (1 + rounding)
    assert np.abs(c[:, 3]).max() <= limits.delta + past
    assert np.abs(c[:, 2]).max() <= limits.ell_ddot * (1 + rounding)
    assert np.abs(c[:, 1]).max() <= limits.ell_dot * (1 + rounding)
    assert np.abs(c[:, 4]).max() > 0.99 * limits.delta_dot  # the test's stick is wild enough


def test_shaped_stick_is_continuous_in_delta_and_its_rate():
    _, _, rows, _ = restless(120.0)
    segments = [segment for _, _, segment in rows]
    for one, next_one in itertools.pairwise(segments):
        end = segment_control(one, next_one.start)
        assert (end.delta, end.delta_dot) == pytest.approx(next_one.control[3:5], abs=1e-15)


def test_shaped_stick_settles_on_its_wish_and_never_passes_it():
    limits, rest = parameter_set("thesis").stick, rest_ell(80.0, 2.9)
    past = limits.delta_ddot * TICK**2 / 4
    now = Control(rest, 0.0, 0.0, 0.0, 0.0, 0.0)
    path = []
    for k in range(2000):
        segment = shaped(limits, now, k * TICK, TICK, 0.07, rest, rest)
        now = segment_control(segment, (k + 1) * TICK)
        path.append(now.delta)
    assert max(path) <= 0.07 + past
    assert now.delta == pytest.approx(0.07, abs=past)
    assert abs(now.delta_dot) < 1e-15


def test_control_of_sines_has_the_derivatives_of_its_sines():
    t = pi / 3
    c = control(MOVING, t)
    before, after = control(MOVING, t - H), control(MOVING, t + H)
    assert c.delta_dot == pytest.approx((after.delta - before.delta) / (2 * H), abs=1e-7)
    assert c.ell_ddot == pytest.approx((after.ell_dot - before.ell_dot) / (2 * H), abs=1e-7)


def test_shaping_survives_states_on_the_braking_parabola():
    """From rest to a held target with these limits the planner alone fails at tick 58."""
    sport = parameter_set("sport")
    limits, rest = sport.stick._replace(delta_ddot=5.0), rest_ell(25.0, sport.kite.y_A)
    now = Control(rest, 0.0, 0.0, 0.0, 0.0, 0.0)
    for k in range(200):
        segment = shaped(limits, now, k * TICK, TICK, limits.delta, rest, rest)
        now = segment_control(segment, (k + 1) * TICK)
    assert now.delta == pytest.approx(limits.delta, abs=limits.delta_ddot * TICK**2 / 4)


def held(law, stick, seconds, now=None):
    """Controls at the end of each tick with the stick held, thesis limits; from rest."""
    limits, rest = parameter_set("thesis").stick, rest_ell(80.0, 2.9)
    now, controls = now or Control(rest, 0.0, 0.0, 0.0, 0.0, 0.0), []
    for k in range(round(seconds / TICK)):
        wish, rate = asked(limits, law, stick, now, TICK)
        segment = shaped(limits, now, k * TICK, TICK, wish, rest, rest, rate)
        now = segment_control(segment, (k + 1) * TICK)
        controls.append(now)
    return limits, controls


@pytest.mark.parametrize("stick", [1.0, -0.5])
def test_stick_that_commands_the_rate_gets_it_and_stops_at_the_limit(stick):
    limits, controls = held(StickLaw.RATE, stick, 60.0)
    assert controls[99].delta_dot == pytest.approx(stick * limits.delta_dot, rel=1e-12)
    past = limits.delta_ddot * TICK**2 / 4
    assert controls[-1].delta == pytest.approx(np.sign(stick) * limits.delta, abs=past)
    assert max(abs(c.delta) for c in controls) <= limits.delta + past


def test_stick_that_commands_the_rate_holds_delta_when_it_rests():
    _, moving = held(StickLaw.RATE, 1.0, 3.0)
    limits, resting = held(StickLaw.RATE, 0.0, 3.0, moving[-1])
    braking = limits.delta_dot**2 / (2 * limits.delta_ddot)
    assert resting[-1].delta_dot == pytest.approx(0.0, abs=1e-15)
    assert resting[-1].delta == pytest.approx(moving[-1].delta + braking, rel=1e-3)


def test_stick_that_commands_the_acceleration_gets_it_and_the_rate_stays():
    limits, pushed = held(StickLaw.ACCELERATION, 0.5, 0.2)
    assert pushed[-1].delta_dot == pytest.approx(0.5 * limits.delta_ddot * 0.2, rel=1e-9)
    _, coasting = held(StickLaw.ACCELERATION, 0.0, 3.0, pushed[-1])
    assert coasting[-1].delta_dot == pytest.approx(pushed[-1].delta_dot, rel=1e-9)
    _, at_last = held(StickLaw.ACCELERATION, 0.0, 60.0, pushed[-1])
    past = limits.delta_ddot * TICK**2 / 4
    assert at_last[-1].delta == pytest.approx(limits.delta, abs=past)
