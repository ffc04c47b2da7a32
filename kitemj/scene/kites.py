"""The kite and its reference in the drawing model: sails whose vertices move from frame to frame.

Each has a sail in its true size and one that is enlarged for the wide views; groups choose
which is drawn.
"""

from typing import Any

import numpy as np

from kitemj.dynamics.motion import Motion
from kitemj.mujoco_import import mujoco
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, rotated
from kitemj.scene.canopy import canopy
from kitemj.scene.cloth import Fill, Normals, fill_of
from kitemj.scene.model_parts import Mesh, add_mesh, add_shape, add_texture

KITE, REFERENCE_GROUP = 1, 3  # groups of the true size; one more: enlarged
REFERENCE = (1.0, 0.93, 0.55)
APART = 0.002  # m between the two sides of a sail when it is compiled
GLOW = 0.20  # light of the cloth itself


def enlargement(parameters: Parameters) -> float:
    """The factor by which wide views enlarge the kite, so that it can be seen at all."""
    return max(1.0, 0.14 * parameters.lines.length / parameters.kite.span)


def add_kites(spec: Any, parameters: Parameters) -> None:
    """Adds the bodies "kite" and "reference", moved by mocap in this order."""
    cloth = canopy(parameters.kite)
    add_texture(spec, "sail", cloth.image)
    spec.material("sail").emission = GLOW
    spec.add_material(name="reference", emission=GLOW, specular=0.0)
    points = cloth.shape(Fill(1.0, 1.0, 0.0))
    points += APART * Normals(cloth.faces).of(points)  # or equal vertices become one
    for index, scale in enumerate((1.0, enlargement(parameters))):
        add_mesh(spec, f"sail_{index}", Mesh(scale * points, cloth.faces), cloth.places)
    for name, material, rgba, group in (
        ("kite", "sail", [1, 1, 1, 1], KITE),
        ("reference", "reference", [*REFERENCE, 1], REFERENCE_GROUP),
    ):
        body = spec.worldbody.add_body(name=name, mocap=True)
        for index in (0, 1):
            add_shape(body, f"sail_{index}", material=material, rgba=rgba, group=group + index)


class Sails:
    """Sets the vertices of the sails of a drawing model, and gives them to OpenGL."""

    def __init__(self, parameters: Parameters, model: Any) -> None:
        self._parameters, self._model = parameters, model
        self.cloth = canopy(parameters.kite)
        self._normals = Normals(self.cloth.faces)
        self._meshes = [model.mesh(f"sail_{index}").id for index in (0, 1)]
        self._scales = (1.0, enlargement(parameters))
        self._stale: set[int] = set()

    def fill(self, motion: Motion, wide: bool, sun: Vector) -> None:
        """Fills the sail that is seen as the wind of `motion` does, lit by a `sun` [E] there."""
        index, fill = int(wide), fill_of(self._parameters, motion)
        points = self._scales[index] * self.cloth.shape(fill)
        model, mesh = self._model, self._meshes[index]
        turn = np.empty(9)
        mujoco.mju_quat2Mat(turn, model.mesh_quat[mesh])
        to_mesh = turn.reshape(3, 3)  # the compiler moved and turned the mesh
        first, number = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
        model.mesh_vert[first : first + number] = (points - model.mesh_pos[mesh]) @ to_mesh
        # light goes through: what is lit from behind is as bright as from before
        up, to_sun = self._normals.of(points), np.array(rotated(motion.body.R_BE, sun))
        up -= 2 * np.minimum(up @ to_sun, 0.0)[:, None] * to_sun
        start = model.mesh_normaladr[mesh]
        model.mesh_normal[start : start + number] = up @ to_mesh
        self._stale.add(index)

    def upload(self, context: Any) -> None:
        """Gives what has changed to the current context."""
        for index in self._stale:
            mujoco.mjr_uploadMesh(self._model, context, self._meshes[index])
        self._stale.clear()
