"""Alarms: the limit that is or was crossed, the instrument that shows it, how loud it is."""

from typing import NamedTuple

from kitemj.drawing.plates import NOW, QUIET, RECENT
from kitemj.dynamics.motion import Motion
from kitemj.flight.limits import LIMITS, Departure, departure_at
from kitemj.physics.parameters import Parameters

HELD = 6.0
"""s; how long the reason stays on the screen after the flight is back within its limits."""

INSTRUMENT = {
    "ground": "flight",
    "slack": "lines",
    "stall": "air",
    "sideslip": "air",
    "overload": "lines",
    "twist": "model",
}
"""The instrument that shows each limit."""

STEADY = 0.4
"""s; how long an alarm stays loud: a limit that is crossed every other tick must not flash."""


class Alarm(NamedTuple):
    """A limit that is or was crossed, `age` [s] ago."""

    departure: Departure
    age: float = 0.0


def alarm_at(parameters: Parameters, motion: Motion, twist: float = 0.0) -> Alarm | None:
    """The gravest limit that is crossed at this instant; `twist` [rad] of the lines."""
    departure = departure_at(parameters, motion, LIMITS, twist)
    return Alarm(departure) if departure else None


def loudness(alarm: Alarm | None, instrument: str) -> int:
    """How an instrument is to be painted: QUIET, RECENT or NOW."""
    if alarm is None or alarm.age > HELD or INSTRUMENT[alarm.departure.limit.name] != instrument:
        return QUIET
    return volume(alarm)


def volume(alarm: Alarm) -> int:
    """How loud an alarm is where it is told: RECENT or NOW."""
    return NOW if alarm.age < STEADY else RECENT
