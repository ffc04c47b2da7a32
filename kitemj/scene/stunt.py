"""A stunt kite of sail and frame, a delta or a diamond in panels, from span and chord.

The sail is a sheet that is held by the leading edges, the spine and, behind, the standoffs;
between them it bellies away from the pilot. The frame is on the pilot's side of it.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.physics.kite import Kite
from kitemj.physics.vectors import Vector
from kitemj.scene.cloth import BLUE, DARK, RED, WHITE, Cloth, Fill, Points, dyed, sheet

BEND = 1.09  # of the leading edge: 1 is straight
DIHEDRAL = 0.05  # how far the tips are behind the nose, as the pilot sees it, in spans
BELLY, SLACK_BELLY = 0.11, 0.015  # depth in spans, when full and when slack
HELD = 0.6  # the fill for which the standoffs are long enough
FRONT = 0.008  # of the frame before the sail, in spans
FLUTTER = 0.03  # of a slack sail's edge, in spans
BEATS, WAVES = 5.0, 2.3  # 1/s; along half the span
ACROSS, ALONG = 14, 8  # quadrilaterals of one half, and from edge to edge
TEXELS = (256, 512)


class Cut(NamedTuple):
    """How a sail is cut. Depths are behind the nose, in heights; places across in half spans.

    `tips`: the depth of the tips. `edge`: the trailing edge, places and depths; `hollow`: how far
    it is cut in between those. `cross`: the depth on the spine where the spreaders meet that go
    to `lower` on the leading edges; `upper`: where another goes from edge to edge, 0 without one.
    `standoffs`: where they hold the trailing edge.
    """

    tips: float
    edge: tuple[tuple[float, float], ...]
    hollow: tuple[float, ...]
    cross: float
    lower: float
    upper: float = 0.0
    standoffs: tuple[float, ...] = ()


DELTA = Cut(
    1.0,
    ((0.0, 0.83), (0.2, 0.89), (0.43, 0.94), (1.0, 1.0)),
    (0.012, 0.016, 0.055),
    cross=0.5,
    lower=0.70,
    upper=0.30,
    standoffs=(0.2, 0.43),
)
DIAMOND = Cut(0.38, ((0.0, 1.0), (1.0, 0.38)), (0.02,), cross=0.38, lower=0.97)
SLENDER = 3.0
"""Spans to chords; a triangle of less would be as high as it is wide: that is a diamond."""


class Outline(NamedTuple):
    """The sail's plan: `height` [m] along the spine's line, `nose` [m] ahead of G."""

    cut: Cut
    span: float
    height: float
    nose: float

    def leading(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """x [m] of the leading edge, at `u` half spans from the middle, 0 to 1."""
        return self.nose - self.height * _leading(self.cut, u)

    def trailing(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """x [m] of the trailing edge."""
        return self.nose - self.height * _trailing(self.cut, u)


def outline(kite: Kite) -> Outline:
    """The plan of which the mean chord is the kite's, its middle of area at G."""
    cut, u = DELTA if kite.span > SLENDER * kite.chord else DIAMOND, np.linspace(0.0, 1.0, 2001)
    first, last = _leading(cut, u), _trailing(cut, u)
    chord, middle = last - first, (last + first) / 2
    height = kite.chord / float(chord.mean())
    return Outline(cut, kite.span, height, height * float((chord * middle).mean() / chord.mean()))


def stunt(kite: Kite) -> Cloth:
    """The cloth of a stunt kite."""
    plan = outline(kite)
    half = np.unique(np.concatenate([np.linspace(0.0, 1.0, ACROSS + 1), plan.cut.standoffs]))
    u, v = np.meshgrid(
        np.concatenate([-half[:0:-1], half]), np.linspace(0.0, 1.0, ALONG + 1), indexing="ij"
    )
    flat = _flat(plan, u, v)
    faces = sheet(*u.shape)
    both = np.concatenate([faces, faces[:, ::-1] + flat.shape[0]])

    def shape(fill: Fill) -> Points:
        points = _filled(plan, flat, u, v, fill)
        return np.concatenate([points, points])

    places = np.stack([flat[:, 1] / plan.span + 0.5, (plan.nose - flat[:, 0]) / plan.height], 1)
    return Cloth(
        shape,
        both,
        np.concatenate([places, places]),
        _panels(plan.cut),
        _rods(plan),
        np.concatenate([_knots(plan, side) for side in (1.0, -1.0)]),
    )


def point(kite: Kite, across: float, along: float) -> Vector:
    """Point [m, B] of the flat sail: `across` -1 to 1 (A₊), `along` 0 (leading edge) to 1."""
    return Vector(*map(float, _at(outline(kite), across, along)))


def _leading(cut: Cut, u: NDArray[np.float64]) -> NDArray[np.float64]:
    """The leading edge behind the nose, in heights."""
    return np.asarray(cut.tips * u**BEND)


def _trailing(cut: Cut, u: NDArray[np.float64]) -> NDArray[np.float64]:
    """The trailing edge behind the nose, in heights."""
    knots, depths = zip(*cut.edge, strict=True)
    edge: NDArray[np.float64] = np.interp(u, knots, depths)
    for (a, b), hollow in zip(pairwise(knots), cut.hollow, strict=True):
        inside = (u > a) & (u < b)
        edge[inside] -= hollow * np.sin(np.pi * (u[inside] - a) / (b - a))
    return edge


