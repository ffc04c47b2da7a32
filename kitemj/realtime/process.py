"""The flight in a process of its own: nothing that paints, waits or resizes can hold it up.

Two threads of one Python share one interpreter; while the painting one has it, and the system
has put that one aside, a tick cannot begin. Between processes only news and wishes pass.
"""

import queue
import time
from contextlib import suppress

from kitemj.drawing.history import History
from kitemj.errors import FlightError, InputError
from kitemj.flight.live import Command, TickResult
from kitemj.pilots.course import Course
from kitemj.pilots.crash import Touch
from kitemj.realtime.launch import Launched, launch
from kitemj.realtime.pacer import Timekeeping
from kitemj.realtime.worker import End, Ready, Setup, StartAt, Stop, TickNews

PATIENCE = 60.0
"""s; to load and, the first time after an installation, to compile."""


def with_lessons(setup: Setup, course: Course) -> Setup:
    """The same, with the course's own start as the second one, and begun there if it wants to."""
    return setup._replace(other_starts=course.starts, start_at=int(course.start is not None))


class FlightProcess:
    """To those who paint, what a `Pacer` is; started at once, so that it loads meanwhile.

    `update` brings its attributes up to date. Raises InputError and FlightError from there.
    """

    def __init__(self, setup: Setup, launched: Launched | None = None) -> None:
        """`launched`: the process to use, if one was launched before."""
        self.model, self.parameters = setup.model, setup.scenario.parameters
        self.history, self.times = History(self.parameters), Timekeeping()
        self.touch: Touch | None = None
        self.problem, self.memory = "", 0.0
        self.result: TickResult
        self._recording, self._ready, self._ended = "none", False, False
        self._rate, self._command, self._start_at = 1.0, Command(), setup.start_at
        self._heard: list[TickNews] = []
        self._t = 0.0  # s of flight that is known of
        self._process, self._link, self._told = launched or launch()
        self._tell(setup)

    def wait(self) -> None:
        """Until the flight stands at its start."""
        until = time.monotonic() + PATIENCE
        while not self._ready:
            self._hear(self._next(timeout=1.0))
            if time.monotonic() > until:
                raise FlightError(self.model, 0.0, f"it did not begin within {PATIENCE:g} s", [])

    def start(self) -> None:
        """Time begins."""
        self._tell("go")

    def update(self) -> list[TickNews]:
        """All ticks since the last call, the newest of which is now."""
        while (news := self._next()) is not None:
            self._hear(news)
        heard, self._heard = self._heard, []
        return heard

    @property
    def rate(self) -> float:
        """Simulated over wall time."""
        return self._rate

    @rate.setter
    def rate(self, rate: float) -> None:
        if rate != self._rate:
            self._rate = rate
            self._tell(rate)

    @property
    def start_at(self) -> int:
        """As `Pacer.start_at`."""
        return self._start_at

    @start_at.setter
    def start_at(self, start: int) -> None:
        if start != self._start_at:
            self._start_at = start
            self._tell(StartAt(start))

    @property
    def command(self) -> Command:
        """What was asked for last."""
        return self._command

    @command.setter
    def command(self, command: Command) -> None:
        if command != self._command:
            self._command = command
            self._tell(command)

    def ask(self, deed: str) -> None:
        """As `Pacer.ask`."""
        self._tell(deed)

    def stop(self, ending: str) -> str:
        """Ends the flight; returns what became of the recording."""
        self._tell(Stop(ending))
        until = time.monotonic() + PATIENCE
        with suppress(FlightError, InputError):  # the flight is over in any case
            while not self._ended and time.monotonic() < until:
                self._hear(self._next(timeout=0.1))
        self._process.join(1.0)
        self._link.close()
        return self._recording

    def _tell(self, wish: object) -> None:
        with suppress(OSError):  # it has ended; `update` says why
            self._link.send(wish)

    def _next(self, timeout: float = 0.0) -> TickNews | Ready | End | None:
        try:
            news: TickNews | Ready | End = self._told.get(timeout > 0, timeout)
        except queue.Empty:
            if self._ended or self._process.is_alive() or not self._told.empty():
                return None
            raise FlightError(
                self.model, self._t, "its process was ended from outside", []
            ) from None
        return news

    def _hear(self, news: TickNews | Ready | End | None) -> None:
        if isinstance(news, End):
            self._recording, self._ended = news.recording, True
            if news.bad_input:
                raise InputError(news.error)
            if news.error:
                raise FlightError(self.model, self._t, news.error, [])
        elif isinstance(news, Ready):
            self._ready, self.result = True, news.result
        elif news is not None:
            self._heard.append(news)
            self._t = news.result.motion.t
            self.result, self.times, self.touch = news.result, news.times, news.touch
            self.problem, self.memory = news.problem, news.memory
            self.history.add(news.done, news.result.motion, news.lateness)
