"""The title page over a picture: a name, what can be chosen, and how."""

from functools import lru_cache

import numpy as np
import pygame

from kitemj.cockpit.menu import Entry, Menu
from kitemj.drawing.colours import CALL, DIM, WHITE, Colour
from kitemj.drawing.text import put, width, wrapped

NAME, SAYS = "kitemj", "a kite on two lines, in your hands"
HINT = "Enter, A or a click chooses;  Esc leaves"
LEFT = 92  # units of a frame of 720 rows, as all sizes here
NAME_ROW, SAYS_ROW, FIRST_ROW, STEP, TOLD_ROW, HINT_ROW = 138, 212, 312, 56, 598, 676
LARGE, USUAL, SMALL, LEAST = 74, 26, 17, 9  # heights of digits; px that the smallest takes
SHUT: Colour = (166, 174, 184)
ROOM, SHADED = 0.4, 0.74
"""Parts of the width: text keeps to the first, and the shade below it ends at the second."""
DARK = 0.76
"""Of the light that the shade takes: what is written stays legible before a white cloud."""


def paint_title(surface: pygame.Surface, menu: Menu, message: str = "") -> list[pygame.Rect]:
    """Paints the page over a frame; returns the boxes [px] of the entries.

    `message`: a sentence that the person should read; empty: none.
    """
    unit = surface.get_height() / 720
    surface.blit(_shade(surface.get_size()), (0, 0))
    _spaced(surface, NAME, LEFT * unit, NAME_ROW * unit, LARGE * unit)
    small = max(SMALL * unit, LEAST)
    put(surface, SAYS, (LEFT + 4) * unit, SAYS_ROW * unit, small, DIM)
    boxes = []
    for i, entry in enumerate(menu.entries):
        row = (FIRST_ROW + STEP * i) * unit
        _entry(surface, entry, row, unit, i == menu.marked)
        wide, tall = round(ROOM * surface.get_width()), round(STEP * unit)
        boxes.append(pygame.Rect(0, round(row - tall / 2), wide, tall))
    put(surface, HINT, LEFT * unit, HINT_ROW * unit, max(15 * unit, LEAST), DIM)
    told, colour = (message, CALL) if message else (menu.entry.says, WHITE)
    for i, line in enumerate(wrapped(told, ROOM * surface.get_width() - LEFT * unit, small)):
        put(surface, line, LEFT * unit, TOLD_ROW * unit + 1.5 * i * small, small, colour)
    return boxes


def _entry(surface: pygame.Surface, entry: Entry, row: float, unit: float, marked: bool) -> None:
    size, colour = USUAL * unit, WHITE if marked else DIM if entry.open else SHUT
    left = LEFT * unit
    if marked:
        bar = pygame.Rect(0, 0, round(5 * unit), round(36 * unit))
        bar.midleft = (round(left - 26 * unit), round(row))
        surface.fill(CALL, bar)
    put(surface, entry.label, left, row, size, colour)
    x = left + width(entry.label, size) + 22 * unit
    if entry.offers:
        shade = CALL if marked else DIM
        for x_tip, way in ((x, -1), (x + 44 * unit + width(entry.offered, size), 1)):
            tip = (x_tip + 5 * way * unit, row)
            feet = [(x_tip - 5 * way * unit, row + dy * unit) for dy in (-8, 8)]
            pygame.draw.polygon(surface, shade, [tip, *feet])
        put(surface, entry.offered, x + 22 * unit, row, size, colour)


def _spaced(surface: pygame.Surface, text: str, x: float, y: float, height: float) -> None:
    """Writes large letters with room between them."""
    for letter in text:
        put(surface, letter, x, y, height, WHITE)
        x += width(letter, height) + 0.07 * height


@lru_cache(2)
def _shade(size: tuple[int, int]) -> pygame.Surface:
    """A shade that falls from the left, so that text is read over any sky."""
    wide = size[0]
    shade = pygame.Surface(size, pygame.SRCALPHA)
    shade.fill((8, 12, 20, 0))
    across = np.clip((np.arange(wide) / wide - ROOM) / (SHADED - ROOM), 0.0, 1.0)
    falls = 1.0 - across * across * (3.0 - 2.0 * across)
    alpha = pygame.surfarray.pixels_alpha(shade)
    alpha[:] = np.round(255 * DARK * falls)[:, None]
    del alpha  # it locks the surface
    return shade
