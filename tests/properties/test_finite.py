"""No force and no line length is ever not a number: speeds to 10⁴ m/s, rates to 10³ rad/s."""

from math import isfinite

from hypothesis import example, given
from hypothesis import strategies as st

from kitemj.dynamics.motion import State
from kitemj.physics.aerodynamics import TableAero
from kitemj.physics.frames import R_BE, quaternion
from kitemj.physics.loads import aerodynamic_wrench, air
from kitemj.physics.steering import line_motion
from kitemj.physics.vectors import Vector
from kitemj.physics.wind import Wind
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
