"""The wind window: the quarter-sphere of the lines as the pilot sees it, the kite and its trail.

An equidistant projection about the downwind direction: the distance from the middle of the
ground line is the angle from the wind, so the rim is the edge of the window and a kite that
overflies it is seen outside. Left is the pilot's left.
"""

from functools import lru_cache
from math import acos, cos, degrees, hypot, pi, radians, sin

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.drawing.colours import CALL, LEFT, RIGHT, WHITE, Colour
from kitemj.drawing.panel import Panel
from kitemj.drawing.plates import paint_smoothly, smooth
from kitemj.drawing.sky_path import PATH, paint_mark
from kitemj.drawing.smooth import smooth_lines
from kitemj.drawing.trail import paint_trail
from kitemj.drawing.wished import Wished, in_E
from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, cross, dot, minus, norm, plus, times
from kitemj.scene.views import UP, downwind

WIDTH, HEIGHT = 292, 188
FOOT = (146.0, 158.0)  # of the pilot: the middle of the ground line
RADIUS = 118.0  # of the rim, 90° from the wind
RIM: Colour = (226, 234, 244)
GRID, AROUND = 70, 1.5  # opacity 0..255 of the net; width of the rim and of the ground
NO_TRAIL = np.empty((0, 3))
OUTSIDE, LOWEST = 6.0, FOOT[1] - 4.0  # how far beyond the rim, how low the kite is painted
NOSE, WING = 15.0, 11.0  # of the kite's mark, from its middle


