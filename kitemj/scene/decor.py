"""Flat shapes and strokes added to a scene of MuJoCo's in W and E."""

from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kitemj.mujoco_import import mujoco
from kitemj.physics.frames import world
from kitemj.physics.vectors import Vector

TRIANGLE = int(mujoco.mjtGeom.mjGEOM_TRIANGLE)
DECOR = int(mujoco.mjtCatBit.mjCAT_DECOR)
NOWHERE, UPRIGHT, WHOLE = np.zeros(3), np.eye(3).ravel(), np.ones(3)
Colour = tuple[float, float, float]


def added(mjv: Any, kind: int, colour: Colour, alpha: float = 1.0, emission: float = 0.35) -> Any:
    """The next geom of the scene, of this kind, not yet placed; None when the scene is full."""
    if mjv.ngeom >= mjv.maxgeom:
        return None
    geom = mjv.geoms[mjv.ngeom]
    rgba = np.array([*colour, alpha], np.float32)
    mujoco.mjv_initGeom(geom, kind, WHOLE, NOWHERE, UPRIGHT, rgba)
    geom.category, geom.transparent, geom.emission = DECOR, int(alpha < 1.0), emission
    mjv.ngeom += 1
    return geom


def add_flat(mjv: Any, corners_W: NDArray[np.float64], colour: Colour, alpha: float) -> None:
    """Adds a level convex polygon (n, 3) [m, W] of a plain colour, as triangles."""
    first = corners_W[0]
    sides = corners_W[1:] - first
    for b, c in pairwise(sides):
        geom = added(mjv, TRIANGLE, colour, alpha, emission=1.0)
        if geom is None:
            return
        geom.pos[:] = first
        geom.mat[:, 0], geom.mat[:, 1] = b, c


def add_stroke(
    mjv: Any, kind: int, width: float, start: Vector, end: Vector, colour: Colour
) -> None:
    """Adds a geom `kind` of half width `width` [m] from one point [m, E] to another."""
    geom = added(mjv, kind, colour)
    if geom is not None:
        mujoco.mjv_connector(geom, kind, width, np.array(world(start)), np.array(world(end)))
