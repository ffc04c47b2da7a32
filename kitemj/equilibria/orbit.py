"""One round of a closed orbit: its motions, and the range of what people ask about."""

from math import hypot
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.motion import Motion
from kitemj.equilibria.minimal import Array, Minimal, seen
from kitemj.physics.steering import Control

SAMPLES = 480
"""Of one period; extremes are those of parabolas through three neighbours."""


class Range(NamedTuple):
    """Least and largest value; `swing` is half of what lies between."""

    low: float
    high: float

    @property
    def swing(self) -> float:
        """(high - low)/2."""
        return 0.5 * (self.high - self.low)


class Orbit(NamedTuple):
    """`motions`: `SAMPLES` + 1 from one end of the period to the other; ranges over it.

    q, α, β, elevation and azimuth of G seen from O_E (positive to the pilot's left) in rad;
    `x_E`, `y_E`, `height` of G in m; `airspeed`, `speed` of G in m/s; tensions in N, of
    either line and of both together.
    """

    motions: list[Motion]
    phi: Range
    gamma: Range
    eta: Range
    theta: Range
    alpha: Range
    beta: Range
    elevation: Range
    azimuth: Range
    x_E: Range
    y_E: Range
    height: Range
    airspeed: Range
    speed: Range
    tension_plus: Range
    tension_minus: Range
    tension_both: Range


def orbit(kite: Minimal, x: Array, period: float, control: Control) -> Orbit:
    """The round from `x` (8,) of `period` [s], flown by `kite` with `control` held."""
    motions = kite.motions(x, control, period, SAMPLES)
    return Orbit(motions, *(range_of(column) for column in np.array(list(map(_row, motions))).T))


def range_of(values: Array) -> Range:
    """Least and largest of a periodic signal sampled evenly, both ends of the period given."""
    return Range(-_peak(-values[:-1]), _peak(values[:-1]))


def _peak(values: Array) -> float:
    """The top of the parabola through the largest value and its neighbours."""
    i = int(np.argmax(values))
    a, b, c = values[i - 1], values[i], values[(i + 1) % len(values)]
    bend = a - 2 * b + c
    return float(b - (a - c) ** 2 / (8 * bend)) if bend < 0 else float(b)


def _row(motion: Motion) -> list[float]:
    """The values of one motion in the order of `Orbit`."""
    p, v, T = motion.body.p_G_E, motion.body.v_G_E, motion.tensions
    angles = [*(motion.q or ()), motion.air.alpha, motion.air.beta, *seen(p)]
    return [*angles, p.x, p.y, -p.z, motion.air.speed, hypot(v.x, v.y, v.z), *T, sum(T)]
