"""Meshes, textures and shapes added to the specification of a drawing model."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.mujoco_import import mujoco

FLAT = mujoco.mjtTexture.mjTEXTURE_2D


class Mesh(NamedTuple):
    """Vertices (n, 3) [m, W] and the triangles (m, 3) that index them, outside to the front."""

    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]


def add_mesh(spec: Any, name: str, mesh: Mesh, texcoord: Any = (), normals: Any = ()) -> None:
    """Adds a mesh; if textured, where in its texture (u, v) each vertex is; its normals, or own."""
    added = spec.add_mesh(name=name, uservert=mesh.vertices.ravel(), userface=mesh.faces.ravel())
    added.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL  # flat meshes have no volume
    added.usertexcoord, added.usernormal = np.ravel(texcoord), np.ravel(normals)


def add_texture(spec: Any, name: str, image: NDArray[np.uint8]) -> None:
    """Adds a picture (height, width, 3 or 4) as a texture, and a material of its name."""
    height, width, channels = image.shape
    size = {"width": width, "height": height, "nchannel": channels}
    spec.add_texture(name=name, type=FLAT, **size, data=image.ravel())
    _add_material(spec, name)


def add_blank_texture(spec: Any, name: str, side: int) -> None:
    """Adds a texture of `side` texels that `paint_texture` is to paint, and a material.

    The engine reads a picture that it is given number by number, 0.3 s for a million texels.
    """
    plain = mujoco.mjtBuiltin.mjBUILTIN_FLAT
    spec.add_texture(name=name, type=FLAT, builtin=plain, width=side, height=side, nchannel=3)
    _add_material(spec, name)


def paint_texture(model: Any, name: str, image: NDArray[np.uint8]) -> None:
    """Paints a picture of the size that the texture has, in the compiled model."""
    begin = model.tex_adr[model.texture(name).id]
    model.tex_data[begin : begin + image.size] = image.ravel()


def _add_material(spec: Any, name: str) -> None:
    layers = [""] * int(mujoco.mjtTextureRole.mjNTEXROLE)
    layers[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = name
    spec.add_material(name=name, textures=layers, specular=0.0)


def add_shape(body: Any, mesh: str, **attributes: Any) -> None:
    """Adds a geom that takes no part in contacts, so that flat meshes need no convex hull."""
    kind = mujoco.mjtGeom.mjGEOM_MESH
    body.add_geom(type=kind, meshname=mesh, contype=0, conaffinity=0, **attributes)
