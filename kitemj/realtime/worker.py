"""What runs in the flight's own process, and the messages that pass to and fro."""

import signal
import time
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, NamedTuple

from kitemj.drawing.history import History
from kitemj.dynamics.motion import State
from kitemj.errors import InputError
from kitemj.flight.live import Command, LiveFlight, TickResult
from kitemj.flight.scenario import Scenario
from kitemj.pilots.crash import Touch
from kitemj.realtime.memory import peak_memory
from kitemj.realtime.pacer import Pacer, Timekeeping, go_first
from kitemj.recording.header import header_of
from kitemj.recording.recorder import Recorder
from kitemj.recording.resume import RecordedTick


class Setup(NamedTuple):
    """What the process is to fly; `record` names a new recording, None: there is none."""

    scenario: Scenario
    model: str
    reference: str
    step: float
    record: Path | None = None
    overwrite: bool = False
    past: tuple[RecordedTick, ...] = ()
    other_starts: tuple[State, ...] = ()
    start_at: int = 0

    def flight(self) -> LiveFlight:
        """A flight at its start."""
        return LiveFlight(self.scenario, self.model, self.reference, self.step, self.other_starts)


class TickNews(NamedTuple):
    """Of one tick: `begun` and `done` [s] on the clock that all processes share.

    `memory` [MB]: the most that the process has had so far.
    """

    begun: float
    done: float
    command: Command
    result: TickResult
    lateness: float
    times: Timekeeping
    touch: Touch | None
    problem: str
    memory: float


class Ready(NamedTuple):
    """The flight stands at its start."""

    result: TickResult


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
        news = TickNews(
            self._begun,
            time.perf_counter(),
            command,
            self.result,
            lateness,
            replace(self.times),
            self.touch,
            self.problem,
            peak_memory(),
        )
        self._told.put(news)


def fly(link: Connection, told: Any) -> None:
    """All that the process does, from the setup on, which comes through `link`."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the painter's, who stops us
    setup = _next_wish(link)
    if not isinstance(setup, Setup):
        return
    try:
        end = _flown(setup, link, told)
    except InputError as error:
        end = End("none", error.args[0], bad_input=True)
    except Exception as error:
        end = End("none", str(error))
    told.put(end)
    if _alone(link):
        told.cancel_join_thread()


def _flown(setup: Setup, link: Connection, told: Any) -> End:
    flight = setup.flight()
    flight.warm_up()
    go_first()  # and with it all threads that begin from here on
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


def _alone(link: Connection) -> bool:
    """Whether nobody is left to hear anything."""
    try:
        while link.poll():
            link.recv()
    except (EOFError, OSError):
        return True
    return False


def _next_wish(link: Connection) -> object:
    """Waits for it."""
    try:
        return link.recv()
    except (EOFError, OSError):  # whoever painted is gone
        return Stop("the program that showed it was ended")
