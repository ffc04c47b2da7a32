"""A kite is its own mirror image: steered left or right, it flies the same seen in a mirror."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitemj.dynamics.formulation import MODELS, make_model
from kitemj.dynamics.motion import Motion, State
from kitemj.physics.frames import R_BE, Angles
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Sines
from kitemj.physics.vectors import Vector
from tests.properties.strategies import kites, number, states, vectors
from tests.support import SPORT, STILL, aloft, rest

ROUNDING = 1e-12
"""Relative: of forces, sums of a few terms."""
FLIGHT = 1e-9
"""m and rad after 1 s; rounding, which calm flight does not amplify."""


def mirrored_angles(q: Angles) -> Angles:
    return Angles(-q.phi, q.gamma, -q.eta, q.theta)


def mirrored_wind(parameters: Parameters) -> Parameters:
    return parameters._replace(wind=parameters.wind._replace(azimuth=-parameters.wind.azimuth))


@given(kites, states, vectors(30.0), vectors(5.0))
def test_air_forces_of_the_mirror_image(parameters, state, v, omega):
    high = Vector(-10.0, 5.0, -15.0)
    one = aerodynamic_wrench(parameters, high, R_BE(state.q), v, omega, 1.0)
    force, moment = aerodynamic_wrench(
        mirrored_wind(parameters),
        Vector(high.x, -high.y, high.z),
        R_BE(mirrored_angles(state.q)),
        Vector(v.x, -v.y, v.z),
        Vector(-omega.x, omega.y, -omega.z),
        1.0,
    )
    scale = max(map(abs, (*one.force, *one.moment)))
    assert one.force == pytest.approx((force.x, -force.y, force.z), abs=ROUNDING * scale)
    assert one.moment == pytest.approx((-moment.x, moment.y, -moment.z), abs=ROUNDING * scale)


def flown(model: str, parameters: Parameters, start: State, programme: Sines) -> Motion:
    kite = make_model(model, parameters, 0.005)
    kite.start(start, programme)
    kite.advance(programme, 1.0)
    return kite.motion(programme)


@pytest.mark.parametrize("model", MODELS)
@settings(max_examples=20)
@given(number(-0.3, 0.3), number(-0.1, 0.1), number(-0.1, 0.1), number(-0.2, 0.2), st.data())
def test_flights_of_the_mirror_image(model, phi, phi_dot, delta, azimuth, data):
    wind = SPORT.wind._replace(speed=10.0, azimuth=azimuth)
    parameters = SPORT._replace(wind=wind)
    swing = data.draw(number(-0.05, 0.05))
    start = State(aloft(parameters, phi).q, STILL._replace(phi=phi_dot))
    programme = Sines(rest(SPORT), delta, swing, 2.0, 0.2, 1.0)
    other = programme._replace(delta=-delta, delta_amplitude=-swing)
    one = flown(model, parameters, start, programme)
    two = flown(model, mirrored_wind(parameters), State(*map(mirrored_angles, start)), other)
    x, y, z = two.body.p_G_E
    assert one.body.p_G_E == pytest.approx((x, -y, z), abs=FLIGHT)
    assert one.q == pytest.approx(mirrored_angles(two.q), abs=FLIGHT)
    assert one.air.beta == pytest.approx(-two.air.beta, abs=100 * FLIGHT)
    assert one.tensions == pytest.approx(two.tensions[::-1], abs=1e-5)
