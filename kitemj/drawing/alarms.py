"""Alarms: the limit that is crossed, the instrument that shows it, the text of the banner."""

from typing import NamedTuple

import pygame

from kitemj.drawing.colours import ALARM, CALL, INK, WHITE, Colour
from kitemj.drawing.panel import NOW, QUIET, RECENT
from kitemj.drawing.text import put, width, wrapped
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

LEADING = 17  # px of 720 rows between lines of the banner


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
    return NOW if alarm.age == 0.0 else RECENT


def paint_banner(
    surface: pygame.Surface,
    room: pygame.Rect,
    unit: float,
    alarm: Alarm | None,
    message: str,
    top: bool,
) -> pygame.Rect:
    """Paints the message and the reason of the alarm; returns the box [px], empty for neither.

    surface: the frame
    room: px, where the banner may be
    unit: px, the size of a unit
    alarm: the limit that is or was crossed; None: no alarm
    message: a sentence; empty: none
    top: whether it stands at the top of `room` or at its foot
    """
    inner = room.width - 24 * unit
    lines: list[tuple[str, float, Colour, Colour]] = []

    def say(text: str, size: float, colour: Colour, field: Colour) -> None:
        lines.extend((part, size, colour, field) for part in wrapped(text, inner, size * unit))

    if message and not (alarm and message == alarm.departure.limit.sentence):
        say(message, 20, CALL, INK)
    if alarm and alarm.age <= HELD:
        _, limit, reading = alarm.departure
        colours, ago = (WHITE, ALARM), ""
        if alarm.age > 0.0:
            colours, ago = (CALL, INK), f"{max(round(alarm.age), 1)} s ago: "
        say(f"{limit.name.upper()}: {reading}", 23, *colours)
        say(ago + limit.sentence, 18, *colours)
    wide = max((width(text, size * unit) for text, size, _, _ in lines), default=0) + 24 * unit
    tall = sum(size + LEADING for _, size, _, _ in lines) * unit
    whole = pygame.Rect(0, 0, round(wide) if lines else 0, round(tall))
    whole.midtop = (room.centerx, room.top if top else round(room.bottom - tall))
    row = float(whole.top)
    for text, size, colour, field in lines:
        tall = (size + LEADING) * unit
        box = pygame.Rect(0, round(row), round(wide), round(row + tall) - round(row))
        box.centerx = room.centerx
        surface.fill(field, box)
        put(surface, text, room.centerx, row + tall / 2, size * unit, colour, 0.5)
        row += tall
    return whole
