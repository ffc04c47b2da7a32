"""Near γ = 90° two of Lagrange's coordinates turn about one axis: digits are lost, and counted."""

import re
from math import acos, isnan

import numpy as np
import pytest

from kitemj.dynamics.formulation import make_model
from kitemj.errors import FlightError
from kitemj.flight.agreement import relative
from kitemj.flight.limits import Ending
from kitemj.flight.scenario import scenario_of
from kitemj.flight.simulate import simulate
from kitemj.physics.parameter_files import parameter_set
from tests.support import KITES, random_cases

LOST = 1e-7
"""Relative, of q̈ and tensions: what is promised up to where the model stops."""
KINDS = {**KITES, "set sport": parameter_set("sport")}


@pytest.mark.parametrize("name", KINDS)
def test_what_lagrange_says_near_its_edge_is_right_or_nothing(name):
    parameters = KINDS[name]
    lagrange, free = (make_model(model, parameters) for model in ("lagrange", "newton-euler"))
    said, silent = 0, 0
    for i, case in enumerate(random_cases(120, seed=5)):
        gamma = acos(10.0 ** -(i % 40 / 8)) * (-1) ** i  # cos γ from 1 to 1e-5
        state = case.state._replace(q=case.state.q._replace(gamma=gamma))
        c = case.segment.control
        ell = c.ell * parameters.lines.length / case.parameters.lines.length
        met, right = (kite.at(state, c._replace(ell=ell), 0.0) for kite in (lagrange, free))
        if isnan(met.q_ddot.phi):
            assert abs(np.cos(gamma)) < 0.02
            silent += 1
            continue
        assert relative(met.q_ddot, right.q_ddot) < LOST
        assert relative(met.tensions, right.tensions, 1.0) < LOST
        said += 1
    assert said > 40
    assert silent > 20


TOO_NEAR = (
    r"lagrange cannot fly on after t = 0\.\d+ s: γ = 89\.\d\d° is too near 90°, where φ and η turn "
    r"about one axis: .* ask newton-euler or mujoco"
)
LOW = {
    **{"set": "sport", "duration": 3.0, "wind": {"speed": 0.5}},
    "start": {"at": "state", "gamma_deg": 86.0, "theta_deg": -20.0, "gamma_dot": 0.02},
}


def test_a_flight_that_comes_there_says_why_it_ends():
    scenario = scenario_of(LOW, "low")
    flight = simulate(scenario, "lagrange")
    assert flight.ending is Ending.DIVERGED
    assert np.array([motion.t for motion in flight.motions]).max() == pytest.approx(0.8)
    assert re.fullmatch(TOO_NEAR, flight.note)
    assert simulate(scenario, "newton-euler").ending is Ending.GROUND


def test_a_live_flight_that_comes_there_says_so_too():
    scenario = scenario_of(LOW, "low")
    kite, hands = make_model("lagrange", scenario.parameters), scenario.programme
    kite.start(scenario.start, hands)

    def fly_on():
        for _ in range(300):
            kite.advance(hands, 0.01)

    with pytest.raises(FlightError, match=TOO_NEAR):
        fly_on()


def test_a_force_that_jumps_to_and_fro_ends_a_flight():
    """Air from behind: α jumps from 180° to -180°, and either side drives to the other."""
    astern = {"at": "state", "gamma_deg": 86.0, "gamma_dot": 0.02}
    tables = {"set": "laksa", "duration": 1.0, "wind": {"speed": 0.5}, "start": astern}
    for model in ("lagrange", "newton-euler"):
        flight = simulate(scenario_of(tables, "astern"), model)
        assert flight.ending is Ending.DIVERGED
        assert "too quick for any step" in flight.note
