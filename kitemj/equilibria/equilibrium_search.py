"""Equilibria out of the plane of symmetry, by following a curve through one that is known.

Where three of the four accelerations vanish there is a curve in q = (φ, γ, η, θ). It passes
through every equilibrium, leaves the plane of symmetry, and is followed to both sides; where
the fourth acceleration, φ̈, changes sign along it, the kite can stand as well. An equilibrium
on a curve that meets no known one would be missed.
"""

import numpy as np

from kitemj.dynamics.lagrange import accelerations
from kitemj.equilibria.minimal import Array
from kitemj.physics.compiled import compiled
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control
from kitemj.physics.vectors import Vector, cross, dot

STEP = float(np.radians(2.0))
"""rad; along the curve in q."""
STEPS = 100
"""To either side."""
DIFFERENCE = 1e-5
"""rad; of the Jacobian."""
ON_CURVE = 1e-9
"""rad; last correction of a point that lies on the curve."""
STEEPEST = float(np.radians(85.0))
"""|γ| [rad] beyond which the coordinates are too close to their singularity."""


@compiled
def _q_ddot(parameters: Parameters, c: Control, q: Array) -> Array:
    """q̈ (4,) [rad/s²] at rest, φ̈ last."""
    still = Angles(0.0, 0.0, 0.0, 0.0)
    a = accelerations(parameters, c, 0.0, Angles(q[0], q[1], q[2], q[3]), still).q_ddot
    return np.array([a.gamma, a.eta, a.theta, a.phi])


@compiled
def _slopes(parameters: Parameters, c: Control, q: Array) -> Array:
    """Derivatives (3, 4) of the first three of `_q_ddot` by q."""
    J = np.empty((3, 4))
    for i in range(4):
        there = q.copy()
        there[i] += DIFFERENCE
        after = _q_ddot(parameters, c, there)
        there[i] -= 2 * DIFFERENCE
        before = _q_ddot(parameters, c, there)
        J[:, i] = (after[:3] - before[:3]) / (2 * DIFFERENCE)
    return J


@compiled
def _tangent(J: Array) -> Array:
    """The unit vector (4,) that J (3, 4) takes to zero: its minors with alternating signs."""
    t = np.empty(4)
    for i in range(4):
        a, b, c = (i + 1) % 4, (i + 2) % 4, (i + 3) % 4
        minor = (
            J[0, a] * (J[1, b] * J[2, c] - J[1, c] * J[2, b])
            - J[0, b] * (J[1, a] * J[2, c] - J[1, c] * J[2, a])
            + J[0, c] * (J[1, a] * J[2, b] - J[1, b] * J[2, a])
        )
        t[i] = -minor if i % 2 else minor
    unit: Array = t / np.sqrt(np.sum(t * t))
    return unit


@compiled
def _correction(J: Array, f: Array) -> Array:
    """The shortest d (4,) with J d = f[:3], by Cramer's rule on rows of unit length."""
    rows, right = np.empty((3, 4)), np.empty(3)
    for i in range(3):
        size = np.sqrt(np.sum(J[i] * J[i]))
        rows[i], right[i] = J[i] / size, f[i] / size
    ab, ac, bc = np.sum(rows[0] * rows[1]), np.sum(rows[0] * rows[2]), np.sum(rows[1] * rows[2])
    a, b, c = Vector(1.0, ab, ac), Vector(ab, 1.0, bc), Vector(ac, bc, 1.0)
    r, det = Vector(right[0], right[1], right[2]), dot(a, cross(b, c))
    x, y, z = dot(r, cross(b, c)) / det, dot(r, cross(c, a)) / det, dot(r, cross(a, b)) / det
    shortest: Array = x * rows[0] + y * rows[1] + z * rows[2]
    return shortest


@compiled
def traced(parameters: Parameters, c: Control, start: Array, side: float) -> tuple[Array, Array]:
    """Points q (n, 4) [rad] along the curve from `start` (4,), and φ̈ (n,) there.

    `side` +1: to where φ + η grows; -1: to the other.
    """
    points, rest = np.empty((STEPS + 1, 4)), np.empty(STEPS + 1)
    q, last = start.copy(), side * np.array([1.0, 0.0, 1.0, 0.0])
    points[0], rest[0] = q, _q_ddot(parameters, c, q)[3]
    for n in range(1, STEPS + 1):
        tangent = _tangent(_slopes(parameters, c, q))
        if np.sum(tangent * last) < 0:
            tangent = -tangent
        q, last, moved = q + STEP * tangent, tangent, 1.0
        for _ in range(8):
            correction = _correction(_slopes(parameters, c, q), _q_ddot(parameters, c, q))
            moved = np.sqrt(np.sum(correction * correction))
            q = q - correction
            if not moved > ON_CURVE:
                break
        if not moved < 1e-6 or abs(q[1]) > STEEPEST:
            return points[:n], rest[:n]
        points[n], rest[n] = q, _q_ddot(parameters, c, q)[3]
    return points, rest


def beside(parameters: Parameters, control: Control, known: Array) -> list[Array]:
    """Points q (4,) [rad] close to further equilibria on the curve through `known` (4,)."""
    found: list[Array] = []
    for side in (1.0, -1.0):
        points, rest = traced(parameters, control, known, side)
        for i in np.flatnonzero(rest[1:-1] * rest[2:] < 0) + 1:
            part = rest[i] / (rest[i] - rest[i + 1])
            found.append(points[i] + part * (points[i + 1] - points[i]))
    return found
