"""Sources of films: a scenario flown by a model, or a recording; both give shots."""

from dataclasses import replace
from math import isfinite, nan
from typing import Protocol

import numpy as np

from kitemj.cockpit.parallel_painting import Shot
from kitemj.drawing.readings import Readings
from kitemj.drawing.recorded_traces import RecordedTraces
from kitemj.flight.compare import position_gap
from kitemj.flight.limits import departure_at
from kitemj.flight.scenario import Scenario
from kitemj.flight.simulate import simulate
from kitemj.physics.parameters import Parameters
from kitemj.physics.shaping import StickLaw
from kitemj.recording.file import Recording
from kitemj.recording.replay import Replay
from kitemj.recording.track import Track


class FilmSource(Protocol):
    """A flight that can be looked at; `duration` in s, `ending` says how it ended."""

    parameters: Parameters
    caption: str
    duration: float
    ending: str

    def shot(self, t: float, speed: float) -> Shot:
        """The shot `t` [s] after the start, shown `speed` times as fast as it was."""


class ScenarioSource:
    """`model` flying `scenario` beside the Lagrangian reference, every `interval` [s].

    Raises InputError for what cannot be flown.
    """

    def __init__(self, scenario: Scenario, model: str, step: float, interval: float) -> None:
        interval = min(interval, scenario.times.duration)
        framed = replace(scenario, times=scenario.times._replace(output_interval=interval))
        flight = simulate(framed, model, step)
        self.parameters, self.caption = scenario.parameters, f"{scenario.source}: {model}"
        self.ending = flight.ending.value
        self._model, self._interval, self._motions = model, interval, flight.motions
        self._references = simulate(framed, "lagrange", step).motions
        self.duration = flight.motions[-1].t

    def shot(self, t: float, speed: float) -> Shot:
        """The shot at the row nearest to `t` [s]."""
        row = min(round(t / self._interval), len(self._motions) - 1)
        motion = self._motions[row]
        reference = self._references[row] if row < len(self._references) else None
        departure = departure_at(self.parameters, motion)
        readings = Readings(
            model=self._model,
            gap=position_gap(motion, reference) if reference else None,
            delta_command=motion.control.delta,
            stick="programme",
            speed=speed,
            message=departure.limit.sentence if departure else "",
        )
        return Shot(motion, reference, readings)


class RecordingSource:
    """A recording, with its reference beside it, or with `again`: its input flown again.

    `times` [s] count from the first tick on, over all restarts.
    """

    def __init__(self, recording: Recording, again: Replay | None = None) -> None:
        self.parameters, self.ending = recording.parameters, recording.ending or "it breaks off"
        model = recording.header.model + (f" and {again.model}" if again else "")
        self.caption = f"{recording.path.name}: {model}"
        self._model, self._stick = recording.header.model, recording.parameters.stick.delta
        self._label = f"reference: {again.model}" if again else "recorded"
        self._tick, self._track = recording.header.tick, Track(recording)
        self._again = Track(recording, again.columns) if again else None
        self.duration = self._track.last * self._tick
        columns = recording.columns
        self._gaps = np.where(again.comparable, again.gaps, nan) if again else columns["gap_m"]
        self._wish, self._law = columns["stick_delta"], columns["stick_law"]
        self._lateness = columns["lateness_s"]
        self._missed = np.cumsum(self._lateness > self._tick)
        self._traces = RecordedTraces(recording, self._track)
        self._episodes, self._episode = len(recording.episodes), columns["leg"]

    def shot(self, t: float, speed: float) -> Shot:
        """The shot at `t` [s], between two ticks too."""
        place = min(max(t / self._tick, 0.0), float(self._track.last))
        row = min(round(place), self._track.last)
        motion = self._track.motion(place)
        assert motion is not None  # what was recorded was flown
        reference = self._track.reference(place, motion)
        gap = float(self._gaps[row])
        if self._again:
            reference = self._again.motion(place) if isfinite(gap) else None
        restarts = f" {self._episode[row] + 1}/{self._episodes}" if self._episodes > 1 else ""
        readings = Readings(
            model=self._model,
            gap=gap if isfinite(gap) else None,
            delta_command=float(self._wish[row]) * self._stick,
            law=StickLaw(int(self._law[row])),
            missed_ticks=int(self._missed[row]),
            lateness=float(self._lateness[row]),
            stick=f"{self._label}{restarts}",
            speed=speed,
            traces=self._traces.at(row),
        )
        return Shot(motion, reference, readings)
