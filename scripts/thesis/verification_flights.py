"""Section 4.3: a flight steered in real time, replays of its input, and the differences."""

from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.controls.programmed import ProgrammedStick, Row
from kitemj.dynamics.motion import Motion
from kitemj.flight.limits import GROUND
from kitemj.flight.live import TICK
from kitemj.flight.scenario import scenario_of
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Segment, control, ell_delta
from kitemj.realtime.messages import Stop, Wish
from kitemj.realtime.pacer import Pacer
from kitemj.recording.file import Recording, read_recording
from kitemj.recording.live import LiveFlight
from kitemj.recording.replay import replay
from kitemj.recording.table import ATTITUDE, MOTION, STEERING, Columns, motion_row
from thesis.ode45 import ATOL, RTOL, solve

MOVES = ((0.5, 1.0), (4.0, -1.0), (9.5, 0.3), (12.0, 0.0))
"""Time [s] and stick from then on."""

MODELS = ("mujoco", "lagrange", "newton-euler")
THESIS_STEP = 0.1
"""s; the longest step of the thesis's way, which does not tell its own."""

TIGHT = 1e-12
"""Relative and absolute tolerance that leave the interpolation as the only error."""

SAMPLES_PER_TICK = 10
"""Of a tick, in which the control is looked at."""

ANGLES = ("phi_rad", "gamma_rad", "eta_rad", "theta_rad")
POSITION = ("x_E_m", "y_E_m", "z_E_m")

Array = NDArray[np.float64]


class ReplayedFlight(NamedTuple):
    """The input flown once more: motions `every` so many ticks, by the columns of `MOTION`."""

    name: str
    every: int
    columns: Columns
    note: str = ""


def record_flight(path: Path, seconds: float) -> Recording:
    """A recording, at `path`, of the thesis kite steered by a programme in real time.

    The stick is read at every tick by the flight's own time, so that a late thread changes
    nothing in what is flown. Raises what ended the flight, if anything did.
    """
    scenario = scenario_of({"set": "thesis", "duration": seconds}, "the flight of section 4.3")
    stick = ProgrammedStick([Row(t, steer) for t, steer in MOVES], scenario.parameters)
    LiveFlight(scenario, reference="lagrange").warm_up()
    with LiveFlight(scenario, reference="lagrange", record=path) as flight:

        def wishes() -> Iterator[Wish]:
            departure = flight.result.departure
            landed = departure is not None and departure.limit is GROUND
            if landed or flight.ticks == round(seconds / TICK):
                yield Stop("as long as was asked")
            yield stick.command(flight.result.motion)

        flight.close(Pacer(flight, wishes, lambda news: None).run())
    return read_recording(path)


def segments_of(recording: Recording) -> list[Segment]:
    """What was flown in each tick; the recording must have one episode."""
    tick = recording.header.tick
    rows = np.column_stack([recording.columns[name] for name in STEERING])[1:]
    return [Segment(k * tick, Control(*row)) for k, row in enumerate(rows.tolist())]


class LinearInterpolation:
    """The thesis's way (MATLAB's interp1): straight lines between saved values, for each signal."""

    def __init__(self, segments: list[Segment], tick: float) -> None:
        last = control(segments[-1], len(segments) * tick)
        self._samples = np.array([*(s.control for s in segments), last])
        self._times = tick * np.arange(len(self._samples))

    def __call__(self, t: float) -> Control:
        """The control at time `t` [s]."""
        return Control(*(float(np.interp(t, self._times, signal)) for signal in self._samples.T))


def all_replays(recording: Recording) -> list[ReplayedFlight]:
    """Its input through each model, and through the thesis's solver in three ways."""
    found = []
    for model in MODELS:
        replayed = replay(recording, model)
        note = "the same to the last bit" if replayed.identical else replayed.note
        found.append(ReplayedFlight(f"{model}, exact", 1, replayed.columns, note))
    tick, segments = recording.header.tick, segments_of(recording)
    exact = [partial(control, segment) for segment in segments]
    straight = LinearInterpolation(segments, tick)
    every = round(THESIS_STEP / tick)
    parameters, start = recording.parameters, recording.header.states[0]
    for name, steering, n, rtol, atol in (
        ("ode45, exact", exact, 1, RTOL, ATOL),
        ("ode45 tight, interp1", [straight] * len(segments), 1, TIGHT, TIGHT),
        ("ode45, interp1", [straight] * (len(segments) // every), every, RTOL, ATOL),
    ):
        motions = solve(parameters, start, steering, n * tick, rtol, atol).motions
        found.append(ReplayedFlight(name, n, columns_of(motions)))
    return found


def columns_of(motions: list[Motion]) -> Columns:
    """By the columns of `MOTION`."""
    rows = np.array([motion_row(motion) for motion in motions]).T
    return dict(zip(MOTION, rows, strict=True))


def distances(recording: Recording, replayed: ReplayedFlight, names: tuple[str, ...]) -> Array:
    """Distance of the two in the columns `names`, (rows,)."""
    rows = slice(None, None, replayed.every)
    differences = [replayed.columns[n] - recording.columns[n][rows] for n in names]
    return np.asarray(np.sqrt(np.sum(np.square(differences), axis=0)))


def delta_series(parameters: Parameters, columns: Columns) -> Array:
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
    straight = LinearInterpolation(segments, tick)
    places = [
        (k, (k + (i + 0.5) / SAMPLES_PER_TICK) * tick)
        for k in range(len(segments))
        for i in range(SAMPLES_PER_TICK)
    ]
    exact = np.array([control(segments[k], t) for k, t in places])
    lines = np.array([straight(t) for _, t in places])
    errors = dict(zip(Control._fields, np.abs(lines - exact).T, strict=True))
    return {"t_s": np.array([t for _, t in places]), **errors}
