"""A scenario flown by a model, with no screen."""

from dataclasses import dataclass

import numpy as np

from kitemj.dynamics.motion import Model, Motion
from kitemj.errors import FlightError, InputError
from kitemj.flight.limits import Departure, Ending, first_departure, touches_ground
from kitemj.flight.scenario import Scenario
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters

MODELS = ("mujoco", "newton-euler", "lagrange")
DEFAULT_STEP = 0.002
"""s; holds the MuJoCo kite within 1 µm of the reference over a minute."""
MAX_STEP = 0.1
"""s; the fastest motion of a kite of this size would not be resolved beyond."""


@dataclass(frozen=True)
class Simulation:
    """What came of it: the motions, how it ended, where it first left the limits of validity."""

    model: str
    scenario: Scenario
    motions: list[Motion]
    ending: Ending
    departure: Departure | None
    note: str = ""


def make_model(name: str, parameters: Parameters, step: float = DEFAULT_STEP) -> Model:
    """The model called `name` with steps of `step` [s]; raises as `check_model`."""
    check_model(name, step)
    if name == "mujoco":
        from kitemj.dynamics.mujoco_kite import MujocoKite

        return MujocoKite(parameters, step)
    if name == "lagrange":
        from kitemj.dynamics.lagrange_kite import LagrangeKite

        return LagrangeKite(parameters, step)
    from kitemj.dynamics.newton_euler_kite import NewtonEulerKite

    return NewtonEulerKite(parameters, step)


def check_model(name: str, step: float) -> None:
    """Raises InputError for an unknown model or a step [s] that is not positive, or too long."""
    if not 0 < step <= MAX_STEP:
        raise InputError(f"--step must be > 0 s and <= {MAX_STEP} s, got {step} s")
    if name not in MODELS:
        raise InputError(f"there is no model {name!r}; there are: {', '.join(MODELS)}")


def simulate(scenario: Scenario, model: str = "mujoco", step: float = DEFAULT_STEP) -> Simulation:
    """Flies `scenario` from start to end, or until it touches the ground or diverges.

    `step` [s] is the longest step of models with fixed steps. Raises InputError for an
    unknown model.
    """
    kite = make_model(model, scenario.parameters, step)
    kite.start(scenario.start, scenario.programme)
    ending, note = Ending.FINISHED, ""
    try:
        motions = kite.trajectory(scenario.programme, scenario.output_times)
    except FlightError as error:
        motions, ending, note = error.motions, Ending.DIVERGED, str(error)
    for index, motion in enumerate(motions):
        if touches_ground(scenario.parameters, motion):
            motions, ending = motions[: index + 1], Ending.GROUND
            break
    motions = continuous(motions)
    departure = first_departure(scenario.parameters, motions)
    return Simulation(model, scenario, motions, ending, departure, note)


def continuous(motions: list[Motion]) -> list[Motion]:
    """The same motions with q free of jumps by 2π, as a kite that loops needs."""
    if not motions:
        return motions
    unwrapped = np.unwrap([motion.q for motion in motions], axis=0).tolist()
    return [motion._replace(q=Angles(*q)) for motion, q in zip(motions, unwrapped, strict=True)]
