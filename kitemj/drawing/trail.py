"""The kite's trail as a line in the picture: bright where it is new, fading where it is old."""

from math import tan

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.drawing.smooth import smooth_lines
from kitemj.physics.vectors import cross
from kitemj.scene.views import Camera

COLOUR = (255.0, 232.0, 120.0)
FAINT, BRIGHT = 0.12, 0.95  # opacity of the oldest and of the newest piece
LEAST_DEPTH = 0.5  # m before the camera


def seen(
    camera: Camera, points: NDArray[np.float64], box: pygame.Rect
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Columns and rows (n, 2) [px] of `points` (n, 3) [m, E] in `box`; which are before the eye.

    The same projection as `views.pixel`.
    """
    right = cross(camera.forward, camera.up)
    sight = points - np.array(camera.position)
    depth = sight @ np.array(camera.forward)
    before = depth > LEAST_DEPTH
    focal = box.height / 2 / tan(camera.field / 2) / np.where(before, depth, 1.0)
    columns = box.left + box.width / 2 - 0.5 + focal * (sight @ np.array(right))
    rows = box.top + box.height / 2 - 0.5 - focal * (sight @ np.array(camera.up))
    return np.stack([columns, rows], axis=1), before


def paint_trail(
    surface: pygame.Surface,
    places: NDArray[np.float64],
    usable: NDArray[np.bool_],
    box: pygame.Rect,
    width: float,
) -> None:
    """Paints a line through `places` (n, 2) [px], oldest first, `width` px wide, within `box`."""
    if len(places) < 2:
        return
    opacity = np.linspace(FAINT, BRIGHT, len(places) - 1)[:, None]
    colours = np.concatenate([np.tile(COLOUR, (len(opacity), 1)), opacity], axis=1)
    smooth_lines(surface, places, colours, width, box, usable)
