"""Sources of films: a simulated flight, or a recording; both give shots."""

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import isfinite, nan
from pathlib import Path
from typing import Any

import numpy as np

from kitemj.autopilot.guided_flight import simulate_as_said
from kitemj.cockpit.film_paths import path_flown
from kitemj.cockpit.parallel_painting import Shot
from kitemj.cockpit.screens import FRAME_RATE
from kitemj.drawing.history import History, Traces
from kitemj.drawing.readings import Readings
from kitemj.drawing.recorded_traces import RecordedTraces
from kitemj.drawing.wished import Wished
from kitemj.dynamics.formulation import DEFAULT_STEP
from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.flight.compare import position_gap
from kitemj.flight.guided_table import guided_at
from kitemj.flight.limits import departure_at
from kitemj.flight.pilot_settings import PilotSettings
from kitemj.flight.scenario import Scenario, as_scenario, check_rows
from kitemj.physics.shaping import StickLaw
from kitemj.physics.steering import Control
from kitemj.pilots.crash import Touch, touch_at
from kitemj.plots.flight import Flight, flight_of_simulation
from kitemj.recording.file import Recording, read_recording
from kitemj.recording.recorder import SUFFIX
from kitemj.recording.replay import Replay, replay
from kitemj.recording.table import HAND
from kitemj.recording.track import Track, between

SAME = 1e-6
"""s; far below a frame of any film, far above the rounding of times."""


class MotionSource:
    """A simulated flight, beside the motions of a reference at the same times if there are any.

    `stick` says what steered; `pilot`: what its autopilot was told, if one flew. Raises InputError
    for a flight that has columns only.
    """

    def __init__(
        self,
        flight: Flight,
        references: Sequence[Motion] = (),
        stick: str = "simulated",
        pilot: PilotSettings | None = None,
    ) -> None:
        if not flight.motions:
            why = "was read from a file and has no motions: film the file"
            raise InputError(f"{flight.name} {why}")
        self.parameters, self.caption = flight.parameters, flight.name
        self.ending = flight.ending.value if flight.ending else ""
        self._model, self._stick = flight.model, stick
        self._motions, self._references = flight.motions, references
        self._times = [motion.t for motion in flight.motions]
        self._history, self._known = History(self.parameters), 0
        self.duration = self._times[-1]
        self._guided, self._path = flight.guided, path_flown(self.parameters, pilot)

    def shot(self, t: float, speed: float) -> Shot:
        """The shot at `t` [s], between two motions too, shown `speed` times as fast as it was."""
        row = max(bisect_right(self._times, t + SAME) - 1, 0)
        motion = self._motion(self._motions, row, t)
        known = row < len(self._references)
        reference = self._motion(self._references, row, t) if known else None
        departure = departure_at(self.parameters, motion)
        readings = Readings(
            model=self._model,
            gap=position_gap(motion, reference) if reference else None,
            delta_command=motion.control.delta,
            stick=self._stick,
            speed=speed,
            message=departure.limit.sentence if departure else "",
            traces=self._traces(row),
            touch=touch_at(self.parameters, motion, self._motions[row - 1] if row else None),
            wished=self._wished(row),
        )
        return Shot(motion, reference, readings)

    def _wished(self, row: int) -> Wished | None:
        """What the autopilot told of the tick that ended at `row`; at the start of the next."""
        told = [each for each in self._guided[row : row + 2] if each]
        return Wished(self._path, told[0]) if told else None

    def _traces(self, row: int) -> Traces:
        """What a watcher of all motions up to `row` remembers there."""
        if row + 1 < self._known:  # back in time
            self._history, self._known = History(self.parameters), 0
        for motion in self._motions[self._known : row + 1]:
            self._history.add(motion.t, motion)
        self._known = row + 1
        return self._history.traces(self._motions[row].t)

    def _motion(self, motions: Sequence[Motion], row: int, t: float) -> Motion:
        """The motion at `t` [s], at or after that of `row`."""
        now = motions[row]
        if t - now.t <= SAME or row + 1 >= len(motions):
            return now
        then = motions[row + 1]
        part = (t - now.t) / (then.t - now.t)
        both = zip(now.control, then.control, strict=True)
        steering = Control(*((1 - part) * a + part * b for a, b in both))
        return between(self.parameters, now, then, part, steering)


