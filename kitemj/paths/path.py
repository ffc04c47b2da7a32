"""Closed curves in the sky, and how a kite would fly them: how fast, how its nose turns."""

from math import cos, degrees, pi, sin
from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline

from kitemj.errors import InputError
from kitemj.flight.pilot_settings import PathSettings
from kitemj.paths.lemniscate import Curve, lemniscate
from kitemj.paths.sphere import axes_at, azimuth_of, direction, elevation_of
from kitemj.physics.compiled import Array
from kitemj.physics.vectors import Vector

POINTS = 720
"""Of a sampled path."""
FINE = 2048
"""Steps once around by which the length of a curve is summed; periodic and smooth: exact to
rounding, but for a spline's knots."""
FEWEST = 4
"""Points of a path; through three goes a circle, which is said by its radius."""
APART = 0.01
"""rad; nearer neighbours are a slip of the pen: 0.25 m on 25 m lines."""
SHARPEST = 200.0
"""1, geodesic curvature of 0.3°; a curve that turns more has a cusp."""


class Path(NamedTuple):
    """A closed curve sampled at equal arcs of `spacing` [rad]; the last point is before the first.

    `points`, `ahead` (n, 3): directions and unit courses, axes of `kitemj.paths.sphere`.
    `curvature` (n,) [1]: geodesic, how much the course turns to the right for each rad of way.
    `speed` (n,): of the kite, in winds, by glide alone; `turning` (n,): how much the nose turns
    for each rad of way, which is the curvature and the change of drift.
    """

    points: Array
    ahead: Array
    curvature: Array
    speed: Array
    turning: Array
    spacing: float


def path_of(settings: PathSettings, glide: float) -> Path:
    """The path for a kite of a `glide` ratio (lift over drag, whole kite).

    A circle turns left for "up" as for "left". Raises InputError for points that are too few
    or too near one another, a curve with a cusp, and one that is not wholly downwind.
    """
    return sampled(curve_of(settings), glide)


def curve_of(settings: PathSettings) -> Curve:
    """The curve, unchecked but for its numbers. Raises InputError."""
    if settings.kind == "points":
        return through(settings.points)
    for name in ("radius",) if settings.kind == "circle" else ("width", "height"):
        size, most = getattr(settings, name), pi / 2 if name == "radius" else pi
        if not 0.0 < size < most:
            raise InputError(
                f"pilot.path.{name} must be above 0 deg and below {degrees(most):g} deg, "
                f"got {degrees(size):g} deg"
            )
    return circle(settings) if settings.kind == "circle" else lemniscate(settings)


def circle(settings: PathSettings) -> Curve:
    """A circle of `settings.radius` [rad] around its middle, from its top."""
    middle, right, up = axes_at(settings.azimuth, settings.elevation)
    side = -1.0 if settings.turn in ("up", "left") else 1.0
    far, near = sin(settings.radius), cos(settings.radius)

    def curve(t: Array) -> tuple[Array, Array, Array]:
        s, c = side * far * np.sin(t), far * np.cos(t)
        first = np.outer(c, up) + np.outer(s, right)
        second = np.outer(-side * s, up) + np.outer(side * c, right)
        return near * middle + first, second, -first

    return curve


def through(points: tuple[tuple[float, float], ...]) -> Curve:
    """A closed curve of continuous curvature through (azimuth, elevation) [rad], in their order.

    A periodic cubic spline of directions by their distances. Raises InputError.
    """
    if len(points) < FEWEST:
        raise InputError(
            f"pilot.path.points must be {FEWEST} or more, got {len(points)}: "
            f"add some, or ask for a circle"
        )
    places = np.array([direction(*each) for each in points])
    apart = 2 * np.arcsin(np.linalg.norm(np.roll(places, -1, axis=0) - places, axis=1) / 2)
    if apart.min() < APART:
        i = int(apart.argmin())
        raise InputError(
            f"pilot.path.points {i + 1} and {(i + 1) % len(points) + 1} must be "
            f"{degrees(APART):.2g} deg apart or more, are {degrees(apart[i]):.2g} deg apart: "
            f"leave one out"
        )
    way = np.append(0.0, np.cumsum(apart)) * (2 * pi / apart.sum())
    spline = CubicSpline(way, np.vstack((places, places[:1])), bc_type="periodic")

    def curve(t: Array) -> tuple[Array, Array, Array]:
        return spline(t), spline(t, 1), spline(t, 2)

    return curve


