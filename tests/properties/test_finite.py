"""No force and no line length is ever not a number: speeds to 10⁴ m/s, rates to 10³ rad/s."""

from dataclasses import replace
from math import isfinite

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from kitemj.dynamics.formulation import MODELS, make_model
from kitemj.dynamics.motion import State
from kitemj.equilibria.modes import stability
from kitemj.equilibria.trim import equilibria
from kitemj.errors import FlightError, InputError
from kitemj.flight.limits import Ending
from kitemj.flight.live import Command, SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.flight.simulate import simulate
from kitemj.physics.aerodynamics import TableAero
from kitemj.physics.frames import R_BE, quaternion
from kitemj.physics.loads import aerodynamic_wrench, air
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.steering import line_motion
from kitemj.physics.vectors import Vector
from kitemj.physics.wind import Wind
from tests.bits import numbers
from tests.properties.strategies import hands, kites, number, states, vectors
from tests.support import LAKSA, STILL

ROW = ((1.0, -2.0, 0.5),) * 8
NONE, FAST, UNDER_GROUND = Vector(0.0, 0.0, 0.0), Vector(1e3, 0.0, 0.0), Vector(0.0, 0.0, 5.0)
LEVEL = State(STILL, STILL)
TABLE = LAKSA._replace(aero=TableAero((ROW,) * 6, (0.3, -0.3, 0.1)))

winds = st.builds(
    Wind,
    number(0.0, 100.0),
    number(0.0, 2.0),
    number(0.01, 1e3),
    number(0.0, 1.0),
    number(0.0, 10.0),
    number(-3.2, 3.2),
)
# straight above, on and below the ground; up to 10 km away
points = vectors(1e4)


@given(st.one_of(kites, st.just(TABLE)), winds, points, states, vectors(1e4), vectors(1e3))
@example(TABLE, Wind(0.0), NONE, LEVEL, Vector(1e-160, 0.0, 0.0), FAST)  # hardly any airspeed
@example(TABLE, Wind(0.0), NONE, LEVEL, NONE, FAST)  # none
@example(LAKSA, Wind(7.0, 0.14), UNDER_GROUND, LEVEL, Vector(0.0, 9.0, 0.0), NONE)  # β = 90°
def test_the_air_s_force_is_a_number(parameters, wind, p, state, v, omega):
    parameters = parameters._replace(wind=wind)
    attitude = R_BE(state.q)
    wrench = aerodynamic_wrench(parameters, p, attitude, v, omega, 3.0)
    met = air(parameters, p, attitude, v, 3.0)
    assert all(map(isfinite, (*wrench.force, *wrench.moment, *met)))


@given(
    kites.flatmap(lambda kite: st.tuples(st.just(kite), hands(kite))), st.sampled_from((1.0, -1.0))
)
def test_line_lengths_and_rates_are_numbers(given_, side):
    parameters, segment = given_
    assert all(map(isfinite, line_motion(parameters.kite.y_A, segment.control, side)))


@given(states)
def test_a_quaternion_is_a_unit(state):
    e = quaternion(R_BE(state.q))
    assert all(map(isfinite, e))
    assert abs(sum(x * x for x in e) - 1.0) < 1e-14


GUSTS = {"speed": 15.0, "gust_amplitude": 1.0, "gust_frequency": 20.0}
COARSE = 0.01
"""s; five times the default step: the air then damps a sport kite faster than steps can follow."""


@pytest.mark.parametrize("seed", [2, 9])
def test_a_live_flight_is_finite_to_its_named_end(seed):
    random = np.random.default_rng(seed)
    scenario = scenario_of({"set": "sport", "duration": 60.0, "wind": GUSTS}, "gusts")
    flight = SteeredFlight(scenario, step=COARSE)

    def fly_on(command):
        for k in range(6000):
            if k % 10 == 0:
                command = Command(*map(float, random.uniform(-1.0, 1.0, 2)))
            assert all(map(isfinite, numbers(flight.tick(command).motion)))

    with pytest.raises(FlightError, match=r"the numbers left the finite \([\w ]+\)"):
        fly_on(Command())


HANGING = {"set": "laksa", "duration": 1.0, "start": {"at": "state", "gamma_deg": 23.0}}
SPINNING = {"set": "laksa", "duration": 1.0, "start": {"phi_dot": 1000.0}}


@pytest.mark.parametrize("model", MODELS.shipped)
@pytest.mark.parametrize("kite", [{"y_A": 1e-12}, {"chord": 1e300}, {"area": 1e300}, {}])
def test_every_row_of_every_model_is_finite_or_the_flight_ends(model, kite):
    scenario = scenario_of(HANGING if kite else SPINNING, "odd")
    parameters = scenario.parameters._replace(kite=scenario.parameters.kite._replace(**kite))
    scenario = replace(scenario, parameters=parameters)  # no file may ask for such a kite
    flight = simulate(scenario, model, 0.02)
    assert all(map(isfinite, numbers(tuple(flight.motions))))
    assert flight.ending is not Ending.DIVERGED or "cannot fly on after t = " in flight.note
    kite = make_model(model, scenario.parameters, 0.02)
    kite.start(scenario.start, scenario.programme)
    rows = kite.batch(scenario.programme, np.linspace(0.0, 1.0, 11), 0.0, 1e-8)
    assert np.isfinite(rows).all()
    assert flight.ending is not Ending.FINISHED or len(rows) == 11


def test_an_equilibrium_that_is_not_finite_is_a_sentence():
    narrow = parameter_set("sport")
    narrow = narrow._replace(kite=narrow.kite._replace(y_A=1e-12))
    with pytest.raises(InputError, match="ask another model"):
        equilibria(narrow, model="mujoco")
    with pytest.raises(InputError, match="finds no finite tensions: ask another model"):
        stability(narrow, model="mujoco")
