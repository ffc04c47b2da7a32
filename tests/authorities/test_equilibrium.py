"""The hanging kite: the paper's one scalar equation, written out here again, and its numbers."""

from math import cos, degrees, radians, sin, sqrt

import numpy as np
import pytest
from scipy.optimize import brentq

from kitemj.dynamics.formulation import MODELS, make_model
from kitemj.dynamics.motion import State
from kitemj.flight.equilibrium import equilibrium
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Segment
from tests.agreement.formulations import shipped
from tests.support import LAKSA, STILL, THESIS, Case, rest

PAPER = {"alpha": 7.746286, "gamma": 22.882617, "theta": -15.136331}
"""deg, for the set `laksa`; seven digits."""
PULL = 43.7845
"""N in each line."""
HALF_A_DIGIT = 5e-7
"""deg."""
AT_REST = 1e-9
"""m/s² and rad/s²; rounding of forces of 90 N on 4 kg, and of the engine's lines."""
SETS = {"laksa": LAKSA, "thesis": THESIS}


def papers_alpha(parameters: Parameters) -> float:
    """α [rad] of Λ (X cos α + Z sin α) + c C_m - Z C_x + X C_z = 0, Λ = 2 m g / (ρ S V²)."""
    kite, aero, air = parameters.kite, parameters.aero, parameters.environment
    weight = kite.mass * air.gravity
    loading = 2 * weight / (air.air_density * kite.area * parameters.wind.speed**2)

    def moment(alpha: float) -> float:
        return (
            loading * (kite.x_A * cos(alpha) + kite.z_A * sin(alpha))
            + kite.chord * (aero.Cm_0 + aero.Cm_alpha * alpha)
            - kite.z_A * (aero.Cx_0 + aero.Cx_alpha * alpha)
            + kite.x_A * (aero.Cz_0 + aero.Cz_alpha * alpha)
        )

    return brentq(moment, 0.0, radians(20.0), xtol=1e-15)


def test_numbers_of_the_paper_s_equation():
    found = equilibrium(LAKSA)
    for name, angle in PAPER.items():
        assert degrees(getattr(found, name)) == pytest.approx(angle, abs=HALF_A_DIGIT)
    assert found.tension == pytest.approx(PULL, abs=5e-5)


@pytest.mark.parametrize("name", SETS)
def test_angle_of_attack_solves_the_paper_s_equation(name):
    assert equilibrium(SETS[name]).alpha == pytest.approx(papers_alpha(SETS[name]), abs=1e-12)


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("name", SETS)
def test_models_have_no_acceleration_there(model, name):
    parameters = SETS[name]
    found = equilibrium(parameters)
    state = State(Angles(0.0, found.gamma, 0.0, found.theta), STILL)
    hands = Segment(0.0, Control(rest(parameters), 0.0, 0.0, 0.0, 0.0, 0.0))
    now = shipped(model).at(Case(parameters, state, hands))
    assert np.abs(now.a_G_E).max() < AT_REST
    assert np.abs(now.omega_dot_B).max() < AT_REST
    assert now.tensions == pytest.approx((found.tension, found.tension), rel=1e-9)


@pytest.mark.parametrize("model", MODELS)
def test_models_read_the_paper_s_numbers_from_the_flight(model):
    state = State(Angles(0.0, radians(PAPER["gamma"]), 0.0, radians(PAPER["theta"])), STILL)
    hands = Segment(0.0, Control(sqrt(200.0**2 - 2.9**2), 0.0, 0.0, 0.0, 0.0, 0.0))
    kite = make_model(model, LAKSA)
    kite.start(state, hands)
    motion = kite.motion(hands)
    assert degrees(motion.air.alpha) == pytest.approx(PAPER["alpha"], abs=2 * HALF_A_DIGIT)
    assert motion.tensions == pytest.approx((PULL, PULL), abs=1e-4)
    # γ leans the lines downwind; the pitch is α, because the wind is level
    a, g, ell = radians(PAPER["alpha"]), radians(PAPER["gamma"]), hands.control.ell
    X, Z = LAKSA.kite.x_A, LAKSA.kite.z_A
    x = -ell * sin(g) - X * cos(a) - Z * sin(a)
    z = -ell * cos(g) + X * sin(a) - Z * cos(a)
    assert motion.body.p_G_E == pytest.approx((x, 0.0, z), abs=5e-6), "m: digits of the angles"
