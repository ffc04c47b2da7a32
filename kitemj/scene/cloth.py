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
from kitemj.physics.vectors import Vector

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
    across and down. `rods` are the frame's, from end to end; `bridle` has the points on the sail to
    which the lines of one side go, by the side (+1 left, -1 right).
    """

    shape: Callable[[Fill], Points]
    faces: NDArray[np.int32]
    places: NDArray[np.float64]
    image: NDArray[np.uint8]
    rods: Callable[[Fill], list[tuple[Vector, Vector]]]
    bridle: Callable[[Fill, float], list[Vector]]


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


def sheet(rows: int, columns: int, closed: bool = False) -> NDArray[np.int32]:
    """Triangles of a grid of `rows` x `columns` vertices; `closed`: the last row meets the first.

    The face is where rows, columns and the way outside make a right hand.
    """
    i, j = np.meshgrid(np.arange(rows if closed else rows - 1), np.arange(columns - 1))
    a = (i * columns + j).ravel()
    c = ((i + 1) % rows * columns + j).ravel()
    both = np.concatenate([np.stack([a, c, c + 1], 1), np.stack([a, c + 1, a + 1], 1)])
    return both.astype(np.int32)


def normals(points: Points, faces: NDArray[np.int32]) -> Points:
    """Unit normals at the vertices: the mean of the faces around, by their size."""
    a, b, c = (points[faces[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    total = np.zeros_like(points)
    for k in range(3):
        for axis in range(3):
            total[:, axis] += np.bincount(faces[:, k], across[:, axis], len(points))
    unit: Points = total / np.maximum(np.linalg.norm(total, axis=1), 1e-12)[:, None]
    return unit


def dyed(image: NDArray[np.float64], where: NDArray[np.bool_], colour: Colour) -> None:
    """Paints a part of an image (rows, columns, 3) of numbers in 0..1."""
    image[where] = colour
