"""A scenario flown as it says: by its autopilot, where it has [pilot], else by its programme."""

from kitemj.autopilot.autopilot import Autopilot
from kitemj.autopilot.drift_hold import DriftPilot
from kitemj.dynamics.formulation import DEFAULT_STEP
from kitemj.errors import InputError
from kitemj.flight.scenario import Scenario
from kitemj.flight.simulate import Simulation, simulate
from kitemj.pilots.piloted import simulate_pilot


def pilot_of(scenario: Scenario) -> Autopilot | DriftPilot:
    """The pilot of a scenario that has [pilot], at the beginning of a flight.

    A kite that is mirrored, which does not turn, is held by a pilot of its own.
    Raises InputError, which names the file, for what cannot be flown.
    """
    if scenario.pilot is None:
        raise InputError(f"{scenario.source} has no [pilot]: add one, or name a pilot")
    try:
        if scenario.parameters.stick.mirrored:
            return DriftPilot(scenario.parameters, scenario.pilot)
        return Autopilot(scenario.parameters, scenario.pilot)
    except InputError as error:
        raise InputError(f"{error} ({scenario.source}, [pilot])") from None


def simulate_as_said(
    scenario: Scenario, model: str = "mujoco", step: float = DEFAULT_STEP
) -> Simulation:
    """As `simulate`; under the scenario's autopilot where it has one. Raises InputError."""
    if scenario.pilot is None:
        return simulate(scenario, model, step)
    return simulate_pilot(scenario, pilot_of(scenario), model, step)
