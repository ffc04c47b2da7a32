"""The scene of a picture: MuJoCo's geoms for motions seen by a camera.

`Scene.fill` places the kites (mocap bodies of the drawing model) and adds what changes its
shape from frame to frame: lines, bridles, force arrows, pilot, wind. Positions come in
frame E and leave in W through `kitemj.physics.frames`.
"""

from collections.abc import Sequence
from itertools import chain, pairwise, product, repeat
from math import sqrt, tan
from typing import Any

import numpy as np

from kitemj.dynamics.motion import Motion, attachment_E
from kitemj.mujoco_import import mujoco
from kitemj.physics.frames import quaternion, world, world_quaternion
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, cross, dot, minus, norm, plus, times, unrotated
from kitemj.scene import scenery as look
from kitemj.scene.canopy import surface_point
from kitemj.scene.ground import EXTENT
from kitemj.scene.quality import Quality
from kitemj.scene.surroundings import Surroundings
from kitemj.scene.views import NEAR, UP, Camera, downwind

O_E = Vector(0.0, 0.0, 0.0)
MAX_GEOMS = 400
FIGURE = 0.05  # least height of the pilot in parts of the frame's
SAG_PIECES = 16
SLACK = 1e-4  # m, a line longer than its distance by more hangs
AIR = (1.0, 0.86, 0.20)
WEIGHT = (0.97, 0.97, 0.97)
WIND = (0.75, 0.95, 1.0)
THREAD = (0.20, 0.20, 0.22)
COLOURS = (look.RED, look.BLUE)  # of the first lines, the pilot's left and right; others: THREAD
SHIRT = (0.95, 0.55, 0.10)
SKIN = (0.85, 0.65, 0.50)

ARROW = int(mujoco.mjtGeom.mjGEOM_ARROW)
LINE = int(mujoco.mjtGeom.mjGEOM_LINE)
CAPSULE = int(mujoco.mjtGeom.mjGEOM_CAPSULE)
SPHERE = int(mujoco.mjtGeom.mjGEOM_SPHERE)
ALL = int(mujoco.mjtCatBit.mjCAT_ALL)
SKYBOX, CULL_FACE = int(mujoco.mjtRndFlag.mjRND_SKYBOX), int(mujoco.mjtRndFlag.mjRND_CULL_FACE)
NOWHERE, UPRIGHT = np.zeros(3), np.eye(3).ravel()


