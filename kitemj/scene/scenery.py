"""The MuJoCo model that is only drawn: ground, sky, rings and two kites.

It has no dynamics.
"""

from math import log10
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.mujoco_import import mujoco
from kitemj.physics.parameters import Parameters
from kitemj.scene.cloth import WHITE
from kitemj.scene.kites import KITE, add_kites

HORIZON = (0.86, 0.91, 0.95)
ZENITH = (0.24, 0.48, 0.80)
MEADOW = (0.47, 0.57, 0.40)

TILE = 100.0  # m of ground that the texture covers
TEXELS = 512
MEADOW_END = 1000.0  # m, half the side of the textured ground
EXTENT = 9000.0  # m, from here on all is horizon
HAZE = 24  # steps of colour from meadow to horizon
SUN = (-0.36, 0.36, -0.86)  # W, where its light goes
AMBIENT = 0.55
RINGS = 6
RING_NEAR, RING_FAR = 0.006, 0.016  # half the width of a ring in steps
RING_BAND = 4  # width of the textured band in widths of the ring
RING_TEXELS = 64
RING_ALPHA = 0.95  # below 1, or the engine does not blend
SKY = 64  # texels of one side of the sky's cube


class Mesh(NamedTuple):
    """Vertices (n, 3) [m, W] and the triangles (m, 3) that index them, outside to the front."""

    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]


def drawing_model(parameters: Parameters, width: int, height: int, software: bool) -> Any:
    """The compiled ``MjModel`` for frames of `width` x `height` pixels."""
    spec = mujoco.MjSpec()
    spec.visual.global_.offwidth, spec.visual.global_.offheight = width, height
    spec.visual.quality.offsamples = 0 if software else 4
    spec.visual.quality.shadowsize = 0
    spec.visual.headlight.ambient = [AMBIENT] * 3
    spec.visual.headlight.diffuse = spec.visual.headlight.specular = [0.0] * 3
    spec.worldbody.add_light(
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
        dir=[*SUN],
        diffuse=[(1.0 - AMBIENT) / (-SUN[2])] * 3,  # level ground shows its colour as it is
        specular=[0.0] * 3,
        castshadow=False,
    )
    _add_sky(spec)
    _add_ground(spec)
    _add_rings(spec, parameters.lines.length)
    add_kites(spec, parameters)
    return spec.compile()


def ring_step(length: float) -> float:
    """Distance [m] between rings around O_E: 1, 2 or 5 times a power of ten, near L₀/4."""
    decade = 10.0 ** np.floor(log10(length / 4))
    return float(max(s * decade for s in (1, 2, 5) if s * decade <= length / 4 * 1.001))


def _add_ground(spec: Any) -> None:
    """Adds the ground as a mesh: MuJoCo's plane costs thrice as much where the processor draws."""
    texture = _ground_texture()
    _add_texture(spec, "ground", mujoco.mjtTexture.mjTEXTURE_2D, texture)
    n = 16
    x = np.linspace(-MEADOW_END, MEADOW_END, n + 1)
    corners = np.array([(a, b, 0.0) for a in x for b in x])
    start = np.array([i * (n + 1) + j for i in range(n) for j in range(n)])
    a, b, c, d = start, start + n + 1, start + n + 2, start + 1
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    _add_mesh(spec, "ground", Mesh(corners, faces.astype(np.int32)), corners[:, :2] / TILE)
    _add_shape(spec.worldbody, "ground", material="ground")
    meadow = texture.mean(axis=(0, 1)) / 255
    edges = np.geomspace(MEADOW_END, EXTENT, HAZE + 1)
    for k in range(HAZE):
        blend = ((k + 0.5) / HAZE) ** 1.2
        colour = (1 - blend) * meadow + blend * np.array(HORIZON)
        _add_mesh(spec, f"haze_{k}", _annulus(edges[k], edges[k + 1]))
        # a hand's breadth lower, so that the corners of the meadow lie over the haze
        _add_shape(spec.worldbody, f"haze_{k}", rgba=[*colour, 1], pos=[0, 0, -0.5])


