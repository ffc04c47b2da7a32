"""Closed curves in the sky, and how a kite would fly them: how fast, how its nose turns."""

from collections.abc import Callable
from math import cos, pi, sin, sqrt
from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline

from kitemj.autopilot.sphere import direction
from kitemj.flight.pilot_settings import PathSettings
from kitemj.physics.compiled import Array

POINTS = 720
"""Of a sampled path."""


class Path(NamedTuple):
    """A closed curve sampled at equal arcs of `spacing` [rad]; the last point is before the first.

    `points`, `ahead` (n, 3): directions and unit courses, axes of `kitemj.autopilot.sphere`.
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
    """The path for a kite of a `glide` ratio (lift over drag, whole kite)."""
    a, b = settings.width / 2, settings.height / 2
    sign = -1.0 if settings.turn in ("up", "left") else 1.0

    def eight(t: Array) -> tuple[Array, Array]:
        lap = 1.0 + np.cos(t) ** 2
        return a * np.sin(t) / lap, sign * 2 * sqrt(2) * b * np.sin(t) * np.cos(t) / lap

    def circle(t: Array) -> tuple[Array, Array]:
        return sign * settings.radius * np.sin(t), settings.radius * np.cos(t)

    curve = eight if settings.kind == "lemniscate" else circle
    return sampled(on_sphere(curve, settings.azimuth, settings.elevation), glide)


def on_sphere(
    curve: Callable[[Array], tuple[Array, Array]], azimuth: float, elevation: float
) -> Callable[[Array], Array]:
    """The curve (right, up) [rad] laid on the sphere along great circles from its middle."""
    middle = np.array(direction(azimuth, elevation))
    right = np.array([-sin(azimuth), cos(azimuth), 0.0])
    up = np.array([-sin(elevation) * cos(azimuth), -sin(elevation) * sin(azimuth), cos(elevation)])

    def laid(t: Array) -> Array:
        x, y = curve(t)
        far = np.hypot(x, y)
        toward = np.outer(x, right) + np.outer(y, up)
        return np.asarray(np.cos(far)[:, None] * middle + np.sinc(far / pi)[:, None] * toward)

    return laid


def sampled(curve: Callable[[Array], Array], glide: float) -> Path:
    """The path along `curve`, whose parameter goes once around in 2π."""
    t = np.linspace(0.0, 2 * pi, 4001)
    steps = np.linalg.norm(np.diff(curve(t), axis=0), axis=1)
    way = np.append(0.0, np.cumsum(steps))
    points = curve(CubicSpline(way, t)(np.arange(POINTS) * way[-1] / POINTS))
    spacing = float(way[-1]) / POINTS

    def slope(values: Array) -> Array:
        return (np.roll(values, -1, axis=0) - np.roll(values, 1, axis=0)) / (2 * spacing)

    ahead = slope(points)
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    right = np.cross(ahead, points)
    curvature = np.sum(slope(ahead) * right, axis=1)
    downwind = np.array([1.0, 0.0, 0.0])
    inflow = points @ downwind
    across = downwind - inflow[:, None] * points
    along = np.sum(across * ahead, axis=1)
    room = (glide * inflow) ** 2 - np.sum(across**2, axis=1) + along**2
    speed = along + np.sqrt(np.maximum(room, 1e-6))
    air = speed[:, None] * ahead - across
    drift = np.unwrap(np.arctan2(np.sum(air * right, axis=1), np.sum(air * ahead, axis=1)))
    return Path(points, ahead, curvature, speed, curvature + slope(drift), spacing)
