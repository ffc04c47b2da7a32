"""A live flight kept in step with the wall clock, in a thread of its own."""

import gc
import os
import sys
import threading
import time
from contextlib import suppress
from dataclasses import dataclass

from kitemj.cockpit.history import History
from kitemj.flight.live import TICK, Command, LiveFlight, Moment
from kitemj.recording.recorder import Recorder
from kitemj.recording.table import Tick

MAX_LAG = 0.25
"""s; further behind than this the flight does not race after the clock: time is let go."""


@dataclass
class Timekeeping:
    """How well real time was kept.

    Tick k is to be done within `TICK` of the moment at which it is due; `missed` counts
    those that were not. `lateness` and `worst` [s]: from due to done. `lost` [s]: wall time
    that was let go (a machine asleep), not flown.
    """

    ticks: int = 0
    missed: int = 0
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
        self.largest_gap = max(self.largest_gap, gap)


class Pacer(threading.Thread):
    """Flies ticks as they come due; `command` is written to it, `moment` read from it.

    Both are replaced whole, so neither side waits for the other. `rate` is simulated over
    wall time: 1 is real time, 0 a pause; it may be changed at any moment. `error` holds what
    ended the flight, if anything did; `history` and `recorder` are told of every tick.
    """

    def __init__(
        self, flight: LiveFlight, history: History, recorder: Recorder | None = None
    ) -> None:
        super().__init__(name="physics", daemon=True)
        self.flight, self.history, self.recorder = flight, history, recorder
        self.command, self.rate = Command(), 1.0
        self.times = Timekeeping()
        self.error: Exception | None = None
        self.moment: Moment = flight.restart()
        self._tell(self.command, 0.0)
        self._stopping = threading.Event()
        self._restarting = threading.Event()
        self._stepping = threading.Event()

    def run(self) -> None:
        """Ticks until `stop`; the interpreter hands over at once when a tick is due."""
        _go_first()
        sys.setswitchinterval(TICK / 20)
        gc.disable()  # a search for cycles holds the interpreter for 50 ms; there are hardly any
        try:
            while not self._stopping.is_set():
                if self.rate > 0:
                    self._keep_pace(self.rate)
                elif self._stepping.wait(TICK):
                    self._stepping.clear()
                    self._tick(time.perf_counter())
        except Exception as error:  # shown by whoever flies; a thread's own end is silent
            self.error = error

    def _keep_pace(self, rate: float) -> None:
        """Ticks by the clock for as long as the rate stays."""
        origin, k = time.perf_counter(), 0
        while self.rate == rate and not self._stopping.is_set():
            due = origin + k * TICK / rate
            self._wait(due)
            lateness = self._tick(due)
            self.times.note(lateness, TICK / rate, self.moment.gap or 0.0)
            k += 1
            if lateness > MAX_LAG:
                origin += lateness
                self.times.lost += lateness

    def _tick(self, due: float) -> float:
        """One tick; how much later than `due` [s] it was done."""
        if self._restarting.is_set():
            self._restarting.clear()
            self.moment = self.flight.restart()
            self._tell(Command(), 0.0)
        command = self.command
        self.moment = self.flight.tick(command)
        lateness = time.perf_counter() - due
        self._tell(command, lateness)
        return lateness

    def stop(self) -> None:
        """Ends the flight after the tick that is under way."""
        self._stopping.set()
        self.join()
        gc.enable()

    def restart(self) -> None:
        """The flight begins anew with the next tick."""
        self._restarting.set()

    def step(self) -> None:
        """One tick, while paused."""
        self._stepping.set()

    def _tell(self, command: Command, lateness: float) -> None:
        flight, moment = self.flight, self.moment
        self.history.add(time.perf_counter(), moment.motion, lateness)
        if self.recorder:
            control = flight.segment.control
            self.recorder.add(Tick(flight.ticks, control, command, moment, lateness))

    @staticmethod
    def _wait(due: float) -> None:
        while (left := due - time.perf_counter()) > 0:
            time.sleep(left)


def _go_first() -> None:
    """Asks the system to run this thread as soon as it wakes; not every user may ask.

    Without it a picture that is painted on all cores makes a tick in a thousand late.
    """
    with suppress(AttributeError, OSError):
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))
