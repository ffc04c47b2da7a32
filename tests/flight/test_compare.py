"""Agreement is claimed of what was flown: until the touch itself, and of a kite that moved."""

from dataclasses import replace
from pathlib import Path

import pytest

from kitemj.dynamics.formulation import MODELS
from kitemj.dynamics.ground import CLOSE, above
from kitemj.errors import InputError
from kitemj.flight.compare import compare, compare_models
from kitemj.flight.limits import Ending
from kitemj.flight.restless import restless
from kitemj.flight.scenario import Times, read_scenario, scenario_of
from kitemj.flight.simulate import simulate
from kitemj.physics.steering import control
from tests.properties.test_endings import SMALL

DOCS = Path(__file__).parents[2] / "docs"
DIVE = scenario_of({**SMALL, "set": "laksa", "duration": 8.0, "steering": {"delta": 0.1}}, "dive")
STEP = 0.002
"""s; the program's default."""
MOMENT = 1e-8
"""s; within it all touch the ground: at 10 m/s as far apart as 0.1 µm."""


@pytest.mark.parametrize("interval", [0.05, 8.0])
def test_every_model_ends_at_the_moment_it_touches_the_ground(interval):
    flown = replace(DIVE, times=Times(8.0, interval))
    touches = []
    for model in MODELS.shipped:
        flight = simulate(flown, model, STEP)
        assert flight.ending is Ending.GROUND
        *before, last = (above(flown.parameters, motion.body) for motion in flight.motions)
        assert min(before) >= 0.0
        assert -CLOSE <= last < 0.0
        assert [motion.t for motion in flight.motions[:-1]] == flown.output_times[: len(before)]
        touches.append(flight.motions[-1].t)
    assert max(touches) - min(touches) < MOMENT


def test_a_row_that_touches_is_not_compared():
    for each in compare_models(DIVE, ["mujoco", "newton-euler", "lagrange"], STEP):
        assert each.verdict == "yes"
        assert each.until == pytest.approx(3.7), "the touch is at 3.734 s"


def test_what_is_compared_at_its_start_alone_agrees_with_nothing():
    [one] = compare_models(replace(DIVE, times=Times(8.0, 8.0)), ["mujoco", "lagrange"], STEP)
    assert one.until == 0.0
    assert one.verdict == "nothing compared"
    assert not one.agrees


def test_a_kite_at_rest_shows_nothing():
    at_rest = {"set": "sport", "duration": 2.0, "steering": {"programme": "rest"}}
    [one] = compare_models(scenario_of(at_rest, "test"), ["newton-euler", "lagrange"], STEP)
    assert one.verdict == "at rest"


def test_what_cannot_be_flown_is_a_sentence():
    wild = scenario_of({"set": "laksa", "duration": 1.0, "start": {"theta_deg": -40.0}}, "wild")
    flight = simulate(wild, "lagrange")
    with pytest.raises(InputError, match="there is nothing to compare in wild: a line is slack"):
        compare(flight, flight)


OWN = {"lines": {"length": 30.0}, "wind": {"speed": 7.0}, "stick": {"delta": 0.5}}
"""As a reader of docs/extend.md makes it: no steering programme."""
FAR = 1.0
"""m; more than a kite at rest moves by 10¹³."""


@pytest.mark.parametrize(
    "tables", [{"set": "sport"}, {"set": "laksa"}, {"set": "thesis"}, {"set": "sport", **OWN}]
)
def test_one_s_own_kite_is_moved_by_hands_within_the_stick_s_limits(tables):
    given = scenario_of({**tables, "duration": 30.0}, "own")
    [one] = compare_models(given, ["newton-euler", "lagrange"], STEP)
    assert one.verdict == "yes"
    assert one.until == one.valid == 30.0, "no line slack, no stall, not on the ground"
    assert one.moved > FAR
    stick, moving = given.parameters.stick, restless(given)
    held = control(given.programme, 0.0)
    first, *others = (control(moving.programme, 0.01 * k) for k in range(3001))
    assert first[:2] == pytest.approx(held[:2], abs=1e-12)
    assert first[3:5] == pytest.approx(held[3:5], abs=1e-12)
    for c in others:
        assert abs(c.delta - held.delta) < stick.delta
        assert abs(c.ell - held.ell) < stick.ell
        for name in ("delta_dot", "delta_ddot", "ell_dot", "ell_ddot"):
            assert abs(getattr(c, name)) < getattr(stick, name)


def test_a_programme_that_is_named_is_flown():
    shipped = read_scenario("rest_200m")
    assert shipped.steered
    assert not scenario_of({"set": "laksa", "duration": 1.0}, "test").steered
