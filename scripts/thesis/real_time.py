"""Section 4.7: real time measured while painting, while starting up, and while the stick moves."""

from collections.abc import Sequence
from math import isnan, nan
from pathlib import Path

import numpy as np

from kitemj.errors import NoGraphics
from kitemj.flight.live import TICK
from kitemj.tables import Cell, Table
from thesis.machine import machine
from thesis.real_time_figures import lateness_figure
from thesis.real_time_flights import (
    FLY_INTERVAL,
    MISSED_ALLOWED,
    SIZE,
    SWING,
    Run,
    measure_all,
    measure_without_pictures,
)
from thesis.section import Answer, Drawing, NamedTable, Section, Verdict

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


def section(scratch: Path) -> Section:
    """Flights in real time; where there is no OpenGL, those without a picture."""
    answers: Sequence[Answer] = ANSWERS
    try:
        renderer, runs = _renderer(), measure_all(SECONDS)
    except NoGraphics as error:
        renderer, runs = f"nothing: {error}", measure_without_pictures(SECONDS)
        reason = "nothing can be painted on this machine"
        answers = [
            Answer(a.item, Verdict.NOT_APPLICABLE, reason) if a.item in NEED_PICTURE else a
            for a in ANSWERS
        ]
    groups = {group: [run for run in runs if run.case.group == group] for group in _CAPTIONS}
    drawings = [
        Drawing(f"real_time_{group}", f"{_CAPTIONS[group]} {_CURVES}", lateness_figure(own))
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
            NamedTable("real_time_runs", _run_table(runs)),
            NamedTable("real_time_lateness", _lateness_table(runs), show=False),
        ],
    )


def _renderer() -> str:
    """What draws."""
    from kitemj.scene.gl import open_graphics

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
        f"{_besides([run.other_load for run in runs])} That is in these numbers, and another run "
        f"gives others.",
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
        f"Say that real time is kept where no time is lost and at most {MISSED_ALLOWED:.0%} of the "
        f"ticks are missed. It was kept in {sum(run.kept for run in runs)} of {len(runs)} flights. "
        f"Kept here, not in the thesis: {', '.join(won) or 'none'}. Kept in the thesis, not here: "
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
                run.other_load,
            )
        )
    return Table(f"flights of {SECONDS:g} s in real time", columns, rows)


def _lateness_table(runs: list[Run]) -> Table:
    """A row for each tick, a column for each flight."""
    names = [run.case.name.replace(" ", "_") + "_ms" for run in runs]
    late = np.column_stack([1e3 * run.late for run in runs])
    rows: list[tuple[Cell, ...]] = [(k * TICK, *row) for k, row in enumerate(late.tolist())]
    return Table("how late each tick was done", ("due_s", *names), rows)


_CAPTIONS = {
    "display": "How often a picture is painted.",
    "start": "The first picture opened in flight, and before it.",
    "input": f"How often the stick goes from one side to the other, ±{SWING:g} rad, with "
    f"{1 / FLY_INTERVAL:.0f} pictures a second.",
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