def _ground_texture() -> NDArray[np.uint8]:
    """Adds a texture: two greens in turn every 10 m, a line between, a bolder one every 100 m."""
    metre = TEXELS / TILE
    square = (np.arange(TEXELS) / metre // 10).astype(int)
    image = np.where(np.add.outer(square, square) % 2, 0.94, 1.0)[:, :, None] * np.array(MEADOW)
    thin = (np.arange(TEXELS) % (10 * metre)) < 1.0
    bold = np.arange(TEXELS) < 3
    for lines, strength in ((thin, 0.35), (bold, 0.6)):
        on = lines[:, None] | lines[None, :]
        image[on] += strength * (1.0 - image[on])
    return np.asarray(255 * image, np.uint8)


def _add_sky(spec: Any) -> None:
    """Adds a cube whose colour depends on elevation only; pale at the horizon and below."""
    across = (np.arange(SKY) + 0.5) / SKY * 2 - 1
    u, v = np.meshgrid(across, across)
    length = np.sqrt(1 + u**2 + v**2)
    wall, roof, floor = -v / length, 1 / length, -1 / length
    sine = np.concatenate([wall, wall, roof, floor, wall, wall])
    blend = (np.clip(sine, 0, 1) ** 0.55)[..., None]
    faces = np.asarray(255 * ((1 - blend) * HORIZON + blend * np.array(ZENITH)), np.uint8)
    _add_texture(spec, "sky", mujoco.mjtTexture.mjTEXTURE_SKYBOX, faces)


def _add_rings(spec: Any, length: float) -> None:
    """Adds white rings as bands of a texture that is clear beside the line.

    Where a ring is thinner than a pixel the texture's smaller copies make it faint; plain
    white meshes break into dashes there.
    """
    step = ring_step(length)
    line = np.zeros((4, RING_TEXELS, 4), np.uint8)
    line[:, :, :3] = 255
    core = RING_TEXELS // (2 * RING_BAND)
    line[:, RING_TEXELS // 2 - core : RING_TEXELS // 2 + core, 3] = 255
    _add_texture(spec, "ring", mujoco.mjtTexture.mjTEXTURE_2D, line)
    lift = [0.0, 0.0, 0.0006 * length]  # out of the ground's depth rounding
    for k in range(1, RINGS + 1):
        for size, half in enumerate((RING_NEAR, RING_FAR)):
            name = f"ring_{k}_{size}"
            band = RING_BAND * half * step
            ring = _annulus(k * step - band, k * step + band)
            across = np.repeat([[0.0, 0.5], [1.0, 0.5]], len(ring.vertices) // 2, axis=0)
            _add_mesh(spec, name, ring, across)
            white = {"material": "ring", "rgba": [*WHITE, RING_ALPHA]}
            _add_shape(spec.worldbody, name, **white, pos=lift, group=KITE + size)


def _annulus(inner: float, outer: float) -> Mesh:
    """A flat ring around the origin, its face up."""
    sides = 96
    turn = np.arange(sides) * 2 * np.pi / sides
    circle = np.stack([np.cos(turn), np.sin(turn), np.zeros(sides)], 1)
    i, j = np.arange(sides), (np.arange(sides) + 1) % sides
    faces = np.concatenate([np.stack([i, i + sides, j + sides], 1), np.stack([i, j + sides, j], 1)])
    return Mesh(np.concatenate([inner * circle, outer * circle]), faces.astype(np.int32))


def _add_mesh(spec: Any, name: str, mesh: Mesh, texcoord: Any = ()) -> None:
    added = spec.add_mesh(name=name, uservert=mesh.vertices.ravel(), userface=mesh.faces.ravel())
    added.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL  # flat meshes have no volume
    added.usertexcoord = np.ravel(texcoord)


def _add_texture(spec: Any, name: str, kind: Any, image: NDArray[np.uint8]) -> None:
    height, width, channels = image.shape
    size = {"width": width, "height": height, "nchannel": channels}
    spec.add_texture(name=name, type=kind, **size, data=image.ravel())
    if kind == mujoco.mjtTexture.mjTEXTURE_2D:
        layers = [""] * int(mujoco.mjtTextureRole.mjNTEXROLE)
        layers[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = name
        spec.add_material(name=name, textures=layers, specular=0.0)


def _add_shape(body: Any, mesh: str, **attributes: Any) -> None:
    """Adds a geom that takes no part in contacts, so that flat meshes need no convex hull."""
    kind = mujoco.mjtGeom.mjGEOM_MESH
    body.add_geom(type=kind, meshname=mesh, contype=0, conaffinity=0, **attributes)
