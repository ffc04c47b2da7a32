"""The five frames, drawn once; the only place where z-down becomes z-up.

::

    pilot at O_E looks downwind                 side view (φ = η = 0)
      y_E (pilot's left)                              x_E <---+ O_E      wind ->
       ^                                                      | \\
       |                                                  z_E v  \\  line
       +---> x_E into the wind (z_E down)                         \\
                                                                   kite (x_E < 0, z_E < 0)

E  Earth, at the ground point O_E: x_E into the wind, z_E down; wind blows along -x_E.
1  E turned by φ about z_E, then by γ about y_1. The lines' plane π holds y_1 and z_1.
2  1 turned by η about x_1; y_2 runs from A₋ to A₊.
B  2 turned by θ about y_2, at the centre of mass G: x_B forward, y_B starboard, z_B to ground.
W  the engine's world, z up: W = diag(1, -1, -1) E.

Source: Sánchez-Arriaga, García-Villalba, Schmehl, Applied Mathematical Modelling 47 (2017),
section 2. The thesis prints R_1E without some of its φ.
"""

from math import atan2, cos, hypot, sin, sqrt
from typing import NamedTuple

from kitemj.physics.compiled import compiled
from kitemj.physics.vectors import Rotation, Vector, cross, dot, norm, product, times


class Angles(NamedTuple):
    """q = (φ, γ, η, θ) [rad]: the state of a kite whose two lines are straight."""

    phi: float
    gamma: float
    eta: float
    theta: float


class Quaternion(NamedTuple):
    """Unit quaternion (w, x, y, z) of a rotation that takes body components to E."""

    w: float
    x: float
    y: float
    z: float


@compiled
def R_1E(phi: float, gamma: float) -> Rotation:
    """v_1 = R_1E v_E; `phi`, `gamma` in rad."""
    sp, cp, sg, cg = sin(phi), cos(phi), sin(gamma), cos(gamma)
    return Rotation(
        Vector(cg * cp, cg * sp, -sg), Vector(-sp, cp, 0.0), Vector(sg * cp, sg * sp, cg)
    )


@compiled
def R_21(eta: float) -> Rotation:
    """v_2 = R_21 v_1; `eta` in rad."""
    s, c = sin(eta), cos(eta)
    return Rotation(Vector(1.0, 0.0, 0.0), Vector(0.0, c, s), Vector(0.0, -s, c))


@compiled
def R_B2(theta: float) -> Rotation:
    """v_B = R_B2 v_2; `theta` in rad."""
    s, c = sin(theta), cos(theta)
    return Rotation(Vector(c, 0.0, -s), Vector(0.0, 1.0, 0.0), Vector(s, 0.0, c))


@compiled
def R_2E(q: Angles) -> Rotation:
    """v_2 = R_2E v_E."""
    return product(R_21(q.eta), R_1E(q.phi, q.gamma))


@compiled
def R_BE(q: Angles) -> Rotation:
    """v_B = R_BE v_E."""
    return product(R_B2(q.theta), R_2E(q))


@compiled
def angles(R_BE: Rotation, p_O2_E: Vector) -> Angles:
    """q [rad] of a pose: attitude and the midpoint of the attachments [m, E].

    γ in [-π/2, π/2], the others in (-π, π]. Zero length of `p_O2_E` gives non-numbers.
    """
    normal = cross(p_O2_E, R_BE.y)
    x_1 = times(1.0 / norm(normal), normal)
    phi = atan2(x_1.y, x_1.x)
    gamma = atan2(-x_1.z, hypot(x_1.x, x_1.y))
    R_1 = R_1E(phi, gamma)
    z_2 = cross(x_1, R_BE.y)
    eta = atan2(dot(R_BE.y, R_1.z), dot(R_BE.y, R_1.y))
    return Angles(phi, gamma, eta, atan2(-dot(R_BE.x, z_2), dot(R_BE.x, x_1)))


@compiled
def world(v_E: Vector) -> Vector:
    """Components in W of components in E, and the other way: diag(1, -1, -1) is its own inverse."""
    return Vector(v_E.x, -v_E.y, -v_E.z)


@compiled
def R_BE_of(e: Quaternion) -> Rotation:
    """R_BE of the unit quaternion that takes B to E."""
    w, x, y, z = e
    return Rotation(
        Vector(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)),
        Vector(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)),
        Vector(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)),
    )


@compiled
def quaternion(R_BE: Rotation) -> Quaternion:
    """Unit quaternion that takes B to E, of R_BE; w is not negative.

    Of the four possible formulas the one with the largest divisor (Shepperd, 1978).
    """
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = R_BE
    trace = xx + yy + zz
    if trace >= max(xx, yy, zz):
        d = sqrt(1 + trace)
        return Quaternion(d / 2, (yz - zy) / (2 * d), (zx - xz) / (2 * d), (xy - yx) / (2 * d))
    if xx >= max(yy, zz):
        d = sqrt(1 + xx - yy - zz)
        e = Quaternion((yz - zy) / (2 * d), d / 2, (xy + yx) / (2 * d), (zx + xz) / (2 * d))
    elif yy >= zz:
        d = sqrt(1 - xx + yy - zz)
        e = Quaternion((zx - xz) / (2 * d), (xy + yx) / (2 * d), d / 2, (yz + zy) / (2 * d))
    else:
        d = sqrt(1 - xx - yy + zz)
        e = Quaternion((xy - yx) / (2 * d), (zx + xz) / (2 * d), (yz + zy) / (2 * d), d / 2)
    s = -1.0 if e.w < 0 else 1.0
    return Quaternion(s * e.w, s * e.x, s * e.y, s * e.z)


@compiled
def world_quaternion(e: Quaternion) -> Quaternion:
    """The quaternion that takes B to W of the one that takes B to E, and the other way.

    diag(1, -1, -1) is the turn by π about x: quaternion (0, 1, 0, 0), up to a sign.
    """
    return Quaternion(-e.x, e.w, -e.z, e.y)
