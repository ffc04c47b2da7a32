"""The MuJoCo model that is only drawn: ground, sky, rings and two kites.

It has no dynamics.
"""

from math import log10
from typing import Any

import numpy as np

from kitemj.mujoco_import import mujoco
from kitemj.physics.frames import world
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import times
from kitemj.scene.cloth import WHITE
from kitemj.scene.gusts_and_grass import add_gusts_and_grass
from kitemj.scene.kites import add_kites
from kitemj.scene.landscape import add_landscape
from kitemj.scene.model_parts import Mesh, add_mesh, add_shape, add_texture, paint_texture
from kitemj.scene.quality import Quality
from kitemj.scene.sun import sun

RING_GROUP = 5
AMBIENT = 0.55
RINGS = 6
RING_WIDTH = 0.008  # half of it, in steps
RING_BAND = 4  # width of the textured band in widths of the ring
RING_TEXELS = 64
RING_ALPHA = 0.5


def drawing_model(parameters: Parameters, width: int, height: int, quality: Quality) -> Any:
    """The compiled ``MjModel`` for frames of `width` x `height` pixels."""
    spec = mujoco.MjSpec()
    spec.visual.global_.offwidth, spec.visual.global_.offheight = width, height
    spec.visual.quality.offsamples = quality.samples
    spec.visual.quality.shadowsize = 0
    spec.visual.headlight.ambient = [AMBIENT] * 3
    spec.visual.headlight.diffuse = spec.visual.headlight.specular = [0.0] * 3
    sunlight = times(-1.0, world(sun(parameters)))
    spec.worldbody.add_light(
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
        dir=[*sunlight],
        diffuse=[(1.0 - AMBIENT) / -sunlight.z] * 3,  # level ground shows its colour as it is
        specular=[0.0] * 3,
        castshadow=False,
    )
    pictures = add_landscape(spec, parameters, quality.texels)
    add_gusts_and_grass(spec, parameters)
    _add_rings(spec, parameters.lines.length)
    add_kites(spec, parameters)
    model = spec.compile()
    for name, picture in pictures.items():
        paint_texture(model, name, picture)
    return model


def ring_step(length: float) -> float:
    """Distance [m] between rings around O_E: 1, 2 or 5 times a power of ten, near L₀/4."""
    decade = 10.0 ** np.floor(log10(length / 4))
    return float(max(s * decade for s in (1, 2, 5) if s * decade <= length / 4 * 1.001))


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
    add_texture(spec, "ring", line)
    lift = [0.0, 0.0, 0.0006 * length]  # out of the ground's depth rounding
    for k in range(1, RINGS + 1):
        band = RING_BAND * RING_WIDTH * step
        ring = _annulus(k * step - band, k * step + band)
        across = np.repeat([[0.0, 0.5], [1.0, 0.5]], len(ring.vertices) // 2, axis=0)
        add_mesh(spec, f"ring_{k}", ring, across)
        white = {"material": "ring", "rgba": [*WHITE, RING_ALPHA]}
        add_shape(spec.worldbody, f"ring_{k}", **white, pos=lift, group=RING_GROUP)


def _annulus(inner: float, outer: float) -> Mesh:
    """A flat ring around the origin, its face up."""
    sides = 96
    turn = np.arange(sides) * 2 * np.pi / sides
    circle = np.stack([np.cos(turn), np.sin(turn), np.zeros(sides)], 1)
    i, j = np.arange(sides), (np.arange(sides) + 1) % sides
    faces = np.concatenate([np.stack([i, i + sides, j + sides], 1), np.stack([i, j + sides, j], 1)])
    return Mesh(np.concatenate([inner * circle, outer * circle]), faces.astype(np.int32))