def _flat(plan: Outline, u: NDArray[np.float64], v: NDArray[np.float64]) -> Points:
    """Points [m, B] of the sail as it is cut."""
    aside = np.abs(u)
    x = (1 - v) * plan.leading(aside) + v * plan.trailing(aside)
    z = DIHEDRAL * plan.span * (0.4 - aside)
    return np.stack([x, u * plan.span / 2, z], axis=-1).reshape(-1, 3)


def _filled(
    plan: Outline,
    flat: Points,
    u: NDArray[np.float64],
    v: NDArray[np.float64],
    fill: Fill,
) -> Points:
    """Points [m, B] of the sail in the wind: away from the pilot, most behind the middle."""
    full = np.where(u > 0, fill.left, fill.right)
    aside = np.abs(u)
    hold = 2.6 * aside**0.7 * (1 - aside) * np.sin(np.pi * 0.72 * v)
    belly = (SLACK_BELLY + (BELLY - SLACK_BELLY) * full) * hold
    wave = np.sin(2 * np.pi * (WAVES * aside + 0.6 * v - BEATS * fill.t) + (u > 0))
    loose = FLUTTER * (1 - full) ** 3 * v**2 * (1 - aside) ** 0.5 * np.minimum(6 * aside, 1)
    points = flat.copy()
    points[:, 2] -= plan.span * (belly + loose * wave).ravel()
    return points


def _at(plan: Outline, u: float, v: float) -> Points:
    """A point (3,) [m, B] of the sail as it is cut."""
    place: Points = _flat(plan, np.array([u]), np.array([v]))[0]
    return place


def _rods(plan: Outline) -> NDArray[np.float64]:
    """Leading edges, spine, spreaders and standoffs, from end to end (n, 2, 3) [m, B]."""
    front, cut = np.array([0.0, 0.0, FRONT * plan.span]), plan.cut
    nose, cross, end = (
        place + front for place in (_at(plan, 0.0, 0.0), _cross(plan), _at(plan, 0.0, 1.0))
    )
    rods = [(nose, end)]
    if cut.upper:
        rods.append((_at(plan, cut.upper, 0.0) + front, _at(plan, -cut.upper, 0.0) + front))
    for side in (1.0, -1.0):
        rods += pairwise([_at(plan, side * u, 0.0) + front for u in (0.0, 0.25, 0.6, 0.97)])
        lower = _at(plan, side * cut.lower, 0.0) + front
        rods.append((cross, lower))
        for u in cut.standoffs:
            tail = np.array([[side * u]]), np.array([[1.0]])
            held = _filled(plan, _flat(plan, *tail), *tail, Fill(HELD, HELD, 0.0))[0]
            rods.append((cross + u / cut.lower * (lower - cross), held))
    return np.array(rods)


def _cross(plan: Outline) -> Points:
    """Where the spreaders meet on the spine (3,) [m, B]."""
    return _at(plan, 0.0, plan.cut.cross / plan.cut.edge[0][1])


def _knots(plan: Outline, side: float) -> Points:
    """Where the bridle's legs of one side are tied (3, 3) [m, B]; on the spine beside the other."""
    edge = [_at(plan, side * u, 0.0) for u in (0.30, 0.70)]
    return np.array([*edge, _cross(plan) + np.array([0.0, 1e-6 * side, 0.0])])


def _panels(cut: Cut) -> NDArray[np.uint8]:
    """The sail's colours: red left, blue right, white about the spine; one band left, two right."""
    rows, columns = TEXELS
    down, across = np.meshgrid(
        (np.arange(rows) + 0.5) / rows, (np.arange(columns) + 0.5) / columns * 2 - 1, indexing="ij"
    )
    u, left = np.abs(across), across > 0
    wide = np.minimum(down / cut.tips, 1.0) ** (1 / BEND)  # of the sail there
    if cut.tips < 1:
        wide = np.minimum(wide, (1.001 - down) / (1 - cut.tips))
    # rays from nose and tail: 0 on the spine, 1 on the edges
    ray = u / np.maximum(wide, 1e-3)
    image = np.where(left[..., None], RED, BLUE)
    image[ray > 0.74] *= 0.62
    dyed(image, ray < 0.20, WHITE)
    image[ray < 0.075] = (0.98, 0.78, 0.16)
    for seam in (0.20, 0.47, 0.74):
        image[np.abs(ray - seam) * wide < 0.006] *= 0.55
    for side, bands in ((left, (0.66,)), (~left, (0.58, 0.74))):
        for band in bands:
            dyed(image, side & (np.abs(u - band) < 0.045), WHITE)
    behind = _trailing(cut, u.ravel()).reshape(u.shape) - down
    dyed(image, behind < 0.016, DARK)
    dyed(image, (1 - ray) * wide < 0.022, DARK)
    dyed(image, down < 0.06, DARK)  # the nose is reinforced
    return np.asarray(255 * np.clip(image, 0, 1), np.uint8)
