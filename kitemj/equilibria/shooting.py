"""Periodic orbits by shooting: Newton's method on Φ_T(x) = x.

Source of the method: Seydel, Practical Bifurcation and Stability Analysis (2010), chapter 7.
"""

from typing import NamedTuple

import numpy as np

from kitemj.equilibria.minimal import Array, Minimal, steps_for
from kitemj.physics.steering import Control

MOST_ROUNDS = 4
"""After which a flight on the cycle may come back to where it was."""
CLOSED = 1e-8
"""Largest |Φ_T(x) - x| of a cycle, in rad and in rates over `state_units`."""
ROUNDING = 1e-12
"""A gap at which there is nothing left to correct."""
STANDS = 1e-4
"""Closer to the equilibrium than this, scaled, it is the equilibrium that was found."""
DIFFERENCE = 1e-4
"""Of `state_units`; moves the start for the monodromy matrix."""


class Section(NamedTuple):
    """Where orbits are closed: coordinate `k` as at the equilibrium `x_eq` (8,) [rad, rad/s].

    `control`: the lines, held; `units` (8,): changes of x that matter.
    """

    x_eq: Array
    control: Control
    k: int
    units: Array


class Closed(NamedTuple):
    """A state `x` (8,) that comes back after `period` [s] but for `gap`, scaled."""

    x: Array
    period: float
    gap: float


def monodromy(
    kite: Minimal, x: Array, T: float, control: Control, steps: int, units: Array
) -> Array:
    """dΦ_T/dx (8, 8), by central differences, extrapolated once.

    kite: the model that flies
    x: (8,) state at the start, rad and rad/s
    T: s, the time Φ goes on
    control: the lines, held
    steps: how many the model takes in `T`
    units: (8,) of `x`; both sides of the derivative are measured in them
    """
    columns = []
    for e in np.eye(8):
        d = DIFFERENCE * units * e
        after, before, half_after, half_before = (
            kite.flow(x + s * d, control, T, steps) for s in (1.0, -1.0, 0.5, -0.5)
        )
        wide, narrow = (after - before) / 2, half_after - half_before
        columns.append((4 * narrow - wide) / (3 * DIFFERENCE * units))
    return np.column_stack(columns)


def closed(
    kite: Minimal, section: Section, x: Array, T: float, M: Array | None = None
) -> Closed | None:
    """The closed orbit near the state `x` (8,) [rad, rad/s] and the period `T` [s].

    `M` (8, 8): a monodromy matrix to use throughout (one of another model will do); None: that
    of each iterate. Returns None where Newton's method does not reach `CLOSED`, or runs away.
    """
    steps, near, best = steps_for(T), T, Closed(x, T, np.inf)
    _, control, k, units = section
    free = [i for i in range(8) if i != k]
    for _ in range(12):
        end = kite.flow(x, control, T, steps)
        gap = (end - x) / units
        size = float(np.abs(gap).max())
        if not size < best.gap:
            break
        best = Closed(x, T, size)
        if size < ROUNDING:
            break
        slope = monodromy(kite, x, T, control, steps, units) if M is None else M
        along = kite.answer(end, control).x_dot / units
        J = np.column_stack([(slope - np.eye(8))[:, free], along])
        if not np.isfinite(J).all():
            break
        step = np.linalg.lstsq(J, -gap, rcond=None)[0]
        x, T = x.copy(), T + float(step[7])
        x[free] += step[:7] * units[free]
        if not 0.5 * near < T < 2 * near:
            break
    return best if best.gap < CLOSED else None


def primitive(kite: Minimal, section: Section, found: Closed) -> Closed:
    """The same orbit flown once: the flight may have been seen to return after several rounds."""
    for rounds in range(MOST_ROUNDS, 1, -1):
        T = found.period / rounds
        moved = kite.flow(found.x, section.control, T) - found.x
        if np.abs(moved / section.units).max() < STANDS:
            return closed(kite, section, found.x, T) or found
    return found
