"""Section 4.7: the flights in real time: pictures at any rate, a cold start, a moving stick.

What is measured is the loop of `kitemj fly`, with another painter. Nothing that is imported
here paints: the first picture of the cold start is to be the first.
"""

from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from multiprocessing import get_context
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.flight.live import TICK
from kitemj.flight.scenario import Scenario, scenario_of
from thesis.observed_flight import (
    FrameTime,
    InstrumentedProcess,
    StickMover,
    flight_process,
    observe,
)
from thesis.processor_load import other_load, processor_time

if TYPE_CHECKING:
    from kitemj.drawing.picture import Picture

SIZE = (1280, 720)
FLY_INTERVAL = 1 / 30
"""s; between frames of `kitemj fly`."""

SWING = 0.15
"""rad; the thesis changes δ from this to its opposite."""

MISSED_ALLOWED = 0.01
"""Of the ticks may be missed, and no time lost, where real time is said to be kept."""


class Case(NamedTuple):
    """A flight: frames every `frames` [s] (0: as fast as possible; None: none), the stick to
    the other side every `moves` [s]; `thesis`: the figure, and whether it kept real time."""

    group: str
    name: str
    frames: float | None = None
    moves: float | None = None
    thesis: tuple[str, bool] | None = None
    cold: bool = False


CASES = (
    Case("display", "no picture"),
    Case("display", "a picture every 5 s", 5.0, thesis=("Figure 39", True)),
    Case("display", "a picture every 1 s", 1.0, thesis=("Figure 38", True)),
    Case("display", "a picture every 0.5 s", 0.5, thesis=("Figure 40", False)),
    Case("display", "30 pictures a second", FLY_INTERVAL),
    Case("display", "pictures as fast as possible", 0.0),
    Case("start", "cold start", FLY_INTERVAL, thesis=("Figure 41", False), cold=True),
    Case("start", "warm start", FLY_INTERVAL, thesis=("Figure 42", True)),
    Case("input", "stick moved every 5 s", FLY_INTERVAL, 5.0, ("Figure 44", True)),
    Case("input", "stick moved every 1 s", FLY_INTERVAL, 1.0, ("Figure 43", True)),
    Case("input", "stick moved every 0.4 s", FLY_INTERVAL, 0.4, ("Figure 46", True)),
    Case("input", "stick moved every 0.1 s", FLY_INTERVAL, 0.1, ("Figure 45", False)),
    Case("input", "stick moved every 10 ms", FLY_INTERVAL, 0.01),
    Case("input", "stick moved every 1 ms", FLY_INTERVAL, 0.001),
)


class Run(NamedTuple):
    """What was measured: `late` [s] of each tick, frames, moves of the stick, time lost [s].

    `other_load`: cores that other programs kept busy meanwhile.
    """

    case: Case
    late: NDArray[np.float64]
    frames: list[FrameTime]
    moves: int
    lost: float
    other_load: float

    @property
    def missed(self) -> NDArray[np.bool_]:
        """Ticks that were done later than a tick after they were due."""
        return self.late > TICK

    @property
    def kept(self) -> bool:
        """Whether real time was kept, as `MISSED_ALLOWED` has it."""
        return self.missed.mean() <= MISSED_ALLOWED and self.lost == 0.0

    @property
    def last_missed(self) -> float:
        """When [s] the last tick was missed; 0 if none was."""
        missed = np.flatnonzero(self.missed)
        return float(missed[-1] + 1) * TICK if len(missed) else 0.0

    def __str__(self) -> str:
        """One clause."""
        return (
            f"{self.case.name}: {self.missed.sum()} of {len(self.late)}, at worst "
            f"{1e3 * self.late.max():.1f} ms late"
        )


def make_scenario(seconds: float) -> Scenario:
    """The thesis kite, with room for its `SWING`, for so many `seconds` [s]."""
    tables = {"set": "thesis", "duration": seconds, "stick": {"delta": SWING}}
    return scenario_of(tables, "the flights of section 4.7")


def measure(
    case: Case,
    seconds: float,
    physics: InstrumentedProcess,
    open_picture: "Callable[[], Picture] | None",
) -> Run:
    """`case` flown for so many `seconds` [s] in real time; not painted without `open_picture`."""
    mover = StickMover(physics, case.moves) if case.moves else None
    before = processor_time()
    if open_picture and case.frames is not None:
        flight = observe(physics, round(seconds / TICK), open_picture, case.frames, mover=mover)
    else:
        flight = observe(physics, round(seconds / TICK), mover=mover)
    busy = other_load(before, processor_time())
    late = np.array([tick.lateness for tick in flight.ticks])
    return Run(case, late, flight.frames, mover.moves if mover else 0, flight.lost, busy)


def measure_cold(case: Case, seconds: float) -> Run:
    """In a process that has never painted: all that painting needs is loaded in flight."""
    scenario = make_scenario(seconds)
    with ExitStack() as stack, flight_process(scenario) as physics:
        return measure(case, seconds, physics, lambda: stack.enter_context(_picture(scenario)))


def _picture(scenario: Scenario) -> "Picture":
    from kitemj.drawing.picture import Picture

    return Picture(scenario.parameters, *SIZE)


def measure_all(seconds: float) -> list[Run]:
    """Every case; raises NoGraphics where nothing can be painted."""
    scenario = make_scenario(seconds)
    cold = {case.name: _alone(case, seconds) for case in CASES if case.cold}
    with _picture(scenario) as picture, flight_process(scenario) as physics:
        _warm_up(picture, physics)
        return [
            cold.get(case.name) or measure(case, seconds, physics, lambda: picture)
            for case in CASES
        ]


def _warm_up(picture: "Picture", physics: InstrumentedProcess) -> None:
    """The first frame, which takes longer than others, painted before it matters."""
    from kitemj.drawing.readings import Readings

    picture.paint(physics.result.motion, None, Readings())


def _alone(case: Case, seconds: float) -> Run:
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        return pool.submit(measure_cold, case, seconds).result()


def measure_without_pictures(seconds: float) -> list[Run]:
    """The cases that are left where nothing can be painted."""
    cases = [case for case in CASES if case.group == "input" or case.frames is None]
    with flight_process(make_scenario(seconds)) as physics:
        return [measure(case, seconds, physics, None) for case in cases]
