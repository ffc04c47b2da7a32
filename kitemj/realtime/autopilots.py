"""The autopilots of a live flight, one for each thing that they can fly, made before it begins."""

from copy import deepcopy

from kitemj.autopilot.autopilot import Autopilot
from kitemj.errors import FlightError, InputError
from kitemj.flight.live import SteeredFlight
from kitemj.flight.pilot_settings import PilotSettings, TurnRateLaw
from kitemj.paths.check_path import usual_path
from kitemj.physics.parameters import Parameters
from kitemj.realtime.messages import Offer

TRIED = 300
"""Ticks that each flies beforehand, so that nothing is compiled or loaded in a tick that counts."""


def autopilots(flight: SteeredFlight) -> tuple[dict[str, Autopilot], dict[str, Offer]]:
    """Those that can fly, and what is offered to the person, in the order of going round.

    What the scenario of `flight` says comes first, if it says anything. The flight is flown for it,
    and begins anew.
    """
    made, offers = dict[str, Autopilot](), dict[str, Offer]()
    asked, fault = flight.scenario.pilot, ""
    for flown in (*(("scenario",) if asked else ()), "eight", "circle", "hold", "land"):
        if fault:  # of the kite itself
            offers[flown] = Offer(fault=fault)
            continue
        try:
            pilot = _made(flown, flight.parameters, asked, made)
        except InputError as error:
            if flown == "scenario":
                raise
            offers[flown] = Offer(fault=str(error))
            fault = "" if made else str(error)
            continue
        _tried(flight, pilot)
        made[flown] = pilot
        along = "path" in pilot.settings.phases
        offers[flown] = Offer(pilot.path.points if along else None)
    flight.restart()
    return made, offers


def _made(
    flown: str, parameters: Parameters, asked: PilotSettings | None, made: dict[str, Autopilot]
) -> Autopilot:
    """One that flies what `flown` names; what those `made` before know of the kite is known."""
    if flown == "scenario":
        assert asked
        return Autopilot(parameters, asked)
    law = next((pilot.law for pilot in made.values()), None)
    if flown in ("hold", "land"):
        settings = PilotSettings(("hold",) if flown == "hold" else ("land",))
        return _with_phases(made.get("eight"), parameters, settings, law)
    if flown == "circle" and law:
        circle = usual_path(parameters, law, "circle")
        return Autopilot(parameters, PilotSettings(path=circle), law)
    return Autopilot(parameters, PilotSettings(), law)


def _with_phases(
    other: Autopilot | None,
    parameters: Parameters,
    settings: PilotSettings,
    law: TurnRateLaw | None,
) -> Autopilot:
    """One with these settings, whose path does not matter: a copy of an `other` if there is one."""
    if other is None:
        return Autopilot(parameters, settings, law)
    pilot = deepcopy(other)
    pilot.settings, pilot.kite = settings, pilot.kite._replace(settings=settings)
    pilot.restart(0.0)
    return pilot


def _tried(flight: SteeredFlight, pilot: Autopilot) -> None:
    """Flies for a while, as it is going to."""
    motion = flight.restart().motion
    pilot.restart(motion.t)
    try:
        for _ in range(TRIED):
            motion = flight.tick(pilot.command(motion)).motion
    except FlightError:
        pass  # who begins a flight in such a place is told then
