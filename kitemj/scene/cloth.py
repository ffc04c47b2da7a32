"""What a kite is sewn of: its mesh, which billows, its colours, its frame and its bridle.

Coordinates are those of the body frame B (x forward, y starboard, z to the ground), the centre of
mass at the origin. Only for the eye: no force is computed from it.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters

Colour = tuple[float, float, float]
RED: Colour = (0.88, 0.09, 0.11)  # the pilot's left, A₊
BLUE: Colour = (0.09, 0.27, 0.92)  # the pilot's right, A₋
WHITE: Colour = (0.96, 0.96, 0.94)
DARK: Colour = (0.13, 0.13, 0.16)

Points = NDArray[np.float64]
"""Of shape (n, 3), in m."""


class Fill(NamedTuple):
    """How the wind fills the cloth: 0 hangs, 1 is drawn tight, at the left and right; `t` in s."""

    left: float
    right: float
    t: float


class Cloth(NamedTuple):
    """A kite for the eye. `shape` gives the vertices [m, B] of a fill, `faces` (m, 3) index them.

    `places` (n, 2) of the vertices are in `image` (rows, columns, 3), 0..1 from its first corner
    across and down. `rods` (k, 2, 3) [m, B] are the frame's, from end to end; `bridle` (k, 3) the
    points on the sail where its legs end, those with y > 0 from A₊, with y < 0 from A₋.
    """

    shape: Callable[[Fill], Points]
    faces: NDArray[np.int32]
    places: NDArray[np.float64]
    image: NDArray[np.uint8]
    rods: NDArray[np.float64]
    bridle: Points


def fill_of(parameters: Parameters, motion: Motion) -> Fill:
    """The fill that the pull [N] of the left and the right line makes; half for a usual pull."""
    left, right = (_filled(parameters, pull) for pull in motion.tensions[:2])
    return Fill(left, right, motion.t)


def _filled(parameters: Parameters, pull: float) -> float:
    """0 without a pull, half for that of a kite at rest in its wind, towards 1 beyond."""
    usual = usual_force(parameters) / 2
    return max(pull, 0.0) / (max(pull, 0.0) + usual)


def usual_force(parameters: Parameters) -> float:
    """What the air does to a kite at rest [N], roughly: its weight and a light pull."""
    kite, V = parameters.kite, parameters.wind.speed
    weight = kite.mass * parameters.environment.gravity
    return max(weight + 0.15 * parameters.environment.air_density * kite.area * V * V, 1e-6)


def sheet(rows: int, columns: int) -> NDArray[np.int32]:
    """Triangles of a grid of `rows` x `columns` vertices.

    The face is where rows, columns and the way outside make a right hand.
    """
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1))
    a = (i * columns + j).ravel()
    c = a + columns
    both = np.concatenate([np.stack([a, c, c + 1], 1), np.stack([a, c + 1, a + 1], 1)])
    return both.astype(np.int32)


class Normals:
    """Unit normals at the vertices of a mesh: the mean of the faces around, by their size."""

    def __init__(self, faces: NDArray[np.int32]) -> None:
        """For a mesh of which every vertex is a corner of a face."""
        self._corners = faces.T
        order = np.argsort(faces.ravel(), kind="stable")
        self._around = order // 3  # faces, by their vertices
        self._starts = np.searchsorted(faces.ravel()[order], np.arange(faces.max() + 1))

    def of(self, points: Points) -> Points:
        """Of vertices (n, 3) in any frame."""
        a, b, c = (points[corner] for corner in self._corners)
        total = np.add.reduceat(np.cross(b - a, c - a)[self._around], self._starts)
        unit: Points = total / np.maximum(np.linalg.norm(total, axis=1), 1e-12)[:, None]
        return unit


def dyed(image: NDArray[np.float64], where: NDArray[np.bool_], colour: Colour) -> None:
    """Paints a part of an image (rows, columns, 3) of numbers in 0..1."""
    image[where] = colour
