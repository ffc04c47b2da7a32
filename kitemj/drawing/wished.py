"""What an autopilot flies, as pictures show it: a path in the sky, and the point ahead on it."""

from math import isfinite
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.flight.pilot_settings import Guided
from kitemj.paths.sphere import direction
from kitemj.physics.vectors import Vector, cross
from kitemj.scene.views import UP

FOLLOWED, LEFT = 0.95, 0.4
"""Opacity of a path that is followed, and of one that is not, or not yet."""


class Wished(NamedTuple):
    """`path` (n, 3): directions in the axes of `kitemj.paths.sphere`; None: there is none."""

    path: NDArray[np.float64] | None
    guided: Guided | None = None

    @property
    def opacity(self) -> float:
        """Of the path."""
        return FOLLOWED if self.guided and self.guided.phase == "path" else LEFT

    @property
    def attractor(self) -> NDArray[np.float64] | None:
        """The direction (1, 3) of the point that is flown to; None: there is none."""
        guided = self.guided
        if guided is None or not isfinite(guided.azimuth + guided.elevation):
            return None
        return np.array([direction(guided.azimuth, guided.elevation)])


def in_E(wind: Vector, directions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Directions (n, 3) in E; `wind` is the unit vector downwind."""
    left = cross(UP, wind)
    return np.asarray(directions * (1.0, -1.0, 1.0) @ np.array([wind, left, UP]))
