"""What the report says of free and steered flights and of the limits, by independent ways."""

from math import degrees

import numpy as np
import pytest

from kitemj.dynamics.batch import ALPHA, BETA, TENSIONS
from kitemj.equilibria.minimal import held
from kitemj.equilibria.modes import crossings, growth
from kitemj.flight.live import TICK
from kitemj.physics.steering import control, line_motion, rest_ell
from thesis import free_and_steered_flights as free
from thesis import limits_of_steering_flights as limits
from thesis import limits_of_steering_tables as tables
from thesis.forced_response import (
    STEP,
    ForcedLagrange,
    SineSteering,
    periodic_flight,
    settled_state,
    stability_threshold,
)
from thesis.programmed_steering import (
    FULL_DEFLECTION,
    live_flights,
    scenario,
    square_wave,
    steering_spline,
    stick_values,
)

QUICK = SineSteering(0.05, 0.6)
MODELS_APART = 0.01
"""°; a fifteen-hundredth of β_max, far more than the models differ by."""


def test_without_a_swing_a_repeating_flight_is_the_equilibrium():
    """Multipliers of a step size of 0.04 s against eigenvalues: 1e-6 1/s."""
    parameters, nothing = free.parameters_at(80.0, -0.3), SineSteering(0.0, 0.6)
    found = periodic_flight(parameters, nothing, settled_state(parameters, nothing))
    assert found is not None
    assert found.growth == pytest.approx(growth(parameters).real, abs=1e-6)


def test_with_a_tiny_swing_stability_is_lost_where_it_is_without():
    [crossing] = crossings(free.parameters_at(80.0, -0.1), "aero.Cl_beta", -0.6, 0.0)
    assert stability_threshold(
        free.parameters_at(80.0, -0.1), SineSteering(1e-4, 0.6)
    ).value == pytest.approx(crossing.value, abs=1e-5)


@pytest.mark.parametrize("cl_beta", [-0.30, -0.38])
def test_a_flight_beside_the_repeating_one_leaves_it_as_its_multipliers_say(cl_beta):
    """The free kite is stable at -0.30 and not at -0.38; the swing changes where that is."""
    parameters = free.parameters_at(80.0, cl_beta)
    near = free.parameters_at(80.0, -0.30)
    found = periodic_flight(near, QUICK, settled_state(near, QUICK))
    found = periodic_flight(parameters, QUICK, found.x)
    kite, steps = ForcedLagrange(parameters, QUICK), round(QUICK.period / STEP)
    x = found.x + 1e-7 * np.array([1.0, 0, 0, 0, 0, 0, 0, 0])
    sizes = []
    for _ in range(20):
        x = kite.flow(x, held(1.0), QUICK.period, steps)
        sizes.append(np.linalg.norm(x - found.x))
    slope = np.polyfit(QUICK.period * np.arange(12), np.log(sizes[8:]), 1)[0]
    # a pair of multipliers turns as it grows, which makes the sizes wave by a few percent
    assert slope == pytest.approx(found.growth, abs=0.02 * abs(found.growth) + 2e-3)


def test_beta_grows_in_flight_as_its_mode_says():
    """Both to 0.1 %: what tolerance and the other modes leave."""
    flown = free.measured_growth(80.0, -0.36)
    assert flown == pytest.approx(growth(free.parameters_at(80.0, -0.36)).real, rel=1e-3)


@pytest.mark.parametrize("length", free.LENGTHS)
def test_lines_that_move_at_once_throw_the_kite(length):
    rows = free.flight_rows(length, free.THESIS, free.SLOW, 0.0)
    thrown = free.start_beta(length, free.SLOW)
    assert abs(degrees(rows[0, BETA])) == pytest.approx(thrown, abs=1e-6)
    assert degrees(np.abs(rows[1000:, BETA]).max()) < 0.2 * thrown


