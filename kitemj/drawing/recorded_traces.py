"""The history that instruments show, out of a recording, at any of its rows."""

import numpy as np
from numpy.typing import NDArray

from kitemj.drawing import history
from kitemj.drawing.alarms import HELD, alarm_at
from kitemj.drawing.history import CHART_COLUMNS, CHART_SPAN, Traces, twist_angle
from kitemj.flight.limits import TWIST, Numbers
from kitemj.recording.file import Recording
from kitemj.recording.table import LIMITS, limit_numbers
from kitemj.recording.track import Track

TWIST_STEP = 0.1
"""s between looks at the lines' twist; no kite turns by half a turn meanwhile."""


class RecordedTraces:
    """The traces at any row of a recording."""

    def __init__(self, recording: Recording, track: Track) -> None:
        columns, tick = recording.columns, recording.header.tick
        self._recording, self._track, self._tick = recording, track, tick
        self._places = np.column_stack([columns[name] for name in ("x_E_m", "y_E_m", "z_E_m")])
        self._pull = np.mean(limit_numbers(columns).tensions, axis=0)
        self._beyond = np.logical_or.reduce([columns[name] for name in LIMITS])
        self._every = max(1, round(history.TRAIL_STEP / tick))
        self._looks = max(1, round(TWIST_STEP / tick))
        self._starts = np.array([episode.start for episode in recording.episodes])
        self._twist = np.concatenate([self._twists(episode) for episode in recording.episodes])
        self._beyond |= ~TWIST.kept(recording.parameters.limits, Numbers(twist=self._twist))

    def at(self, row: int) -> Traces:
        """The traces to be shown at `row`."""
        start = int(self._starts[np.searchsorted(self._starts, row, side="right") - 1])
        first = max(start, row - self._every * (history.TRAIL_POINTS - 1))
        back = slice(row, first - 1 if first else None, -self._every)
        trail, pull = self._places[back][::-1].copy(), self._pull[back][::-1].copy()
        twist, alarm = float(self._twist[row]), None
        held = max(start, row - round(HELD / self._tick))
        if len(recent := np.flatnonzero(self._beyond[held : row + 1][::-1])):
            last = row - int(recent[0])
            motion, turned = self._track.motion(last), float(self._twist[last])
            found = alarm_at(self._recording.parameters, motion, turned) if motion else None
            alarm = found._replace(age=int(recent[0]) * self._tick) if found else None
        unseen = np.full(CHART_COLUMNS, np.nan)
        return Traces(trail, twist, self._lateness(row), unseen, alarm, pull)

    def _lateness(self, row: int) -> NDArray[np.float64]:
        """The largest lateness [s] in each part of the last CHART_SPAN."""
        share = max(1, round(CHART_SPAN / self._tick / CHART_COLUMNS))
        values = np.full(share * CHART_COLUMNS, np.nan)
        known = self._recording.columns["lateness_s"][: row + 1][-len(values) :]
        values[len(values) - len(known) :] = known
        return np.asarray(np.fmax.reduce(values.reshape(CHART_COLUMNS, share), axis=1))

    def _twists(self, episode: slice) -> NDArray[np.float64]:
        """The twist [rad] at each row of the episode, as it was when last looked at."""
        motions = map(self._track.motion, range(episode.start, episode.stop, self._looks))
        angles = [twist_angle(self._track.parameters, motion) for motion in motions if motion]
        return np.repeat(np.unwrap(angles), self._looks)[: episode.stop - episode.start]
