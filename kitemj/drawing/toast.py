"""Toasts: what is wrong and what to do, on small plates over each other."""

import pygame

from kitemj.drawing.alarms import HELD, Alarm, volume
from kitemj.drawing.colours import ALARM, CALL, INK, WHITE, Colour
from kitemj.drawing.panel import Panel
from kitemj.drawing.plates import NOW, QUIET
from kitemj.drawing.text import width, wrapped

PAD, LEADING = 12, 1.5  # units around the words; of lines, in digit heights
SIGN = 34  # units left of the words, for the sign
LOUD, PLAIN = 18.0, 16.0  # units, digits of what to do and of the rest


def paint_message(
    surface: pygame.Surface, room: pygame.Rect, unit: float, text: str, top: bool = False
) -> pygame.Rect:
    """Paints a sentence at the foot of `room` [px], or its top; returns its box."""
    inner = (room.width / unit - 2 * PAD) * unit
    lines = [(line, PLAIN, WHITE, False) for line in wrapped(text, inner, PLAIN * unit)]
    return _paint(surface, room, unit, lines, top)


def paint_alarm(
    surface: pygame.Surface,
    room: pygame.Rect,
    unit: float,
    alarm: Alarm,
    numbers: bool = False,
    top: bool = False,
) -> pygame.Rect:
    """Paints an alarm; returns its box.

    surface: the frame
    room: px, where it may be
    unit: px, the size of a unit
    alarm: the limit that is or was crossed
    numbers: whether it says by how much, and how long ago
    top: whether it stands at the top of `room` or at its foot
    """
    _, limit, reading = alarm.departure
    inner, how_loud = (room.width / unit - 2 * PAD - SIGN) * unit, volume(alarm)
    colour = WHITE if how_loud == NOW else CALL
    said = f"{limit.name.upper()}: {limit.advice}"
    lines = [(line, LOUD, colour, True) for line in wrapped(said, inner, LOUD * unit, True)]
    if numbers:
        ago = f"{max(round(alarm.age), 1)} s ago: " if how_loud != NOW else ""
        why = f"{ago}{limit.sentence} ({reading})"
        lines += [(line, PLAIN, WHITE, False) for line in wrapped(why, inner, PLAIN * unit)]
    return _paint(surface, room, unit, lines, top, how_loud, SIGN)


def told(alarm: Alarm | None) -> Alarm | None:
    """The alarm while it is to be told."""
    return alarm if alarm and alarm.age <= HELD else None


def _paint(
    surface: pygame.Surface,
    room: pygame.Rect,
    unit: float,
    lines: list[tuple[str, float, Colour, bool]],
    top: bool,
    alarm: int = QUIET,
    sign: float = 0.0,
) -> pygame.Rect:
    """Paints a plate with lines, and returns its box [px].

    surface: the frame
    room: px, where it may be
    unit: px, the size of a unit
    lines: text, height of a digit [units], colour, whether it is bold
    top: whether it stands at the top of `room` or at its foot
    alarm: how loud it is
    sign: units, room for a sign before the lines; 0: there is none
    """
    wide = max(width(text, size * unit, bold) for text, size, _, bold in lines) / unit
    wide += 2 * PAD + sign
    tall = sum(LEADING * size for _, size, *_ in lines) + 2 * PAD - 6
    box = pygame.Rect(0, 0, round(wide * unit), round(tall * unit))
    box.midbottom = surface.get_width() // 2, room.bottom
    if top:
        box.top = room.top
    box.clamp_ip(room)
    panel = Panel(surface, (box.left, box.top, wide, tall), unit)
    panel.ground(alarm)
    if sign:
        _sign(panel, PAD + 11, tall / 2, ALARM if alarm == NOW else INK)
    row = PAD - 3.0
    for text, size, colour, bold in lines:
        row += LEADING * size
        panel.text(text, PAD + sign, row - LEADING * size / 2, size, colour, bold=bold)
    return panel.box


def _sign(panel: Panel, x: float, y: float, ink: Colour) -> None:
    """Paints a triangle with a stroke in it: something is wrong."""
    panel.polygon([(x, y - 12), (x + 13, y + 11), (x - 13, y + 11)], CALL)
    panel.bar(x - 1.5, y - 4, 3, 8, ink)
    panel.bar(x - 1.5, y + 6, 3, 3, ink)
