"""A live flight kept in step with the wall clock, in a thread of its own."""

import gc
import os
import sys
import threading
import time
from collections import deque
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass

from kitemj.drawing.history import History
from kitemj.flight.live import TICK, Command, LiveFlight, TickResult
from kitemj.pilots.crash import FirstTouch, Touch
from kitemj.realtime.rewind import RewindHistory, RewindPoint
from kitemj.recording.recorder import Recorder
from kitemj.recording.resume import RecordedTick
from kitemj.recording.table import Tick

MAX_LAG = 0.25
"""s; further behind than this the flight does not race after the clock: time is let go."""


FRAME = 1 / 30
"""s; what a person sees at once."""


@dataclass
class Timekeeping:
    """How well real time was kept.

    Tick k is to be done within `TICK` of the moment at which it is due; `missed` counts
    those that were not, `late` those that were later than a frame. `lateness` and `worst`
    [s]: from due to done. `lost` [s]: wall time that was let go (a machine asleep), not flown.
    """

    ticks: int = 0
    missed: int = 0
    late: int = 0
    lateness: float = 0.0
    worst: float = 0.0
    largest_gap: float = 0.0
    lost: float = 0.0

    def note(self, lateness: float, allowed: float, gap: float) -> None:
        """A tick that was done `lateness` [s] after it was due, with a `gap` [m]."""
        self.ticks += 1
        self.lateness = lateness
        self.worst = max(self.worst, lateness)
        self.missed += lateness > allowed
        self.late += lateness > FRAME
        self.largest_gap = max(self.largest_gap, gap)


class Pacer(threading.Thread):
    """Flies ticks as they come due; `command` is written to it, `moment` read from it.

    Both are replaced whole, so neither side waits for the other. `rate` is simulated over
    wall time: 1 is real time, 0 a pause; it may be changed at any moment. `start_at`: which
    of the flight's starts the next restart goes to. A kite that met the
    ground stays as it met it until somebody goes back or begins again. `error` holds what
    ended the flight, if anything did; `history` and `recorder` are told of every tick.
    """

    def __init__(
        self,
        flight: LiveFlight,
        history: History,
        recorder: Recorder | None = None,
        past: Iterable[RecordedTick] = (),
        start_at: int = 0,
    ) -> None:
        """`past`: ticks that are flown at once, before the first that is paced."""
        super().__init__(name="physics", daemon=True)
        self.flight, self.history, self.recorder = flight, history, recorder
        self.model, self.parameters = flight.kite.name, flight.parameters
        self.command, self.rate = Command(), 1.0
        self.start_at = start_at
        self.times = Timekeeping()
        self.error: Exception | None = None
        self._rewind, self._episode = RewindHistory(), -1
        self._deeds: deque[str] = deque()
        self._stopping = threading.Event()
        self.result: TickResult
        self._restart()
        for command, segment in past:
            self.result = flight.fly(segment)
            self._tell(command, 0.0)

    def run(self) -> None:
        """Ticks until `stop`; the interpreter hands over at once when a tick is due."""
        go_first()
        sys.setswitchinterval(TICK / 20)
        gc.disable()  # a search for cycles holds the interpreter for 50 ms; there are hardly any
        try:
            while not self._stopping.is_set():
                if self._flying(self.rate):
                    self._keep_pace(self.rate)
                else:
                    time.sleep(TICK)
                    self._obey()
        except Exception as error:  # shown by whoever flies; a thread's own end is silent
            self.error = error

    @property
    def problem(self) -> str:
        """What the person should know of the disk."""
        return self.recorder.problem if self.recorder else ""

    @property
    def touch(self) -> Touch | None:
        """How the kite met the ground, where it waits now."""
        return self._ground.touch

    def ask(self, deed: str) -> None:
        """ "restart", "step" (while paused), "rewind", "save" or "load", before the next tick."""
        self._deeds.append(deed)

    def update(self) -> None:
        """Its attributes are always those of now; raises what ended the flight."""
        if self.error:
            raise self.error

    def stop(self, ending: str = "") -> str:
        """Ends the flight after the tick that is under way; what became of the recording."""
        self._stopping.set()
        self.join()
        gc.enable()
        return self.recorder.close(str(self.error or ending)) if self.recorder else "none"

    def _flying(self, rate: float) -> bool:
        return self.rate == rate > 0 and not self.touch and not self._stopping.is_set()

    def _keep_pace(self, rate: float) -> None:
        """Ticks by the clock for as long as the rate stays."""
        origin, k = time.perf_counter(), 0
        while self._flying(rate):
            due = origin + k * TICK / rate
            self._wait(due)
            self._obey()
            if not self._flying(rate):
                break
            lateness = self._tick(due)
            self.times.note(lateness, TICK / rate, self.result.gap or 0.0)
            k += 1
            if lateness > MAX_LAG:
                origin += lateness
                self.times.lost += lateness

    def _tick(self, due: float) -> float:
        """One tick; how much later than `due` [s] it was done."""
        command = self.command
        self.result = self.flight.tick(command)
        lateness = time.perf_counter() - due
        self._tell(command, lateness)
        return lateness

    def _obey(self) -> None:
        """Does what was asked since."""
        while self._deeds:
            deed = self._deeds.popleft()
            if deed == "restart":
                self._restart()
            elif deed == "step" and not self.rate and not self.touch:
                self._tick(time.perf_counter())
            elif deed == "rewind":
                self._go_on_from(self._rewind.back(self.flight))
            elif deed == "save":
                self._rewind.mark(self.flight, self._episode)
            elif deed == "load":
                self._go_on_from(self._rewind.recall())

    def _restart(self) -> None:
        self._rewind.forget()
        self.result = self.flight.restart(self.start_at)
        self._begin_episode()
        self._tell(Command(), 0.0)

    def _begin_episode(self) -> None:
        self._episode += 1
        self._ground = FirstTouch(self.flight.parameters)

    def _go_on_from(self, kept: RewindPoint | None) -> None:
        if kept:
            self.result = self.flight.resume(kept.saved)
            self._begin_episode()
            self._tell(Command(), 0.0, kept.episode)

    def _tell(self, command: Command, lateness: float, resumed: int | None = None) -> None:
        flight, result = self.flight, self.result
        self._ground.watch(result.motion)
        if resumed is None:
            self._rewind.see(flight, self._episode)
        self.history.add(time.perf_counter(), result.motion, lateness)
        if self.recorder:
            control = flight.segment.control
            tick = Tick(flight.ticks, control, command, result, lateness, resumed, self.start_at)
            self.recorder.add(tick)

    @staticmethod
    def _wait(due: float) -> None:
        while (left := due - time.perf_counter()) > 0:
            time.sleep(left)


def go_first() -> None:
    """Asks the system to run this thread as soon as it wakes; not every user may ask.

    Without it a picture that is painted on all cores makes a tick in a thousand late.
    """
    with suppress(AttributeError, OSError):
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))
