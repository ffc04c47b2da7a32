"""The closed loop over a lap: what is left of a deviation after once around.

The loop is sampled and repeats itself: the product of the matrices of its ticks is the monodromy
matrix, whose eigenvalues are the Floquet multipliers. One of them is 1: who is ahead on the path
stays ahead. If all others are within the unit circle, each deviation dies out, lap after lap.
"""

from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from kitemj.physics.compiled import Array
from kitemj.robustness.linear import Opened

MOST_GAIN = 32.0
"""Beyond, a gain margin is no longer looked for; 30 dB."""
MOST_DELAY = 200
"""Ticks; beyond, a delay margin is no longer looked for."""


class Floquet(NamedTuple):
    """Multipliers by descending modulus, that of the place on the path apart."""

    place: complex
    others: Array

    @property
    def largest(self) -> float:
        """Modulus of the largest that counts; below 1, deviations die out."""
        return float(abs(self.others[0]))


def monodromy(matrices: Array) -> Array:
    """The product of the matrices (n, m, m) of the ticks of a lap, the first to the right."""
    product = np.eye(matrices.shape[1])
    for matrix in matrices:
        product = matrix @ product
    return product


def multipliers(matrices: Array, along: Array | None = None) -> Floquet:
    """The Floquet multipliers of a lap of `matrices` (n, m, m).

    `along` (m,): how x changes along the lap at its beginning. The multiplier whose left
    eigenvector sees most of it is that of the place; None: there is none, and it is nan.
    """
    values, right = np.linalg.eig(monodromy(matrices))
    order = np.argsort(-abs(values))
    if along is None:
        return Floquet(complex(np.nan), values[order])
    parts = abs(right.conj().T @ along) / np.linalg.norm(along)
    near = abs(values - 1.0) < 0.5
    place = int(np.argmax(np.where(near, parts, -1.0)))
    return Floquet(complex(values[place]), values[order[order != place]])


def changed(loop: Opened, gain: complex = 1.0, delay: int = 0) -> Array:
    """Matrices of the ticks, closed with what answers errors times `gain`, `delay` ticks later.

    A complex `gain` turns the phase.

    (n, 11 + delay, 11 + delay). What the place on the path asks for comes as before, so that the
    lap remains what it is.
    """
    n, m, _ = loop.A.shape
    answer = gain * (loop.C - loop.by_place)
    inner = loop.A + loop.B[:, :, None] * loop.by_place[:, None, :]
    if delay == 0:
        return np.asarray(inner + loop.B[:, :, None] * answer[:, None, :])
    whole = np.zeros((n, m + delay, m + delay), type(gain))
    whole[:, :m, :m] = inner
    whole[:, :m, m] = loop.B
    for i in range(delay - 1):
        whole[:, m + i, m + i + 1] = 1.0
    whole[:, m + delay - 1, :m] = answer
    return whole


def gain_margins(loop: Opened, along: Array) -> tuple[float, float]:
    """The factors on the gain, below 1 and above, at which deviations stop dying out.

    0 and inf where there is none.
    """

    def worst(gain: float) -> float:
        return multipliers(changed(loop, gain), along).largest

    most = _first(worst, np.geomspace(1.0, MOST_GAIN, 41))
    least = _first(worst, np.geomspace(1.0, 1 / MOST_GAIN, 41))
    return (0.0 if least is None else least), (np.inf if most is None else most)


def phase_margin(loop: Opened, along: Array) -> float:
    """The least angle [deg] by which the loop, turned in phase, lets deviations grow; inf: none.

    For a loop that does not change in time it is the phase margin of the Nyquist plot.
    """

    def worst(angle: float) -> float:
        gains = (complex(np.exp(sign * 1j * angle)) for sign in (1, -1))
        return max(multipliers(changed(loop, gain), along).largest for gain in gains)

    found = _first(worst, np.linspace(0.0, np.pi, 37))
    return np.inf if found is None else float(np.degrees(found))


def disk_margin(loop: Opened, along: Array) -> float:
    """The diameter of the largest balanced disk of factors with which all deviations die out.

    Factors (1 + z α/2) / (1 - z α/2), |z| = 1, of Seiler, Packard & Gahinet, IEEE Control
    Systems 40 (2020) 78, none of which changes in time.
    """
    circle = np.exp(1j * np.linspace(0.0, np.pi, 19))

    def worst(diameter: float) -> float:
        half = diameter / 2 * circle
        factors = ((1 + half) / (1 - half)).tolist()
        return max(multipliers(changed(loop, complex(g)), along).largest for g in factors)

    found = _first(worst, np.linspace(0.0, 1.95, 14))
    return 2.0 if found is None else found


def delay_margin(loop: Opened, along: Array) -> float:
    """The ticks of more delay with which deviations still die out; one more, and they grow."""
    low, high = 0, 1

    def stable(delay: int) -> bool:
        bigger = np.concatenate((along, np.zeros(delay)))
        return multipliers(changed(loop, 1.0, delay), bigger).largest < 1.0

    if not stable(0):
        return -1.0
    while stable(high):
        low, high = high, 2 * high
        if high > MOST_DELAY:
            return np.inf
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if stable(middle) else (low, middle)
    return float(low)


def _first(worst: Callable[[float], float], values: Array) -> float | None:
    """The first of `values` beyond which `worst` exceeds 1, by bisection; None: none does."""
    for a, b in pairwise(values):
        if worst(float(b)) >= 1.0:
            low, high = float(a), float(b)
            for _ in range(12):
                middle = (low + high) / 2
                low, high = (low, middle) if worst(middle) >= 1.0 else (middle, high)
            return low
    return None
