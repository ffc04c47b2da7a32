"""The thesis's solver: its accuracy where nothing jumps, its count, its way with a jump."""

from functools import partial

import numpy as np
import pytest

from kitemj.dynamics.formulation import make_model
from kitemj.flight.scenario import scenario_of
from kitemj.physics.steering import Control, Segment, control, rest_ell
from thesis.ode45 import solve

SCENARIO = scenario_of({"set": "thesis", "duration": 1.0}, "test")
ELL = rest_ell(SCENARIO.parameters.lines.length, SCENARIO.parameters.kite.y_A)
STILL = Control(ELL, 0.0, 0.0, 0.0, 0.0, 0.0)
TICK, TICKS = 0.01, 100

NEAR = 1e-9
"""m; two Runge-Kutta methods of order 4 and 5 in steps of 10 ms and less, in calm flight."""


def pulled(ddot):
    """A second in which δ is driven with δ̈ = `ddot` [rad/s²], then braked."""
    segments, now = [], STILL
    for k in range(TICKS):
        now = now._replace(delta_ddot=ddot if k < TICKS // 2 else -ddot)
        segments.append(Segment(k * TICK, now))
        now = control(segments[-1], (k + 1) * TICK)
    return segments


def test_it_flies_as_the_lagrangian_model_does():
    segments = pulled(0.05)
    found = solve(
        SCENARIO.parameters, SCENARIO.start, [partial(control, s) for s in segments], TICK
    )
    kite = make_model("lagrange", SCENARIO.parameters)
    kite.start(SCENARIO.start, segments[0])
    assert len(found.motions) == TICKS + 1
    for segment, motion in zip(segments, found.motions[1:], strict=True):
        kite.advance(segment, TICK)
        own = kite.motion(segment)
        assert motion.t == pytest.approx(own.t)
        np.testing.assert_allclose(motion.body.p_G_E, own.body.p_G_E, atol=NEAR)
    assert abs(found.motions[-1].control.delta) > 0.01


def test_a_kite_at_rest_costs_one_step_a_tick():
    found = solve(SCENARIO.parameters, SCENARIO.start, [lambda t: STILL] * TICKS, TICK)
    assert found.evaluations == 7 * TICKS  # one to begin with, six for a step
    assert found.rejected == 0
    assert found.smallest == TICK


def test_a_jump_of_delta_makes_it_reject_steps_and_no_pulse_is_passed_over():
    jump = 0.1
    held = [STILL] * TICKS
    held[50] = STILL._replace(delta=jump, delta_dot=jump / TICK, delta_ddot=jump / TICK**2)
    held[51] = STILL._replace(delta=jump, delta_ddot=-jump / TICK**2)
    held[52:] = [STILL._replace(delta=jump)] * (TICKS - 52)
    found = solve(SCENARIO.parameters, SCENARIO.start, [lambda t, c=c: c for c in held], TICK)
    assert found.rejected > 0
    assert found.smallest < TICK / 10
    before, after = (max(map(abs, m.tensions)) for m in (found.motions[50], found.motions[51]))
    assert after > 100 * before
