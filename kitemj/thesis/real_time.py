"""Section 4.7: what painting, its start and a restless stick do to real time, measured here.

What is measured is the loop of `kitemj fly`, with another painter. Nothing that is imported
here paints: the first picture of the cold start is to be the first.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from math import ceil, isnan, nan
from multiprocessing import get_context
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.cockpit.flight_process import FlightProcess
from kitemj.errors import NoGraphics
from kitemj.flight.live import TICK
from kitemj.flight.scenario import Scenario, scenario_of
from kitemj.tables import Cell, Table
from kitemj.thesis.machine import machine
from kitemj.thesis.other_work import others, work
from kitemj.thesis.panels import panels
from kitemj.thesis.section import Answer, Drawing, Named, Section, Verdict
from kitemj.thesis.watching import Hand, Painted, flying, watch

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from kitemj.cockpit.picture import Picture

_PAINTING = "another machine, and a flight in a process of its own, which waits for no picture"
_STICK = "another machine, and a stick that is read once a tick however often it moves"

ANSWERS = (
    Answer(
        "Figure 25",
        Verdict.DIFFERS,
        "missed ticks over time, of flights on the machine at hand",
        "real_time_display",
    ),
    Answer("Figure 38", Verdict.DIFFERS, _PAINTING, "real_time_display"),
    Answer("Figure 39", Verdict.DIFFERS, _PAINTING, "real_time_display"),
    Answer("Figure 40", Verdict.DIFFERS, _PAINTING, "real_time_display"),
    Answer("Figure 41", Verdict.DIFFERS, _PAINTING, "real_time_start"),
    Answer("Figure 42", Verdict.DIFFERS, _PAINTING, "real_time_start"),
    Answer("Figure 43", Verdict.DIFFERS, _STICK, "real_time_input"),
    Answer("Figure 44", Verdict.DIFFERS, _STICK, "real_time_input"),
    Answer("Figure 45", Verdict.DIFFERS, _STICK, "real_time_input"),
    Answer("Figure 46", Verdict.DIFFERS, _STICK, "real_time_input"),
)
NEED_PICTURE = {f"Figure {number}" for number in (38, 39, 40, 41, 42)}

SECONDS = 5.5
"""Of each flight: the rarest picture and the rarest move come every 5 s."""

SIZE = (1280, 720)
SMOOTH = 1 / 30
"""s; between frames of `kitemj fly`."""

SWING = 0.15
"""rad; the thesis changes δ from this to its opposite."""

KEPT = 0.01
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
    Case("display", "30 pictures a second", SMOOTH),
    Case("display", "pictures as fast as possible", 0.0),
    Case("start", "cold start", SMOOTH, thesis=("Figure 41", False), cold=True),
    Case("start", "warm start", SMOOTH, thesis=("Figure 42", True)),
    Case("input", "stick moved every 5 s", SMOOTH, 5.0, ("Figure 44", True)),
    Case("input", "stick moved every 1 s", SMOOTH, 1.0, ("Figure 43", True)),
    Case("input", "stick moved every 0.4 s", SMOOTH, 0.4, ("Figure 46", True)),
    Case("input", "stick moved every 0.1 s", SMOOTH, 0.1, ("Figure 45", False)),
    Case("input", "stick moved every 10 ms", SMOOTH, 0.01),
    Case("input", "stick moved every 1 ms", SMOOTH, 0.001),
)


class Run(NamedTuple):
    """What was measured: `late` [s] of each tick, frames, moves of the stick, time lost [s].

    `others`: cores that other programs kept busy meanwhile.
    """

    case: Case
    late: NDArray[np.float64]
    frames: list[Painted]
    moves: int
    lost: float
    others: float

    @property
    def missed(self) -> NDArray[np.bool_]:
        """Ticks that were done later than a tick after they were due."""
        return self.late > TICK

    @property
    def kept(self) -> bool:
        """Whether real time was kept, as `KEPT` has it."""
        return self.missed.mean() <= KEPT and self.lost == 0.0

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


def the_scenario() -> Scenario:
    """The thesis kite, with room for its `SWING`."""
    tables = {"set": "thesis", "duration": SECONDS, "stick": {"delta": SWING}}
    return scenario_of(tables, "the flights of section 4.7")


def flown(
    case: Case, seconds: float, physics: FlightProcess, opened: "Callable[[], Picture] | None"
) -> Run:
    """`case` for so many `seconds` [s] in real time; where nothing is `opened`, not painted."""
    hand = Hand(physics, case.moves) if case.moves else None
    before = work()
    if opened and case.frames is not None:
        seen = watch(physics, round(seconds / TICK), opened, case.frames, hand=hand)
    else:
        seen = watch(physics, round(seconds / TICK), hand=hand)
    busy = others(before, work())
    late = np.array([tick.lateness for tick in seen.ticks])
    return Run(case, late, seen.frames, hand.moves if hand else 0, seen.lost, busy)


def flown_cold(case: Case, seconds: float) -> Run:
    """In a process that has never painted: all that painting needs is loaded in flight."""
    scenario = the_scenario()
    with ExitStack() as stack, flying(scenario) as physics:
        return flown(case, seconds, physics, lambda: stack.enter_context(_picture(scenario)))


def _picture(scenario: Scenario) -> "Picture":
    from kitemj.cockpit.picture import Picture

    return Picture(scenario.parameters, *SIZE)


def all_flown(seconds: float) -> list[Run]:
    """Every case; raises NoGraphics where nothing can be painted."""
    scenario = the_scenario()
    cold = {case.name: _alone(case, seconds) for case in CASES if case.cold}
    with _picture(scenario) as picture, flying(scenario) as physics:
        _warm_up(picture, physics)
        return [
            cold.get(case.name) or flown(case, seconds, physics, lambda: picture) for case in CASES
        ]


def _warm_up(picture: "Picture", physics: FlightProcess) -> None:
    """The first frame, which takes longer than others, painted before it matters."""
    from kitemj.cockpit.picture import Readings

    picture.paint(physics.moment.motion, None, Readings())


def _alone(case: Case, seconds: float) -> Run:
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        return pool.submit(flown_cold, case, seconds).result()


def unpainted(seconds: float) -> list[Run]:
    """The cases that are left where nothing can be painted."""
    cases = [case for case in CASES if case.group == "input" or case.frames is None]
    with flying(the_scenario()) as physics:
        return [flown(case, seconds, physics, None) for case in cases]


def section(scratch: Path) -> Section:
    """Flights in real time; where there is no OpenGL, those without a picture."""
    answers: Sequence[Answer] = ANSWERS
    try:
        renderer, runs = _renderer(), all_flown(SECONDS)
    except NoGraphics as reason:
        renderer, runs = f"nothing: {reason}", unpainted(SECONDS)
        because = "nothing can be painted on this machine"
        answers = [
            Answer(a.item, Verdict.NOT_APPLICABLE, because) if a.item in NEED_PICTURE else a
            for a in ANSWERS
        ]
    groups = {group: [run for run in runs if run.case.group == group] for group in _CAPTIONS}
    drawings = [
        Drawing(f"real_time_{group}", f"{_CAPTIONS[group]} {_CURVES}", _figure(own))
        for group, own in groups.items()
        if own
    ]
    return Section(
        "Real time, and what each task does to it (section 4.7)",
        answers,
        _THESIS,
        _here(renderer, groups),
        _WHY,
        drawings,
        timed=[
            Named("real_time_runs", _run_table(runs)),
            Named("real_time_lateness", _lateness_table(runs), show=False),
        ],
    )


def _renderer() -> str:
    """What draws."""
    from kitemj.cockpit.gl import open_graphics

    graphics = open_graphics(16, 16)
    graphics.context.free()
    return graphics.renderer


def _here(renderer: str, groups: dict[str, list[Run]]) -> list[str]:
    """What was measured."""
    runs = [run for own in groups.values() for run in own]
    sentences = [
        f"Measured on {machine()}, frames of {SIZE[0]} x {SIZE[1]} drawn by {renderer}. Each "
        f"flight lasted {SECONDS:g} s; a tick of {TICK * 1e3:g} ms is missed when it is done more "
        f"than {TICK * 1e3:g} ms after it was due. (kitemj realtime measures more, for as long as "
        f"one likes.)",
        f"{_besides([run.others for run in runs])} That is in these numbers, and another run gives "
        f"others.",
    ]
    sentences += [
        f"Missed ticks, {_WORDS[group]}: {'; '.join(map(str, runs))}."
        for group, runs in groups.items()
        if runs
    ]
    for run in groups["start"]:
        when = f"{sum(run.frames[0]):.2f} s after the flight began" if run.frames else "never"
        last = f", the last one at {run.last_missed:.2f} s" if run.missed.any() else ""
        sentences.append(
            f"{run.case.name.capitalize()}: the first frame was there {when}; ticks missed: "
            f"{run.missed.sum()}{last}."
        )
    both = [(run, run.case.thesis) for run in runs if run.case.thesis]
    won = [run.case.name for run, (_, kept) in both if run.kept and not kept]
    lost = [run.case.name for run, (_, kept) in both if kept and not run.kept]
    return [
        *sentences,
        f"Say that real time is kept where no time is lost and at most {KEPT:.0%} of the ticks are "
        f"missed. It was kept in {sum(run.kept for run in runs)} of {len(runs)} flights. Kept "
        f"here, not in the thesis: {', '.join(won) or 'none'}. Kept in the thesis, not here: "
        f"{', '.join(lost) or 'none'}.",
    ]


def _besides(cores: list[float]) -> str:
    """What else the machine had to do."""
    if isnan(cores[0]):
        return "How busy other programs kept the machine is not known here."
    return (
        f"Other programs kept {min(cores):.2f} to {max(cores):.2f} cores busy meanwhile (the table "
        f"has it for each flight)."
    )


def _run_table(runs: list[Run]) -> Table:
    """A row for each flight."""
    columns = (
        "flight",
        "thesis",
        "kept_in_thesis",
        "kept_here",
        "ticks",
        "missed",
        "last_missed_s",
        "late_median_ms",
        "late_worst_ms",
        "lost_s",
        "frames",
        "frame_median_ms",
        "frame_worst_ms",
        "stick_moves",
        "others_cores",
    )
    rows = list[tuple[Cell, ...]]()
    for run in runs:
        figure, kept = run.case.thesis or ("", "")
        frames = [1e3 * frame.duration for frame in run.frames] or [nan]
        rows.append(
            (
                run.case.name,
                figure,
                kept if kept == "" else "yes" if kept else "no",
                "yes" if run.kept else "no",
                len(run.late),
                int(run.missed.sum()),
                run.last_missed,
                1e3 * float(np.median(run.late)),
                1e3 * float(run.late.max()),
                run.lost,
                len(run.frames),
                float(np.median(frames)),
                max(frames),
                run.moves,
                run.others,
            )
        )
    return Table(f"flights of {SECONDS:g} s in real time", columns, rows)


def _lateness_table(runs: list[Run]) -> Table:
    """A row for each tick, a column for each flight."""
    names = [run.case.name.replace(" ", "_") + "_ms" for run in runs]
    late = np.column_stack([1e3 * run.late for run in runs])
    rows: list[tuple[Cell, ...]] = [(k * TICK, *row) for k, row in enumerate(late.tolist())]
    return Table("how late each tick was done", ("due_s", *names), rows)


def _figure(runs: list[Run]) -> "Figure":
    """A panel for each flight."""
    columns = min(len(runs), 3)
    rows = ceil(len(runs) / columns)
    figure, axes = panels(
        rows, columns, (4.0 * columns + 0.5, 2.9 * rows), sharex=True, sharey=True
    )
    worst = max(10 * TICK, *(float(run.late.max()) for run in runs))
    most = max(4, *(int(run.missed.sum()) for run in runs))
    for ax, run in zip(axes.flat, runs, strict=False):
        _panel(ax, run)
        ax.set_ylim(1e-2, 2e3 * worst)
        count = ax.twinx()
        t = TICK * np.arange(len(run.late))
        count.step(t, np.cumsum(run.missed), where="post", color="tab:red", lw=1.4)
        count.set_ylim(-0.05 * most, 1.1 * most)
        count.tick_params(axis="y", colors="tab:red")
        count.set_ylabel("missed ticks", color="tab:red", fontsize=8)
    for ax in axes[-1]:
        ax.set_xlabel("time [s]")
    return figure


def _panel(ax: "Axes", run: Run) -> None:
    """How late ticks were; where frames are few, when they were begun."""
    case = run.case
    if case.frames is not None and case.frames > 10 * SMOOTH:
        for frame in run.frames:
            ax.axvline(frame.t, color="0.7", lw=3)
    t = TICK * np.arange(len(run.late))
    ax.semilogy(t, 1e3 * np.maximum(run.late, 1e-5), color="tab:blue", lw=0.7)
    ax.axhline(1e3 * TICK, color="0.3", ls="--", lw=0.9)
    figure = f" ({case.thesis[0]})" if case.thesis else ""
    ax.set_title(case.name + figure, fontsize=9)
    ax.set_ylabel("late [ms]", color="tab:blue", fontsize=8)


_CAPTIONS = {
    "display": "How often a picture is painted.",
    "start": "The first picture opened in flight, and before it.",
    "input": f"How often the stick goes from one side to the other, ±{SWING:g} rad, with "
    f"{1 / SMOOTH:.0f} pictures a second.",
}
_CURVES = (
    "Blue: how late each tick was done; above the dashed line it is missed. Red: missed ticks so "
    "far. Grey: a picture is begun, where there are few."
)
_WORDS = {
    "display": "by the rate of the display",
    "start": "by the start of the display",
    "input": "by how often the stick moves",
}

_THESIS = [
    "The measure of punctuality is Simulink's count of missed ticks: how far the simulation is "
    "behind; it returns to zero where lag was passing (Figure 25).",
    "Drawing is the dearest task: every picture cost a missed tick. With one every second or five "
    "seconds real time was kept, with one every half a second it was not (Figures 38-40). With "
    "figures that were opened at the start it took 10 s to reach real time, with figures opened "
    "before none (Figures 41 and 42).",
    "δ that changed between 0.15 and -0.15 every 5, 1 or 0.4 s did no harm; every 0.1 s, ticks "
    "were missed at every step (Figures 43-46).",
]

_WHY = [
    "In Simulink solving and drawing take turns. Here the flight has a process of its own, which, "
    "where the system lets it, runs first; it waits for no picture, and what holds it up is other "
    "work on all cores.",
    "A stick that moves adds nothing to the work of a tick, which reads it once and flies a fixed "
    "number of steps; the shaped motion of the lines is as smooth for a stick that is thrown from "
    "side to side. The thesis's solver controls its error and shortens its steps at every jump.",
    "A cold start loads libraries and opens OpenGL while the flight goes on. kitemj fly paints "
    "its first frame before the flight begins.",
]
