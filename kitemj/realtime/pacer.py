"""A live flight kept in step with the wall clock."""

import gc
import os
import sys
import time
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from math import nan

from kitemj.autopilot.autopilot import Autopilot
from kitemj.autopilot.drift_hold import DriftPilot
from kitemj.flight.live import TICK, Command
from kitemj.flight.pilot_settings import Guided
from kitemj.pilots.assist import Assist
from kitemj.pilots.crash import FirstTouch
from kitemj.realtime.memory import peak_memory
from kitemj.realtime.messages import (
    Assisted,
    Deed,
    Piloted,
    Rate,
    Stop,
    TickNews,
    Timekeeping,
    Wish,
)
from kitemj.realtime.rewind import Moment, RewindHistory
from kitemj.recording.live import LiveFlight, RecordedTick

MAX_LAG = 0.25
"""s; further behind than this the flight does not race after the clock: time is let go."""


class Pacer:
    """Flies ticks as they come due, and between them does what is wished for.

    A kite that met the ground stays as it met it until somebody goes back or begins again.
    """

    def __init__(
        self,
        flight: LiveFlight,
        wishes: Callable[[], Iterable[Wish]],
        tell: Callable[[TickNews], None],
        autopilots: Mapping[str, Autopilot | DriftPilot] | None = None,
    ) -> None:
        """`flight` at its start; `wishes` returns those since it was last asked, before each
        tick; `tell` is told of the start and of each tick; `autopilots` by what they fly."""
        self._flight, self._wishes, self._tell = flight, wishes, tell
        self._command, self._rate, self._start = Command(), 1.0, flight.episode.start
        self._assist, self._assisted = Assist(), False
        self._autopilots = autopilots or {}
        self._autopilot: Autopilot | DriftPilot | None = None
        self._times, self._rewind = Timekeeping(), RewindHistory()
        self._ground, self._begun = FirstTouch(flight.parameters), 0.0
        self._ending: str | None = None

    def run(self, past: Iterable[RecordedTick] = ()) -> str:
        """Ticks until somebody wishes it to stop; returns the ending that they say.

        `past`: ticks that are flown at once, before the first that is paced. Raises
        FlightError where the flight diverges.
        """
        self._see(Command())
        for tick in past:
            self._flight.hand = tick.hand
            self._flight.fly(tick.segment, tick.command)
            self._see(tick.command)
        while self._ending is None:
            if self._flying(self._rate):
                self._keep_pace(self._rate)
            else:
                time.sleep(TICK)
                self._obey()
        return self._ending

    def _flying(self, rate: float) -> bool:
        return self._rate == rate > 0 and not self._ground.touch and self._ending is None

    def _keep_pace(self, rate: float) -> None:
        """Ticks by the clock for as long as the rate stays."""
        origin, k = time.perf_counter(), 0
        while self._flying(rate):
            due = origin + k * TICK / rate
            while (left := due - time.perf_counter()) > 0:
                time.sleep(left)
            self._obey()
            if not self._flying(rate):
                break
            self._tick(due)
            late, gap = self._flight.lateness, self._flight.result.gap or 0.0
            lost = late if late > MAX_LAG else 0.0
            self._times = self._times.noted(late, TICK / rate, gap, lost)
            origin, k = origin + lost, k + 1
            self._see(self._command)

    def _tick(self, due: float) -> None:
        """A tick by the stick as it is now, what the assist makes of it, or the autopilot."""
        stick, hand, autopilot = self._command, nan, self._autopilot
        if autopilot:
            stick = autopilot.command(self._flight.result.motion)
        elif self._assisted:
            self._assist.hand = hand = stick.delta
            stick = self._assist.command(self._flight.result.motion)._replace(ell=stick.ell)
        self._flight.hand = hand
        self._flight.guided = self._told(autopilot.guided) if autopilot else None
        self._flight.tick(stick, due)

    def _obey(self) -> None:
        """Takes in what was wished for since."""
        for wish in self._wishes():
            if isinstance(wish, Command):
                self._command = wish
            elif isinstance(wish, Rate):
                self._rate = wish.rate
            elif isinstance(wish, Assisted):
                self._assisted = wish.on
            elif isinstance(wish, Piloted):
                self._autopilot = self._autopilots.get(wish.flown)
                self._begin_anew()
            elif isinstance(wish, Deed):
                self._do(wish)
            elif isinstance(wish, Stop):
                self._ending = wish.ending
                break
        self._begun = time.perf_counter()

    def _do(self, deed: Deed) -> None:
        if deed is Deed.RESTART:
            self._rewind.forget()
            self._flight.restart(self._start)
            self._ground = FirstTouch(self._flight.parameters)
            self._begin_anew()
            self._see(Command())
        elif deed is Deed.STEP and not self._rate and not self._ground.touch:
            self._tick(time.perf_counter())
            self._see(self._command)
        elif deed is Deed.REWIND:
            self._resume(self._rewind.back(self._flight))
        elif deed is Deed.SAVE:
            self._rewind.mark(self._flight, self._autopilot)
        elif deed is Deed.LOAD:
            self._resume(self._rewind.recall())

    def _resume(self, moment: Moment | None) -> None:
        """Back to `moment`; the autopilot that flew it goes on as it did, another begins anew."""
        if moment:
            knows = moment.knows if moment.autopilot is self._autopilot else None
            self._flight.resume(moment.flight, self._told(knows.guided) if knows else None)
            self._ground = FirstTouch(self._flight.parameters)
            if isinstance(self._autopilot, Autopilot) and knows:
                self._autopilot.resume(knows)
            else:
                self._begin_anew()
            self._report(Command())

    def _told(self, guided: Guided) -> Guided:
        """What is told of the present autopilot; only the scenario's flies again in a replay."""
        own = self._autopilot is self._autopilots.get("scenario")
        return guided if own else guided._replace(since=nan)

    def _begin_anew(self) -> None:
        """The autopilot begins with the motion as it is: what it remembers is of another."""
        if self._autopilot:
            self._autopilot.restart(self._flight.result.motion.t)

    def _see(self, command: Command) -> None:
        """What comes of a start or a tick."""
        self._rewind.see(self._flight, self._autopilot)
        self._report(command)

    def _report(self, command: Command) -> None:
        flight, touch = self._flight, self._ground.watch(self._flight.result.motion)
        now = command, flight.result, flight.lateness, self._times, touch, flight.problem
        news = TickNews(self._begun, time.perf_counter(), *now, peak_memory(), flight.guided)
        self._tell(news)


def go_first() -> None:
    """Asks the system to run this thread, and those it begins, as soon as they wake.

    Not every user may ask. Without it a picture that is painted on all cores makes a tick in a
    thousand late.
    """
    with suppress(AttributeError, OSError):
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))
    sys.setswitchinterval(TICK / 20)  # the interpreter hands over at once when a tick is due
    gc.disable()  # a search for cycles holds it for 50 ms; there are hardly any
