"""There and back: lengths and (ℓ, δ), pose and q, attitude and quaternion, body and engine."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline

from kitemj.dynamics import engine as engines
from kitemj.dynamics.motion import angles_of
from kitemj.dynamics.straight import straight_body
from kitemj.physics.frames import R_BE, R_BE_of, quaternion
from kitemj.physics.steering import (
    Control,
    Segment,
    Sines,
    Spline,
    control,
    ell_delta,
    line_motion,
)
from tests.properties.strategies import hands, kites, number, states
from tests.support import KITES

ROUNDING = 1e-12
"""Relative or rad, m/s on lines of up to 240 m."""

cases = kites.flatmap(lambda kite: st.tuples(st.just(kite), states, hands(kite)))


@given(number(0.1, 5.0), number(1.5, 300.0), number(-1.4, 1.4))
def test_lengths_give_back_ell_and_delta(y_A, ratio, delta):
    ell = ratio * y_A
    control = Control(ell, 0.0, 0.0, delta, 0.0, 0.0)
    plus, minus = (line_motion(y_A, control, side).length for side in (1.0, -1.0))
    assert (plus > minus) == (delta > 0) or abs(delta) < 1e-12, "the right hand pulls: δ > 0"
    back = ell_delta(plus, minus, y_A)
    assert back[0] == pytest.approx(ell, rel=ROUNDING)
    # δ = asin(s) with s a difference of squares: ratio digits are lost, near 90° more
    assert back[1] == pytest.approx(delta, abs=ROUNDING * 10 * ratio)


def programmes():
    """A programme of each kind, over 10 s."""
    t = np.linspace(0.0, 10.0, 21)
    ell, delta = CubicSpline(t, 20.0 + np.sin(t)).c, CubicSpline(t, 0.2 * np.cos(2 * t)).c
    yield Sines(20.0, 0.05, 0.3, 1.7, 2.0, 0.9)
    yield Spline(t, np.ascontiguousarray(ell), np.ascontiguousarray(delta))
    yield Segment(3.0, Control(20.0, 0.7, -0.4, 0.1, 0.2, 0.3))


@pytest.mark.parametrize("programme", list(programmes()), ids=lambda p: type(p).__name__)
@pytest.mark.parametrize("t", [0.1, 3.3, 7.9])
def test_what_hands_and_lines_do_is_the_derivative_of_where_they_are(programme, t):
    h = 1e-4  # s; truncation h² times a third derivative of some 10: 1e-7
    before, now, after = (control(programme, s) for s in (t - h, t, t + h))

    def rate(name: str) -> float:
        return (getattr(after, name) - getattr(before, name)) / (2 * h)

    for name in ("ell", "ell_dot", "delta", "delta_dot"):
        following = f"{name.removesuffix('_dot')}_{'ddot' if name.endswith('_dot') else 'dot'}"
        assert rate(name) == pytest.approx(getattr(now, following), abs=1e-6)
    for side in (1.0, -1.0):
        one, two, three = (line_motion(0.3, c, side) for c in (before, now, after))
        assert (three.length - one.length) / (2 * h) == pytest.approx(two.rate, abs=1e-6)
        assert (three.rate - one.rate) / (2 * h) == pytest.approx(two.acceleration, abs=1e-6)


@given(cases)
def test_pose_gives_back_q(case):
    parameters, (q, q_dot), segment = case
    body = straight_body(parameters, q, q_dot, segment.control)
    # φ of the midpoint's normal: the error grows as the lines come near the axis y_1
    assert angles_of(parameters, body) == pytest.approx(tuple(q), abs=100 * ROUNDING)


@given(states)
def test_attitude_gives_back_its_quaternion(state):
    R = R_BE(state.q)
    again = R_BE_of(quaternion(R))
    for row, wanted in zip(again, R, strict=True):
        assert row == pytest.approx(tuple(wanted), abs=ROUNDING)


ENGINES = {name: engines.build(parameters, 0.002) for name, parameters in KITES.items()}


@given(st.sampled_from(list(KITES)), states, st.data())
def test_the_engine_gives_back_the_body_that_was_placed(name, state, data):
    segment = data.draw(hands(KITES[name]))
    body = straight_body(KITES[name], *state, segment.control)
    engine = ENGINES[name][2]
    engines.place(engine, body)
    back = engines.body_of(engine)
    assert back.p_G_E == pytest.approx(tuple(body.p_G_E), abs=ROUNDING)
    assert back.v_G_E == pytest.approx(tuple(body.v_G_E), abs=ROUNDING)
    assert back.omega_B == pytest.approx(tuple(body.omega_B), abs=ROUNDING)
    for row, wanted in zip(back.R_BE, body.R_BE, strict=True):
        assert row == pytest.approx(tuple(wanted), abs=ROUNDING)
