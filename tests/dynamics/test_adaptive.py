"""The compiled integrator against scipy's of the same name, and against what it promises."""

from math import nan, radians

import numpy as np
import pytest
from scipy.integrate import DOP853, solve_ivp

from kitemj.dynamics import adaptive, lagrange_kite, newton_euler_kite
from kitemj.dynamics.adaptive import carried, room_for
from kitemj.dynamics.batch import ALPHA, CLEARANCE, TENSIONS, X, Z
from kitemj.dynamics.lagrange_kite import LagrangeKite, LagrangeSystem
from kitemj.dynamics.mujoco_kite import MujocoKite
from kitemj.dynamics.newton_euler_kite import NewtonEulerKite, NewtonEulerSystem
from kitemj.physics.steering import Sines
from tests.support import LAKSA, LAKSA_STEERING, SPORT, aloft, rest

QUICK = Sines(rest(SPORT), delta_amplitude=radians(6.0), delta_frequency=1.0)
FLIGHTS = {"laksa": (LAKSA, LAKSA_STEERING, 60.0), "sport": (SPORT, QUICK, 10.0)}
ROUNDING = 1e-10
"""rad, rad/s; what two orders of summation make of one flight of 60 s."""


def states(parameters):
    return np.array([*aloft(parameters).q, *aloft(parameters).q_dot])


def test_numbers_are_those_that_scipy_has():
    assert np.array_equal(adaptive.NODES, DOP853.C)
    assert np.array_equal(adaptive.WEIGHTS, DOP853.A)
    assert np.array_equal(adaptive.RESULT, DOP853.B)
    assert np.array_equal(adaptive.ERROR_3, DOP853.E3[: adaptive.STAGES])
    assert np.array_equal(adaptive.ERROR_5, DOP853.E5[: adaptive.STAGES])


@pytest.mark.parametrize("name", FLIGHTS)
def test_a_flight_is_scipy_s(name):
    parameters, programme, duration = FLIGHTS[name]
    system, x = LagrangeSystem(parameters, programme), states(parameters)

    def rates(t, x):
        out = np.empty(8)
        lagrange_kite.rates(system, t, x, out)
        return out

    theirs = solve_ivp(rates, (0.0, duration), x, method="DOP853", rtol=1e-13, atol=1e-14)
    room = room_for(x)
    assert carried(system, room, 0.0, duration, 1e-13) == duration
    assert room.x == pytest.approx(theirs.y[:, -1], abs=ROUNDING)
    # ... with as few evaluations, give or take the first steps
    assert room.state[2] < 1.2 * theirs.nfev


def test_error_follows_the_tolerance():
    system, x = LagrangeSystem(LAKSA, LAKSA_STEERING), states(LAKSA)
    exact = room_for(x)
    carried(system, exact, 0.0, 60.0, 1e-14)
    errors, evaluations = [], []
    for tolerance in (1e-4, 1e-6, 1e-8, 1e-10):
        room = room_for(x)
        carried(system, room, 0.0, 60.0, tolerance)
        errors.append(np.abs(room.x - exact.x).max())
        evaluations.append(room.state[2])
        assert errors[-1] < 100 * tolerance
    assert errors == sorted(errors, reverse=True)
    assert evaluations == sorted(evaluations)


def test_compiled_and_plain_take_the_same_steps():
    system, x = LagrangeSystem(LAKSA, LAKSA_STEERING), states(LAKSA)
    compiled, plain = room_for(x), room_for(x)
    assert carried(system, compiled, 0.0, 2.0, 1e-8) == 2.0
    assert carried.py_func(system, plain, 0.0, 2.0, 1e-8) == 2.0
    assert np.array_equal(plain.x, compiled.x)
    assert plain.state[2] == compiled.state[2]


@pytest.mark.parametrize("start", [nan, np.pi / 2])
def test_what_cannot_be_integrated_stops_and_says_where(start):
    x = states(LAKSA)
    x[1] = start  # γ = 90°: φ and η turn about the same axis
    x[0] = nan if start != start else x[0]
    room = room_for(x)
    assert carried(LagrangeSystem(LAKSA, LAKSA_STEERING), room, 0.0, 1.0, 1e-8) < 1.0


def test_the_free_body_keeps_its_length_of_line():
    kite = NewtonEulerKite(SPORT)
    kite.start(aloft(SPORT), QUICK)
    x = np.empty(13)
    newton_euler_kite.put(kite._y, x)
    room = room_for(x)
    assert carried(NewtonEulerSystem(SPORT, QUICK), room, 0.0, 5.0, 1e-12) == 5.0
    lagrange = LagrangeKite(SPORT)
    lagrange.start(aloft(SPORT), QUICK)
    [end] = lagrange.trajectory(QUICK, [5.0])
    assert room.x[:3] == pytest.approx(tuple(end.body.p_G_E), abs=1e-9)


ONE_FLIGHT = 1e-10
"""m; LagrangeKite flies its trajectories with scipy's integrator, its batches with ours."""


@pytest.mark.parametrize("kind", [MujocoKite, LagrangeKite, NewtonEulerKite])
def test_a_batch_says_what_the_motions_say(kind):
    times = np.linspace(0.0, 2.0, 21)
    kite = kind(LAKSA, 0.01)
    kite.start(aloft(LAKSA), LAKSA_STEERING)
    rows = kite.batch(LAKSA_STEERING, times, 0.0, kite_tolerance(kind))
    kite.start(aloft(LAKSA), LAKSA_STEERING)
    motions = kite.trajectory(LAKSA_STEERING, times.tolist())
    for row, motion in zip(rows, motions, strict=True):
        assert row[X : Z + 1] == pytest.approx(tuple(motion.body.p_G_E), abs=ONE_FLIGHT)
        assert row[TENSIONS:] == pytest.approx(tuple(motion.tensions))
        assert row[ALPHA] == pytest.approx(motion.air.alpha)
        assert 0 < row[CLEARANCE] < -motion.body.p_G_E.z


def kite_tolerance(kind):
    """What `trajectory` flies with."""
    return {LagrangeKite: lagrange_kite.TOLERANCE}.get(kind, newton_euler_kite.TOLERANCE)


def test_a_batch_ends_where_the_kite_is_too_low():
    kite = LagrangeKite(LAKSA)
    kite.start(aloft(LAKSA, phi=0.3), LAKSA_STEERING)
    times = np.linspace(0.0, 5.0, 51)
    heights = kite.batch(LAKSA_STEERING, times, -np.inf, 1e-8)[:, CLEARANCE]
    touch = float(heights[20])
    first = int(np.flatnonzero(heights < touch + 1e-9)[0])
    rows = kite.batch(LAKSA_STEERING, times, touch + 1e-9, 1e-8)
    assert len(rows) == first + 1
