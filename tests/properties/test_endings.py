"""Every way in which a flight can end, or leave what the model vouches for, has its sentence."""

import re

import pytest

from kitemj.flight.limits import LIMITS, SIDESLIP, SLACK, STALL, Ending, Limit
from kitemj.flight.scenario import scenario_of
from kitemj.flight.simulate import Simulation, simulate

STEP = 0.02
"""s; endings do not ask for accuracy."""
CALM = {"set": "laksa", "duration": 3.0}
SMALL = {
    "kite": {
        **{"mass": 0.22, "inertia_x": 0.03, "inertia_y": 0.006, "inertia_z": 0.035},
        **{"chord": 0.45, "span": 1.7, "area": 0.6, "x_A": 0.05, "y_A": 0.3, "z_A": 0.3},
    },
    "aero": {"Cn_beta": 0.5, "Cy_beta": -3.0},
    "lines": {"length": 20.0},
    "wind": {"speed": 6.0},
}


def flown(changes: dict, model: str = "mujoco") -> Simulation:
    return simulate(scenario_of({**CALM, **changes}, "test.toml"), model, STEP)


def assert_departs(flight: Simulation, limit: Limit, reading: str) -> None:
    assert flight.departure.limit is limit
    assert re.fullmatch(
        rf"t = \d+\.\d\d s: {re.escape(limit.sentence)} \({reading}\)", str(flight.departure)
    )


def test_finished():
    flight = flown({})
    assert flight.ending is Ending.FINISHED
    assert flight.departure is None
    assert flight.motions[-1].t == CALM["duration"]


@pytest.mark.parametrize("model", ["mujoco", "lagrange", "newton-euler"])
def test_slack(model):
    nose_down = {"start": {"theta_deg": -12.0}}
    flight = flown(nose_down, model)
    assert_departs(flight, SLACK, r"left -?[\d.]+ N, right -?[\d.]+ N, at least 0 N")


def test_slack_lines_of_the_engine_do_not_push():
    flight = flown({"start": {"theta_deg": -12.0}})
    later = [T for motion in flight.motions[1:] for T in motion.tensions]
    assert min(later) == 0.0, "slack"
    assert max(later) > 0.0, "and caught again"


def test_stall():
    flight = flown({"start": {"theta_deg": 25.0}})
    assert_departs(flight, STALL, r"α = 32\.75°, α_stall = 25°")


def test_sideslip():
    flight = flown({"start": {"phi_dot": 0.03}})
    assert_departs(flight, SIDESLIP, r"β = -1\d\.\d\d°, β_max = 15°")


@pytest.mark.parametrize("model", ["mujoco", "lagrange", "newton-euler"])
def test_ground(model):
    flight = flown({**SMALL, "duration": 8.0, "steering": {"delta": 0.1}}, model)
    assert flight.ending is Ending.GROUND
    assert 3.0 < flight.motions[-1].t < 5.0
    assert -flight.motions[-1].body.p_G_E.z < SMALL["kite"]["span"]


def test_diverged():
    flight = flown({"wind": {"speed": 1000.0}, "start": {"phi_dot": 1000.0}})
    assert flight.ending is Ending.DIVERGED
    assert flight.note == (
        "mujoco cannot fly on after t = 0.100 s: the numbers left the finite (coordinates); "
        "a shorter step may help"
    )
    assert len(flight.motions) == 1, "what was flown until then is kept"


@pytest.mark.parametrize(
    "sentence", [*(ending.value for ending in Ending), *(limit.sentence for limit in LIMITS)]
)
def test_a_sentence_is_for_people(sentence):
    assert len(sentence.split()) > 4
    assert not sentence.endswith(".")
