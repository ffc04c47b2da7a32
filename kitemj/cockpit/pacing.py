"""A live flight kept in step with the wall clock, in a thread of its own."""

import gc
import sys
import threading
import time
from dataclasses import dataclass

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


class Pacer(threading.Thread):
    """Flies ticks as they come due; `command` is written to it, `moment` read from it.

    Both are replaced whole, so neither side waits for the other. `error` holds what ended
    the flight, if anything did; `recorder` is told of every tick.
    """

    def __init__(self, flight: LiveFlight, recorder: Recorder | None = None) -> None:
        super().__init__(name="physics", daemon=True)
        self.flight, self.recorder = flight, recorder
        self.command = Command()
        self.times = Timekeeping()
        self.error: Exception | None = None
        self.moment: Moment = flight.restart()
        self._record(self.command, self.moment, 0.0)
        self._stopping = threading.Event()
        self._restarting = threading.Event()

    def run(self) -> None:
        """Ticks until `stop`; the interpreter hands over at once when a tick is due."""
        sys.setswitchinterval(TICK / 20)
        gc.freeze()  # what is there already is not searched for garbage: 50 to 150 ms at a time
        origin, k = time.perf_counter(), 0
        while not self._stopping.is_set():
            due = origin + k * TICK
            self._wait(due)
            try:
                if self._restarting.is_set():
                    self._restarting.clear()
                    self._record(Command(), self.flight.restart(), 0.0)
                command = self.command
                self.moment = self.flight.tick(command)
            except Exception as error:  # shown by whoever flies; a thread's own end is silent
                self.error = error
                return
            k += 1
            lag = self._note(time.perf_counter() - due, self.moment)
            self._record(command, self.moment, lag)
            if lag > MAX_LAG:
                origin += lag
                self.times.lost += lag

    def stop(self) -> None:
        """Ends the flight after the tick that is under way."""
        self._stopping.set()
        self.join()
        gc.unfreeze()

    def restart(self) -> None:
        """The flight begins anew with the next tick."""
        self._restarting.set()

    def _record(self, command: Command, moment: Moment, lateness: float) -> None:
        if self.recorder:
            flight = self.flight
            control = flight.segment.control
            self.recorder.add(Tick(flight.ticks, control, command, moment, lateness))

    @staticmethod
    def _wait(due: float) -> None:
        while (left := due - time.perf_counter()) > 0:
            time.sleep(left)

    def _note(self, lateness: float, moment: Moment) -> float:
        times = self.times
        times.ticks += 1
        times.lateness = lateness
        times.worst = max(times.worst, lateness)
        times.missed += lateness > TICK
        times.largest_gap = max(times.largest_gap, moment.gap or 0.0)
        return lateness
