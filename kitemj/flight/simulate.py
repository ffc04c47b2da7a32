"""A scenario flown by a model, with no screen."""

from dataclasses import dataclass

import numpy as np

from kitemj.dynamics.formulation import DEFAULT_STEP, make_model
from kitemj.dynamics.motion import Motion
from kitemj.errors import FlightError, InputError
from kitemj.flight.limits import Departure, Ending, first_departure, touches_ground
from kitemj.flight.pilot_settings import Guided
from kitemj.flight.scenario import Scenario
from kitemj.physics.frames import Angles

MOST_STEPS = 1e9
"""Of a flight; a step takes some 10 µs."""


@dataclass(frozen=True)
class Simulation:
    """What came of it: the motions, how it ended, where it first left the limits of validity.

    `guided`: what an autopilot told at each motion, where one flew.
    """

    model: str
    scenario: Scenario
    motions: list[Motion]
    ending: Ending
    departure: Departure | None
    note: str = ""
    guided: tuple[Guided | None, ...] = ()


def simulate(scenario: Scenario, model: str = "mujoco", step: float = DEFAULT_STEP) -> Simulation:
    """Flies `scenario` from start to end, or until it touches the ground or diverges.

    `step` [s] is the longest step of models with fixed steps. Raises InputError for an
    unknown model.
    """
    kite, duration = make_model(model, scenario.parameters, step), scenario.times.duration
    if duration / step > MOST_STEPS:
        raise InputError(
            f"{duration:g} s in steps of {step:g} s are more than {MOST_STEPS:g} steps, which take "
            f"hours: fly less of it, or in steps (`step`) of {duration / MOST_STEPS:g} s or more"
        )
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
    angles = [motion.q for motion in motions if motion.q]
    if not angles:
        return motions
    unwrapped = np.unwrap(angles, axis=0).tolist()
    return [motion._replace(q=Angles(*q)) for motion, q in zip(motions, unwrapped, strict=True)]