def sampled(curve: Curve, glide: float) -> Path:
    """The path along `curve`, whose parameter goes once around in 2π."""
    t, spacing = equal_arcs(curve)
    r, r_1, r_2 = curve(t)
    far = np.linalg.norm(r, axis=1)
    points = r / far[:, None]
    _check_downwind(points)
    pace = np.linalg.norm(np.cross(r, r_1), axis=1)
    # det(p, p', p'')/|p'|³ of p = r/|r|; the sign because these axes are left-handed
    curvature = -np.sum(np.cross(r, r_1) * r_2, axis=1) * far**3 / np.maximum(pace, 1e-12) ** 3
    _check_smooth(points, curvature)
    ahead = r_1 - np.sum(r_1 * points, axis=1)[:, None] * points
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    speed = gliding(points, ahead, glide)
    path = Path(points, ahead, curvature, speed, curvature, spacing)
    return path._replace(turning=nose_turning(path, speed))


def equal_arcs(curve: Curve) -> tuple[Array, float]:
    """Parameters (POINTS,) of points at equal arcs along `curve`, and the arc [rad]."""

    def pace(t: Array) -> Array:
        r, r_1, _ = curve(t)
        found = np.linalg.norm(np.cross(r, r_1), axis=1) / np.sum(r * r, axis=1)
        return np.asarray(found)

    t = np.linspace(0.0, 2 * pi, FINE + 1)
    paces = pace(t)
    paces[-1] = paces[0]
    way = CubicSpline(t, paces, bc_type="periodic").antiderivative()
    total = float(way(2 * pi))
    wanted = np.arange(POINTS) * (total / POINTS)
    found = np.interp(wanted, way(t), t)
    for _ in range(3):  # Newton's steps, from a good guess
        found = found - (way(found) - wanted) / np.maximum(pace(found), 1e-9)
    return np.asarray(found), total / POINTS


def gliding(points: Array, ahead: Array, glide: float) -> Array:
    """Speeds (n,) in winds at `points` in the directions `ahead`, both (n, 3), by glide alone.

    Without weight, what a kite meets of the air across the line is `glide` times what it meets
    along it: |v - W_t| = E W_r (Erhard & Strauch, IEEE Trans. Control Syst. Technol. 21 (2013)
    13). Where there is no such speed, as good as that of the wind along the way.
    """
    inflow, along = points[:, 0], ahead[:, 0]
    # 1 - inflow²: of the wind across the line, in winds
    room = (glide * inflow) ** 2 - (1.0 - inflow**2) + along**2
    return np.asarray(along + np.sqrt(np.maximum(room, 1e-6)))


def courses(path: Path) -> Array:
    """The course [rad] from up (n,), to the right, as `kitemj.paths.sphere.course`."""
    up = np.array([0.0, 0.0, 1.0]) - path.points[:, 2:] * path.points
    right = np.cross(up, path.points)
    return np.asarray(
        np.arctan2(np.sum(path.ahead * right, axis=1), np.sum(path.ahead * up, axis=1))
    )


def drifts(path: Path, speed: Array) -> Array:
    """From course to nose [rad], to the right, at the `speed` (n,) in winds: into the air."""
    right = np.cross(path.ahead, path.points)
    return np.asarray(np.unwrap(np.arctan2(-right[:, 0], speed - path.ahead[:, 0])))


def nose_turning(path: Path, speed: Array) -> Array:
    """How much the nose turns for each rad of way (n,) at the `speed` (n,) in winds."""
    return path.curvature + periodic_slope(drifts(path, speed), path.spacing)


def periodic_slope(values: Array, spacing: float) -> Array:
    """The derivative of `values` (n,), `spacing` apart, which go once around."""
    way = spacing * np.arange(len(values) + 1)
    return np.asarray(
        CubicSpline(way, np.append(values, values[0]), bc_type="periodic")(way[:-1], 1)
    )


def place(point: Array) -> str:
    """Where a direction is seen, for a sentence."""
    p = Vector(*map(float, point))
    side = degrees(azimuth_of(p))
    return f"azimuth {side:.0f} deg, elevation {degrees(elevation_of(p)):.0f} deg"


def _check_downwind(points: Array) -> None:
    """Raises InputError for a path that passes upwind of the pilot or into the ground."""
    i, low = int(points[:, 0].argmin()), int(points[:, 2].argmin())
    if points[i, 0] <= 0.0:
        raise InputError(
            f"pilot.path must lie downwind of the pilot, it passes over and behind him at "
            f"{place(points[i])}: make it lower or smaller"
        )
    if points[low, 2] <= 0.0:
        raise InputError(
            f"pilot.path must lie above the ground, it passes {place(points[low])}: "
            f"make it higher or smaller"
        )


def _check_smooth(points: Array, curvature: Array) -> None:
    """Raises InputError for a path that has a cusp, or turns back on itself."""
    i = int(np.abs(curvature).argmax())
    if not abs(curvature[i]) < SHARPEST:
        raise InputError(
            f"pilot.path must turn on {degrees(1 / SHARPEST):.2g} deg or more, it has a corner at "
            f"{place(points[i])}: draw it rounder there"
        )
