"""Plates: what instruments and words lie on, rounded and translucent; small smooth drawings."""

from collections.abc import Callable
from functools import lru_cache

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.drawing.colours import ALARM, CALL, INK, WHITE

QUIET, RECENT, NOW = 0, 1, 2
"""How loud a plate is: nothing wrong, a limit was crossed a moment ago, it is crossed."""

ROUND = 10.0  # units, the radius of a corner
OPACITY = 0.75  # of a plate; over white, white text has 9 : 1 on it and the palest colour 4.5 : 1
EDGE = 0.16  # opacity of the line around it
FINER = 4  # times: what is drawn so much larger and made smaller has smooth edges


def paint_plate(surface: pygame.Surface, box: pygame.Rect, unit: float, alarm: int = QUIET) -> None:
    """Paints a plate into `box` [px]: dark glass; with a bright edge; or a red field."""
    radius = max(round(ROUND * unit), 2)
    plate = _plate(box.size, radius, unit, alarm)
    if alarm != QUIET or not surface.get_rect().contains(box) or min(box.size) < 2 * radius:
        surface.blit(plate, box)
        return
    # numpy darkens the frame fifty times as fast as pygame blends; corners alone are blended
    r, (w, h) = radius, box.size
    pieces = [pygame.Rect(x, y, r, r) for x in (0, w - r) for y in (0, h - r)]
    corners = [surface.subsurface(piece.move(box.topleft)).copy() for piece in pieces]
    pixels = pygame.surfarray.pixels3d(surface)
    glass = pixels[box.left : box.right, box.top : box.bottom].transpose(1, 0, 2)
    glass >>= 2
    glass += _ink(w)
    line, bright = max(round(unit), 1), np.uint8(EDGE * 255)
    for rim in (glass[:line], glass[-line:], glass[line:-line, :line], glass[line:-line, -line:]):
        rim += bright
    del pixels, glass, rim  # they lock the surface
    for piece, corner in zip(pieces, corners, strict=True):
        corner.blit(plate, (0, 0), piece)
        surface.blit(corner, piece.move(box.topleft))


def paint_smoothly(
    surface: pygame.Surface, box: pygame.Rect, draw: Callable[[pygame.Surface, float], None]
) -> None:
    """Paints `smooth(box.size, draw)` into `box` [px]."""
    surface.blit(smooth(box.size, draw), box)


def smooth(size: tuple[int, int], draw: Callable[[pygame.Surface, float], None]) -> pygame.Surface:
    """A clear surface of `size` [px] with what `draw` draws, its edges smooth.

    `draw` is given a surface, and how many times as large it is.
    """
    large = pygame.Surface((FINER * size[0], FINER * size[1]), pygame.SRCALPHA)
    draw(large, FINER)
    return pygame.transform.smoothscale(large, size)


@lru_cache(32)
def _ink(width: int) -> NDArray[np.uint8]:
    """What a plate's own colour adds to a row of `width` darkened pixels."""
    return np.tile(np.array([OPACITY * c for c in INK], np.uint8), (width, 1))


@lru_cache(128)
def _plate(size: tuple[int, int], radius: int, unit: float, alarm: int) -> pygame.Surface:
    colour, opacity = (ALARM, 1.0) if alarm == NOW else (INK, OPACITY)
    edge, strong, wide = (WHITE, EDGE, unit) if alarm == QUIET else (CALL, 1.0, 2.5 * unit)

    def draw(large: pygame.Surface, finer: float) -> None:
        whole, corner = large.get_rect(), round(finer * radius)
        large.fill((*colour, 0))  # the colour of clear pixels is mixed in at the corners
        pygame.draw.rect(large, (*colour, round(255 * opacity)), whole, 0, corner)
        line = pygame.Surface(whole.size, pygame.SRCALPHA)
        thick = max(round(finer * wide), FINER)
        pygame.draw.rect(line, (*edge, round(255 * strong)), whole, thick, corner)
        large.blit(line, (0, 0))

    return smooth(size, draw)
