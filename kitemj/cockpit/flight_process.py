"""The flight in a process of its own: nothing that paints, waits or resizes can hold it up.

Two threads of one Python share one interpreter; while the painting one has it, and the system
has put that one aside, a tick cannot begin. Between processes only news and wishes pass.
"""

import os
import queue
import signal
import time
from contextlib import suppress
from dataclasses import replace
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, NamedTuple

from kitemj.cockpit.history import History
from kitemj.cockpit.pacing import Pacer, Timekeeping, go_first
from kitemj.dynamics.motion import State
from kitemj.errors import FlightError, InputError
from kitemj.flight.course import Course
from kitemj.flight.crash import Touch
from kitemj.flight.live import Command, LiveFlight, Moment
from kitemj.flight.scenario import Scenario
from kitemj.recording.going_on import Flown
from kitemj.recording.header import header_of
from kitemj.recording.recorder import Recorder

PATIENCE = 60.0
"""s; to load and, the first time after an installation, to compile."""


class Setup(NamedTuple):
    """What the process is to fly; `record` names a new recording, None: there is none."""

    scenario: Scenario
    model: str
    reference: str
    step: float
    record: Path | None = None
    overwrite: bool = False
    past: tuple[Flown, ...] = ()
    other_starts: tuple[State, ...] = ()
    start_at: int = 0

    def flight(self) -> LiveFlight:
        """A flight at its start."""
        return LiveFlight(self.scenario, self.model, self.reference, self.step, self.other_starts)


def with_lessons(setup: Setup, course: Course) -> Setup:
    """The same, with the course's own start as the second one, and begun there if it wants to."""
    return setup._replace(other_starts=course.starts, start_at=int(course.start is not None))


class News(NamedTuple):
    """Of one tick: `begun` and `done` [s] on the clock that all processes share."""

    begun: float
    done: float
    command: Command
    moment: Moment
    lateness: float
    times: Timekeeping
    touch: Touch | None
    problem: str


class Ready(NamedTuple):
    """The flight stands at its start."""

    moment: Moment


class End(NamedTuple):
    """The last news: what became of the recording; `error` is what ended the flight."""

    recording: str
    error: str = ""
    bad_input: bool = False


class StartAt(NamedTuple):
    """Where the next restart goes to."""

    start: int


class Stop(NamedTuple):
    """The last wish."""

    ending: str


class FlightProcess:
    """To those who paint, what a `Pacer` is; started at once, so that it loads meanwhile.

    `update` brings its attributes up to date. Raises InputError and FlightError from there.
    """

    def __init__(self, setup: Setup) -> None:
        context = get_context("spawn")
        self.model, self.parameters = setup.model, setup.scenario.parameters
        self.history, self.times = History(self.parameters), Timekeeping()
        self.touch: Touch | None = None
        self.problem, self._recording, self._ended = "", "none", False
        self._link, theirs = context.Pipe()
        self._told: Any = context.Queue()
        self._ready = False
        self.moment: Moment
        self._rate, self._command, self._start_at = 1.0, Command(), setup.start_at
        self._heard: list[News] = []
        self._t = 0.0  # s of flight that is known of
        self._process = context.Process(
            target=_fly, args=(setup, theirs, self._told), name="physics", daemon=True
        )
        self._process.start()
        theirs.close()

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

    def update(self) -> list[News]:
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

    def _next(self, timeout: float = 0.0) -> News | Ready | End | None:
        try:
            news: News | Ready | End = self._told.get(timeout > 0, timeout)
        except queue.Empty:
            if self._ended or self._process.is_alive() or not self._told.empty():
                return None
            raise FlightError(
                self.model, self._t, "its process was ended from outside", []
            ) from None
        return news

    def _hear(self, news: News | Ready | End | None) -> None:
        if isinstance(news, End):
            self._recording, self._ended = news.recording, True
            if news.bad_input:
                raise InputError(news.error)
            if news.error:
                raise FlightError(self.model, self._t, news.error, [])
        elif isinstance(news, Ready):
            self._ready, self.moment = True, news.moment
        elif news is not None:
            self._heard.append(news)
            self._t = news.moment.motion.t
            self.moment, self.times, self.touch = news.moment, news.times, news.touch
            self.problem = news.problem
            self.history.add(news.done, news.moment.motion, news.lateness)


class _Reporter(Pacer):
    """A pacer that takes its wishes from `link` and tells each tick."""

    def __init__(
        self,
        setup: Setup,
        flight: LiveFlight,
        recorder: Recorder | None,
        link: Connection,
        told: Any,
    ) -> None:
        self._link, self._told, self.ending, self._begun = link, told, "", 0.0
        history = History(flight.parameters)
        super().__init__(flight, history, recorder, setup.past, setup.start_at)

    def _wish(self) -> None:
        wish = _next_wish(self._link)
        if isinstance(wish, Stop):
            self.ending = wish.ending
            self._stopping.set()
        elif isinstance(wish, Command):
            self.command = wish
        elif isinstance(wish, StartAt):
            self.start_at = wish.start
        elif isinstance(wish, float):
            self.rate = wish
        else:
            self._deeds.append(str(wish))

    def _obey(self) -> None:
        while not self._stopping.is_set() and self._link.poll():
            self._wish()
        super()._obey()
        self._begun = time.perf_counter()

    def _tell(self, command: Command, lateness: float, resumed: int | None = None) -> None:
        super()._tell(command, lateness, resumed)
        done, times, problem = time.perf_counter(), replace(self.times), self.problem
        self._told.put(
            News(self._begun, done, command, self.moment, lateness, times, self.touch, problem)
        )


def _fly(setup: Setup, link: Connection, told: Any) -> None:
    """All of the process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the painter's, who stops us
    go_first()
    try:
        end = _flown(setup, link, told)
    except InputError as error:
        end = End("none", str(error), bad_input=True)
    except Exception as error:
        end = End("none", str(error))
    told.put(end)
    if os.getppid() == 1:  # nobody is left to hear it
        told.cancel_join_thread()


def _flown(setup: Setup, link: Connection, told: Any) -> End:
    flight = setup.flight()
    flight.warm_up()
    told.put(Ready(flight.restart(setup.start_at)))
    if isinstance(_next_wish(link), Stop):  # anything but time's beginning
        return End("none")
    recorder = None
    if setup.record:
        header = header_of(flight)
        recorder = Recorder(setup.record, header, flight.parameters, setup.overwrite)
    pacer = _Reporter(setup, flight, recorder, link, told)
    pacer.run()
    error = str(getattr(pacer.error, "reason", pacer.error) or "")
    return End(recorder.close(error or pacer.ending) if recorder else "none", error)


def _next_wish(link: Connection) -> object:
    """Waits for it."""
    try:
        return link.recv()
    except (EOFError, OSError):  # whoever painted is gone
        return Stop("the program that showed it was ended")
