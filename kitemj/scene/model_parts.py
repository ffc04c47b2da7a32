"""Meshes, textures and shapes added to the specification of a drawing model."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.mujoco_import import mujoco


class Mesh(NamedTuple):
    """Vertices (n, 3) [m, W] and the triangles (m, 3) that index them, outside to the front."""

    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]


def add_mesh(spec: Any, name: str, mesh: Mesh, texcoord: Any = ()) -> None:
    added = spec.add_mesh(name=name, uservert=mesh.vertices.ravel(), userface=mesh.faces.ravel())
    added.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL  # flat meshes have no volume
    added.usertexcoord = np.ravel(texcoord)


def add_texture(spec: Any, name: str, kind: Any, image: NDArray[np.uint8]) -> None:
    height, width, channels = image.shape
    size = {"width": width, "height": height, "nchannel": channels}
    spec.add_texture(name=name, type=kind, **size, data=image.ravel())
    if kind == mujoco.mjtTexture.mjTEXTURE_2D:
        layers = [""] * int(mujoco.mjtTextureRole.mjNTEXROLE)
        layers[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = name
        spec.add_material(name=name, textures=layers, specular=0.0)


def add_shape(body: Any, mesh: str, **attributes: Any) -> None:
    """Adds a geom that takes no part in contacts, so that flat meshes need no convex hull."""
    kind = mujoco.mjtGeom.mjGEOM_MESH
    body.add_geom(type=kind, meshname=mesh, contype=0, conaffinity=0, **attributes)
