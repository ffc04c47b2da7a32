"""The path that an autopilot is to fly, drawn in the sky, and the point on it that it flies to."""

from math import ceil, tan

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.drawing.plates import paint_smoothly
from kitemj.drawing.smooth import smooth_lines
from kitemj.drawing.trail import seen
from kitemj.drawing.wished import Wished, in_E
from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import minus, norm
from kitemj.scene.views import Camera, downwind, pixel

PATH, SHADE = (150, 255, 205), (10, 40, 38)
"""The line, and what is below it: one of the two is seen against anything."""
WIDTH, EDGE = 2.6, 2.4
"""units; of the line, and by how much the shade is wider."""
DASH, GAP = 5, 3
"""pieces of a path of 240."""
PIECES = 240
MARK = 6.0
"""units; the radius of the point that is flown to."""
CLEAR = 0.6
"""spans around the kite, where it would be written across it: it has no depth."""


def paint_sky_path(
    surface: pygame.Surface,
    camera: Camera,
    parameters: Parameters,
    wished: Wished,
    motion: Motion,
    unit: float,
) -> None:
    """Paints the path at the lines' length, dashed, and its attractor; not over the kite.

    surface: the frame
    camera: that of the view
    parameters: of the set that flies
    wished: the path
    motion: the kite, which is in front
    unit: px, the size of a unit
    """
    wind, whole = downwind(parameters), surface.get_rect()
    if wished.path is not None:
        points = wished.path[:: max(len(wished.path) // PIECES, 1)]
        points = np.concatenate([points, points[:1]])
        places, usable = placed(camera, parameters, in_E(wind, points), whole)
        usable &= _beside_kite(camera, parameters, motion, places, whole)
        dashes = np.arange(len(points) - 1) % (DASH + GAP) < DASH
        for colour, width in ((SHADE, WIDTH + EDGE), (PATH, WIDTH)):
            opacity = wished.opacity * dashes
            colours = np.column_stack([np.tile(colour, (len(dashes), 1)), opacity])
            smooth_lines(surface, places, colours, width * unit, whole, usable)
    if wished.attractor is not None:
        (place,), (before,) = placed(camera, parameters, in_E(wind, wished.attractor), whole)
        if before:
            paint_mark(surface, place, MARK * unit, whole)


def placed(
    camera: Camera, parameters: Parameters, directions: NDArray[np.float64], box: pygame.Rect
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Where directions (n, 3) [E] are seen at the lines' length, as `seen`."""
    return seen(camera, parameters.lines.length * directions, box)


def paint_mark(
    surface: pygame.Surface, place: NDArray[np.float64], radius: float, inside: pygame.Rect
) -> None:
    """Paints a small ring around `place` [px] where it is `inside` a box."""
    column, row = float(place[0]), float(place[1])
    if not inside.collidepoint(column, row):
        return
    reach = ceil(radius) + 2
    box = pygame.Rect(round(column) - reach, round(row) - reach, 2 * reach, 2 * reach)

    def draw(large: pygame.Surface, finer: float) -> None:
        middle = (column - box.left + 0.5) * finer, (row - box.top + 0.5) * finer
        pygame.draw.circle(large, SHADE, middle, radius * finer)
        pygame.draw.circle(large, PATH, middle, 0.78 * radius * finer)
        pygame.draw.circle(large, SHADE, middle, 0.36 * radius * finer)

    paint_smoothly(surface, box, draw)


def _beside_kite(
    camera: Camera,
    parameters: Parameters,
    motion: Motion,
    places: NDArray[np.float64],
    box: pygame.Rect,
) -> NDArray[np.bool_]:
    """Which `places` (n, 2) [px] are not where the kite is seen."""
    G = motion.body.p_G_E
    at, far = pixel(camera, G, box.width, box.height), norm(minus(G, camera.position))
    if at.depth <= 0.0:
        return np.full(len(places), True)
    size = CLEAR * parameters.kite.span * box.height / 2 / tan(camera.field / 2) / max(far, 0.1)
    return np.asarray(np.hypot(places[:, 0] - at.column, places[:, 1] - at.row) > size)
