"""The panels of a first flight: the lesson with its advice, and how the kite met the ground.

Both lie between the panels at the sides: the lesson where the kite is not, the card of a
touch in the middle.
"""

import pygame

from kitemj.drawing.colours import CALL, DIM, GOOD, INK, LEFT, RIGHT, TROUGH, WHITE, Colour
from kitemj.drawing.panel import NAME, Panel
from kitemj.drawing.text import width, wrapped
from kitemj.pilots.course import LessonStatus
from kitemj.pilots.crash import Touch

HEIGHT, CARD_EDGE = 160, 14  # units
GAP = 8  # units between things that lie above one another
SIZES = (26, 24, 22, 20, 18)  # of the advice, the first that fits in two lines
LEADING = 1.45  # of lines, in digit heights
CHEVRONS = (0.1, 0.3, 0.7)  # of the stick's way, from which on each is lit
START_AGAIN, FLY_AGAIN = "R or the pad's A button starts again", "R or A flies again"
HINT = "N: next   B: begin again   Shift + key: fully"


def paint_lesson(
    surface: pygame.Surface, room: pygame.Rect, unit: float, lesson: LessonStatus, top: bool
) -> pygame.Rect:
    """Paints the lesson at the top or the foot of `room` [px]; returns its box."""
    row = float(room.top if top else room.bottom - HEIGHT * unit)
    panel = Panel(surface, (room.left, row, room.width / unit, HEIGHT), unit)
    panel.ground()
    middle, inner = panel.width / 2, panel.width - 28
    number = f"Lesson {lesson.number} of {lesson.total}  ·  " if lesson.number else ""
    panel.text(number + lesson.title, middle, 20, NAME, WHITE, 0.5)
    panel.text(HINT, middle, HEIGHT - 16, NAME - 3, align=0.5)
    advice = f"{lesson.advice}. {FLY_AGAIN}" if lesson.down else lesson.advice
    size, lines = _fitting(advice, inner, unit)
    colour = GOOD if lesson.praised else WHITE
    for i, line in enumerate(lines):
        below = (i - (len(lines) - 1) / 2) * size * LEADING
        panel.text(line, middle, 68 + below, size, colour, 0.5)
    _progress(panel, lesson)
    return panel.box


def beside(room: pygame.Rect, box: pygame.Rect, unit: float) -> pygame.Rect:
    """What is left of `room` [px] above or below `box`, whichever is more."""
    gap = round(GAP * unit)
    above, below = box.top - gap - room.top, room.bottom - box.bottom - gap
    top = room.top if above > below else box.bottom + gap
    return pygame.Rect(room.left, top, room.width, max(above, below))


def _fitting(text: str, inner: float, unit: float) -> tuple[float, tuple[str, ...]]:
    """The largest size [units] in which `text` takes two lines, or the smallest; the lines."""
    for size in SIZES:
        lines = wrapped(text, inner * unit, size * unit)
        if len(lines) <= 2:
            break
    return size, lines


def _progress(panel: Panel, lesson: LessonStatus) -> None:
    """Paints a bar, and at its ends which way the stick should go, by how much."""
    row, left, wide = 112, 84.0, panel.width - 168
    panel.bar(left, row, wide, 10, TROUGH)
    if lesson.progress > 0:
        panel.bar(left, row, min(lesson.progress, 1.0) * wide, 10, GOOD)
    for side, colour in ((-1.0, LEFT), (1.0, RIGHT)):
        edge = left - 14 if side < 0 else left + wide + 14
        for i, least in enumerate(CHEVRONS):
            foot = edge + side * 18 * i
            points = [(foot, row - 6), (foot + side * 13, row + 5), (foot, row + 16)]
            panel.polygon(points, colour if lesson.push * side > least else TROUGH)


def paint_touch(
    surface: pygame.Surface, room: pygame.Rect, unit: float, touch: Touch
) -> pygame.Rect:
    """Paints what broke, how fast, where, what to do, in the middle of `room`; its box [px]."""
    for unit in [share * unit for share in (1.0, 0.9, 0.8, 0.7)]:  # the first that fits
        lines = _card(touch, room.width / unit - 2 * CARD_EDGE, unit)
        tall = sum(size * LEADING for _, size, _ in lines) + 2 * CARD_EDGE
        if tall * unit <= room.height:
            break
    wide = max(width(text, size * unit) for text, size, _ in lines) / unit + 2 * CARD_EDGE
    corner = room.centerx - wide * unit / 2, room.centery - tall * unit / 2
    panel = Panel(surface, (*corner, wide, tall), unit)
    surface.fill(INK, panel.box)
    edge = GOOD if touch.gentle else CALL
    pygame.draw.rect(surface, edge, panel.box, max(round(3 * unit), 1))
    row = float(CARD_EDGE)
    for text, size, shade in lines:
        panel.text(text, wide / 2, row + size * LEADING / 2, size, shade, 0.5)
        row += size * LEADING
    return panel.box


def _card(touch: Touch, inner: float, unit: float) -> list[tuple[str, float, Colour]]:
    """Lines not wider than `inner` [units]: text, size [units], colour."""
    said = [(touch.damage, 30.0, GOOD if touch.gentle else CALL)]
    if not touch.gentle:
        said.append((touch.reason, 16.0, DIM))
    facts = (f"First the {touch.part}", touch.pace, touch.place)
    said += [*((fact, 18.0, WHITE) for fact in facts), (START_AGAIN, 20.0, CALL)]
    return [
        (line, size, colour)
        for text, size, colour in said
        for line in wrapped(text, inner * unit, size * unit)
    ]
