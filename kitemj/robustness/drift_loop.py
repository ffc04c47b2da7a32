"""The loop of a `DriftHold`, opened where the lines pull the kite: for margins."""

import numpy as np
from numpy.typing import NDArray

from kitemj.autopilot.drift_design import QUICK, DriftDesign, Sideways
from kitemj.flight.live import TICK
from kitemj.physics.compiled import Array

Complex = NDArray[np.complex128]


def kite_answer(kite: Sideways, omega: float) -> Complex:
    """(2,): how azimuth and heading [1] answer δ that swings at `omega` [rad/s]."""
    powers = np.array([1.0, 1j * omega, -(omega**2)])  # δ, δ̇ and δ̈ of one swing
    x = np.linalg.solve(1j * omega * np.eye(4) - kite.A, kite.B @ powers)
    return np.asarray(kite.C @ x + kite.D @ powers)


def hold_by_ticks(design: DriftDesign) -> tuple[Array, Array]:
    """w⁺ = M w + N y of filter, gains and hands, (8, 8) and (8, 2).

    w = (x, offsets, δ, δ̇), of which x and offsets are not yet corrected by y, azimuth and heading.
    """
    kite, L = design.sideways, design.L
    M, correct = np.zeros((8, 8)), np.eye(8)
    believes = np.hstack([kite.C, np.eye(2), kite.D[:, :2]])
    correct[:6] -= L @ believes
    rest = np.zeros((6, 8))  # z - z* for each of w
    rest[:4, :4] = np.eye(4)
    rest[4, 6] = rest[5, 7] = 1.0
    rest[:, 4] += np.array([*design.rest, 1.0, 0.0]) / design.azimuth
    ddot = -QUICK * (design.K @ rest)
    ddot[7] -= QUICK
    states = [0, 1, 2, 3, 6, 7]
    M[np.ix_(states, states)] = design.later
    M[4, 4] = M[5, 5] = 1.0
    M[states] += np.outer(design.moved, ddot)
    N = np.vstack([L, np.zeros((2, 2))])
    return M @ correct, M @ N


def loop_gain(design: DriftDesign, frequencies: Array) -> Complex:
    """-δ of the hands for each rad of δ at the kite, (k,), at `frequencies` [rad/s]."""
    M, N = hold_by_ticks(design)
    found = []
    for omega in frequencies:
        turned = np.exp(1j * omega * TICK) * np.eye(8) - M
        found.append(-np.linalg.solve(turned, N @ kite_answer(design.sideways, omega))[6])
    return np.array(found)


def closed_loop(design: DriftDesign) -> Complex:
    """Eigenvalues [1/s] of kite and hold together, (12,), sorted; no logarithm of zero is taken."""
    M, N = hold_by_ticks(design)
    kite = design.sideways
    both = np.zeros((12, 12))
    both[:4, :4], both[:4, 10:] = design.later[:4, :4], design.later[:4, 4:]
    seen = np.hstack([kite.C, np.zeros((2, 6)), kite.D[:, :2]])
    both[4:] = N @ seen
    both[4:, 4:] += M
    # δ̈ of the hands moves the kite within the tick as it moves the filter's
    both[:4] += np.outer(design.moved[:4] / design.moved[5], both[11] - np.eye(12)[11])
    found = np.log(np.linalg.eigvals(both).astype(complex)) / TICK
    return np.asarray(found[np.argsort(-found.real)])
