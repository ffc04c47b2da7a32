"""Directions on the sphere around the pilot, in his own axes: x downwind, y right, z up.

Looking outward, "right of" a course is as the pilot sees it. Angles in rad; azimuth positive to
the right, as in `kitemj.pilots.sight`.
"""

from math import atan2, cos, hypot, sin

import numpy as np

from kitemj.physics.compiled import Array, compiled
from kitemj.physics.vectors import Vector, cross, dot, norm, plus, times

UP = Vector(0.0, 0.0, 1.0)


@compiled
def direction(azimuth: float, elevation: float) -> Vector:
    """Where that is seen, a unit vector."""
    c = cos(elevation)
    return Vector(c * cos(azimuth), c * sin(azimuth), sin(elevation))


@compiled
def azimuth_of(p: Vector) -> float:
    """Of a direction."""
    return atan2(p.y, p.x)


@compiled
def elevation_of(p: Vector) -> float:
    """Of a direction."""
    return atan2(p.z, hypot(p.x, p.y))


@compiled
def tangential(p: Vector, v: Vector) -> Vector:
    """The part of `v` that is across the unit vector `p`."""
    return plus(v, times(-dot(p, v), p))


@compiled
def right_of(p: Vector, ahead: Vector) -> Vector:
    """Unit vector to the right of the unit course `ahead` at `p`; these axes are left-handed."""
    return cross(ahead, p)


@compiled
def course(p: Vector, ahead: Vector) -> float:
    """The angle of the course `ahead` at `p` from up, right positive, in (-π, π]."""
    up = Vector(-p.z * p.x, -p.z * p.y, 1.0 - p.z * p.z)
    return atan2(dot(ahead, right_of(p, up)), dot(ahead, up))


@compiled
def ahead_of(p: Vector, angle: float) -> Vector:
    """The unit course at `p` whose angle from up is `angle`; the inverse of `course`."""
    up = Vector(-p.z * p.x, -p.z * p.y, 1.0 - p.z * p.z)
    up = times(1.0 / norm(up), up)
    return plus(times(cos(angle), up), times(sin(angle), right_of(p, up)))


def axes_at(azimuth: float, elevation: float) -> tuple[Array, Array, Array]:
    """The direction (3,), and the unit vectors to the right and up there."""
    s, c, se, ce = sin(azimuth), cos(azimuth), sin(elevation), cos(elevation)
    out = np.array([ce * c, ce * s, se])
    return out, np.array([-s, c, 0.0]), np.array([-se * c, -se * s, ce])