class Scene:
    """The drawing model with its state; `mjv` is what MuJoCo renders."""

    def __init__(self, parameters: Parameters, width: int, height: int, quality: Quality) -> None:
        self.parameters, self.rings = parameters, False
        self.model = look.drawing_model(parameters, width, height, quality)
        self.mjv = mujoco.MjvScene(self.model, MAX_GEOMS)
        self._data = mujoco.MjData(self.model)
        self._option = mujoco.MjvOption()
        self._free = mujoco.MjvCamera()
        self._references = np.flatnonzero(self.model.geom_group >= look.REFERENCE_GROUP)
        self._surroundings = Surroundings(parameters, self.model)
        self.mjv.flags[:] = 0
        self.mjv.flags[[SKYBOX, CULL_FACE]] = 1

    def fill(
        self,
        motion: Motion,
        reference: Motion | None,
        camera: Camera,
        forces: bool = True,
    ) -> None:
        """Makes the scene of `motion` as `camera` sees it.

        One that is near the kite sees its true size, bridles and, unless `forces` is off,
        force arrows.
        """
        close = camera.near
        size = 0 if close else 1
        visible = 0.0 if reference is None else _visibility(motion, reference, self.parameters)
        self._option.geomgroup[1:] = 0
        self._option.geomgroup[look.KITE + size] = 1
        self._option.geomgroup[look.RING_GROUP] = self.rings
        self._option.geomgroup[look.REFERENCE_GROUP + size] = visible > 0
        model, data = self.model, self._data
        for mocap, each in enumerate((motion,) if reference is None else (motion, reference)):
            data.mocap_pos[mocap] = world(each.body.p_G_E)
            data.mocap_quat[mocap] = world_quaternion(quaternion(each.body.R_BE))
        model.geom_rgba[self._references, 3] = 0.5 * visible
        mujoco.mj_kinematics(model, data)
        mujoco.mj_camlight(model, data)
        mujoco.mjv_updateScene(model, data, self._option, None, self._free, ALL, self.mjv)
        self._aim(camera)
        enlarged = 1.0 if close else look.enlargement(self.parameters)
        self._surroundings.add(self.mjv, motion, enlarged)
        self._add_lines(motion, COLOURS, 3.0 if close else 2.0)
        if reference is not None and visible > 0:
            self._add_lines(reference, (look.REFERENCE, look.REFERENCE), 1.0)
        self._add_pilot(camera)
        if close:
            self._add_bridles(motion)
            if forces:
                self._add_forces(motion)
        if self.rings:
            tail, tip = self.wind_arrow(motion, close)
            self._arrow(tail, minus(tip, tail), WIND, 0.04 * norm(minus(tip, tail)))

    def wind_arrow(self, motion: Motion, close: bool) -> tuple[Vector, Vector]:
        """Tail and tip [m, E] of the arrow that shows the wind."""
        p, wind = self.parameters, downwind(self.parameters)
        span, L = p.kite.span, p.lines.length
        left = cross(UP, wind)
        if close:
            aside = plus(times(1.25 * span, left), times(0.12 * span, UP))
            tail = plus(motion.body.p_G_E, plus(aside, times(-0.6 * span, wind)))
            return tail, plus(tail, times(1.2 * span, wind))
        tail = plus(times(0.12 * L, left), times(0.05 * L, UP))
        return tail, plus(tail, times(0.25 * L, wind))

    def _aim(self, camera: Camera) -> None:
        top = NEAR * tan(camera.field / 2)
        for eye in self.mjv.camera:
            eye.pos, eye.forward, eye.up = (world(v_E) for v_E in camera[:3])
            eye.frustum_center, eye.frustum_top, eye.frustum_bottom = 0.0, top, -top
            eye.frustum_near, eye.frustum_far = NEAR, 2 * EXTENT

    def _add_lines(self, motion: Motion, colours: tuple[Any, Any], width: float) -> None:
        for line, colour in zip(motion.lines, chain(colours, repeat(THREAD)), strict=False):
            points: Sequence[Vector] = line.points
            if len(points) == 2 and line.length > norm(points[-1]) + SLACK:
                points = hanging(points[-1], line.length)
            for a, b in pairwise(points):
                self._stroke(LINE, width, a, b, colour)

    def _add_bridles(self, motion: Motion) -> None:
        for side, across, along in product((1.0, -1.0), (0.35, 0.92), (0.08, 0.75)):
            knot = attachment_E(self.parameters, motion.body, side)
            point = surface_point(self.parameters.kite, side * across, along)
            self._stroke(LINE, 1.0, knot, _from_body(motion, point), THREAD)

    def _add_forces(self, motion: Motion) -> None:
        p, body = self.parameters, motion.body
        metres = 1.0 / newtons_per_metre(p)
        wrench = aerodynamic_wrench(p, body.p_G_E, body.R_BE, body.v_G_E, body.omega_B, motion.t)
        air = unrotated(body.R_BE, wrench.force)
        weight = Vector(0.0, 0.0, p.kite.mass * p.environment.gravity)
        self._arrow(body.p_G_E, times(metres, air), AIR)
        self._arrow(body.p_G_E, times(metres, weight), WEIGHT)
        for line, colour in zip(motion.lines, chain(COLOURS, repeat(THREAD)), strict=False):
            *_, before, A = line.points
            pull = max(line.tension_kite, 0.0) * metres / norm(minus(before, A))
            self._arrow(A, times(pull, minus(before, A)), colour)

    def _add_pilot(self, camera: Camera) -> None:
        """Adds a person 1.8 m tall, or as tall as it takes to be seen."""
        depth = dot(minus(O_E, camera.position), camera.forward)
        s = max(1.0, FIGURE * 2 * depth * tan(camera.field / 2) / 1.8)
        wind, left = downwind(self.parameters), cross(UP, downwind(self.parameters))

        def at(ahead: float, aside: float, height: float) -> Vector:
            sideways = plus(times(ahead * s, wind), times(aside * s, left))
            return plus(sideways, times(height * s, UP))

        for foot in (0.2, -0.2):
            self._stroke(CAPSULE, 0.09 * s, at(0, foot, 0.05), at(0, foot / 2, 0.85), THREAD)
            self._stroke(CAPSULE, 0.07 * s, at(0, 1.2 * foot, 1.35), at(0.45, foot, 1.15), SKIN)
        self._stroke(CAPSULE, 0.19 * s, at(0, 0, 0.9), at(0, 0, 1.3), SHIRT)
        if (head := self._next(SPHERE, SKIN)) is not None:
            head.size, head.pos = [0.15 * s] * 3, world(at(0, 0, 1.66))

    def _arrow(self, start: Vector, along: Vector, colour: Any, width: float = 0.0) -> None:
        if norm(along) > 1e-3:
            thick = width or 0.018 * self.parameters.kite.span
            self._stroke(ARROW, thick, start, plus(start, along), colour)

    def _stroke(self, kind: int, width: float, start: Vector, end: Vector, colour: Any) -> None:
        geom = self._next(kind, colour)
        if geom is not None:
            mujoco.mjv_connector(geom, kind, width, np.array(world(start)), np.array(world(end)))

    def _next(self, kind: int, colour: Any) -> Any:
        if self.mjv.ngeom >= self.mjv.maxgeom:
            return None
        geom = self.mjv.geoms[self.mjv.ngeom]
        rgba = np.array([*colour, 1.0], np.float32)
        mujoco.mjv_initGeom(geom, kind, NOWHERE, NOWHERE, UPRIGHT, rgba)
        geom.emission = 0.35
        self.mjv.ngeom += 1
        return geom


