"""Sections 4.3 and 4.4: a flight steered in real time, compared with replays of its input."""

from collections.abc import Mapping
from math import nan
from pathlib import Path

import numpy as np

from kitemj.recording.file import Recording
from kitemj.tables import Cell, Table
from thesis.section import Answer, Drawing, NamedTable, Section, Verdict
from thesis.verification_figures import control_figure, state_figure
from thesis.verification_flights import (
    ANGLES,
    POSITION,
    Array,
    ReplayedFlight,
    all_replays,
    distances,
    interpolation_errors,
    record_flight,
)

ANSWERS = (
    Answer(
        "Figure 23",
        Verdict.NOT_APPLICABLE,
        "a flow chart; the same is done by replay in kitemj/recording/replay.py, from the shell by "
        "kitemj replay FILE --model lagrange",
    ),
    Answer(
        "Figure 24",
        Verdict.REPRODUCED,
        "control and state of a flight and of its input flown again",
        "verification_state",
    ),
    Answer(
        "Figure 26",
        Verdict.NOT_APPLICABLE,
        "a Simulink block diagram with dimensional signals; kitemj has no others: all is in SI",
    ),
    Answer(
        "Figure 27",
        Verdict.REPRODUCED,
        "without the errors of interpolating: what is recorded of a tick is all of it",
        "verification_control",
    ),
    Answer(
        "Figure 28",
        Verdict.REPRODUCED,
        "in two more formulations; the differences are on an axis of their own, to be seen at all",
        "verification_state",
    ),
)

SECONDS = 15.0

TENSIONS = ("tension_plus_N", "tension_minus_N")


def section(scratch: Path) -> Section:
    """A flight in real time, flown again."""
    recording = record_flight(scratch / "interactive.arrows", SECONDS)
    replays, errors = all_replays(recording), interpolation_errors(recording)
    drawings = [
        Drawing(
            "verification_control",
            "Above, δ that was flown in real time and δ of the flights from its recording, by "
            "equation (9) from where the attachments are. Below, how far these are from the "
            "real-time flight, and straight lines between saved values from what was steered.",
            control_figure(recording, replays, errors),
        ),
        Drawing(
            "verification_state",
            "Left, the state in real time and flown again from the recording; right, the "
            "differences, on a logarithmic axis. Where a curve is missing the difference is "
            "exactly zero.",
            state_figure(recording, replays),
        ),
    ]
    return Section(
        "The flight verified: its input flown again (sections 4.3 and 4.4)",
        ANSWERS,
        _THESIS,
        _here(recording, replays, errors),
        _WHY,
        drawings,
        [
            NamedTable("verification_differences", _difference_table(recording, replays)),
            NamedTable("verification_interpolation", _interpolation_table(errors)),
        ],
    )


def _here(
    recording: Recording, replays: list[ReplayedFlight], errors: Mapping[str, Array]
) -> list[str]:
    """What the flights show."""
    of = {a.name: a for a in replays}

    def gap(name: str) -> float:
        return float(np.nanmax(distances(recording, of[name], POSITION)))

    def state(name: str) -> float:
        return max(float(np.nanmax(distances(recording, of[name], (n,)))) for n in ANGLES)

    identical = of["mujoco, exact"].note
    return [
        f"A programme moved the stick for {recording.columns['t_s'][-1]:g} s in the loop that a "
        f"person flies in, ticks of {recording.header.tick * 1e3:g} ms by the wall clock, each of "
        f"them recorded ({len(recording)} rows). The stick was read by the time of the flight, so "
        f"that the same is flown each time.",
        f"Flown again from the file, the numbers of the model that flew it "
        f"({recording.header.model}) are {identical or 'not the same'}. Lagrange's equations stay "
        f"within {gap('lagrange, exact'):.2g} m and {state('lagrange, exact'):.2g} rad, those of "
        f"Newton and Euler within {gap('newton-euler, exact'):.2g} m and "
        f"{state('newton-euler, exact'):.2g} rad.",
        f"The thesis's way, straight lines between saved values and its solver, ends up "
        f"to {gap('ode45, interp1'):.2g} m and {state('ode45, interp1'):.2g} rad away. With the "
        f"solver made exact the straight lines alone give "
        f"{gap('ode45 tight, interp1'):.2g} m: between ticks they miss δ by up to "
        f"{errors['delta'].max():.2g} rad, δ̇ by {errors['delta_dot'].max():.2g} rad/s and δ̈ by "
        f"{errors['delta_ddot'].max():.2g} rad/s².",
    ]


def _difference_table(recording: Recording, replays: list[ReplayedFlight]) -> Table:
    """A row for each flight: the largest differences to the recording."""
    columns = ("flown_again_by", "position_m", *ANGLES, "alpha_deg", "beta_deg", *TENSIONS, "note")
    rows = list[tuple[Cell, ...]]()
    for a in replays:
        one = [POSITION, *((name,) for name in columns[2:-1])]
        rows.append((a.name, *(_largest(distances(recording, a, names)) for names in one), a.note))
    return Table("largest differences to the recorded flight", columns, rows)


def _largest(values: Array) -> float:
    return float(np.nanmax(values)) if np.isfinite(values).any() else nan


def _interpolation_table(errors: Mapping[str, Array]) -> Table:
    """A row for each signal."""
    units = {"delta": "rad", "delta_dot": "rad/s", "delta_ddot": "rad/s²"}
    rows: list[tuple[Cell, ...]] = [
        (name, unit, float(errors[name].max())) for name, unit in units.items()
    ]
    return Table("interp1 against what was flown", ("signal", "unit", "largest"), rows)


_THESIS = [
    "The input of a Simulink flight was saved and flown again in LAKSA's MATLAB code with ode45 "
    "(Figure 23). Its time steps are others, so δ and its derivatives were interpolated linearly "
    "(interp1).",
    "Plotted over one another, control and state agree (Figures 24, 27 and 28) up to small errors "
    "that the thesis puts down to the numerical method. It gives no size.",
]

_WHY = [
    "Here nothing is interpolated. A tick is flown with constant δ̈, so a row of the recording "
    "holds all of it, and the other models integrate the same parabolas. What is left between "
    "MuJoCo and the two formulations is rounding and the steps of 2 ms.",
    "δ̈ jumps where a tick begins. A straight line between saved values makes a ramp of the jump "
    "in the tick before, so that δ̈ acts half a tick too early and its integral is no longer the "
    "interpolated δ̇: for that long the kite gets the wrong rate.",
]
