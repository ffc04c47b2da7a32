"""The panels of a first flight: the lesson with its advice, and how the kite met the ground.

The lesson lies at the foot of the picture, below the kite; the card in the sky, over a kite that
lies on the ground.
"""

import pygame

from kitemj.drawing.colours import CALL, DIM, GOOD, LEFT, RIGHT, TROUGH, WHITE, Colour
from kitemj.drawing.panel import Panel
from kitemj.drawing.text import width, wrapped
from kitemj.pilots.course import LessonStatus
from kitemj.pilots.crash import Touch

HEIGHT, CARD_EDGE = 116, 16  # units
GAP = 10  # units between things that lie above one another
SIZES = ((1, 20), (1, 18), (2, 20), (2, 18), (2, 16))
"""Lines that an advice takes at most, and its digits [units]: the first that fits."""
HIGH = 0.22  # of the room above and below it, the part above a card
SMALL = 16.0  # units, digits of the rest
LEADING = 1.6  # of lines, in digit heights
ARROWS = 84  # units at either end, for which way the stick should go
CHEVRONS = (0.1, 0.3, 0.7)  # of the stick's way, from which on each is lit
START_AGAIN, FLY_AGAIN = "R or the pad's A button starts again", "R or A flies again"
HINT = "N next   B again"


def paint_lesson(
    surface: pygame.Surface, room: pygame.Rect, unit: float, lesson: LessonStatus
) -> pygame.Rect:
    """Paints the lesson at the foot of `room` [px]; returns its box."""
    row = room.bottom - HEIGHT * unit
    panel = Panel(surface, (room.left, row, room.width / unit, HEIGHT), unit)
    panel.ground()
    middle, inner = panel.width / 2, panel.width - 2 * ARROWS
    number = f"Lesson {lesson.number} of {lesson.total}: " if lesson.number else ""
    panel.text(number + lesson.title, 16, 20, SMALL, DIM)
    panel.text(HINT, panel.width - 16, 20, SMALL, DIM, 1)
    advice = f"{lesson.advice}. {FLY_AGAIN}" if lesson.down else lesson.advice
    size, lines = _fitting(advice, inner, unit)
    colour = GOOD if lesson.praised else WHITE
    for i, line in enumerate(lines):
        below = (i - (len(lines) - 1) / 2) * size * LEADING
        panel.text(line, middle, 67 + below, size, colour, 0.5)
    _progress(panel, lesson)
    return panel.box


def beside(room: pygame.Rect, box: pygame.Rect, unit: float) -> pygame.Rect:
    """What is left of `room` [px] above or below `box`, whichever is more."""
    gap = round(GAP * unit)
    above, below = box.top - gap - room.top, room.bottom - box.bottom - gap
    top = room.top if above > below else box.bottom + gap
    return pygame.Rect(room.left, top, room.width, max(above, below))


def _fitting(text: str, inner: float, unit: float) -> tuple[float, tuple[str, ...]]:
    """The size [units] in which `text` fits into the `inner` [units] of a lesson; its lines."""
    for most, size in SIZES:
        lines = wrapped(text, inner * unit, size * unit)
        if len(lines) <= most:
            break
    return size, lines


def _progress(panel: Panel, lesson: LessonStatus) -> None:
    """Paints a bar along the foot, and at both ends which way the stick should go, by how much."""
    wide = panel.width - 32
    panel.bar(16, HEIGHT - 14, wide, 5, TROUGH)
    if lesson.progress > 0:
        panel.bar(16, HEIGHT - 14, min(lesson.progress, 1.0) * wide, 5, GOOD)
    for side, colour in ((-1.0, LEFT), (1.0, RIGHT)):
        edge = panel.width / 2 + side * (panel.width / 2 - ARROWS + 10)
        for i, least in enumerate(CHEVRONS):
            foot = edge + side * 19 * i
            points = [(foot, 67 - 13), (foot + side * 16, 67), (foot, 67 + 13)]
            panel.polygon(points, colour if lesson.push * side > least else TROUGH)


def paint_touch(
    surface: pygame.Surface,
    room: pygame.Rect,
    unit: float,
    touch: Touch,
    lesson: LessonStatus | None = None,
) -> pygame.Rect:
    """Paints what broke, how fast, where, what to do, high in `room` [px]; returns its box [px].

    A `lesson` that waits for another flight has its say on the card.
    """
    advice = START_AGAIN
    if lesson and lesson.down:
        advice = FLY_AGAIN if lesson.advice == touch.damage else f"{lesson.advice}. {FLY_AGAIN}"
    for unit in [share * unit for share in (1.0, 0.9, 0.8, 0.7)]:  # the first that fits
        lines = _card(touch, advice, room.width / unit - 2 * CARD_EDGE, unit)
        tall = sum(size * LEADING for _, size, _ in lines) + 2 * CARD_EDGE
        if tall * unit <= room.height:
            break
    wide = max(width(text, size * unit, True) for text, size, _ in lines) / unit + 2 * CARD_EDGE
    box = pygame.Rect(0, 0, round(wide * unit), round(tall * unit))
    box.midtop = surface.get_width() // 2, room.top + round(HIGH * max(room.height - box.height, 0))
    panel = Panel(surface, (box.left, box.top, wide, tall), unit)
    panel.ground()
    panel.bar(CARD_EDGE, 7, wide - 2 * CARD_EDGE, 3, GOOD if touch.gentle else CALL)
    row = float(CARD_EDGE)
    for text, size, shade in lines:
        bold = shade != WHITE
        panel.text(text, wide / 2, row + size * LEADING / 2, size, shade, 0.5, bold)
        row += size * LEADING
    return panel.box


def _card(touch: Touch, advice: str, inner: float, unit: float) -> list[tuple[str, float, Colour]]:
    """Lines not wider than `inner` [units]: text, size [units], colour."""
    guess = "" if touch.gentle else f" ({touch.reason})"
    said = (
        (touch.damage, 20.0, GOOD if touch.gentle else CALL),
        (f"First the {touch.part}, {touch.pace}, {touch.place}{guess}", SMALL, WHITE),
        (advice, 17.0, CALL),
    )
    return [
        (line, size, colour)
        for text, size, colour in said
        for line in wrapped(text, inner * unit, size * unit, True)
    ]
