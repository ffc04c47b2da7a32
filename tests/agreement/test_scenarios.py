"""Every scenario that ships, flown to its end by all three models."""

from pathlib import Path

import pytest

from kitemj.dynamics.formulation import DEFAULT_STEP
from kitemj.dynamics.lagrange_kite import LagrangeKite
from kitemj.dynamics.motion import Motion, State
from kitemj.flight.compare import compare_models, position_gap
from kitemj.flight.ladder import ladder
from kitemj.flight.scenario import Scenario, read_scenario

FILES = sorted((Path(__file__).parents[2] / "scenarios").glob("*.toml"))

ADAPTIVE = 1e-7
"""m; Newton-Euler against Lagrange, both at rtol 1e-12: 0.0002 µm measured in loops, elsewhere
a thousandth of that."""
STEPPED = 1e-6
"""m; MuJoCo in its default steps of 2 ms against Lagrange: 0.42 µm in loops, elsewhere 0.005."""
GROWTH = 4.0
"""Times that a small error of the start may grow until the end of the loops: 2.7 for one of φ,
so that a gap at the end is about the sum of what the steps did wrong, not an echo of one."""


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_flights_agree_to_the_end(file):
    scenario = read_scenario(file)
    free, engine = compare_models(scenario, ["newton-euler", "mujoco", "lagrange"], DEFAULT_STEP)
    assert free.until == engine.until == scenario.times.duration
    assert free.position.value <= ADAPTIVE
    assert engine.position.value <= STEPPED
    assert free.agrees, "attitude and tension as well"
    assert engine.agrees, "attitude and tension as well"


@pytest.mark.parametrize("name", ["loops_20m", "sport_loops", "steer_and_reel_200m"])
def test_every_rung_holds_along_the_flight(name):
    [file] = [file for file in FILES if file.stem == name]
    rungs = ladder(read_scenario(file))
    assert all(rung.holds for rung in rungs), rungs
    assert len(rungs) == 14, "seven rungs for each of two models"


def flown(scenario: Scenario, aside: float) -> list[Motion]:
    """Lagrange's flight from a start turned by `aside` [rad]."""
    q, q_dot = scenario.start
    kite = LagrangeKite(scenario.parameters)
    kite.start(State(q._replace(phi=q.phi + aside), q_dot), scenario.programme)
    return kite.trajectory(scenario.programme, scenario.output_times)


def test_a_small_error_grows_little_in_the_loops():
    [file] = [file for file in FILES if file.stem == "loops_20m"]
    scenario = read_scenario(file)
    right, growths = flown(scenario, 0.0), []
    for aside in (1e-8, 1e-7):
        gaps = [position_gap(a, b) for a, b in zip(flown(scenario, aside), right, strict=True)]
        growths.append(max(gaps) / gaps[0])
    assert max(growths) < GROWTH
    assert growths[0] == pytest.approx(growths[1], rel=0.02), "small: grows in proportion"
    assert max(motion.air.speed for motion in right) > 20.0, "m/s: violent indeed"
