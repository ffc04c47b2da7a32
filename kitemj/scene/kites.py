"""The kite and its reference in the drawing model: sails whose vertices move from frame to frame.

Each has a sail in its true size and one that is enlarged for the wide views; groups choose
which is drawn.
"""

from typing import Any

import numpy as np

from kitemj.dynamics.motion import Motion
from kitemj.mujoco_import import mujoco
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, dot, minus, norm
from kitemj.scene.canopy import canopy
from kitemj.scene.cloth import Fill, Points, fill_of, normals

KITE, REFERENCE_GROUP = 1, 3  # groups of the true size; one more: enlarged
REFERENCE = (1.0, 0.93, 0.55)
APART = 0.002  # m between the two sides of a sail when it is compiled
GLOW, THROUGH = 0.30, 0.45  # light of the cloth itself, and of the sun behind it


def enlargement(parameters: Parameters) -> float:
    """The factor by which wide views enlarge the kite, so that it can be seen at all."""
    return max(1.0, 0.14 * parameters.lines.length / parameters.kite.span)


def add_kites(spec: Any, parameters: Parameters) -> None:
    """Adds the bodies "kite" and "reference", moved by mocap in this order."""
    cloth = canopy(parameters.kite)
    height, width, channels = cloth.image.shape
    size = {"width": width, "height": height, "nchannel": channels}
    kind = mujoco.mjtTexture.mjTEXTURE_2D
    spec.add_texture(name="sail", type=kind, **size, data=cloth.image.ravel())
    layers = [""] * int(mujoco.mjtTextureRole.mjNTEXROLE)
    layers[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = "sail"
    spec.add_material(name="sail", textures=layers, emission=GLOW, specular=0.05)
    spec.add_material(name="reference", emission=GLOW, specular=0.0)
    points = cloth.shape(Fill(1.0, 1.0, 0.0))
    points += APART * normals(points, cloth.faces)  # or equal vertices become one
    for index, scale in enumerate((1.0, enlargement(parameters))):
        mesh = spec.add_mesh(
            name=f"sail_{index}",
            uservert=(scale * points).ravel(),
            userface=cloth.faces.ravel(),
            usertexcoord=cloth.places.ravel(),
        )
        mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
    for name, material, rgba, group in (
        ("kite", "sail", [1, 1, 1, 1], KITE),
        ("reference", "reference", [*REFERENCE, 1], REFERENCE_GROUP),
    ):
        body = spec.worldbody.add_body(name=name, mocap=True)
        for index in (0, 1):
            body.add_geom(
                type=mujoco.mjtGeom.mjGEOM_MESH,
                meshname=f"sail_{index}",
                material=material,
                rgba=rgba,
                group=group + index,
                contype=0,
                conaffinity=0,
            )


class Sails:
    """Sets the vertices of the sails of a drawing model, and gives them to OpenGL."""

    def __init__(self, parameters: Parameters, model: Any) -> None:
        self._parameters, self._model = parameters, model
        self.cloth = canopy(parameters.kite)
        self._meshes = [model.mesh(f"sail_{index}").id for index in (0, 1)]
        self._scales = (1.0, enlargement(parameters))
        self._material = model.material("sail").id
        self._set: dict[int, Fill] = {}
        self._stale: set[int] = set()

    def fill(self, motion: Motion, wide: bool) -> Fill:
        """Fills the sail that is seen as the wind of `motion` does."""
        index, fill = int(wide), fill_of(self._parameters, motion)
        if self._set.get(index) != fill:
            self._set[index] = fill
            self._stale.add(index)
            self._move(index, self._scales[index] * self.cloth.shape(fill))
        return fill

    def _move(self, index: int, points: Points) -> None:
        """Writes vertices [m, B] and their normals where the compiler put the mesh."""
        model, mesh = self._model, self._meshes[index]
        first, number = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
        turn = np.empty(9)
        mujoco.mju_quat2Mat(turn, model.mesh_quat[mesh])
        rows, turned = slice(first, first + number), turn.reshape(3, 3)
        model.mesh_vert[rows] = (points - model.mesh_pos[mesh]) @ turned
        start = model.mesh_normaladr[mesh]
        model.mesh_normal[start : start + number] = normals(points, self.cloth.faces) @ turned

    def light(self, motion: Motion, eye: Vector, sun: Vector) -> None:
        """Lets the light of a `sun` [E, where it shines to] through, where it falls from behind."""
        body = motion.body
        seen = 1.0 if dot(body.R_BE.z, minus(eye, body.p_G_E)) > 0 else -1.0
        behind = max(0.0, seen * dot(body.R_BE.z, sun)) / norm(sun)
        self._model.mat_emission[self._material] = GLOW + THROUGH * behind

    def upload(self, context: Any) -> None:
        """Gives what has changed to the current context."""
        for index in self._stale:
            mujoco.mjr_uploadMesh(self._model, context, self._meshes[index])
        self._stale.clear()
