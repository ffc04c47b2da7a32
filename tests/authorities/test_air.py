"""What the air must do whatever the coefficients are: nothing in still air, V², dimensions."""

from math import pi

import pytest

from kitemj.dynamics.formulation import MODELS, make_model
from kitemj.dynamics.motion import State, energy
from kitemj.physics.frames import R_BE, Angles
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Sines, rest_ell
from kitemj.physics.vectors import Vector, rotated
from kitemj.physics.wind import Wind, wind_speed, wind_velocity
from tests.support import LAKSA, SPORT, STILL, aloft

NONE = Vector(0.0, 0.0, 0.0)
ATTITUDE = R_BE(Angles(0.3, 0.5, -0.2, -0.4))
HIGH = Vector(-70.0, 20.0, -150.0)


def forces(parameters: Parameters, v_G_E: Vector, omega_B: Vector = NONE) -> tuple[float, ...]:
    wrench = aerodynamic_wrench(parameters, HIGH, ATTITUDE, v_G_E, omega_B, 0.0)
    return (*wrench.force, *wrench.moment)


def in_wind(speed: float) -> Parameters:
    return LAKSA._replace(wind=Wind(speed))


def test_a_kite_that_drifts_with_the_wind_feels_nothing():
    drifting = wind_velocity(LAKSA.wind, HIGH, 0.0)
    assert drifting == (-7.0, 0.0, 0.0), "the wind blows along -x_E"
    assert forces(LAKSA, drifting, Vector(1.0, 2.0, 3.0)) == (0.0,) * 6


def test_no_air_no_force():
    empty = LAKSA._replace(environment=LAKSA.environment._replace(air_density=0.0))
    assert forces(empty, Vector(9.0, 5.0, -3.0), Vector(1.0, 2.0, 3.0)) == (0.0,) * 6


@pytest.mark.parametrize("factor", [0.1, 2.0, 10.0])
def test_forces_grow_with_the_square_of_the_wind(factor):
    expected = [factor**2 * f for f in forces(in_wind(7.0), NONE)]
    assert forces(in_wind(7.0 * factor), NONE) == pytest.approx(expected, rel=1e-12)


def test_only_the_velocity_against_the_air_counts():
    moved = forces(in_wind(12.0), Vector(-5.0, 0.0, 0.0))
    assert moved == pytest.approx(forces(in_wind(7.0), NONE), rel=1e-12)


def test_signs_of_the_forces_on_a_hanging_kite():
    """Lift up, drag downwind; a wind from the kite's left pushes it to the right."""
    q = aloft(LAKSA).q
    force = aerodynamic_wrench(LAKSA, HIGH, R_BE(q), NONE, NONE, 0.0).force
    R = R_BE(q)
    in_E = Vector(*(sum(R[i][j] * force[i] for i in range(3)) for j in range(3)))
    assert in_E.z < -LAKSA.kite.mass * LAKSA.environment.gravity, "lifts more than it weighs"
    assert in_E.x < 0
    assert in_E.y == pytest.approx(0.0, abs=1e-12)
    # frame E: the wind turned by +90° about z_E (down) blows along -y_E
    aside = LAKSA._replace(wind=Wind(7.0, azimuth=pi / 2))
    assert rotated(R, wind_velocity(aside.wind, HIGH, 0.0)).y < 0
    assert aerodynamic_wrench(aside, HIGH, R, NONE, NONE, 0.0).force.y < 0


def test_wind_grows_with_height_and_comes_in_gusts():
    """V (h/H₀)^a (1 + ε sin Ωt) of the paper, at points where it needs no computer."""
    wind = Wind(7.0, 0.14, 10.0, gust_amplitude=0.1, gust_frequency=0.6)
    quarter = pi / 2 / 0.6  # s; the gust is at its height
    assert wind_speed(wind, 10.0, 0.0) == pytest.approx(7.0)
    assert wind_speed(wind, 10.0, quarter) == pytest.approx(7.7)
    assert wind_speed(wind, 10.0, 3 * quarter) == pytest.approx(6.3)
    assert wind_speed(wind, 20.0, 0.0) == pytest.approx(7.0 * 2**0.14)
    assert wind_speed(wind, -1.0, 0.0) == 0.0
    assert wind_speed(Wind(7.0), 123.0, 9.0) == 7.0


SCALED = {"lagrange": 1e-9, "newton-euler": 1e-9, "mujoco": 1e-8}
"""m; rounding, and for MuJoCo where its solver stops: a threshold in units that do not scale."""


@pytest.mark.parametrize("model", MODELS)
def test_a_flight_scales_with_the_square_root_of_gravity(model):
    """Froude: g, V², V_ref², rates² all fourfold is the same flight in half the time."""
    base, k = SPORT._replace(wind=Wind(10.0)), 2.0
    fast = base._replace(
        wind=Wind(10.0 * k),
        environment=base.environment._replace(gravity=k * k * base.environment.gravity),
        aero=base.aero._replace(V_ref=k * base.aero.V_ref),
    )
    ell = rest_ell(20.0, base.kite.y_A)
    slow_hands, fast_hands = (Sines(ell, 0.0, 0.1, k_ * 2.0) for k_ in (1.0, k))
    slow, quick = make_model(model, base, 0.002), make_model(model, fast, 0.002 / k)
    start = aloft(base).q
    slow.start(State(start, STILL._replace(phi=0.03)), slow_hands)
    quick.start(State(start, STILL._replace(phi=0.03 * k)), fast_hands)
    slow.advance(slow_hands, 1.0)
    quick.advance(fast_hands, 1.0 / k)
    a, b = slow.motion(slow_hands), quick.motion(fast_hands)
    assert b.body.p_G_E == pytest.approx(tuple(a.body.p_G_E), abs=SCALED[model])
    assert b.body.v_G_E == pytest.approx([k * v for v in a.body.v_G_E], abs=1e-8)
    assert b.tensions == pytest.approx([k * k * T for T in a.tensions], rel=1e-8)
    assert abs(a.body.p_G_E.y) > 0.1, "m: it did fly somewhere"


@pytest.mark.parametrize("model", MODELS)
def test_without_air_and_with_still_hands_energy_stays(model):
    """A swing in empty space, with the weight turned upwards, as a balloon's: lines stay tight."""
    balloon = SPORT._replace(environment=SPORT.environment._replace(gravity=-9.81, air_density=0.0))
    hands = Sines(rest_ell(20.0, SPORT.kite.y_A))
    kite = make_model(model, balloon, 0.002)
    kite.start(State(Angles(0.2, 0.3, 0.1, 0.0), Angles(0.1, 0.0, 0.0, 0.3)), hands)
    before = energy(balloon, kite.motion(hands).body)
    kinetic = before - balloon.kite.mass * -9.81 * -kite.motion(hands).body.p_G_E.z
    kite.advance(hands, 5.0)
    after = kite.motion(hands)
    assert min(after.tensions) > 0
    assert energy(balloon, after.body) == pytest.approx(before, abs=1e-5 * kinetic)
