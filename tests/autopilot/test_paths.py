"""Paths on the sphere against geometry: great and small circles, areas, sizes, crossings."""

from math import asin, atan2, cos, pi, radians, sin, tan

import numpy as np
import pytest

from kitemj.autopilot.follow import advanced, length_of, nearest, vector_at
from kitemj.errors import InputError
from kitemj.flight.pilot_settings import PathSettings
from kitemj.paths.lemniscate import BLENDS, sharpest_bend, widest
from kitemj.paths.path import Path, courses, drifts, gliding, path_of, sampled
from kitemj.paths.sphere import course, direction
from kitemj.physics.compiled import Array
from kitemj.physics.vectors import Vector

GLIDE = 3.5
ROUNDING = 1e-9  # 1; of derivatives that are written out
SUMMED = 1e-6  # rad; of a sum over 720 points of a smooth curve
POLYGON = 2e-4  # rad²; 720 great circles in place of a curve
SPLINE = 2e-3  # rad²; the same, of a curve whose curvature has corners at its points

RING = tuple((0.5 * cos(a), 0.8 + 0.2 * sin(a) + 0.1 * cos(2 * a)) for a in np.arange(0, 6.2, 0.7))
CURVES = {
    "right": PathSettings(
        kind="circle", radius=radians(22.0), elevation=radians(44.0), turn="right"
    ),
    "left": PathSettings(kind="circle", radius=radians(22.0), elevation=radians(44.0), turn="left"),
    "aside": PathSettings(azimuth=radians(20.0), width=radians(50.0), height=radians(20.0)),
    "eight": PathSettings(),
    "down": PathSettings(turn="down"),
    "points": PathSettings(kind="points", points=RING),
}
EVEN = 1e-4  # of a step: what an arc's 4th order term and a spline's knots make
AREA = {"points": SPLINE}


def test_a_great_circle_does_not_turn() -> None:
    tilt = np.array([sin(0.3), 0.0, cos(0.3)])
    side, up = np.array([0.0, 1.0, 0.0]), np.array([cos(0.3), 0.0, -sin(0.3)])

    def curve(t: Array) -> tuple[Array, Array, Array]:
        r = np.outer(np.cos(t), up) + np.outer(np.sin(t), side)
        return r, np.outer(-np.sin(t), up) + np.outer(np.cos(t), side), -r

    # a path must lie downwind: of the whole circle only its curvature is asked for
    t = np.linspace(0.0, 2 * pi, 50)
    r, r_1, r_2 = curve(t)
    assert abs(np.sum(np.cross(r, r_1) * r_2, axis=1)).max() < ROUNDING
    assert abs(r @ tilt).max() < ROUNDING
    with pytest.raises(InputError, match="downwind"):
        sampled(curve, GLIDE)


@pytest.mark.parametrize("radius", [5.0, 22.0, 40.0])
@pytest.mark.parametrize(("turn", "sign"), [("right", 1.0), ("left", -1.0)])
def test_a_small_circle_turns_by_the_cotangent_of_its_radius(
    radius: float, turn: str, sign: float
) -> None:
    r = radians(radius)
    settings = PathSettings(kind="circle", radius=r, elevation=0.75, turn=turn)  # type: ignore[arg-type]
    path = path_of(settings, GLIDE)
    assert path.curvature == pytest.approx(sign / tan(r), rel=ROUNDING)
    assert length_of(path) == pytest.approx(2 * pi * sin(r), rel=ROUNDING)
    # from its top, a circle to the right goes right
    assert path.ahead[0] @ [0.0, 1.0, 0.0] == pytest.approx(sign)


@pytest.mark.parametrize("name", CURVES)
def test_turning_and_area_make_whole_turns(name: str) -> None:
    path = path_of(CURVES[name], GLIDE)
    turned = path.spacing * float(path.curvature.sum())
    # Gauss and Bonnet: on a sphere of radius 1 a curve turns by whole turns less the area within
    rest = (turned + area_to_the_right(path)) / (2 * pi)
    assert rest == pytest.approx(round(rest), abs=AREA.get(name, POLYGON))
    assert round(rest) == {"right": 1, "left": -1, "points": -1}.get(name, 0)


def area_to_the_right(path: Path) -> float:
    """Of the polygon of great circles, from triangles (van Oosterom & Strackee 1983)."""
    a = path.points.mean(axis=0)
    a /= np.linalg.norm(a)
    total = 0.0
    for b, c in zip(path.points, np.roll(path.points, -1, axis=0), strict=True):
        total += 2 * atan2(float(np.cross(b, a) @ c), float(1.0 + a @ b + b @ c + c @ a))
    return total


@pytest.mark.parametrize("name", CURVES)
def test_points_are_at_equal_arcs_and_courses_are_along_them(name: str) -> None:
    path = path_of(CURVES[name], GLIDE)
    chord = np.linalg.norm(np.roll(path.points, -1, axis=0) - path.points, axis=1)
    bent = path.curvature**2 + 1.0  # a chord is shorter than its arc by this much
    arc = chord * (1.0 + bent * path.spacing**2 / 24)
    assert arc == pytest.approx(path.spacing, rel=EVEN)
    assert np.linalg.norm(path.points, axis=1) == pytest.approx(1.0)
    assert np.linalg.norm(path.ahead, axis=1) == pytest.approx(1.0)
    between = np.roll(path.points, -1, axis=0) - np.roll(path.points, 1, axis=0)
    between /= np.linalg.norm(between, axis=1)[:, None]
    assert (
        abs(np.sum(between * path.ahead, axis=1) - 1.0).max() < 1e-6
    )  # half a step's bend, squared


