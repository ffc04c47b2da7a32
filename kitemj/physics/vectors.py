"""Vectors and rotations of three dimensions, as tuples that compile to registers."""

from math import sqrt
from typing import NamedTuple

from kitemj.physics.compiled import compiled


class Vector(NamedTuple):
    """Components in the frame that the variable's name ends with (``v_G_E``: in E)."""

    x: float
    y: float
    z: float


class Rotation(NamedTuple):
    """``R_BA``: takes components in A to components in B. Its rows are B's axes seen in A."""

    x: Vector
    y: Vector
    z: Vector


@compiled
def plus(a: Vector, b: Vector) -> Vector:
    """a + b."""
    return Vector(a.x + b.x, a.y + b.y, a.z + b.z)


@compiled
def minus(a: Vector, b: Vector) -> Vector:
    """a - b."""
    return Vector(a.x - b.x, a.y - b.y, a.z - b.z)


@compiled
def times(s: float, a: Vector) -> Vector:
    """s a."""
    return Vector(s * a.x, s * a.y, s * a.z)


@compiled
def dot(a: Vector, b: Vector) -> float:
    """a · b."""
    return a.x * b.x + a.y * b.y + a.z * b.z


@compiled
def cross(a: Vector, b: Vector) -> Vector:
    """a x b."""
    return Vector(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)


@compiled
def norm(a: Vector) -> float:
    """|a|."""
    return sqrt(dot(a, a))


@compiled
def rotated(R_BA: Rotation, v_A: Vector) -> Vector:
    """v_B = R_BA v_A."""
    return Vector(dot(R_BA.x, v_A), dot(R_BA.y, v_A), dot(R_BA.z, v_A))


@compiled
def unrotated(R_BA: Rotation, v_B: Vector) -> Vector:
    """v_A = R_BAᵀ v_B."""
    return plus(plus(times(v_B.x, R_BA.x), times(v_B.y, R_BA.y)), times(v_B.z, R_BA.z))


@compiled
def product(R_CB: Rotation, R_BA: Rotation) -> Rotation:
    """R_CA = R_CB R_BA."""
    return Rotation(unrotated(R_BA, R_CB.x), unrotated(R_BA, R_CB.y), unrotated(R_BA, R_CB.z))
