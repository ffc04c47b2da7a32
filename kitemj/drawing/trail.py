"""The kite's trail as a ribbon: wide and bright where it is new, thin and faint where it is old."""

from math import tan

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.drawing.smooth import smooth_lines
from kitemj.drawing.tensions import Scale
from kitemj.physics.vectors import cross
from kitemj.scene.views import Camera

PALE = (255.0, 244.0, 214.0)
HEAT = np.array([(74.0, 116, 214), (98, 206, 196), (248, 238, 150), (250, 158, 62), (222, 46, 46)])
"""Colours of a pull, from none to the end of the bars that show it."""
FAINT, BRIGHT = 0.05, 0.9  # opacity of the oldest and of the newest piece
THIN = 0.35  # part of the width that the oldest piece has
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


def pull_colours(pull: NDArray[np.float64], scale: Scale) -> NDArray[np.float64]:
    """The colours (n, 3) of what a line pulls (n,) [N]: cold without, red at the bars' end."""
    share = np.sqrt(np.clip(pull / scale.full, 0.0, 1.0)) * (len(HEAT) - 1)
    return np.stack([np.interp(share, range(len(HEAT)), hue) for hue in HEAT.T], axis=1)


def paint_trail(
    surface: pygame.Surface,
    places: NDArray[np.float64],
    usable: NDArray[np.bool_],
    box: pygame.Rect,
    width: float,
    colours: NDArray[np.float64] | None = None,
    bright: float = BRIGHT,
) -> None:
    """Paints a ribbon within `box`.

    surface: the frame
    places: (n, 2) px, the points it leads through, oldest first
    usable: (n,) pieces with an end that is not usable are left out
    box: px; nothing is painted outside
    width: px, of its newest piece
    colours: (n, 3) red, green, blue (0..255) of each point; None: pale
    bright: opacity of its newest piece
    """
    if len(places) < 2:
        return
    age = np.linspace(0.0, 1.0, len(places) - 1)
    hue = np.tile(PALE, (len(age), 1)) if colours is None else colours[1:]
    opacity = FAINT + (bright - FAINT) * age**1.5
    painted = np.concatenate([hue, opacity[:, None]], axis=1)
    smooth_lines(surface, places, painted, width * (THIN + (1 - THIN) * age), box, usable)