@pytest.mark.parametrize("case", limits.CASES)
def test_models_agree_on_every_case(case):
    """Shorter hands than the report's, of full stick throughout."""
    motions = live_flights(80.0, limits.CASES[case].stick(), square_wave(4.0)[:4])
    beta = {model: np.degrees([m.air.beta for m in flown]) for model, flown in motions.items()}
    assert len({len(values) for values in beta.values()}) == 1
    for values in beta.values():
        assert np.abs(values).max() > 0.1
        assert np.abs(values - beta["lagrange"]).max() < MODELS_APART


@pytest.mark.parametrize("schedule", [FULL_DEFLECTION, square_wave(5.0)])
@pytest.mark.parametrize("length", [80.0, 200.0])
def test_beta_rises_with_the_rate_of_the_hands_and_hardly_with_their_acceleration(length, schedule):
    beta = {
        case: limits.largest_beta(length, each, schedule) for case, each in limits.CASES.items()
    }
    assert beta[2] > beta[3] > beta[1]
    assert abs(beta[4] - beta[3]) < 0.2 * (beta[3] - beta[1])


@pytest.mark.parametrize("case", limits.CASES)
def test_beta_is_what_the_hand_changes_most_in_parts_of_the_limits(case):
    rows, given = (
        limits.case_rows(80.0, limits.CASES[case], FULL_DEFLECTION),
        scenario(80.0).parameters.limits,
    )
    beta = np.ptp(np.abs(rows[:, BETA])) / given.beta_max
    assert beta > 2 * np.ptp(rows[:, ALPHA]) / given.alpha_stall
    for side in (TENSIONS, TENSIONS + 1):
        assert beta > 2 * np.ptp(rows[:, side]) / given.tension_max


def test_the_way_of_the_hands_matters_most_then_their_rate():
    shares = [row[-1] for row in tables.sensitivity_table().rows]
    assert shares[0] > 3 * shares[1] > 0
    assert shares[1] > 10 * abs(shares[2])


def test_sudden_hands_meet_slack_lines_long_before_the_limit_of_beta():
    rows = limits.case_rows(80.0, limits.Case(0.1, 1.0, 10.0), FULL_DEFLECTION)
    assert rows[:, TENSIONS:].min() < 0.0
    assert degrees(np.abs(rows[:, BETA]).max()) < 5.0


def test_slow_hands_leave_the_beta_of_the_standing_kite():
    slow = limits.Case(0.1, 0.002, 0.05)
    schedule = ((2.0, 0.0), (120.0, 1.0))
    end = limits.case_rows(80.0, slow, schedule)[-1]
    assert abs(degrees(end[BETA])) == pytest.approx(limits.held_beta(80.0), abs=1e-3)


def test_scheduled_steering_is_that_of_a_live_flight():
    schedule, stick = square_wave(3.0)[:4], limits.CASES[2].stick()
    ell = rest_ell(80.0, scenario(80.0).parameters.kite.y_A)
    programme = steering_spline(stick, schedule, ell)
    motions = live_flights(80.0, stick, schedule)["mujoco"]
    assert len(motions) == len(stick_values(schedule)) + 1
    for i in range(0, len(motions), 50):
        planned = control(programme, i * TICK)
        assert motions[i].control.delta == pytest.approx(planned.delta, abs=1e-12)
    live = max(abs(m.air.beta) for m in motions)
    planned = limits.largest_beta(80.0, limits.CASES[2], schedule)
    assert planned == pytest.approx(degrees(live), abs=1e-4)


def test_arms_make_the_lines_that_they_reach():
    """The δ of the table gives back lines of L₀ ± 0.25 m; 0.1 rad take more."""
    y_A = scenario(80.0).parameters.kite.y_A
    for length, arm, ell, delta, _, printed, way in tables.reach_table().rows:
        for side in (1.0, -1.0):
            made = line_motion(y_A, held(ell, delta), side).length
            assert made == pytest.approx(length + side * arm, abs=1e-9)
        long, short = (line_motion(y_A, held(rest_ell(length, y_A), printed), s) for s in (1, -1))
        assert (long.length - short.length) / 2 == pytest.approx(way, abs=1e-3)
        assert way > arm
        assert delta == pytest.approx(0.0863, abs=1e-4)
