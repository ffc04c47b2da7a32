"""The history that instruments show: trail, turns of the lines, lateness, the last alarm.

`History` is fed at every tick or frame, by one thread; any thread may ask for its `traces`,
which are copies. Its memory is fixed from the start.
"""

from collections import deque
from math import atan2, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.drawing.alarms import Alarm, alarm_at
from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, cross, dot, norm, plus, times
from kitemj.scene.views import UP, downwind

TRAIL_STEP = 0.03  # s of the flight between points of the trail
TRAIL_POINTS = 400
CHART_SPAN = 20.0  # s of the clock that the strip chart shows
CHART_COLUMNS = 250


class Traces(NamedTuple):
    """A copy of the history for one frame.

    `trail` (n, 3) [m, E], oldest first; `twist` [rad], positive to the right. `lateness` and
    `frame_time` (CHART_COLUMNS,) [s]: the longest in each part of the last CHART_SPAN, NaN
    where there was none. `alarm`: the last one, its age counted from when it ended. `pull` (n,)
    [N]: what a line pulled at each point of the trail, the mean of all; None: it is not known.
    """

    trail: NDArray[np.float64]
    twist: float
    lateness: NDArray[np.float64]
    frame_time: NDArray[np.float64]
    alarm: Alarm | None = None
    pull: NDArray[np.float64] | None = None


class Point(NamedTuple):
    """A point of the trail: when [s], how far lines were turned [rad], where [m, E], pull [N]."""

    t: float
    twist: float
    place: Vector
    pull: float


class History:
    """The history of one flight. `now` [s] is any clock that runs as the watcher's."""

    def __init__(self, parameters: Parameters) -> None:
        self._parameters = parameters
        self._points: deque[Point] = deque(maxlen=TRAIL_POINTS)
        self._lateness, self._frame_time = Rolling(), Rolling()
        self._alarm: tuple[float, Alarm] | None = None
        self._t = 0.0  # s, of the last motion

    def add(self, now: float, motion: Motion, lateness: float | None = None) -> None:
        """Adds a tick that was done `lateness` [s] late, or, where no clock is kept, a frame."""
        if lateness is not None:
            self._lateness.add(now, lateness)
        if motion.t < self._t:  # another flight, or the same one from before its alarm
            self._alarm = None
        self._t = motion.t
        while self._points and self._points[-1].t >= motion.t:  # the flight went back
            self._points.pop()
        if not self._points or motion.t - self._points[-1].t > TRAIL_STEP - 1e-6:
            angle = twist_angle(self._parameters, motion)
            last = self._points[-1].twist if self._points else angle
            twist = last + (angle - last + pi) % (2 * pi) - pi
            pull = sum(motion.tensions) / len(motion.tensions)
            self._points.append(Point(motion.t, twist, motion.body.p_G_E, pull))
        alarm = alarm_at(self._parameters, motion, self._points[-1].twist)
        if alarm:
            self._alarm = (now, alarm)

    def add_frame(self, now: float, duration: float) -> None:
        """Adds a frame that took `duration` [s]; may be called by another thread than `add`."""
        self._frame_time.add(now, duration)

    def traces(self, now: float) -> Traces:
        """The traces to be shown at `now` [s]."""
        last, points = self._alarm, list(self._points)
        alarm = last[1]._replace(age=max(now - last[0], 0.0)) if last else None
        trail = np.array([point.place for point in points]).reshape(len(points), 3)
        twist = points[-1].twist if points else 0.0
        late, frames = self._lateness.values(now), self._frame_time.values(now)
        pull = np.array([point.pull for point in points])
        return Traces(trail, twist, late, frames, alarm, pull)


class Rolling:
    """The largest value in each of CHART_COLUMNS parts of the last CHART_SPAN seconds."""

    def __init__(self) -> None:
        self._values = np.full(CHART_COLUMNS, np.nan)
        self._part = -1

    def add(self, now: float, value: float) -> None:
        """Notes `value` at `now` [s]; the clock does not go back."""
        part = int(now / CHART_SPAN * CHART_COLUMNS)
        if part > self._part:
            passed = min(part - self._part, CHART_COLUMNS)
            self._values[np.arange(part - passed + 1, part + 1) % CHART_COLUMNS] = np.nan
            self._part = part
        column = part % CHART_COLUMNS
        self._values[column] = np.fmax(self._values[column], value)

    def values(self, now: float) -> NDArray[np.float64]:
        """The values (CHART_COLUMNS,), the newest last; NaN where nothing was noted."""
        age = int(now / CHART_SPAN * CHART_COLUMNS) - self._part
        rolled = np.roll(self._values, -(self._part + 1) % CHART_COLUMNS)
        if age <= 0:
            return rolled
        shifted = np.full(CHART_COLUMNS, np.nan)
        shifted[: max(CHART_COLUMNS - age, 0)] = rolled[age:]
        return shifted


def twist_angle(parameters: Parameters, motion: Motion) -> float:
    """The angle [rad, -π..π] of the attachments about the lines, seen from the pilot.

    Clockwise is positive: a loop to the right adds 2π. Zero is the frame of the pilot, facing
    downwind, tilted to the kite by the shortest turn; hands that stay level cannot tell it from
    a line that is not twisted. Undefined only for a kite straight upwind on the ground.
    """
    G, wind = motion.body.p_G_E, downwind(parameters)
    u = times(1.0 / max(norm(G), 1e-9), G)
    left = cross(UP, wind)
    # the shortest turn that takes the wind's direction to u, applied to `left`
    axis, c = cross(wind, u), dot(wind, u)
    share = dot(axis, left) / max(1.0 + c, 1e-9)
    reference = plus(plus(times(c, left), cross(axis, left)), times(share, axis))
    across = motion.body.R_BE.y
    return atan2(dot(cross(reference, across), u), dot(reference, across))