class RecordingSource:
    """A recording, with its reference beside it, or with `again`: its input flown again.

    `times` [s] count from the first tick on, over all restarts.
    """

    def __init__(self, recording: Recording, again: Replay | None = None) -> None:
        self.parameters, self.ending = recording.parameters, recording.ending or "it breaks off"
        model = recording.header.model + (f" and {again.model}" if again else "")
        self.caption = f"{recording.path.name}: {model}"
        self._model, self._columns = recording.header.model, recording.columns
        self._label = f"reference: {again.model}" if again else "recorded"
        self._tick, self._track = recording.header.tick, Track(recording)
        self._again = Track(recording, again.columns) if again else None
        self.duration = self._track.last * self._tick
        recorded = self._columns["gap_m"]
        self._gaps = np.where(again.comparable, again.gaps, nan) if again else recorded
        self._missed = np.cumsum(self._columns["lateness_s"] > self._tick)
        self._traces = RecordedTraces(recording, self._track)
        self._starts = [episode.start for episode in recording.episodes]
        self._path = path_flown(recording.parameters, recording.pilot)

    def shot(self, t: float, speed: float) -> Shot:
        """The shot at `t` [s], between two ticks too, shown `speed` times as fast as it was."""
        place = min(max(t / self._tick, 0.0), float(self._track.last))
        row = min(round(place), self._track.last)
        motion = self._track.motion(place)
        assert motion is not None  # what was recorded was flown
        reference = self._track.reference(place, motion)
        gap = float(self._gaps[row])
        if self._again:
            reference = self._again.motion(place) if isfinite(gap) else None
        columns, episodes = self._columns, len(self._starts)
        restarts = f" {columns['leg'][row] + 1}/{episodes}" if episodes > 1 else ""
        readings = Readings(
            model=self._model,
            gap=gap if isfinite(gap) else None,
            delta_command=float(columns["stick_delta"][row]) * self.parameters.stick.delta,
            law=StickLaw(int(columns["stick_law"][row])),
            missed_ticks=int(self._missed[row]),
            lateness=float(columns["lateness_s"][row]),
            stick=f"{self._label}{restarts}",
            speed=speed,
            traces=self._traces.at(row),
            touch=self._touch(row),
            assist=isfinite(float(columns[HAND][row])),
            wished=self._wished(row),
        )
        return Shot(motion, reference, readings)

    def _wished(self, row: int) -> Wished | None:
        """What the autopilot told at `row`; of no scenario, it may fly any path."""
        guided = guided_at(self._columns, row)
        return Wished(self._path, guided) if guided else None

    def _touch(self, row: int) -> Touch | None:
        """How the kite met the ground that it is on at `row`."""
        ground, start = self._columns["ground"], self._starts[bisect_right(self._starts, row) - 1]
        if not ground[row]:
            return None
        first = start + int(np.argmax(ground[start:]))
        motion, before = self._track.motion(first), self._track.motion(max(first - 1, start))
        return touch_at(self.parameters, motion, before) if motion else None


FilmSource = MotionSource | RecordingSource
"""A flight that can be looked at; `duration` in s, `ending` says how it ended."""


def film_source(
    given: Flight | Recording | Scenario | str | Path | Mapping[str, Any],
    model: str | None = None,
    step: float | None = None,
    interval: float = 1 / FRAME_RATE,
) -> FilmSource:
    """What can be filmed of a flight, a recording, a scenario, or a file of either.

    `model` flies a scenario (mujoco if None) beside the Lagrangian reference, or the input of a
    recording again; `step` [s] is its longest, `interval` [s] that of the frames.
    Raises InputError.
    """
    if isinstance(given, (str, Path)) and Path(given).suffix.lower() == SUFFIX:
        given = read_recording(given)
    if isinstance(given, Recording):
        return RecordingSource(given, replay(given, model, step) if model else None)
    if isinstance(given, Flight):
        return MotionSource(given)
    scenario, model, step = as_scenario(given), model or "mujoco", step or DEFAULT_STEP
    times = scenario.times._replace(output_interval=min(interval, scenario.times.duration))
    check_rows(times, f"a frame every {interval:g} s of the flight", scenario.source)
    framed = replace(scenario, times=times)
    references = simulate_as_said(framed, "lagrange", step).motions
    flight = flight_of_simulation(simulate_as_said(framed, model, step))
    return MotionSource(
        replace(flight, name=f"{scenario.source}: {model}"),
        references,
        "autopilot" if scenario.pilot else "programme",
        scenario.pilot,
    )
