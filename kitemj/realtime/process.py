"""The flight in a process of its own: nothing that paints, waits or resizes can hold it up.

Two threads of one Python share one interpreter; while the painting one has it, and the system
has put that one aside, a tick cannot begin. Between processes only news and wishes pass.
"""

import time
from contextlib import suppress

from kitemj.child import GRACE, Child
from kitemj.errors import FlightError, InputError
from kitemj.flight.live import Command, TickResult
from kitemj.flight.pilot_settings import Guided
from kitemj.pilots.crash import Touch
from kitemj.realtime.launch import launch
from kitemj.realtime.messages import (
    Begin,
    Deed,
    End,
    News,
    Offer,
    Ready,
    Stop,
    TickNews,
    Timekeeping,
    Wish,
)
from kitemj.recording.live import FlightSetup

PATIENCE = 300.0
"""s; to load and, the first time after an installation, to compile, on a slow machine too."""
DOUBT = 1.0
"""s of silence, twice the beat of a process that goes on: nothing is asked of it now."""
SILENCE = 5.0
"""s; after so much of it the process is given up."""


class FlightProcess:
    """The flight of `setup`; launched at once, so that it loads meanwhile.

    `update` brings `result`, `times`, `touch`, `problem`, `memory` and `guided` up to date (they
    are as in `TickNews`); `offers` is as in `Ready`; `command` is the last that was asked for,
    `started` whether time ever began, `record` where it is recorded, if it is, `recording` what
    became of that, and `cut` whether the disk did not take all of it. What is raised there is
    raised here: InputError, FlightError; and so is its silence.
    """

    def __init__(self, setup: FlightSetup, launched: Child | None = None) -> None:
        """`launched`: the process to use, if one was launched before."""
        self.model, self.parameters = setup.model, setup.scenario.parameters
        self.times = Timekeeping()
        self.touch: Touch | None = None
        self.problem, self.memory = "", 0.0
        self.guided: Guided | None = None
        self.offers: dict[str, Offer] = {}
        self.result: TickResult
        self.recording, self.cut, self.started = "none", False, False
        self._ready, self._ended = False, False
        self.command, self._asked = Command(), dict[type, Wish]()
        self._heard: list[TickNews] = []
        self._t = 0.0  # s of flight that is known of
        self._silent, self._listened = 0.0, time.monotonic()
        self.record = setup.record
        self._child = launched or launch()
        self._send(setup)

    def wait(self) -> None:
        """Until the flight stands at its start."""
        until = time.monotonic() + PATIENCE
        while not self._ready:
            self._hear(self._next(timeout=1.0))
            if time.monotonic() > until:
                raise FlightError(self.model, 0.0, f"it did not begin within {PATIENCE:g} s", [])

    def start(self) -> None:
        """Time begins."""
        self.started = True
        self.ask(Begin())

    def update(self) -> list[TickNews]:
        """All ticks since the last call, the newest of which is now."""
        now, silent = time.monotonic(), True
        while (news := self._next()) is not None:
            self._hear(news)
            silent = False
        # a program that was itself stopped for an hour has not waited for an hour
        self._silent = self._silent + min(now - self._listened, DOUBT) if silent else 0.0
        self._listened = now
        if self._silent > SILENCE:
            raise FlightError(self.model, self._t, "its process does not answer", [])
        heard, self._heard = self._heard, []
        return heard

    def ask(self, wish: Wish) -> None:
        """Has it done before the next tick; what holds already is not sent again."""
        if isinstance(wish, Command):
            self.command = wish
        if self._silent < DOUBT and (isinstance(wish, Deed) or wish != self._asked.get(type(wish))):
            self._asked[type(wish)] = wish
            self._send(wish)

    def stop(self, ending: str) -> str:
        """Ends the flight; returns what became of the recording."""
        self._child.wake()
        self._send(Stop(ending))
        until = time.monotonic() + 2 * GRACE  # longer than a recording waits for its disk
        with suppress(FlightError, InputError):  # the flight is over in any case
            while not self._ended and time.monotonic() < until:
                self._hear(self._next(timeout=0.1))
        if not self._ended:
            self._child.kill()
            self.recording = f"{self.record} breaks off" if self.record else "none"
        self._child.close()
        return self.recording

    def _send(self, wish: FlightSetup | Wish) -> None:
        with suppress(OSError):  # it has ended; `update` says why
            self._child.link.send(wish)

    def _next(self, timeout: float = 0.0) -> News | None:
        if self._ended:
            return None
        try:
            news: News | None = self._child.link.recv() if self._child.link.poll(timeout) else None
        except (EOFError, OSError):
            why = "its process was ended from outside"
            raise FlightError(self.model, self._t, why, []) from None
        return news

    def _hear(self, news: News | None) -> None:
        if isinstance(news, End):
            self.recording, self.cut, self._ended = news.recording, news.cut, True
            if news.bad_input:
                raise InputError(news.error)
            if news.error:
                raise FlightError(self.model, self._t, news.error, [])
        elif isinstance(news, Ready):
            self._ready, self.result, self.offers = True, news.result, news.offers
        elif isinstance(news, TickNews):
            self._heard.append(news)
            self._t = news.result.motion.t
            self.result, self.times, self.touch = news.result, news.times, news.touch
            self.problem, self.memory, self.guided = news.problem, news.memory, news.guided
