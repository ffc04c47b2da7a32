"""The autopilots of a live flight, one for each thing that they can fly, made before it begins."""

from copy import deepcopy

from kitemj.autopilot.autopilot import Autopilot
from kitemj.autopilot.drift_hold import DriftPilot
from kitemj.autopilot.guided_flight import pilot_of
from kitemj.errors import FlightError, InputError
from kitemj.flight.live import SteeredFlight
from kitemj.flight.pilot_settings import PilotSettings
from kitemj.paths.check_path import usual_path
from kitemj.physics.parameters import Parameters
from kitemj.realtime.messages import Offer

TRIED = 300
"""Ticks that each flies beforehand, so that nothing is compiled or loaded in a tick that counts."""
FIGURES = ("eight", "circle", "hold", "land")


def autopilots(
    flight: SteeredFlight,
) -> tuple[dict[str, Autopilot | DriftPilot], dict[str, Offer]]:
    """Those that can fly, and what is offered to the person, in the order of going round.

    What the scenario of `flight` says comes first, if it says anything. The flight is flown for it,
    and begins anew. Raises InputError where the scenario says what cannot be flown.
    """
    made, offers = dict[str, Autopilot | DriftPilot](), dict[str, Offer]()
    if flight.scenario.pilot:
        made["scenario"] = pilot_of(flight.scenario)
    eight: Autopilot | str | None = None
    for figure in FIGURES:
        try:
            if isinstance(eight, str) and not flight.parameters.stick.mirrored:
                raise InputError(eight)  # of the kite itself, or its wind
            made[figure] = pilot = _made(figure, flight.parameters, eight)
            if figure == "eight" and isinstance(pilot, Autopilot):
                eight = pilot
        except InputError as error:
            offers[figure] = Offer(fault=str(error))
            eight = eight or str(error)
    for name, pilot in made.items():
        _tried(flight, pilot)
        offers[name] = Offer()
        if isinstance(pilot, Autopilot) and "path" in pilot.settings.phases:
            offers[name] = Offer(pilot.path.points)
    flight.restart()
    order = ("scenario", *FIGURES)
    return made, {name: offers[name] for name in order if name in offers}


def _made(
    figure: str, parameters: Parameters, eight: Autopilot | str | None
) -> Autopilot | DriftPilot:
    """One that flies a `figure`; what the pilot of the `eight` knows of the kite is known."""
    alone = PilotSettings(("hold",) if figure == "hold" else ("land",))
    figures = figure in ("eight", "circle")
    if parameters.stick.mirrored:
        return DriftPilot(parameters, PilotSettings() if figures else alone)
    if not isinstance(eight, Autopilot):
        return Autopilot(parameters, PilotSettings() if figures else alone)
    if figures:
        circle = usual_path(parameters, eight.law, "circle")
        return Autopilot(parameters, PilotSettings(path=circle), eight.law)
    pilot = deepcopy(eight)  # which takes no time; the path does not matter
    pilot.settings, pilot.kite = alone, pilot.kite._replace(settings=alone)
    return pilot


def _tried(flight: SteeredFlight, pilot: Autopilot | DriftPilot) -> None:
    """Flies for a while, as it is going to."""
    motion = flight.restart().motion
    pilot.restart(motion.t)
    try:
        for _ in range(TRIED):
            motion = flight.tick(pilot.command(motion)).motion
    except FlightError:
        pass  # who begins a flight in such a place is told then
