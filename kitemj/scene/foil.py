"""A parafoil: an arched, tapered wing of cells that the air blows up, from span and chord."""

from collections.abc import Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from kitemj.physics.kite import Kite
from kitemj.physics.vectors import Vector
from kitemj.scene.cloth import BLUE, DARK, RED, WHITE, Cloth, Fill, Points, dyed, sheet

ARCH = 0.20  # depth of the arch in spans
THICKNESS = 0.12  # of the section in chords
CAMBER = 0.06
CELLS = 15
BULGE = 0.035  # of a cell between its ribs, in chords
SAG, FLUTTER = 0.35, 0.05  # of a slack wing: less arch; waves of the tail in chords
BEATS, WAVES = 3.0, 3.0  # 1/s; along the span
ACROSS = 3  # quadrilaterals of one cell along the span
PROFILE = 8  # of the upper side of the section, and of the lower
RIBS = (0.25, 0.6, 0.95)  # half spans at which the bridle is tied,
ROWS = (0.08, 0.42, 0.8)  # and chords
TEXELS = (128, 1024)


def foil(kite: Kite) -> Cloth:
    """The cloth of a parafoil."""
    across = np.linspace(-1.0, 1.0, ACROSS * CELLS + 1)
    n = len(across)
    rows = 2 * PROFILE + 1  # the nose is first and last
    ring = np.arange(rows - 1) * n
    caps = [[ring[0], ring[k + 1], ring[k]] for k in range(1, rows - 2)]
    last = [[a + n - 1, c + n - 1, b + n - 1] for a, b, c in caps]
    faces = np.concatenate([sheet(rows, n), np.array(caps + last)]).astype(np.int32)
    # upper side 0.5 to 1, lower side on to 1.5: images repeat
    s, t = np.meshgrid((across + 1) / 2, 0.5 + np.arange(rows) / (2 * PROFILE))
    return Cloth(
        lambda fill: _filled(kite, across, fill),
        faces,
        np.stack([s.ravel(), t.ravel()], axis=1),
        _cells(),
        np.empty((0, 2, 3)),
        np.array([point(kite, side * a, b) for side, a, b in product((1, -1), RIBS, ROWS)]),
    )


def point(kite: Kite, across: float, along: float) -> Vector:
    """Point [m, B] on the chord: `across` -1 to 1 (A₊), `along` 0 (nose) to 1 (tail)."""
    nose, chord, z = _section(kite, across)
    return Vector(nose - along * chord, across * kite.span / 2, z)


def _section(kite: Kite, across: float) -> tuple[float, float, float]:
    """x of the nose, chord and z [m] of the section at `across`; the mean chord is the kite's."""
    chord = kite.chord * 1.2 * (1 - 0.5 * across**2)
    nose = 0.6 * kite.chord - 0.28 * kite.chord * across**2
    return nose, chord, ARCH * kite.span * (across**2 - 1 / 3)


def _filled(kite: Kite, across: NDArray[np.float64], fill: Fill) -> Points:
    """Points [m, B]: for each place around the section, those along the span."""
    s = (1 - np.cos(np.linspace(0, np.pi, PROFILE + 1))) / 2
    # NACA four-digit thickness with a closed tail; round the nose, thin behind
    outline = 0.2969 * np.sqrt(s) - 0.1260 * s - 0.3516 * s**2 + 0.2843 * s**3 - 0.1036 * s**4
    shape, camber = 5 * THICKNESS * outline, CAMBER * 4 * s * (1 - s)
    lower = slice(-2, None, -1)
    along = np.concatenate([s, s[lower]])[:, None]
    side = np.repeat([1.0, -1.0], [PROFILE + 1, PROFILE])[:, None]
    thick = np.concatenate([shape, shape[lower]])[:, None] * side
    full = np.where(across > 0, fill.left, fill.right)
    # a rib holds the section, between two the cloth is blown up
    rib = np.abs(np.sin(np.pi * CELLS * (across + 1) / 2))
    blown = side * BULGE * rib * np.sqrt(full) * np.sin(np.pi * along) ** 0.5
    wave = np.sin(2 * np.pi * (WAVES * across - along - BEATS * fill.t))
    loose = FLUTTER * (1 - full) ** 3 * along**2 * wave
    mean = np.concatenate([camber, camber[lower]])[:, None]
    height = mean + thick * (0.65 + 0.35 * np.sqrt(full)) + blown + loose
    nose, chord, z = _sections(kite, across)
    slope = 4 * ARCH * across  # dz/dy of the arch; the section stands upright on it
    upright = np.hypot(1.0, slope)
    x = nose - chord * along
    y = across * kite.span / 2 + chord * height * slope / upright
    down = z - chord * height / upright
    flat = 1 - SAG * (1 - full) ** 3
    return np.stack([x, y, down * flat], axis=-1).reshape(-1, 3)


def _sections(kite: Kite, across: NDArray[np.float64]) -> Sequence[NDArray[np.float64]]:
    return [np.array(each) for each in zip(*(_section(kite, a) for a in across), strict=True)]


def _cells() -> NDArray[np.uint8]:
    """Colours: red left, blue right, white in the middle; one white cell left, two right."""
    rows, columns = TEXELS
    t, s = np.meshgrid(
        (np.arange(rows) + 0.5) / rows, (np.arange(columns) + 0.5) / columns, indexing="ij"
    )
    cell = s * CELLS
    number = np.floor(cell).astype(int) - CELLS // 2  # 0 in the middle, positive to the left
    image = np.where((number > 0)[..., None], RED, BLUE)
    image[number % 2 == 0] *= 0.72
    dyed(image, np.isin(number, (0, 5, -4, -6)), WHITE)
    seam = np.abs(cell - np.round(cell)) < 0.035
    image[seam] *= 0.6
    dyed(image, (t < 0.5) & (t > 0.45) & ~seam, DARK)  # the mouths, below the nose
    return np.asarray(255 * np.clip(image, 0, 1), np.uint8)
