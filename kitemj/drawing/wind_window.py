"""The wind window: the quarter-sphere of the lines as the pilot sees it, the kite and its trail.

An equidistant projection about the downwind direction: the distance from the middle of the
ground line is the angle from the wind, so the rim is the edge of the window and a kite that
overflies it is seen outside. Left is the pilot's left.
"""

from math import acos, cos, degrees, hypot, pi, radians, sin

import numpy as np
from numpy.typing import NDArray

from kitemj.drawing.colours import CALL, DIM, LEFT, RIGHT, WHITE, Colour
from kitemj.drawing.panel import Panel
from kitemj.drawing.trail import paint_trail
from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, cross, dot, minus, norm, plus, times
from kitemj.scene.views import UP, downwind

WIDTH, HEIGHT = 292, 172
FOOT = (146.0, 144.0)  # of the pilot: the middle of the ground line
RADIUS = 124.0  # of the rim, 90° from the wind
SKY: Colour = (38, 62, 92)
GRID: Colour = (92, 118, 148)
EARTH: Colour = (108, 140, 84)
WING = 14.0  # half the kite's width


class WindWindow:
    """The instrument for one parameter set; places are in units of the panel."""

    def __init__(self, parameters: Parameters) -> None:
        wind = downwind(parameters)
        self._wind, self._left = wind, cross(UP, wind)
        (x, y), turns = FOOT, [radians(a) for a in range(0, 181, 6)]
        self._sky = [(x + RADIUS * cos(turn), y - RADIUS * sin(turn)) for turn in turns]
        self._grid = [[self._at(a, e) for a in range(-90, 91, 6)] for e in (30, 60)]
        self._grid += [[self._at(a, e) for e in range(0, 91, 6)] for a in range(-60, 61, 30)]

    def place(self, p_E: Vector) -> tuple[float, float]:
        """The place of the point `p_E` [m, E] in the panel."""
        size = max(norm(p_E), 1e-9)
        ahead, left, up = (dot(p_E, axis) / size for axis in (self._wind, self._left, UP))
        away = acos(min(max(ahead, -1.0), 1.0)) / (pi / 2)
        flat = max(hypot(left, up), 1e-12)
        x, y = FOOT
        return x - RADIUS * away * left / flat, y - RADIUS * away * up / flat

    def places(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """The same for many points (n, 3): (n, 2)."""
        axes = np.array([self._wind, self._left, UP])
        size = np.maximum(np.linalg.norm(points, axis=1), 1e-9)
        ahead, left, up = axes @ points.T / size
        away = np.arccos(np.clip(ahead, -1.0, 1.0)) / (np.pi / 2)
        share = RADIUS * away / np.maximum(np.hypot(left, up), 1e-12)
        return np.stack([FOOT[0] - share * left, FOOT[1] - share * up], axis=1)

    def paint(self, panel: Panel, motion: Motion, trail: NDArray[np.float64]) -> None:
        """Paints the instrument; `trail` (n, 3) [m, E], oldest first."""
        panel.polygon(self._sky, SKY)
        for line in self._grid:
            panel.line(line, GRID, 1)
        panel.line(self._sky, DIM, 2)
        panel.bar(8, FOOT[1], WIDTH - 16, 4, EARTH)
        panel.text("left", 8, FOOT[1] + 17, colour=LEFT)
        panel.text("right", WIDTH - 8, FOOT[1] + 17, colour=RIGHT, align=1)
        panel.text("wind window", FOOT[0] - 8, FOOT[1] + 17, align=0.5)
        box = panel.rect(0, 0, WIDTH, HEIGHT)
        if len(trail):
            trail = trail[::-3][::-1]  # enough for a small picture
            places = np.array([panel.x, panel.y]) + panel.unit * self.places(trail)
            paint_trail(panel.surface, places, np.full(len(trail), True), box, 3 * panel.unit)
        self._paint_kite(panel, motion)

    def _paint_kite(self, panel: Panel, motion: Motion) -> None:
        """Paints a dot with a red and a blue wing, turned as the kite is."""
        G = motion.body.p_G_E
        x, y = self.place(G)
        x, y = min(max(x, 14.0), WIDTH - 14.0), min(max(y, 14.0), FOOT[1] + 6)
        tip = times(1e-3 * max(norm(G), 1.0), motion.body.R_BE.y)
        ahead, behind = self.place(plus(G, tip)), self.place(minus(G, tip))
        dx, dy = ahead[0] - behind[0], ahead[1] - behind[1]
        size = max(hypot(dx, dy), 1e-9)
        dx, dy = WING * dx / size, WING * dy / size
        panel.line([(x, y), (x + dx, y + dy)], LEFT, 6)
        panel.line([(x, y), (x - dx, y - dy)], RIGHT, 6)
        panel.dot(x, y, 5, WHITE if G.z < 0 else CALL)

    def _at(self, azimuth_deg: float, elevation_deg: float) -> tuple[float, float]:
        """The place of a direction; `azimuth_deg` is positive to the pilot's left."""
        azimuth, elevation = radians(azimuth_deg), radians(elevation_deg)
        level = plus(times(cos(azimuth), self._wind), times(sin(azimuth), self._left))
        return self.place(plus(times(cos(elevation), level), times(sin(elevation), UP)))


def bearing(parameters: Parameters, p_E: Vector) -> tuple[float, float]:
    """Azimuth (from downwind, positive to the pilot's left) and elevation [deg] from O_E."""
    wind = downwind(parameters)
    ahead, left = dot(p_E, wind), dot(p_E, cross(UP, wind))
    return degrees(np.arctan2(left, ahead)), degrees(np.arctan2(-p_E.z, hypot(ahead, left)))