class WindWindow:
    """The instrument for one parameter set; places are in units of the panel."""

    def __init__(self, parameters: Parameters) -> None:
        wind = downwind(parameters)
        self._wind, self._left = wind, cross(UP, wind)

    def place(self, p_E: Vector) -> tuple[float, float]:
        """The place of the point `p_E` [m, E] in the panel."""
        size = max(norm(p_E), 1e-9)
        return _spot(*(dot(p_E, axis) / size for axis in (self._wind, self._left, UP)))

    def places(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """The same for many points (n, 3): (n, 2)."""
        axes = np.array([self._wind, self._left, UP])
        size = np.maximum(np.linalg.norm(points, axis=1), 1e-9)
        ahead, left, up = axes @ points.T / size
        away = np.arccos(np.clip(ahead, -1.0, 1.0)) / (np.pi / 2)
        share = RADIUS * away / np.maximum(np.hypot(left, up), 1e-12)
        return np.stack([FOOT[0] - share * left, FOOT[1] - share * up], axis=1)

    def paint(
        self,
        panel: Panel,
        motion: Motion,
        trail: NDArray[np.float64],
        wished: Wished | None = None,
    ) -> None:
        """Paints outline, `wished` path, kite and `trail` (n, 3) [m, E], oldest first; no words."""
        box, top = panel.rect(0, 0, WIDTH, HEIGHT), FOOT[1] - RADIUS - OUTSIDE
        panel.surface.blit(_net(box.size, panel.unit), box)
        if wished:
            self._paint_wished(panel, wished, panel.rect(0, top, WIDTH, FOOT[1] - top))
        if len(trail):
            trail = trail[::-3][::-1]  # enough for a small picture
            places = np.array([panel.x, panel.y]) + panel.unit * self.places(trail)
            usable = np.full(len(trail), True)
            inside = panel.rect(0, top, WIDTH, FOOT[1] - top)
            paint_trail(panel.surface, places, usable, inside, 3 * panel.unit, bright=0.8)
        self._paint_kite(panel, motion)

    def _paint_wished(self, panel: Panel, wished: Wished, inside: pygame.Rect) -> None:
        """Paints the path as a thin line, and the attractor on it."""
        opacity, corner = wished.opacity, np.array([panel.x, panel.y])
        if wished.path is not None:
            around = np.concatenate([wished.path[::4], wished.path[:1]])
            places = corner + panel.unit * self.places(in_E(self._wind, around))
            colours = np.tile((*PATH, opacity), (len(places) - 1, 1))
            smooth_lines(panel.surface, places, colours, 1.6 * panel.unit, inside)
        if wished.attractor is not None:
            (place,) = corner + panel.unit * self.places(in_E(self._wind, wished.attractor))
            paint_mark(panel.surface, place, 4.5 * panel.unit, inside)

    def _paint_kite(self, panel: Panel, motion: Motion) -> None:
        """Paints an arrowhead that flies nose first, its wings in the colours of the kite's."""
        G, R = motion.body.p_G_E, motion.body.R_BE
        x, y = self._kept_inside(*self.place(G))
        nose, left = self._towards(G, R.x), self._towards(G, R.y)
        tip = (NOSE * nose[0], NOSE * nose[1])
        notch = (-0.35 * tip[0], -0.35 * tip[1])
        reach = 1.4 * NOSE
        corner = panel.at(x - reach, y - reach)
        side = max(round(2 * reach * panel.unit), 2)
        box = pygame.Rect(round(corner[0]), round(corner[1]), side, side)

        def draw(large: pygame.Surface, finer: float) -> None:
            k = large.get_width() / (2 * reach)
            for wing, colour in ((1.0, LEFT), (-1.0, RIGHT)):
                back = (
                    wing * WING * left[0] - 0.75 * tip[0],
                    wing * WING * left[1] - 0.75 * tip[1],
                )
                points = [((px + reach) * k, (py + reach) * k) for px, py in (tip, back, notch)]
                pygame.draw.polygon(large, colour if G.z < 0 else CALL, points)
                pygame.draw.lines(large, WHITE, False, points, max(round(finer * panel.unit), 1))

        paint_smoothly(panel.surface, box, draw)

    def _kept_inside(self, x: float, y: float) -> tuple[float, float]:
        """A place no further outside than what is written around leaves room for."""
        away = hypot(x - FOOT[0], y - FOOT[1])
        share = min(1.0, (RADIUS + OUTSIDE) / max(away, 1.0))
        return FOOT[0] + share * (x - FOOT[0]), min(FOOT[1] + share * (y - FOOT[1]), LOWEST)

    def _towards(self, G: Vector, axis: Vector) -> tuple[float, float]:
        """The unit vector in the panel along `axis` [E] of a kite at `G` [m, E]."""
        step = times(1e-3 * max(norm(G), 1.0), axis)
        ahead, behind = self.place(plus(G, step)), self.place(minus(G, step))
        dx, dy = ahead[0] - behind[0], ahead[1] - behind[1]
        size = max(hypot(dx, dy), 1e-9)
        return dx / size, dy / size


@lru_cache(8)
def _net(size: tuple[int, int], unit: float) -> pygame.Surface:
    """The outline: rim and ground, and faintly each 30° of azimuth and elevation."""

    def draw(large: pygame.Surface, finer: float) -> None:
        k = finer * unit
        thin, wide = max(round(finer * 0.8 * unit), 1), max(round(AROUND * k), 1)

        def curve(points: list[tuple[float, float]], colour: tuple[int, ...], w: int) -> None:
            pygame.draw.lines(large, colour, False, [(k * x, k * y) for x, y in points], w)

        large.fill((*RIM, 0))
        for elevation in (30, 60):
            curve([_direction(a, elevation) for a in range(-90, 91, 5)], (*RIM, GRID), thin)
        for azimuth in (-60, -30, 0, 30, 60):
            curve([_direction(azimuth, e) for e in range(0, 91, 5)], (*RIM, GRID), thin)
        curve([_direction(90, e) for e in range(0, 181, 3)], (*RIM, 235), wide)
        (x, y), reach = FOOT, RADIUS + 10
        curve([(x - reach, y), (x + reach, y)], (*RIM, 235), wide)

    return smooth(size, draw)


def _direction(azimuth_deg: float, elevation_deg: float) -> tuple[float, float]:
    """The place of a direction; `azimuth_deg` is positive to the pilot's left."""
    azimuth, elevation = radians(azimuth_deg), radians(elevation_deg)
    level = cos(elevation)
    return _spot(level * cos(azimuth), level * sin(azimuth), sin(elevation))


def _spot(ahead: float, left: float, up: float) -> tuple[float, float]:
    """The place of a unit vector by its parts along the wind, to the left and up."""
    away, flat = acos(min(max(ahead, -1.0), 1.0)) / (pi / 2), max(hypot(left, up), 1e-12)
    x, y = FOOT
    return x - RADIUS * away * left / flat, y - RADIUS * away * up / flat


def bearing(parameters: Parameters, p_E: Vector) -> tuple[float, float]:
    """Azimuth (from downwind, positive to the pilot's left) and elevation [deg] from O_E."""
    wind = downwind(parameters)
    ahead, left = dot(p_E, wind), dot(p_E, cross(UP, wind))
    return degrees(np.arctan2(left, ahead)), degrees(np.arctan2(-p_E.z, hypot(ahead, left)))
