"""A live flight that records itself, and all that it takes to begin one."""

import time
from collections.abc import Mapping
from math import nan
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple, Self

from kitemj.dynamics.formulation import DEFAULT_STEP
from kitemj.dynamics.motion import State
from kitemj.flight.live import Command, Saved, SteeredFlight, TickResult
from kitemj.flight.pilot_settings import Guided
from kitemj.flight.scenario import Scenario
from kitemj.physics.steering import Segment
from kitemj.recording.header import header_of
from kitemj.recording.recorder import Recorder
from kitemj.recording.table import Tick

CLOSED = "closed by its program"


class LiveFlight(SteeredFlight):
    """A flight that is steered tick by tick, and may leave a recording of all that was flown.

    A context manager, which closes the recording. `result` is what is known now; `lateness` [s]
    is that of the last tick; `cut`, once it is closed, whether the disk did not take all of it.
    `hand` is for who lets an assist fly: what the person asks of it, -1..1, recorded with each
    tick until it is set anew; not a number: the stick is the person's own. `guided` is for who lets
    an autopilot fly: what it tells of itself.
    """

    _recorder: Recorder | None = None
    _due: float | None = None
    lateness = 0.0
    cut = False
    hand = nan
    guided: Guided | None = None

    def __init__(
        self,
        scenario: Scenario | str | Path | Mapping[str, Any],
        model: str = "mujoco",
        reference: str | None = None,
        step: float = DEFAULT_STEP,
        other_starts: tuple[State, ...] = (),
        start: int = 0,
        record: str | Path | None = None,
        overwrite: bool = False,
    ) -> None:
        """Stands at its start, which is the first row; raises InputError as `Recorder` does.

        scenario      kite, wind, and the state at which to begin; its steering is not flown
        model         the formulation that flies
        reference     the formulation that follows it through the same ticks; None costs nothing
        step          longest step [s] of formulations with fixed steps
        other_starts  states to begin at besides; `starts` has the scenario's first, then these
        start         which of `starts` to begin at
        record        a new file; None: this flight leaves no recording
        overwrite     whether `record` may replace a file
        """
        super().__init__(scenario, model, reference, step, other_starts, start)
        if record:
            known = header_of(self), self.parameters, overwrite, self.scenario.pilot
            self._recorder = Recorder(Path(record), *known)
            self._add(Command())

    @property
    def problem(self) -> str:
        """What the person should know of the disk."""
        return self._recorder.problem if self._recorder else ""

    def restart(self, start: int = 0) -> TickResult:
        """Back to that of the `starts`, lines still; returns the first moment of the flight."""
        self.hand, self.guided = nan, None
        super().restart(start)
        return self._add(Command())

    def resume(self, saved: Saved, guided: Guided | None = None) -> TickResult:
        """Back to a moment that `save` returned; begins an episode, which goes on from there.

        `guided`: what the autopilot told then, where it goes on with what it knew.
        """
        self.hand, self.guided = nan, guided
        super().resume(saved)
        return self._add(Command())

    def tick(self, command: Command, due: float | None = None) -> TickResult:
        """One tick with the stick at `command`; raises FlightError where the flight diverges.

        `due` [s, perf_counter]: since when it should have been done; None: no clock is kept.
        """
        self._due = due
        return super().tick(command)

    def fly(self, segment: Segment, command: Command, wish: float = 0.0) -> TickResult:
        """One tick of `segment`, which `command` asked for; `wish` [rad] is the δ of it."""
        super().fly(segment, command, wish)
        return self._add(command)

    def close(self, ending: str = CLOSED) -> str:
        """Ends the recording and says why; returns a sentence on what the file holds."""
        recorder, self._recorder = self._recorder, None
        if recorder is None:
            return "none"
        told = recorder.close(ending)
        self.cut = bool(recorder.problem)
        return told

    def __enter__(self) -> Self:
        """The flight itself."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Closes the recording, which tells the error that ended the flight."""
        self.close(str(error) or type(error).__name__ if error else CLOSED)

    def _add(self, command: Command) -> TickResult:
        self.lateness = 0.0 if self._due is None else time.perf_counter() - self._due
        self._due = None
        if self._recorder:
            told = self.lateness, self.hand, self.guided
            now = self.segment.control, command, self.result, *told
            self._recorder.add(Tick(self.episode, self.ticks, *now))
        return self.result


class RecordedTick(NamedTuple):
    """A tick of the past: what the stick asked for, how the lines moved, `LiveFlight.hand`."""

    command: Command
    segment: Segment
    hand: float = nan


class FlightSetup(NamedTuple):
    """What `LiveFlight` takes, and the ticks of the `past` that lead to where it goes on."""

    scenario: Scenario
    model: str = "mujoco"
    reference: str | None = None
    step: float = DEFAULT_STEP
    other_starts: tuple[State, ...] = ()
    start: int = 0
    record: Path | None = None
    overwrite: bool = False
    past: tuple[RecordedTick, ...] = ()

    def flight(self) -> LiveFlight:
        """The flight at its start, the past not flown yet."""
        return LiveFlight(*self[:-1])
