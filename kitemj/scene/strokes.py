"""What is drawn besides the meshes of the model: lines, limbs and arrows, from point to point."""

from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kitemj.mujoco_import import mujoco
from kitemj.physics.frames import world
from kitemj.physics.vectors import Vector, norm, plus
from kitemj.scene.cloth import Colour

ELLIPSOID = int(mujoco.mjtGeom.mjGEOM_ELLIPSOID)
ARROW = int(mujoco.mjtGeom.mjGEOM_ARROW)
LINE = int(mujoco.mjtGeom.mjGEOM_LINE)
CAPSULE = int(mujoco.mjtGeom.mjGEOM_CAPSULE)
SPHERE = int(mujoco.mjtGeom.mjGEOM_SPHERE)
NOWHERE, UPRIGHT = np.zeros(3), np.eye(3).ravel()
WORLD = np.array(world(Vector(1.0, 1.0, 1.0)))
LIGHT = 0.35  # a stroke's own


class Strokes:
    """Adds geoms to an MjvScene, as many as it has room for. Points are (n, 3) in E [m]."""

    def __init__(self, mjv: Any) -> None:
        self._mjv = mjv

    def line(self, points: ArrayLike, width: float, colour: Colour) -> None:
        """A line through points, `width` px wide however far it is."""
        for a, b in pairwise(np.asarray(points) * WORLD):
            self._from_to(LINE, width, a, b, colour)

    def lines(self, ends: ArrayLike, width: float, colour: Colour) -> None:
        """Lines from end to end, (n, 2, 3) [m, E], `width` px wide."""
        for a, b in np.asarray(ends) * WORLD:
            self._from_to(LINE, width, a, b, colour)

    def limb(self, ends: ArrayLike, radius: float, colour: Colour) -> None:
        """A rod with round ends, `radius` in m; a ball where both are one."""
        start, end = np.asarray(ends) * WORLD
        if np.array_equal(start, end):
            if (geom := self._next(SPHERE, colour)) is not None:
                geom.size, geom.pos = [radius] * 3, start
        else:
            self._from_to(CAPSULE, radius, start, end, colour)

    def egg(self, middle: ArrayLike, axes: ArrayLike, colour: Colour) -> None:
        """An ellipsoid with three half axes (3, 3) [m, E], at right angles to each other."""
        if (geom := self._next(ELLIPSOID, colour)) is not None:
            half = np.asarray(axes) * WORLD
            geom.size = sizes = np.linalg.norm(half, axis=1)
            geom.pos, geom.mat = np.asarray(middle) * WORLD, (half / sizes[:, None]).T

    def arrow(self, start: Vector, along: Vector, radius: float, colour: Colour) -> None:
        """An arrow, unless it is shorter than a millimetre."""
        if norm(along) > 1e-3:
            tail, tip = np.array([start, plus(start, along)]) * WORLD
            self._from_to(ARROW, radius, tail, tip, colour)

    def _from_to(self, kind: int, width: float, start: Any, end: Any, colour: Colour) -> None:
        geom = self._next(kind, colour)
        if geom is not None:
            mujoco.mjv_connector(geom, kind, width, start, end)

    def _next(self, kind: int, colour: Colour) -> Any:
        if self._mjv.ngeom >= self._mjv.maxgeom:
            return None
        geom = self._mjv.geoms[self._mjv.ngeom]
        rgba = np.array([*colour, 1.0], np.float32)
        mujoco.mjv_initGeom(geom, kind, NOWHERE, NOWHERE, UPRIGHT, rgba)
        geom.emission = LIGHT
        self._mjv.ngeom += 1
        return geom
