"""The shape of the kite, how the wind fills it, and its lines."""

from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray

from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.vectors import Vector, minus, norm
from kitemj.scene.canopy import canopy, framed, surface_point
from kitemj.scene.cloth import Cloth, Fill, fill_of
from kitemj.scene.lines import drawn, hanging
from tests.scene.motions import EQUILIBRIUM, LAKSA, motion_at
from tests.support import pulling

STUNT = parameter_set("sport")
TRAINER = parameter_set("trainer")
KITES = pytest.mark.parametrize(
    "parameters", [LAKSA, STUNT, TRAINER], ids=["foil", "delta", "diamond"]
)
FULL, SLACK = Fill(1.0, 1.0, 0.0), Fill(0.0, 0.0, 0.0)


def test_short_bridles_have_frames() -> None:
    assert framed(STUNT.kite)
    assert framed(TRAINER.kite), "a diamond with spars"
    assert not framed(LAKSA.kite)
    assert len(canopy(STUNT.kite).rods)
    assert not len(canopy(LAKSA.kite).rods)


def test_a_diamond_is_as_high_as_its_area_asks_for() -> None:
    """Peter Powell's: half of span times spine is the area."""
    kite = TRAINER.kite
    spine = np.ptp(canopy(kite).shape(FULL)[:, 0])
    assert spine * kite.span / 2 == pytest.approx(kite.area, rel=0.05)


@KITES
def test_the_mean_chord_and_the_span_are_the_kites(parameters) -> None:
    kite = parameters.kite
    points = canopy(kite).shape(FULL)
    # the arched section stands upright on the arch: its thickness adds a little at the tips
    assert np.ptp(points[:, 1]) == pytest.approx(kite.span, rel=0.04)
    across = np.linspace(-1, 1, 401)
    nose, tail = ([surface_point(kite, a, s).x for a in across] for s in (0.0, 1.0))
    assert np.mean(np.subtract(nose, tail)) == pytest.approx(kite.chord, rel=0.01)


def outsides(cloth: Cloth, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Twice the areas of the faces (n, 3), as vectors outwards."""
    a, b, c = (points[cloth.faces[:, k]] for k in range(3))
    return np.cross(b - a, c - a)


@KITES
def test_every_face_of_the_cloth_has_an_outside(parameters) -> None:
    """No hole is left: areas of a closed surface add up to nothing; outwards, to its volume."""
    cloth = canopy(parameters.kite)
    points = cloth.shape(FULL)
    areas = outsides(cloth, points)
    assert areas.sum(axis=0) == pytest.approx([0, 0, 0], abs=1e-9 * np.abs(areas).sum())
    volume = np.einsum("ij,ij->", points[cloth.faces[:, 0]], areas) / 6
    assert volume > 0.01 or framed(parameters.kite), "m³"


def belly(parameters, fill: Fill, side: float) -> float:
    """How far [m] the middle of one side's cloth is behind its edges, as the pilot sees it."""
    points = canopy(parameters.kite).shape(fill)
    own = points[side * points[:, 1] > 0.15 * parameters.kite.span]
    own = own[np.abs(own[:, 1]) < 0.25 * parameters.kite.span]
    return -float(own[:, 2].min())


@KITES
def test_cloth_billows_away_from_the_pilot_with_the_load(parameters) -> None:
    depths = [belly(parameters, Fill(f, f, 0.0), 1.0) for f in (0.0, 0.5, 1.0)]
    assert depths == sorted(depths)
    assert depths[2] - depths[0] > 0.01 * parameters.kite.span
    one = Fill(1.0, 0.2, 0.0)
    assert belly(parameters, one, 1.0) > belly(parameters, one, -1.0), "left pulls, left is full"


@KITES
def test_slack_cloth_flutters_and_full_cloth_stands(parameters) -> None:
    shape = canopy(parameters.kite).shape
    moved = [np.abs(shape(f) - shape(f._replace(t=0.05))).max() for f in (FULL, SLACK)]
    assert moved[0] == 0.0
    assert moved[1] > 0.03 * parameters.kite.chord
    assert np.array_equal(shape(SLACK), shape(SLACK)), "the same motion, the same cloth"


def test_the_fill_follows_the_pull_of_its_own_line() -> None:
    motion = motion_at(STUNT, EQUILIBRIUM)
    fills = [fill_of(STUNT, pulling(motion, *both)) for both in ((0, 5), (5, 50), (50, 500))]
    assert [f.left for f in fills] == sorted(f.left for f in fills)
    assert all(0.0 <= f.left < f.right < 1.0 for f in fills)
    assert fill_of(STUNT, pulling(motion, -3.0, 0.0))[:2] == (0.0, 0.0), "a push fills nothing"


def colours(cloth: Cloth, side: float) -> NDArray[np.float64]:
    """Means (3,) of the image where the vertices of one side are; the last part is white's."""
    rows, columns, _ = cloth.image.shape
    own = cloth.places[side * cloth.shape(FULL)[:, 1] > 0.02]
    x = (own[:, 0].clip(0, 0.9999) * columns).astype(int)
    y = (own[:, 1] % 1.0 * rows).astype(int)
    return cloth.image[y, x].astype(float)


@KITES
def test_left_is_red_and_right_is_blue_and_not_by_colour_alone(parameters) -> None:
    cloth = canopy(parameters.kite)
    left, right = colours(cloth, 1.0), colours(cloth, -1.0)
    assert left.mean(axis=0)[0] > 1.3 * left.mean(axis=0)[2]
    assert right.mean(axis=0)[2] > 1.3 * right.mean(axis=0)[0]
    # bands of white across the outer half: one on the left, two on the right
    image = cloth.image.astype(int)
    place = 0.4 if parameters is TRAINER else 0.8  # where the sail is wide
    row = image[int(image.shape[0] * place)].min(axis=1) > 200  # white
    half = len(row) // 2
    outer = half // 4
    bands = [
        int((np.diff(np.r_[0, part.astype(int)]) == 1).sum())
        for part in (row[half + outer :], row[: half - outer])
    ]
    assert bands == [1, 2]


def test_a_hanging_line_is_as_long_as_it_is() -> None:
    end, length = Vector(-30.0, 5.0, -50.0), 60.0
    points = hanging(end, length)
    drawn_length = sum(norm(minus(b, a)) for a, b in pairwise(points))
    assert points[0] == Vector(0.0, 0.0, 0.0)
    assert points[-1] == pytest.approx(end)
    assert drawn_length == pytest.approx(length, rel=0.01)
    assert max(p.z for p in hanging(Vector(-30.0, 0.0, -1.0), 40.0)) <= 0.0


def test_a_line_goes_from_the_hand_to_its_attachment() -> None:
    hand = Vector(-0.4, 0.2, -1.3)
    for slack in (0.0, 2.0):
        line = motion_at(STUNT, EQUILIBRIUM, slack=slack).lines[0]
        points = drawn(line, hand)
        assert points[0] == pytest.approx(hand)
        assert points[-1] == pytest.approx(line.points[-1])
        way = sum(norm(minus(b, a)) for a, b in pairwise(points))
        assert way == pytest.approx(line.length, abs=1.5), "m: the hands' place"
        assert (len(points) > 2) == (slack > 0.0)
