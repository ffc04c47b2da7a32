"""What is drawn besides the meshes of the model: lines, limbs and arrows, from point to point."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from kitemj.mujoco_import import mujoco
from kitemj.physics.frames import world
from kitemj.physics.vectors import Vector, minus, norm, plus
from kitemj.scene.cloth import Colour

ARROW = int(mujoco.mjtGeom.mjGEOM_ARROW)
LINE = int(mujoco.mjtGeom.mjGEOM_LINE)
CAPSULE = int(mujoco.mjtGeom.mjGEOM_CAPSULE)
SPHERE = int(mujoco.mjtGeom.mjGEOM_SPHERE)
NOWHERE, UPRIGHT = np.zeros(3), np.eye(3).ravel()
LIGHT = 0.35  # a stroke's own


class Strokes:
    """Adds geoms to an MjvScene, as many as it has room for. Positions in E [m]."""

    def __init__(self, mjv: Any) -> None:
        self._mjv = mjv

    def line(self, points: Sequence[Vector], width: float, colour: Colour) -> None:
        """A line through points, `width` px wide however far it is."""
        for a, b in pairwise(points):
            self._from_to(LINE, width, a, b, colour)

    def limb(self, start: Vector, end: Vector, radius: float, colour: Colour) -> None:
        """A rod with round ends, `radius` in m."""
        self._from_to(CAPSULE, radius, start, end, colour)

    def arrow(self, start: Vector, along: Vector, radius: float, colour: Colour) -> None:
        """An arrow, unless it is shorter than a millimetre."""
        if norm(along) > 1e-3:
            self._from_to(ARROW, radius, start, plus(start, along), colour)

    def ball(self, middle: Vector, radius: float, colour: Colour) -> None:
        """A sphere, `radius` in m."""
        if (geom := self._next(SPHERE, colour)) is not None:
            geom.size, geom.pos = [radius] * 3, world(middle)

    def _from_to(self, kind: int, width: float, start: Vector, end: Vector, colour: Colour) -> None:
        geom = self._next(kind, colour)
        if geom is not None and norm(minus(end, start)) > 0.0:
            mujoco.mjv_connector(geom, kind, width, np.array(world(start)), np.array(world(end)))

    def _next(self, kind: int, colour: Colour) -> Any:
        if self._mjv.ngeom >= self._mjv.maxgeom:
            return None
        geom = self._mjv.geoms[self._mjv.ngeom]
        rgba = np.array([*colour, 1.0], np.float32)
        mujoco.mjv_initGeom(geom, kind, NOWHERE, NOWHERE, UPRIGHT, rgba)
        geom.emission = LIGHT
        self._mjv.ngeom += 1
        return geom
