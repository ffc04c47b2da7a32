"""Runge-Kutta of order 8 with error control, compiled: DOP853 without a Python call in a step.

The method of Dormand and Prince with error estimates of orders 5 and 3, in the form of Hairer,
Nørsett, Wanner, "Solving Ordinary Differential Equations I", 2nd ed.
(1993), section II.5. Steps end exactly at the time that is asked for, so there is nothing to
interpolate; the step size that the error allows is kept from one call to the next.
"""

from math import inf, isfinite, sqrt
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import DOP853

from kitemj.dynamics.ground import CLOSE
from kitemj.physics.compiled import Array, compiled, law

STAGES = 12
SAFETY, SMALLEST, LARGEST = 0.9, 0.2, 10.0
"""Of the step size that the error allows: part taken, least and greatest change at once."""
BURST, OFTEN = 10_000, 1e5
"""Steps, and those for each second [1/s], after which a motion is too quick to be followed: a
force that jumps at a state to which both sides drive would take steps without end."""

_method: Any = DOP853  # its numbers are attributes of the class
NODES, WEIGHTS, RESULT = _method.C[:STAGES].copy(), _method.A.copy(), _method.B.copy()
"""When a stage is, in parts of a step; what stages make of those after them, and of the step."""
ERROR_3, ERROR_5 = _method.E3[:STAGES].copy(), _method.E5[:STAGES].copy()
"""The result less one of order 3, and less one of order 5."""


class Room(NamedTuple):
    """What one integration works in: `x` (n,), the stages' rates, and one stage's x.

    `state` holds (step size that the error allows, whether `rates[0]` is that of `x`,
    evaluations so far).
    """

    x: Array
    rates: Array
    stage: Array
    state: Array


def room_for(x: Array, step: float = 1e-3) -> Room:
    """Room for an integration from `x` (n,), which is copied; `step` [s]: the first to try."""
    n = len(x)
    return Room(x.copy(), np.empty((STAGES, n)), np.empty(n), np.array([step, 0.0, 0.0]))


def _right_side(system: Any, t: float, x: Array, out: Array) -> None:
    """Writes dx/dt of `system` (a ``NamedTuple``) at time `t` [s] and `x` (n,) to `out` (n,)."""
    raise NotImplementedError


def _room_below(system: Any, t: float, x: Array) -> float:
    """How far [m] `system` at `t` [s], `x` (n,) is above where its flight ends; inf: nowhere."""
    raise NotImplementedError


right_side, system_law = law(_right_side)
room_below, end_law = law(_room_below)


@compiled
def _add(total: Array, weight: float, x: Array) -> None:
    """total += weight x."""
    if weight != 0.0:
        for j in range(len(total)):
            total[j] += weight * x[j]


@compiled
def carried(system: Any, room: Room, t: float, end: float, tolerance: float) -> float:
    """Takes ``room.x`` from time `t` to `end` [s]; the time that was reached.

    `tolerance` bounds the error of a step in each number, relative to its size plus one.
    What was reached is before `end` where no step is short enough, or too many are: a singular,
    non-finite or jumping right-hand side; and where the flight ends, no more than `CLOSE`
    beyond `room_below` = 0.
    """
    x, rates, stage, state = room
    n, over, down, under = len(x), room_below(system, t, x), inf, 0.0
    if over < 0.0:
        return t
    most = state[2] + STAGES * (BURST + OFTEN * (end - t))
    while t < end and state[2] < most:
        h, last = state[0], False
        if t + 1.000001 * h >= end:  # no crumb of a step at the end
            h, last = end - t, True
        if down < inf:  # a step to `down` ended `under` < 0: regula falsi, aimed just below 0
            part = (over + CLOSE / 2) / (over - under)
            h, last = min(h, max(part * (down - t), 1e-12)), False
        first = 0 if state[1] == 0.0 else 1
        for i in range(first, STAGES):  # one call of the right side: it is compiled where it stands
            for j in range(n):
                stage[j] = x[j]
            for k in range(i):
                _add(stage, h * WEIGHTS[i, k], rates[k])
            right_side(system, t + NODES[i] * h, stage, rates[i])
        state[1], state[2] = 1.0, state[2] + STAGES - first
        error = _error(room, h, tolerance)  # leaves the new x in `stage`
        if not isfinite(error):
            factor = SMALLEST
        else:
            factor = min(LARGEST, max(SMALLEST, SAFETY * max(error, 1e-30) ** -0.125))
        below = room_below(system, t + h, stage) if error <= 1.0 else 0.0
        if below < -CLOSE and h > 1e-12:
            down, under = t + h, below
        elif error <= 1.0:
            for j in range(n):
                x[j] = stage[j]
            t = end if last else t + h
            state[0] = max(state[0], factor * h) if last else factor * h
            state[1], over = 0.0, below
            if below < -CLOSE / 4:
                return t
        else:
            state[0] = min(1.0, factor) * h
            if not state[0] > 1e-14 * max(1.0, abs(t)):
                return t
    return t


@compiled
def _error(room: Room, h: float, tolerance: float) -> float:
    """The step's error over what is allowed (root mean square); its result goes to `stage`."""
    x, rates, stage, _ = room
    by_3, by_5 = 0.0, 0.0
    for j in range(len(x)):
        total, error_3, error_5 = 0.0, 0.0, 0.0
        for k in range(STAGES):
            total += RESULT[k] * rates[k, j]
            error_3 += ERROR_3[k] * rates[k, j]
            error_5 += ERROR_5[k] * rates[k, j]
        stage[j] = x[j] + h * total
        allowed = tolerance * (1.0 + max(abs(x[j]), abs(stage[j])))
        by_3 += (error_3 / allowed) ** 2
        by_5 += (error_5 / allowed) ** 2
    if by_5 == 0.0 and by_3 == 0.0:
        return 0.0
    return abs(h) * by_5 / sqrt((by_5 + 0.01 * by_3) * len(x))
