"""A panel: the box of the frame that an instrument is painted in, with its own scale.

All sizes are in pixels of a frame of 720 rows; the panel's unit makes them those of the frame.
"""

from collections.abc import Sequence

import pygame

from kitemj.drawing.colours import DIM, WHITE, Colour
from kitemj.drawing.plates import QUIET, paint_plate
from kitemj.drawing.text import put, width

NUMBER, NAME = 20, 15  # px of digit height in a frame of 720 rows
LARGE = 24  # of the number that is out of its limits
EDGE, GAP = 14.0, 8.0  # units: left and right of what is written; between a name and its value

Place = tuple[float, float, float, float]
"""x, y [px of the frame], width and height [units]."""


class Panel:
    """A box of the frame at (`x`, `y`) px; its own coordinates start there, in units of `unit`."""

    def __init__(self, surface: pygame.Surface, box: Place, unit: float) -> None:
        self.surface, self.unit = surface, unit
        self.x, self.y, self.width, self.height = box

    def ground(self, alarm: int = QUIET) -> None:
        """Paints the plate that it lies on: dark glass, or a red field when it alarms."""
        paint_plate(self.surface, self.box, self.unit, alarm)

    @property
    def box(self) -> pygame.Rect:
        """The box of the panel, in pixels of the frame."""
        return box_of((self.x, self.y, self.width, self.height), self.unit)

    def rect(self, x: float, y: float, width: float, height: float) -> pygame.Rect:
        """A rectangle of the panel in pixels of the frame."""
        u = self.unit
        return box_of((self.x + x * u, self.y + y * u, width, height), u)

    def at(self, x: float, y: float) -> tuple[float, float]:
        """A point of the panel in pixels of the frame."""
        return self.x + x * self.unit, self.y + y * self.unit

    def text(
        self,
        text: str,
        x: float,
        y: float,
        height: float = NAME,
        colour: Colour = DIM,
        align: float = 0.0,
        bold: bool = False,
    ) -> None:
        """Writes into the panel.

        text: one line
        x: units from the panel's left
        y: units from its top, of the digits' middle
        height: units, of a digit
        colour: red, green, blue (0..255)
        align: the part of the text's width that lies left of `x`: 0 starts there, 1 ends
        bold: whether its strokes are heavier
        """
        put(self.surface, text, *self.at(x, y), height * self.unit, colour, align, bold)

    def row(
        self,
        name: str,
        value: str,
        y: float,
        height: float = NUMBER,
        colour: Colour = WHITE,
        quiet: Colour = DIM,
    ) -> None:
        """Writes a name at the left and its value at the right, smaller where there is no room.

        name: what it is
        value: with its unit
        y: units from the panel's top, of the digits' middle
        height: units, of a digit of the value
        colour: of the value
        quiet: the colour of the name
        """
        height = self.fitting(value, height, self.width - 2 * EDGE - GAP - self.wide(name))
        self.text(name, EDGE, y, colour=quiet)
        self.text(value, self.width - EDGE, y, height, colour, 1)

    def fitting(self, text: str, height: float, room: float) -> float:
        """The digit height, up to `height`, in which `text` takes at most `room` [all in units]."""
        while self.wide(text, height) > room and height > 1.0:
            height *= 0.95
        return height

    def wide(self, text: str, height: float = NAME, bold: bool = False) -> float:
        """The width [units] that `text` takes."""
        return width(text, height * self.unit, bold) / self.unit

    def bar(self, x: float, y: float, width: float, height: float, colour: Colour) -> None:
        """Paints a filled rectangle."""
        self.surface.fill(colour, self.rect(x, y, width, height))

    def line(self, points: Sequence[tuple[float, float]], colour: Colour, width: float) -> None:
        """Paints a line through points of the panel."""
        places = [self.at(*point) for point in points]
        pygame.draw.lines(self.surface, colour, False, places, max(round(width * self.unit), 1))

    def polygon(self, points: Sequence[tuple[float, float]], colour: Colour) -> None:
        """Paints a filled polygon."""
        pygame.draw.polygon(self.surface, colour, [self.at(*point) for point in points])

    def dot(self, x: float, y: float, radius: float, colour: Colour) -> None:
        """Paints a filled circle."""
        pygame.draw.circle(self.surface, colour, self.at(x, y), max(radius * self.unit, 1.0))


def box_of(place: Place, unit: float) -> pygame.Rect:
    """The box of a place in whole pixels; neighbours share an edge."""
    x, y, width, height = place
    left, top = round(x), round(y)
    right, bottom = round(x + width * unit), round(y + height * unit)
    return pygame.Rect(left, top, max(right - left, 1), max(bottom - top, 1))
