"""The shape of the kite as triangles: an arched, tapered foil in cells, from span and chord.

Coordinates are those of the body frame B (x forward, y starboard, z to the ground), the
centre of mass at the origin. Only for the eye: no force is computed from it.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.physics.kite import Kite
from kitemj.physics.vectors import Vector

ARCH = 0.20  # depth of the arch in spans
THICKNESS = 0.11  # of the section in chords
CELLS = 9  # of one half
STRIPE = 0.045  # half width of the white stripe in spans
ACROSS = 3  # quadrilaterals of one cell along the span
PROFILE = 10  # points of the upper side of the section, and of the lower


class Mesh(NamedTuple):
    """Vertices (n, 3) [m, B] and the triangles (m, 3) that index them, outside to the front."""

    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]


def canopy(kite: Kite, scale: float = 1.0) -> dict[str, Mesh]:
    """The meshes by name: "plus_light", "plus_dark", "minus_light", "minus_dark", "stripe".

    "plus" is the half of A₊ (y > 0). `scale` enlarges all about the centre of mass.
    """
    edges = np.linspace(2 * STRIPE, 1.0, CELLS + 1)
    parts = {"stripe": _cell(kite, -2 * STRIPE, 2 * STRIPE)}
    for side, name in ((1.0, "plus"), (-1.0, "minus")):
        cells = [_cell(kite, *sorted((side * a, side * b))) for a, b in pairwise(edges)]
        parts[f"{name}_light"] = _joined(cells[0::2])
        parts[f"{name}_dark"] = _joined(cells[1::2])
    return {name: Mesh(scale * part.vertices, part.faces) for name, part in parts.items()}


def surface_point(kite: Kite, across: float, along: float) -> Vector:
    """Point [m, B] on the chord: `across` -1 (A₋) to 1 (A₊), `along` 0 (nose) to 1 (tail)."""
    nose, chord, z = _section(kite, across)
    return Vector(nose - along * chord, across * kite.span / 2, z)


def _section(kite: Kite, across: float) -> tuple[float, float, float]:
    """x of the nose, chord and z [m] of the section at `across`; the mean chord is the kite's."""
    chord = kite.chord * 1.2 * (1 - 0.5 * across**2)
    nose = 0.6 * kite.chord - 0.28 * kite.chord * across**2
    return nose, chord, ARCH * kite.span * (across**2 - 1 / 3)


def _loop(kite: Kite, across: float) -> NDArray[np.float64]:
    """The closed section (2 PROFILE, 3): along the upper side to the tail, back below."""
    nose, chord, z = _section(kite, across)
    s = (1 - np.cos(np.linspace(0, np.pi, PROFILE + 1))) / 2
    # NACA four-digit thickness with a closed tail; round the nose, thin behind
    outline = 0.2969 * np.sqrt(s) - 0.1260 * s - 0.3516 * s**2 + 0.2843 * s**3 - 0.1036 * s**4
    shape, camber = 5 * THICKNESS * outline, 0.06 * 4 * s * (1 - s)
    x, up, low = nose - chord * s, chord * (camber + shape), chord * (camber - shape)
    slope = 2 * ARCH * 2 * across  # dz/dy of the arch; the section stands upright on it
    normal = np.array([0.0, slope, -1.0]) / np.hypot(1.0, slope)
    middle = np.array([0.0, across * kite.span / 2, z])
    around = np.concatenate([np.arange(PROFILE + 1), np.arange(PROFILE - 1, 0, -1)])
    height = np.concatenate([up, low[-2:0:-1]])
    points: NDArray[np.float64] = middle + height[:, None] * normal
    points[:, 0] = x[around]
    return points


def _cell(kite: Kite, start: float, end: float) -> Mesh:
    """The closed body between two sections, `start` < `end` in half spans."""
    loops = [_loop(kite, across) for across in np.linspace(start, end, ACROSS + 1)]
    n = len(loops[0])
    faces = []
    for i in range(ACROSS):
        for j in range(n):
            a, b = i * n + j, i * n + (j + 1) % n
            faces += [(a, b, b + n), (a, b + n, a + n)]
    last = ACROSS * n
    for j in range(1, n - 1):
        faces += [(0, j + 1, j), (last, last + j, last + j + 1)]
    return Mesh(np.concatenate(loops), np.array(faces, np.int32))


def _joined(meshes: list[Mesh]) -> Mesh:
    starts = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes[:-1]])
    faces = [mesh.faces + start for mesh, start in zip(meshes, starts, strict=True)]
    return Mesh(np.concatenate([mesh.vertices for mesh in meshes]), np.concatenate(faces))
