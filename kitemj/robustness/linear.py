"""The loop linearised at each tick of a lap, opened at the stick."""

from math import pi
from typing import NamedTuple

import numpy as np

from kitemj.autopilot.follow import vector_at
from kitemj.autopilot.truth import true_estimate
from kitemj.paths.sphere import course, direction, tangential
from kitemj.physics.compiled import Array
from kitemj.physics.vectors import norm, times
from kitemj.robustness.loop import PROGRESS, STATES, Lap, Loop

STEPS = np.array([1e-5] * 4 + [1e-4] * 4 + [1e-5, 1e-4, 1e-5])
"""Of central differences in x, rad and rad/s: their error is some 1e-8 of what is found, and
rounding less."""
WISH_STEP = 1e-4
"""rad, of δ wished."""


class Opened(NamedTuple):
    """x' = A x + B u, δ wished y = C x, of deviations from a lap, a row a tick.

    A (n, 11, 11), B (n, 11), C (n, 11); u [rad] is what the hands are sent to. `by_place` (n,
    11): of y, what the place on the path alone asks for, so that C - by_place is what answers
    errors. The loop is closed by u = y. `frame` (n + 1, 11, 11): how coordinates that go along with
    the path change with x, at the beginning of each tick and at the end.
    """

    A: Array
    B: Array
    C: Array
    by_place: Array
    frame: Array

    def along_path(self, i: int) -> tuple[Array, Array, Array]:
        """A, B, C of a tick in the coordinates that go along with the path.

        What is frozen must not turn: in fixed coordinates a kite that flies a curve well
        seems to run away.
        """
        here, there = np.linalg.inv(self.frame[i]), self.frame[i + 1]
        return there @ self.A[i] @ here, there @ self.B[i], self.C[i] @ here

    @property
    def closed(self) -> Array:
        """A of each tick with the loop closed, (n, 11, 11)."""
        return np.asarray(self.A + self.B[:, :, None] * self.C[:, None, :])


def opened(loop: Loop, lap: Lap) -> Opened:
    """The loop linearised at each tick of a lap."""
    rows = [_opened_at(loop, x, float(wish)) for x, wish in zip(lap.x, lap.wish, strict=False)]
    A, B, C = (np.array(column) for column in zip(*rows, strict=True))
    slope = _slope(lap.wish, lap.x[:, PROGRESS])
    frame = np.array([_frame_at(loop, x) for x in lap.x])
    return Opened(A, B, C, slope[:, None] * A[:, PROGRESS, :], frame)


def _opened_at(loop: Loop, x: Array, wish: float) -> tuple[Array, Array, Array]:
    A, C = np.empty((STATES, STATES)), np.empty(STATES)
    for j, step in enumerate(STEPS):
        moved = np.zeros(STATES)
        moved[j] = step
        high, low = loop.begin(x + moved), loop.begin(x - moved)
        C[j] = (high.wish - low.wish) / (2 * step)
        end = loop.end(x + moved, high.progress, wish) - loop.end(x - moved, low.progress, wish)
        A[:, j] = end / (2 * step)
    place = loop.begin(x).progress
    more, less = (loop.end(x, place, wish + sign * WISH_STEP) for sign in (1.0, -1.0))
    return A, (more - less) / (2 * WISH_STEP), C


def _frame_at(loop: Loop, x: Array) -> Array:
    frame = np.empty((STATES, STATES))
    for j, step in enumerate(STEPS):
        moved = np.zeros(STATES)
        moved[j] = step
        apart = _beside_path(loop, x + moved) - _beside_path(loop, x - moved)
        frame[:, j] = (ANGLES * ((apart + pi) % (2 * pi) - pi) + (1 - ANGLES) * apart) / (2 * step)
    return frame


ANGLES = np.array([0.0, 0.0, 0.0, 1.0, 1.0] + [0.0] * 6)
"""Which of the coordinates beside the path are angles that go round."""


def _beside_path(loop: Loop, x: Array) -> Array:
    """Progress, error [rad], speed [rad/s], course and heading off the path's [rad], then

    the nose's rate [rad/s], pitch [rad] and its rate [rad/s], δ, δ̇, the place remembered [rad].
    """
    tick = loop.begin(x)
    seen = true_estimate(tick.motion)
    p = direction(seen.azimuth, seen.elevation)
    way = tangential(p, vector_at(loop.path, loop.path.ahead, tick.progress))
    wanted = course(p, times(1.0 / norm(way), way))
    off = seen.course - wanted, seen.heading - wanted
    at = tick.progress, tick.error, seen.speed
    return np.array([*at, *off, seen.turning, x[3], x[7], *x[8:]])


def _slope(wish: Array, way: Array) -> Array:
    """dδ/ds [rad/rad] along a lap that repeats, where s is the progress after each tick."""
    s, n = way[1:], len(wish)
    around = way[-1] - way[0]
    after, before = np.roll(s, -1), np.roll(s, 1)
    after[-1] += around
    before[0] -= around
    return np.asarray((np.roll(wish, -1) - np.roll(wish, 1))[:n] / (after - before))
