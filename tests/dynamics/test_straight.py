"""A free body on two straight lines: the way from (q, q̇) to its motion, and back; and q̈."""

import numpy as np
import pytest

from kitemj.dynamics.formulation import MODELS, make_model
from kitemj.dynamics.straight import state_of, straight_body
from kitemj.flight.agreement import spatial_accelerations
from tests.support import LAKSA, LAKSA_STEERING, aloft, random_cases

CASES = random_cases(60)
ROUNDING = 1e-12
"""rad and rad/s, relative to at least 1; some hundred roundings of numbers of that size."""
ACCELERATION = {"lagrange": 1e-12, "newton-euler": 1e-9, "mujoco": 1e-6}
"""Relative to at least 1 rad/s²; as the ladder's rung: the engine's lines are softened."""
WHEN = 0.7
"""s; of the instants: the wind has gusts."""


def test_the_way_back_is_the_way_back() -> None:
    for parameters, state, segment in CASES:
        found = state_of(parameters, straight_body(parameters, *state, segment.control))
        assert found.q == pytest.approx(state.q, abs=ROUNDING)
        assert found.q_dot == pytest.approx(state.q_dot, abs=ROUNDING)


@pytest.mark.parametrize("model", MODELS)
def test_second_derivatives_of_q_are_those_of_lagrange(model: str) -> None:
    for parameters, state, segment in CASES:
        right = make_model("lagrange", parameters).at(state, segment.control, WHEN)
        met = make_model(model, parameters).at(state, segment.control, WHEN)
        gap = np.linalg.norm(np.subtract(met.q_ddot, right.q_ddot))
        assert gap <= ACCELERATION[model] * max(1.0, np.linalg.norm(right.q_ddot))


def test_lagrange_tells_the_accelerations_in_space_that_its_own_mean() -> None:
    for parameters, state, segment in CASES:
        now = make_model("lagrange", parameters).at(state, segment.control, WHEN)
        a, alpha = spatial_accelerations(parameters, segment.control, state, now.q_ddot)
        assert now.a_G_E == pytest.approx(tuple(a), rel=ROUNDING, abs=ROUNDING * np.abs(a).max())
        assert now.omega_dot_B == pytest.approx(tuple(alpha), abs=ROUNDING * np.abs(alpha).max())


@pytest.mark.parametrize("model", MODELS)
def test_an_instant_asked_for_leaves_the_flight_as_it_was(model: str) -> None:
    kite = make_model(model, LAKSA)
    kite.start(aloft(LAKSA), LAKSA_STEERING)
    kite.advance(LAKSA_STEERING, 0.1)
    before = kite.snapshot()
    _, state, segment = CASES[0]
    assert kite.at(state, segment.control, 0.0).body != kite.motion(LAKSA_STEERING).body
    assert kite.snapshot() == before
