"""A flight in real time with every tick kept, and frames painted at any rate.

The flight has its process, the painter this one. Nothing that is imported here paints, so that
the first picture of a process may be opened in flight.
"""

import time
from collections.abc import Callable
from contextlib import contextmanager
from threading import Event, Thread
from typing import TYPE_CHECKING, NamedTuple

from kitemj.drawing.history import History
from kitemj.dynamics.formulation import DEFAULT_STEP
from kitemj.flight.live import TICK, Command
from kitemj.flight.scenario import Scenario
from kitemj.realtime.messages import Deed, Rate, TickNews
from kitemj.realtime.process import FlightProcess
from kitemj.recording.live import FlightSetup

if TYPE_CHECKING:
    from collections.abc import Iterator

    from kitemj.controls.stick import Stick
    from kitemj.drawing.picture import Picture
    from kitemj.drawing.readings import Readings


class InstrumentedProcess(FlightProcess):
    """A flight of which `history` remembers what instruments show."""

    def __init__(self, setup: FlightSetup) -> None:
        super().__init__(setup)
        self.history = History(self.parameters)

    def update(self) -> list[TickNews]:
        """All ticks since the last call."""
        heard = super().update()
        for news in heard:
            self.history.add(news.done, news.result.motion, news.lateness)
        return heard


class FrameTime(NamedTuple):
    """A frame: begun at `t` [s] of the flight, painted in `duration` [s]."""

    t: float
    duration: float


class ObservedFlight(NamedTuple):
    """What each tick told, the frames, and the wall time [s] that was let go."""

    ticks: list[TickNews]
    frames: list[FrameTime]
    lost: float


class StickMover(Thread):
    """Throws the stick of `physics` from side to side every `interval` [s] of the clock."""

    def __init__(self, physics: InstrumentedProcess, interval: float) -> None:
        super().__init__(name="hand", daemon=True)
        self._physics, self._interval, self.moves = physics, interval, 0
        self._over = Event()

    def run(self) -> None:
        """Until `stop`."""
        begun, side = time.perf_counter(), 1.0
        while not self._over.is_set():
            self._physics.ask(Command(side))
            self.moves, side = self.moves + 1, -side
            due = begun + self.moves * self._interval
            self._over.wait(max(0.0, due - time.perf_counter()))

    def stop(self) -> None:
        """Lets go of the stick."""
        self._over.set()
        self.join()


@contextmanager
def flight_process(scenario: Scenario) -> "Iterator[InstrumentedProcess]":
    """A process that flies `scenario`, paused; it ends with the block."""
    physics = InstrumentedProcess(FlightSetup(scenario, "mujoco", "lagrange", DEFAULT_STEP))
    try:
        physics.wait()
        physics.start()
        physics.ask(Rate(0.0))
        yield physics
    finally:
        physics.stop("watched")


def observe(
    physics: InstrumentedProcess,
    ticks: int,
    open_picture: "Callable[[], Picture] | None" = None,
    interval: float = 0.0,
    stick: "Stick | None" = None,
    mover: StickMover | None = None,
) -> ObservedFlight:
    """Flies from the start on, until the ticks are over or the kite touches the ground.

    physics: the flight, paused
    ticks: how many
    open_picture: opens what paints, once the flight has begun; None: nothing is painted
    interval: s between frames, or as soon as that can be done
    stick: read before each frame; None: the stick rests
    mover: moves the stick by itself; None: nobody does
    """
    lost = physics.times.lost
    _restart(physics)
    if mover:
        mover.start()
    flown, frames, due = list[TickNews](), list[FrameTime](), 0.0
    picture: Picture | None = None
    try:
        while len(flown) < ticks and not physics.touch:
            flown += physics.update()
            if flown and open_picture and time.perf_counter() >= due:
                picture = picture or open_picture()
                painting = time.perf_counter()
                _paint(physics, picture, stick)
                done = time.perf_counter()
                frames.append(FrameTime(painting - flown[0].begun, done - painting))
                physics.history.add_frame(painting, done - painting)
                due = max(due + interval, done)
            else:
                time.sleep(TICK / 4)
    finally:
        if mover:
            mover.stop()
        physics.ask(Rate(0.0))
    return ObservedFlight(flown[:ticks], frames, physics.times.lost - lost)


def _restart(physics: InstrumentedProcess) -> None:
    """Returns when the flight stands at its start, and time runs."""
    time.sleep(5 * TICK)  # a pause that was asked for takes a tick to come
    physics.update()
    physics.ask(Command())
    physics.ask(Deed.RESTART)
    while not any(news.result.motion.t == 0.0 for news in physics.update()):
        time.sleep(TICK)
    physics.ask(Rate(1.0))


def _paint(physics: InstrumentedProcess, picture: "Picture", stick: "Stick | None") -> None:
    result = physics.result
    if stick:
        physics.ask(stick.command(result.motion))
    picture.paint(result.motion, result.reference, readings_of(physics))


def readings_of(physics: InstrumentedProcess) -> "Readings":
    """What the cockpit shows of the flight as it is now."""
    from kitemj.drawing.readings import Readings

    result, times = physics.result, physics.times
    return Readings(
        model=physics.model,
        gap=result.gap,
        delta_command=physics.command.delta * physics.parameters.stick.delta,
        missed_ticks=times.missed,
        lateness=times.lateness,
        stick="programme",
        traces=physics.history.traces(time.perf_counter()),
        touch=physics.touch,
    )
