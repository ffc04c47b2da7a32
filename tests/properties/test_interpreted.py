"""One formula, two ways to run it: plain Python steps through what the machine code computes."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitemj.dynamics import lagrange, newton_euler, straight
from kitemj.physics import frames, loads, steering, wind
from tests.agreement.formulations import copied, shipped
from tests.agreement.rungs import NERVOUS, START, SWINGS
from tests.properties.strategies import hands, kites, number, states, vectors

SAME = 1e-13
"""Relative to the largest number of a result: the two may round the last digit differently."""

cases = kites.flatmap(lambda kite: st.tuples(st.just(kite), states, hands(kite)))


def flat(value):
    """All numbers of nested tuples in a row."""
    return [x for part in value for x in flat(part)] if isinstance(value, tuple) else [value]


def assert_same(formula, *arguments):
    compiled, plain = flat(formula(*arguments)), flat(formula.py_func(*arguments))
    scale = max(1e-300, *map(abs, compiled))
    assert plain == pytest.approx(compiled, rel=0.0, abs=SAME * scale)


@given(cases, vectors(30.0), vectors(3.0), number(0.0, 100.0))
def test_air(case, v, omega, t):
    parameters, state, _ = case
    R, p = frames.R_BE(state.q), frames.Vector(-30.0, 4.0, -80.0)
    assert_same(loads.aerodynamic_wrench, parameters, p, R, v, omega, t)
    assert_same(wind.wind_law.formulas[type(parameters.wind)], parameters.wind, p, t)


@given(cases)
def test_frames_and_steering(case):
    parameters, (q, q_dot), segment = case
    assert_same(frames.R_BE, q)
    assert_same(frames.quaternion, frames.R_BE(q))
    assert_same(steering.line_motion, parameters.kite.y_A, segment.control, 1.0)
    assert_same(steering.segment_control, segment, 0.3)
    assert_same(straight.straight_body, parameters, q, q_dot, segment.control)


@given(cases)
def test_equations_of_motion(case):
    parameters, (q, q_dot), segment = case
    assert_same(lagrange.body, parameters, q, q_dot, segment.control)
    assert_same(lagrange.accelerations, parameters, segment.control, 0.0, q, q_dot)
    body = straight.straight_body(parameters, q, q_dot, segment.control)
    assert_same(newton_euler.accelerations, parameters, segment, 0.0, body)


def test_the_engine_s_loop():
    """Every module of the model in plain Python, and the whole of mj_forward, not its parts."""
    ends = []
    for formulation in (shipped("mujoco"), copied("mujoco")):
        kite = formulation.kite(NERVOUS, 0.002)
        kite.start(START, SWINGS)
        kite.advance(SWINGS, 0.1)
        ends.append(kite.motion(SWINGS))
    compiled, plain = ends
    # fifty steps: three digits more are lost than in one formula, another two in the forces
    assert flat(plain.body) == pytest.approx(flat(compiled.body), rel=0.0, abs=1e-10)
    assert plain.tensions == pytest.approx(tuple(compiled.tensions), rel=1e-8)
