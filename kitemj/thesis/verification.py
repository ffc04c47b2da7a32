"""Sections 4.3 and 4.4: a flight steered in real time, and its input flown again."""

from collections.abc import Mapping
from functools import partial
from math import nan
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.cockpit.programmed import ProgrammedStick, Row
from kitemj.dynamics.motion import Motion
from kitemj.flight.live import TICK, LiveFlight
from kitemj.flight.scenario import scenario_of
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Segment, control, ell_delta
from kitemj.recording.file import Recording, read_recording
from kitemj.recording.header import header_of
from kitemj.recording.recorder import Recorder
from kitemj.recording.replay import flown_again
from kitemj.recording.table import ATTITUDE, MOTION, STEERING, Columns, motion_row
from kitemj.tables import Cell, Table
from kitemj.thesis.ode45 import ATOL, RTOL, solved
from kitemj.thesis.panels import panels
from kitemj.thesis.programmed_pacer import ProgrammedPacer
from kitemj.thesis.section import Answer, Drawing, Named, Section, Verdict

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

ANSWERS = (
    Answer(
        "Figure 23",
        Verdict.NOT_APPLICABLE,
        "a flow chart; the same is done by flown_again in recording/replay.py, from the shell by "
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
MOVES = ((0.5, 1.0), (4.0, -1.0), (9.5, 0.3), (12.0, 0.0))
"""Time [s] and stick from then on."""

REPLAYS = ("mujoco", "lagrange", "newton-euler")
THESIS_STEP = 0.1
"""s; the longest step of the thesis's way, which does not tell its own."""

TIGHT = 1e-12
"""Relative and absolute tolerance that leave the interpolation as the only error."""

PARTS = 10
"""Of a tick, in which the control is looked at."""

ROUNDING = 1e-17
"""rad; smaller differences of δ are not drawn."""

ANGLES = ("phi_rad", "gamma_rad", "eta_rad", "theta_rad")
POSITION = ("x_E_m", "y_E_m", "z_E_m")
TENSIONS = ("tension_plus_N", "tension_minus_N")
Array = NDArray[np.float64]


class Again(NamedTuple):
    """The input flown once more: motions `every` so many ticks, by the columns of `MOTION`."""

    name: str
    every: int
    columns: Columns
    note: str = ""


def recorded(path: Path, seconds: float) -> Recording:
    """A recording, at `path`, of the thesis kite steered by a programme in real time.

    Raises what ended the flight, if anything did.
    """
    scenario = scenario_of({"set": "thesis", "duration": seconds}, "the flight of section 4.3")
    flight = LiveFlight(scenario)
    flight.warm_up()
    recorder = Recorder(path, header_of(flight), flight.parameters)
    stick = ProgrammedStick([Row(t, steer) for t, steer in MOVES], flight.parameters)
    pacer = ProgrammedPacer(flight, round(seconds / TICK), stick, recorder)
    try:
        pacer.start()
        pacer.join()
    finally:
        pacer.stop("as long as was asked")
    pacer.update()
    return read_recording(path)


def segments_of(recording: Recording) -> list[Segment]:
    """What was flown in each tick; the recording must have one leg."""
    tick = recording.header.tick
    rows = np.column_stack([recording.columns[name] for name in STEERING])[1:]
    return [Segment(k * tick, Control(*row)) for k, row in enumerate(rows.tolist())]


class Interpolated:
    """The thesis's way (MATLAB's interp1): straight lines between saved values, for each signal."""

    def __init__(self, segments: list[Segment], tick: float) -> None:
        last = control(segments[-1], len(segments) * tick)
        self._samples = np.array([*(s.control for s in segments), last])
        self._times = tick * np.arange(len(self._samples))

    def __call__(self, t: float) -> Control:
        """The control at time `t` [s]."""
        return Control(*(float(np.interp(t, self._times, signal)) for signal in self._samples.T))


def all_again(recording: Recording) -> list[Again]:
    """Its input through each model, and through the thesis's solver in three ways."""
    found = []
    for model in REPLAYS:
        replay = flown_again(recording, model)
        note = "the same to the last bit" if replay.identical else replay.note
        found.append(Again(f"{model}, exact", 1, replay.columns, note))
    tick, segments = recording.header.tick, segments_of(recording)
    exact = [partial(control, segment) for segment in segments]
    straight = Interpolated(segments, tick)
    every = round(THESIS_STEP / tick)
    parameters, start = recording.parameters, recording.header.states[0]
    for name, steering, n, rtol, atol in (
        ("ode45, exact", exact, 1, RTOL, ATOL),
        ("ode45 tight, interp1", [straight] * len(segments), 1, TIGHT, TIGHT),
        ("ode45, interp1", [straight] * (len(segments) // every), every, RTOL, ATOL),
    ):
        motions = solved(parameters, start, steering, n * tick, rtol, atol).motions
        found.append(Again(name, n, columns_of(motions)))
    return found


def columns_of(motions: list[Motion]) -> Columns:
    """By the columns of `MOTION`."""
    rows = np.array([motion_row(motion) for motion in motions]).T
    return dict(zip(MOTION, rows, strict=True))


def apart(recording: Recording, again: Again, names: tuple[str, ...]) -> Array:
    """Distance of the two in the columns `names`, (rows,)."""
    rows = slice(None, None, again.every)
    differences = [again.columns[n] - recording.columns[n][rows] for n in names]
    return np.asarray(np.sqrt(np.sum(np.square(differences), axis=0)))


def deltas(parameters: Parameters, columns: Columns) -> Array:
    """δ [rad] by equation (9) of the thesis, from where the kite's attachments are, (rows,)."""
    kite = parameters.kite
    G = np.column_stack([columns[name] for name in POSITION])
    R_BE = np.column_stack([columns[name] for name in ATTITUDE]).reshape(-1, 3, 3)
    to_A = [np.array([kite.x_A, side * kite.y_A, kite.z_A]) for side in (1.0, -1.0)]
    lengths = [np.linalg.norm(G + np.einsum("nij,i->nj", R_BE, GA), axis=1) for GA in to_A]
    pairs = zip(*(length.tolist() for length in lengths), strict=True)
    return np.array([ell_delta(plus, minus, kite.y_A)[1] for plus, minus in pairs])


def interpolation_errors(recording: Recording) -> Mapping[str, Array]:
    """|interp1 - what was flown|, PARTS times a tick, for δ and its derivatives; with `t_s`."""
    tick, segments = recording.header.tick, segments_of(recording)
    straight = Interpolated(segments, tick)
    places = [
        (k, (k + (i + 0.5) / PARTS) * tick) for k in range(len(segments)) for i in range(PARTS)
    ]
    exact = np.array([control(segments[k], t) for k, t in places])
    lines = np.array([straight(t) for _, t in places])
    errors = dict(zip(Control._fields, np.abs(lines - exact).T, strict=True))
    return {"t_s": np.array([t for _, t in places]), **errors}


def section(scratch: Path) -> Section:
    """A flight in real time, flown again."""
    recording = recorded(scratch / "interactive.arrows", SECONDS)
    again, errors = all_again(recording), interpolation_errors(recording)
    drawings = [
        Drawing(
            "verification_control",
            "Above, δ that was flown in real time and δ of the flights from its recording, by "
            "equation (9) from where the attachments are. Below, how far these are from the "
            "real-time flight, and straight lines between saved values from what was steered.",
            _control_figure(recording, again, errors),
        ),
        Drawing(
            "verification_state",
            "Left, the state in real time and flown again from the recording; right, the "
            "differences, on a logarithmic axis. Where a curve is missing the difference is "
            "exactly zero.",
            _state_figure(recording, again),
        ),
    ]
    return Section(
        "The flight verified: its input flown again (sections 4.3 and 4.4)",
        ANSWERS,
        _THESIS,
        _here(recording, again, errors),
        _WHY,
        drawings,
        [
            Named("verification_differences", _difference_table(recording, again)),
            Named("verification_interpolation", _interpolation_table(errors)),
        ],
    )


def _here(recording: Recording, again: list[Again], errors: Mapping[str, Array]) -> list[str]:
    """What the flights show."""
    of = {a.name: a for a in again}

    def gap(name: str) -> float:
        return float(np.nanmax(apart(recording, of[name], POSITION)))

    def state(name: str) -> float:
        return max(float(np.nanmax(apart(recording, of[name], (n,)))) for n in ANGLES)

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


def _difference_table(recording: Recording, again: list[Again]) -> Table:
    """A row for each flight: the largest differences to the recording."""
    columns = ("flown_again_by", "position_m", *ANGLES, "alpha_deg", "beta_deg", *TENSIONS, "note")
    rows = list[tuple[Cell, ...]]()
    for a in again:
        one = [POSITION, *((name,) for name in columns[2:-1])]
        rows.append((a.name, *(_largest(apart(recording, a, names)) for names in one), a.note))
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


LOOKS = {
    "lagrange, exact": "C0",
    "newton-euler, exact": "C1",
    "ode45 tight, interp1": "C2",
    "ode45, interp1": "C3",
}
"""The flights that are drawn; MuJoCo's own would be an empty curve."""


def _control_figure(
    recording: Recording, again: list[Again], errors: Mapping[str, Array]
) -> "Figure":
    """δ, and the differences."""
    figure, axes = panels(2, 1, (8.5, 6.0), sharex=True)
    above, below = axes[:, 0]
    t, flown = recording.columns["t_s"], deltas(recording.parameters, recording.columns)
    above.plot(t, flown, color="0.6", lw=4, label="in real time")
    for a in again:
        if a.name in ("lagrange, exact", "newton-euler, exact"):
            own = deltas(recording.parameters, a.columns)
            style = {"color": LOOKS[a.name], "label": a.name}
            above.plot(t, own, "--" if a.name[0] == "l" else ":", lw=1.6, **style)
            _logarithmic(below, t, np.abs(own - flown), **style)
    _logarithmic(below, errors["t_s"], errors["delta"], color="C3", label="interp1")
    below.set_ylim(bottom=ROUNDING)
    above.set_ylabel(r"$\delta$ [rad]")
    below.set(xlabel="time [s]", ylabel=r"difference of $\delta$ [rad]")
    _finish(figure, above, below)
    return figure


def _state_figure(recording: Recording, again: list[Again]) -> "Figure":
    """φ, γ, η, θ, and the differences."""
    figure, axes = panels(len(ANGLES), 2, (10.5, 9.0), sharex=True)
    t = recording.columns["t_s"]
    for (left, right), name, symbol in zip(
        axes, ANGLES, (r"\varphi", r"\gamma", r"\eta", r"\theta"), strict=True
    ):
        left.plot(t, np.degrees(recording.columns[name]), color="0.6", lw=4, label="in real time")
        for a in again:
            if a.name in LOOKS:
                style = {"color": LOOKS[a.name], "label": a.name}
                own = t[:: a.every]
                left.plot(own, np.degrees(a.columns[name]), "--", lw=1.2, **style)
                _logarithmic(right, own, apart(recording, a, (name,)), **style)
        left.set_ylabel(f"${symbol}$ [deg]")
        right.set_ylabel(f"difference of ${symbol}$ [rad]")
    for ax in axes[-1]:
        ax.set_xlabel("time [s]")
    _finish(figure, *axes.flat)
    return figure


def _logarithmic(ax: "Axes", t: Array, values: Array, **style: str) -> None:
    """Zeros are left out: there is no place for them."""
    ax.semilogy(t, np.where(values > 0, values, np.nan), lw=1.0, **style)


def _finish(figure: "Figure", *axes: "Axes") -> None:
    for ax in axes:
        ax.grid(alpha=0.3)
    known = {
        label: handle
        for ax in axes
        for handle, label in zip(*ax.get_legend_handles_labels(), strict=True)
    }
    figure.legend(
        known.values(), known.keys(), loc="outside lower center", ncols=len(known), fontsize=9
    )


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
