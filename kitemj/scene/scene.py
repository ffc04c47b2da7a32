"""The scene of a picture: MuJoCo's geoms for motions seen by a camera.

`Scene.fill` places the kites (mocap bodies of the drawing model) and adds what changes its
shape from frame to frame: sails, lines, bridles, force arrows, pilot, wind. Positions come in
frame E and leave in W through `kitemj.physics.frames`.
"""

from math import tan
from typing import Any

import numpy as np

from kitemj.dynamics.motion import Motion
from kitemj.mujoco_import import mujoco
from kitemj.physics.frames import quaternion, world, world_quaternion
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, cross, dot, minus, norm, plus, times
from kitemj.scene import scenery as look
from kitemj.scene.figure import Hands, add_pilot, hands
from kitemj.scene.forces import add_forces
from kitemj.scene.ground import EXTENT
from kitemj.scene.kites import KITE, REFERENCE, REFERENCE_GROUP, Sails, enlargement
from kitemj.scene.lines import add_bridle, add_lines, from_body
from kitemj.scene.quality import Quality
from kitemj.scene.strokes import Strokes
from kitemj.scene.sun import sun
from kitemj.scene.surroundings import Surroundings
from kitemj.scene.views import NEAR, UP, Camera, downwind

O_E = Vector(0.0, 0.0, 0.0)
MAX_GEOMS = 400
FIGURE = 0.05  # least height of the pilot in parts of the frame's, seen from afar
LINE, THIN = 2, 1  # px of 720 rows
WIND = (0.75, 0.95, 1.0)

ALL = int(mujoco.mjtCatBit.mjCAT_ALL)
CULL_FACE = int(mujoco.mjtRndFlag.mjRND_CULL_FACE)


class Scene:
    """The drawing model with its state; `mjv` is what MuJoCo renders."""

    def __init__(self, parameters: Parameters, width: int, height: int, quality: Quality) -> None:
        self.parameters, self.rings = parameters, False
        self.model = look.drawing_model(parameters, width, height, quality)
        self.mjv = mujoco.MjvScene(self.model, MAX_GEOMS)
        self._data = mujoco.MjData(self.model)
        self._option = mujoco.MjvOption()
        self._free = mujoco.MjvCamera()
        self._references = np.flatnonzero(self.model.geom_group == REFERENCE_GROUP)
        self.surroundings = Surroundings(parameters, self.model)
        self._sails = Sails(parameters, self.model)
        self._strokes = Strokes(self.mjv)
        self.mjv.flags[:] = 0
        self.mjv.flags[CULL_FACE] = 1

    def fill(
        self,
        motion: Motion,
        reference: Motion | None,
        camera: Camera,
        forces: bool = True,
        rows: int = 720,
    ) -> None:
        """Makes the scene of `motion` as `camera` sees it in a picture of so many `rows`.

        One that is near the kite sees force arrows, unless `forces` is off. Then also the wind
        has no arrow.
        """
        wide, strokes = camera.wide, self._strokes
        line = THIN if wide else max(THIN, round(LINE * rows / 720))
        visible = 0.0 if reference is None else _visibility(motion, reference, self.parameters)
        self._option.geomgroup[1:] = 0
        self._option.geomgroup[KITE + wide] = 1
        self._option.geomgroup[look.RING_GROUP] = self.rings
        self._option.geomgroup[REFERENCE_GROUP + wide] = visible > 0
        model, data = self.model, self._data
        for mocap, each in enumerate((motion,) if reference is None else (motion, reference)):
            data.mocap_pos[mocap] = world(each.body.p_G_E)
            data.mocap_quat[mocap] = world_quaternion(quaternion(each.body.R_BE))
        model.geom_rgba[self._references, 3] = 0.5 * visible
        self._sails.fill(motion, wide, sun(self.parameters))
        mujoco.mj_kinematics(model, data)
        mujoco.mj_camlight(model, data)
        mujoco.mjv_updateScene(model, data, self._option, None, self._free, ALL, self.mjv)
        self._aim(camera)
        size = enlargement(self.parameters) if wide else 1.0
        self.surroundings.add(self.mjv, motion, size, camera.position)
        scale = self._figure_scale(camera)
        held = Hands(*(times(scale, hand) for hand in hands(self.parameters, motion)))
        add_lines(strokes, motion, held, line)
        if reference is not None and visible > 0:
            add_lines(strokes, reference, held, THIN, REFERENCE)
        add_pilot(strokes, self.parameters, motion, scale)
        if not wide:
            far = norm(minus(motion.body.p_G_E, camera.position))
            seen = self.parameters.kite.span / far * rows / 2 / tan(camera.field / 2)
            add_bridle(strokes, self.parameters, motion, self._sails.cloth, seen)
        if forces:
            if camera.near:
                add_forces(strokes, self.parameters, motion)
            tail, tip = self.wind_arrow(motion, camera.near)
            along = minus(tip, tail)
            strokes.arrow(tail, along, 0.04 * norm(along), WIND)

    def upload(self, context: Any) -> None:
        """Gives the sails that `fill` moved to the current OpenGL `context`, an MjrContext."""
        self._sails.upload(context)

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

    def _figure_scale(self, camera: Camera) -> float:
        """How much taller than a person the pilot is drawn, to be seen in a wide view."""
        depth = dot(minus(O_E, camera.position), camera.forward)
        seen = FIGURE * 2 * depth * tan(camera.field / 2) / 1.8
        return max(1.0, seen) if camera.wide else 1.0


def _visibility(motion: Motion, reference: Motion, parameters: Parameters) -> float:
    """0 where both kites stand in the same place, so that they do not flicker, to 1.

    The largest distance of nose and tips, 0.3 % to 2 % of the span.
    """
    half, ahead = parameters.kite.span / 2, parameters.kite.chord
    marks = (Vector(ahead, 0.0, 0.0), Vector(0.0, half, 0.0), Vector(0.0, -half, 0.0))
    apart = max(norm(minus(from_body(motion, m), from_body(reference, m))) for m in marks)
    return min(max((apart / parameters.kite.span - 0.003) / 0.017, 0.0), 1.0)
