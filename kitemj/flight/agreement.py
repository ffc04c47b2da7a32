"""What is measured when formulations are held against each other: one number a question."""

from itertools import pairwise
from math import log2
from typing import Any

import numpy as np

from kitemj.dynamics.motion import Motion, State, attachment_E, attachment_velocity_E, energy
from kitemj.dynamics.straight import straight_body
from kitemj.physics.compiled import Array
from kitemj.physics.frames import Angles
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Segment, control
from kitemj.physics.vectors import dot, norm, rotated

EIGHTH_ORDER = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
"""Weights of the central difference at 1, 2, 3 and 4 steps."""


def spatial_accelerations(
    parameters: Parameters, c: Control, state: State, q_ddot: Angles
) -> tuple[Array, Array]:
    """a_G [m/s², E] and ω̇ [rad/s², B] that q̈ [rad/s²] means, each of shape (3,).

    Velocity is linear in q̇, so a = ȧ(q̈ = 0) + Σ ∂v/∂q̇_i q̈_i: the first by a difference of
    eighth order along q + s q̇ (a hundredth of a radian a step: error 1e-13), the second
    without any error. None of Lagrange's own kinematics is used, so a fault in them cannot hide.
    """
    h = 0.01 / max(1.0, *map(abs, state.q_dot), abs(c.delta_dot))
    segment = Segment(0.0, c)

    def velocity(s: float, q_dot: Angles) -> Array:
        q = Angles(*(a + s * b for a, b in zip(state.q, state.q_dot, strict=True)))
        body = straight_body(parameters, q, q_dot, control(segment, s))
        return np.array((*body.v_G_E, *body.omega_B))

    acceleration = np.zeros(6)
    for k, weight in enumerate(EIGHTH_ORDER, start=1):
        acceleration += weight * (velocity(k * h, state.q_dot) - velocity(-k * h, state.q_dot)) / h
    lines_only = velocity(0.0, Angles(0.0, 0.0, 0.0, 0.0))
    for i in range(4):
        one = Angles(*(float(i == j) for j in range(4)))
        acceleration += q_ddot[i] * (velocity(0.0, one) - lines_only)
    return acceleration[:3], acceleration[3:]


def relative(a: Any, b: Any, floor: float = 0.0) -> float:
    """|a - b| / |b|, with |b| taken as at least `floor`."""
    return float(np.linalg.norm(np.subtract(a, b)) / max(floor, float(np.linalg.norm(b))))


def powers(parameters: Parameters, motion: Motion) -> tuple[float, float]:
    """Power [W] that the air gives the kite, and the lines; a line that runs out takes."""
    p, R, v, omega = body = motion.body
    air = aerodynamic_wrench(parameters, p, R, v, omega, motion.t)
    by_lines = 0.0
    for side, tension in zip((1.0, -1.0), motion.tensions, strict=True):
        A = attachment_E(parameters, body, side)
        by_lines -= tension * dot(A, attachment_velocity_E(parameters, body, side)) / norm(A)
    return dot(air.force, rotated(R, v)) + dot(air.moment, omega), by_lines


def imbalance(parameters: Parameters, motions: list[Motion]) -> float:
    """Largest |ΔE - work of air and lines|, relative to the energy turned over (at least 1 J).

    `motions`: an odd number, equally spaced in time; work by Simpson's rule.
    """
    given = np.array([powers(parameters, motion) for motion in motions])
    energies = np.array([energy(parameters, motion.body) for motion in motions])
    h = motions[1].t - motions[0].t

    def integral(y: Array) -> Array:
        return np.asarray(np.cumsum((y[:-2:2] + 4 * y[1:-1:2] + y[2::2]) * h / 3))

    left = energies[2::2] - energies[0] - integral(given.sum(axis=1))
    return float(np.max(np.abs(left)) / max(1.0, integral(np.abs(given).sum(axis=1))[-1]))


def orders(gaps: list[float], floor: float = 0.0) -> list[float]:
    """log₂ of the ratio of `gaps` at steps that halve; none where a gap is below `floor`."""
    return [log2(a / b) for a, b in pairwise(gaps) if b > floor]