def newtons_per_metre(parameters: Parameters) -> float:
    """The scale of the force arrows, a round number.

    The air's force of usual flight is about a span long, a line's ceiling at most eight.
    """
    kite, V = parameters.kite, parameters.wind.speed
    weight = kite.mass * parameters.environment.gravity
    usual = weight + 0.15 * parameters.environment.air_density * kite.area * V * V
    ceiling = parameters.limits.tension_max / 8.0
    wanted = max(usual / 0.9, ceiling, 1e-6) / kite.span
    decade = 10.0 ** np.floor(np.log10(wanted))
    return float(min((s * decade for s in (1, 1.5, 2, 3, 5, 10)), key=lambda s: abs(s - wanted)))


def hanging(end: Vector, length: float) -> list[Vector]:
    """Points [m, E] of a slack line of `length` [m] from O_E to `end`, not below the ground.

    A parabola in place of the catenary. Its depth below the middle of a level line of
    span d is sqrt(3/8 d (L - d)); a slope lets it hang deeper, to a limit for the eye.
    """
    distance = norm(end)
    level = max(sqrt(end.x * end.x + end.y * end.y) / distance, 0.25)
    depth = sqrt(max(0.375 * distance * (length - distance), 0.0)) / level
    shares = [i / SAG_PIECES for i in range(SAG_PIECES + 1)]
    heights = [min(s * end.z + 4 * depth * s * (1 - s), 0.0) for s in shares]
    return [Vector(s * end.x, s * end.y, z) for s, z in zip(shares, heights, strict=True)]


def _from_body(motion: Motion, p_B: Vector) -> Vector:
    return plus(motion.body.p_G_E, unrotated(motion.body.R_BE, p_B))


def _visibility(motion: Motion, reference: Motion, parameters: Parameters) -> float:
    """0 where both kites stand in the same place, so that they do not flicker, to 1.

    The largest distance of nose and tips, 0.3 % to 2 % of the span.
    """
    half, ahead = parameters.kite.span / 2, parameters.kite.chord
    marks = (Vector(ahead, 0.0, 0.0), Vector(0.0, half, 0.0), Vector(0.0, -half, 0.0))
    apart = max(norm(minus(_from_body(motion, m), _from_body(reference, m))) for m in marks)
    return min(max((apart / parameters.kite.span - 0.003) / 0.017, 0.0), 1.0)