@pytest.mark.parametrize("turn", ["up", "down"])
def test_an_eight_has_its_size_and_turns_as_is_said(turn: str) -> None:
    settings = PathSettings(width=1.2, height=0.4, elevation=0.0, turn=turn)  # type: ignore[arg-type]
    settings = settings._replace(elevation=0.7)
    path = path_of(settings, GLIDE)
    middle, right = np.array(direction(0.0, 0.7)), np.array([0.0, 1.0, 0.0])
    up = np.cross(middle, right)
    up *= np.sign(up[2])
    assert asin((path.points @ up).max()) == pytest.approx(0.2, abs=1e-5)  # between points
    assert asin((path.points @ right).max()) == pytest.approx(0.6, abs=1e-5)
    side = int((path.points @ right).argmax())
    assert (path.ahead[side, 2] > 0) == (turn == "up")
    # half a lap later it is in a mirror
    half = np.roll(path.points, 360, axis=0) * [1.0, -1.0, 1.0]
    assert path.points == pytest.approx(half, abs=SUMMED)
    assert path.curvature == pytest.approx(-np.roll(path.curvature, 360), abs=SUMMED)


@pytest.mark.parametrize("ratio", [0.25, 0.34, 0.45])
def test_no_other_eight_of_the_family_has_wider_bends(ratio: float) -> None:
    width, height = 1.3, 1.3 * ratio
    m, _ = widest(width, height)
    best = sharpest_bend(width, height, m)
    for other in np.linspace(*BLENDS, 60):
        assert sharpest_bend(width, height, float(other)) > 0.999 * best
    assert best < min(sharpest_bend(width, height, 0.0), sharpest_bend(width, height, 1.0))
    # no eight of this height has wider bends than two circles with straight lines between
    assert best > 1 / tan(height / 2)
    path = path_of(PathSettings(width=width, height=height), GLIDE)
    assert abs(path.curvature).max() == pytest.approx(best, rel=1e-3)  # between points


def test_a_path_goes_through_its_points() -> None:
    path = path_of(CURVES["points"], GLIDE)
    for azimuth, elevation in RING:
        apart = np.arccos(path.points @ np.array(direction(azimuth, elevation)))
        assert apart.min() < path.spacing
    # its curvature is continuous: no step from point to point stands out
    steps = np.abs(np.diff(path.curvature, append=path.curvature[:1]))
    assert steps.max() < 0.1 * np.ptp(path.curvature)


def test_speed_is_the_glide_and_the_nose_points_into_the_air() -> None:
    path = path_of(PathSettings(), GLIDE)
    wind = np.array([1.0, 0.0, 0.0])
    air = path.speed[:, None] * path.ahead - wind
    out = np.sum(air * path.points, axis=1)
    across = air - out[:, None] * path.points
    assert np.linalg.norm(across, axis=1) == pytest.approx(-GLIDE * out)
    nose = np.array(
        [
            course(Vector(*p), Vector(*a / np.linalg.norm(a)))
            for p, a in zip(path.points.tolist(), across, strict=True)
        ]
    )
    seen = courses(path) + drifts(path, path.speed)
    assert np.cos(nose - seen) == pytest.approx(1.0)
    # straight downwind it flies E times the wind, in any direction
    p = np.array([[1.0, 0.0, 0.0]])
    assert gliding(p, np.array([[0.0, 0.6, 0.8]]), GLIDE) == pytest.approx(GLIDE)
    # the turning of nose and course differ by what comes back in a lap
    assert path.spacing * float((path.turning - path.curvature).sum()) == pytest.approx(
        0, abs=SUMMED
    )


def test_the_place_on_the_path_stays_on_its_branch_at_the_crossing() -> None:
    path = path_of(PathSettings(), GLIDE)
    half = length_of(path) / 2
    p = vector_at(path, path.points, 0.0)
    for branch in (0.0, half):
        ahead = vector_at(path, path.ahead, branch)
        found = nearest(path, p, ahead)
        assert min(abs(found - branch), length_of(path) - abs(found - branch)) < 2 * path.spacing
        progress = branch - 0.2
        for step in np.linspace(-0.2, 0.2, 41):
            there = vector_at(path, path.points, branch + step)
            progress = advanced(path, progress, there)
            assert progress == pytest.approx(branch + step, abs=2 * path.spacing)


@pytest.mark.parametrize(
    ("settings", "says"),
    [
        (PathSettings(kind="points", points=RING[:3]), "must be 4 or more, got 3"),
        (PathSettings(kind="points", points=(*RING, RING[0])), "10 and 1 must be"),
        (
            PathSettings(kind="points", points=((0, 0.5), (0.3, 0.5), (0.6, 0.5), (0.3, 0.5))),
            "corner",
        ),
        (
            PathSettings(kind="circle", radius=radians(50.0), elevation=radians(45.0)),
            "downwind|above",
        ),
        (PathSettings(elevation=radians(80.0)), "over and behind him at azimuth"),
        (PathSettings(elevation=radians(10.0)), "above the ground"),
        (PathSettings(width=radians(200.0)), "pilot.path.width must be above 0 deg and below 180"),
        (PathSettings(kind="circle", radius=radians(95.0)), "pilot.path.radius must be"),
    ],
)
def test_what_is_no_path_is_refused_in_a_sentence(settings: PathSettings, says: str) -> None:
    with pytest.raises(InputError, match=says) as found:
        path_of(settings, GLIDE)
    assert "\n" not in str(found.value)
