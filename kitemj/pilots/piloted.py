"""A scenario with a pilot at the stick, flown as fast as the machine can."""

from kitemj.dynamics.formulation import DEFAULT_STEP
from kitemj.errors import FlightError
from kitemj.flight.limits import Ending, first_departure, touches_ground
from kitemj.flight.live import TICK, SteeredFlight
from kitemj.flight.pilot_settings import Guided
from kitemj.flight.scenario import Scenario
from kitemj.flight.simulate import Simulation, continuous
from kitemj.pilots.manoeuvres import Pilot
from kitemj.progress_bar import with_progress


def simulate_pilot(
    scenario: Scenario, pilot: Pilot, model: str = "mujoco", step: float = DEFAULT_STEP
) -> Simulation:
    """Flies `scenario`, tick by tick, until its end or the ground; its programme is left aside.

    The motions are those at the scenario's output interval [s], rounded to ticks, and the
    last. `step` [s] is the longest step of models with fixed steps.
    """
    flight, (duration, interval) = SteeredFlight(scenario, model, step=step), scenario.times
    result = flight.restart()
    motions, ending, note = [result.motion], Ending.FINISHED, ""
    told: list[Guided | None] = [None]
    ticks, every = max(1, round(duration / TICK)), max(1, round(interval / TICK))
    try:
        for tick in with_progress("flying", range(1, ticks + 1), ticks):
            result = flight.tick(pilot.command(result.motion))
            down = touches_ground(scenario.parameters, result.motion)
            if down or tick % every == 0 or tick == ticks:
                motions.append(result.motion)
                told.append(getattr(pilot, "guided", None))
            if down:
                ending = Ending.GROUND
                break
    except FlightError as error:
        ending, note = Ending.DIVERGED, str(error)
    motions = continuous(motions)
    told[0] = told[1] if len(told) > 1 else None  # of the first moment it tells with the first tick
    departure = first_departure(scenario.parameters, motions)
    guided = tuple(told[: len(motions)]) if any(told) else ()
    return Simulation(model, scenario, motions, ending, departure, note, guided)
