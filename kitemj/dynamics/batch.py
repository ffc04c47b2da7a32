"""A whole flight in one compiled call: a row of numbers at each time, no Python in between.

Any model takes part that registers two formulas for its flight (a ``NamedTuple`` of all that
its compiled functions need): how it is carried on in time, and what it is at an instant.
"""

from math import isfinite
from typing import Any

import numpy as np

from kitemj.dynamics.ground import clearance
from kitemj.dynamics.motion import Motion
from kitemj.physics.compiled import Array, compiled, law
from kitemj.physics.parameters import Parameters

X, Y, Z, ALPHA, BETA, CLEARANCE, TENSIONS = range(7)
"""Columns: G [m, E], angles [rad], lowest corner above ground [m]; from the last on what each
line pulls at the kite [N]."""


def _carry(flight: Any, t: float, end: float) -> float:
    """Takes `flight` from time `t` to `end` [s]; the time that was reached."""
    raise NotImplementedError


def _present(flight: Any, t: float) -> Motion:
    """`flight` at its present time `t` [s]."""
    raise NotImplementedError


carry, carry_law = law(_carry)
present, present_law = law(_present)


@compiled
def rows_at(flight: Any, parameters: Parameters, times: Array, touch: float, lines: int) -> Array:
    """Flies from 0 s through `times` (n,) [s], ascending; a row at each, of a kite on `lines`.

    Fewer than n where the numbers left the finite (the next row would be the first that does
    not hold) or where the kite came lower than `touch` [m] (the last row is there).
    """
    t, kite, rows = 0.0, parameters.kite, np.empty((len(times), TENSIONS + lines))
    for i in range(len(times)):
        if times[i] > t:
            if carry(flight, t, times[i]) < times[i]:
                return rows[:i]
            t = times[i]
        motion = present(flight, t)
        row, body = rows[i], motion.body
        row[X], row[Y], row[Z] = body.p_G_E
        for k in range(len(motion.lines)):
            row[TENSIONS + k] = motion.lines[k].tension_kite
        row[ALPHA], row[BETA] = motion.air.alpha, motion.air.beta
        row[CLEARANCE] = clearance(kite.chord, kite.span, body.p_G_E, body.R_BE)
        if not isfinite(np.sum(row)):
            return rows[:i]
        if row[CLEARANCE] < touch:
            return rows[: i + 1]
    return rows
