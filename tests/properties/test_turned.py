"""The compass does not matter: wind and start turned about the vertical turn the flight."""

import pytest
from hypothesis import given, settings

from kitemj.dynamics.formulation import MODELS, make_model
from kitemj.dynamics.motion import Motion, State
from kitemj.physics.frames import R_1E
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Sines
from kitemj.physics.vectors import rotated
from tests.properties.strategies import number
from tests.support import SPORT, STILL, WEATHER, aloft, rest

FLIGHT = 1e-9
"""m and rad after 1 s; rounding, which calm flight does not amplify."""
FORCE = 1e-5
"""N; the engine's lines multiply rounding of lengths by k = 10⁴/s² at this step."""


def flown(model: str, parameters: Parameters, start: State) -> Motion:
    programme = Sines(rest(SPORT), 0.02, 0.05, 2.0, 0.2, 1.0)
    kite = make_model(model, parameters, 0.005)
    kite.start(start, programme)
    kite.advance(programme, 1.0)
    return kite.motion(programme)


@pytest.mark.parametrize("model", MODELS)
@settings(max_examples=20)
@given(number(-3.0, 3.0), number(-0.3, 0.3))
def test_turned_wind_and_start_turn_the_flight(model, turn, phi):
    ahead = SPORT._replace(wind=WEATHER._replace(speed=10.0, azimuth=0.0))
    aside = ahead._replace(wind=ahead.wind._replace(azimuth=turn))
    q = aloft(ahead, phi).q
    one = flown(model, ahead, State(q, STILL))
    two = flown(model, aside, State(q._replace(phi=q.phi + turn), STILL))
    about = R_1E(turn, 0.0)  # takes what is turned back again
    assert rotated(about, two.body.p_G_E) == pytest.approx(tuple(one.body.p_G_E), abs=FLIGHT)
    assert rotated(about, two.body.v_G_E) == pytest.approx(tuple(one.body.v_G_E), abs=10 * FLIGHT)
    assert two.q[1:] == pytest.approx(one.q[1:], abs=FLIGHT)
    assert two.air == pytest.approx(tuple(one.air), abs=10 * FLIGHT)
    assert two.tensions == pytest.approx(tuple(one.tensions), abs=FORCE)
