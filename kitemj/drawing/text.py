"""Text on a pygame surface: sizes are heights of digits in pixels; rendered strings are cached."""

from functools import lru_cache
from pathlib import Path

import pygame

from kitemj.drawing.colours import Colour

DIGIT = 0.73  # height of a digit in font sizes, of the font that pygame brings
KEPT = 1024  # strings; a flight shows a few dozen at a time


def put(
    surface: pygame.Surface,
    text: str,
    x: float,
    y: float,
    height: float,
    colour: Colour = (255, 255, 255),
    align: float = 0.0,
) -> None:
    """Writes a line of text.

    surface: the frame
    text: one line
    x: px from the left
    y: px from the top, of the digits' middle
    height: px, of a digit
    colour: red, green, blue (0..255)
    align: the part of the text's width that lies left of `x`: 0 starts there, 1 ends
    """
    image = _rendered(text, round(height / DIGIT), colour)
    surface.blit(image, (round(x - align * image.get_width()), round(y - image.get_height() / 2)))


@lru_cache(KEPT)
def width(text: str, height: float) -> int:
    """Width [px] that `text` takes."""
    return int(_font(round(height / DIGIT)).size(text)[0])


@lru_cache(KEPT)
def wrapped(text: str, room: float, height: float) -> tuple[str, ...]:
    """`text` in lines not wider than `room` [px], broken between words."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if width(longer, height) > room and lines[-1]:
            lines.append(word)
        else:
            lines[-1] = longer
    return tuple(lines)


@lru_cache(KEPT)
def _rendered(text: str, size: int, colour: Colour) -> pygame.Surface:
    return _font(size).render(text, True, colour)


@lru_cache(32)
def _font(size: int) -> pygame.font.Font:
    pygame.font.init()
    file = Path(pygame.font.__file__).parent / pygame.font.get_default_font()
    return pygame.font.Font(file, size)
