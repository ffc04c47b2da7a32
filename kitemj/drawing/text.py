"""Text on a pygame surface: sizes are heights of digits in pixels; rendered strings are cached.

The font is DejaVu Sans, which matplotlib brings: digits of one width, so that numbers stand still.
"""

from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path

import pygame

from kitemj.drawing.colours import Colour

DIGIT = 0.73  # height of a digit in font sizes, of DejaVu Sans and of pygame's own
KEPT = 1024  # strings; a flight shows a few dozen at a time
FONTS = ("DejaVuSans.ttf", "DejaVuSans-Bold.ttf")


def put(
    surface: pygame.Surface,
    text: str,
    x: float,
    y: float,
    height: float,
    colour: Colour = (255, 255, 255),
    align: float = 0.0,
    bold: bool = False,
) -> None:
    """Writes a line of text.

    surface: the frame
    text: one line
    x: px from the left
    y: px from the top, of the digits' middle
    height: px, of a digit
    colour: red, green, blue (0..255)
    align: the part of the text's width that lies left of `x`: 0 starts there, 1 ends
    bold: whether its strokes are heavier
    """
    image = _rendered(text, round(height / DIGIT), colour, bold)
    surface.blit(image, (round(x - align * image.get_width()), round(y - image.get_height() / 2)))


@lru_cache(KEPT)
def width(text: str, height: float, bold: bool = False) -> int:
    """Width [px] that `text` takes."""
    return int(_font(round(height / DIGIT), bold).size(text)[0])


@lru_cache(KEPT)
def wrapped(text: str, room: float, height: float, bold: bool = False) -> tuple[str, ...]:
    """`text` in lines not wider than `room` [px], broken between words."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if width(longer, height, bold) > room and lines[-1]:
            lines.append(word)
        else:
            lines[-1] = longer
    return tuple(lines)


@lru_cache(KEPT)
def _rendered(text: str, size: int, colour: Colour, bold: bool) -> pygame.Surface:
    return _font(size, bold).render(text, True, colour)


@lru_cache(64)
def _font(size: int, bold: bool) -> pygame.font.Font:
    pygame.font.init()
    return pygame.font.Font(_file(bold), size)


@lru_cache(2)
def _file(bold: bool) -> Path:
    """The font's file; pygame's own where matplotlib was packed without fonts."""
    spec = find_spec("matplotlib")
    for folder in (spec.submodule_search_locations if spec else None) or ():
        file = Path(folder, "mpl-data", "fonts", "ttf", FONTS[bold])
        if file.exists():
            return file
    return Path(pygame.font.__file__).parent / pygame.font.get_default_font()
