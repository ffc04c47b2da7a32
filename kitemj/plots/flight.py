"""One flight as columns, wherever it came from: what every figure is drawn of."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.flight.limits import RECORDED, Departure, Numbers, departure_in, touches_ground
from kitemj.flight.motion_table import COLUMNS
from kitemj.flight.simulate import Simulation
from kitemj.physics.parameters import Parameters
from kitemj.recording.file import Recording
from kitemj.recording.table import MOTION, Columns, limit_numbers, motion_row

Array = NDArray[np.float64]
AIR_AND_LINES = ("alpha_deg", "beta_deg", "tension_plus_N", "tension_minus_N")
"""What the limits of validity are about."""


class Flight(NamedTuple):
    """Columns of shape (rows,), named and in units as in a recording; `t_s` rises.

    `name` is what titles call the flight. Not all columns of a recording must be there.
    """

    name: str
    parameters: Parameters
    columns: Columns

    @property
    def t(self) -> Array:
        """The times [s], shape (rows,); InputError where there are none."""
        return self.column("t_s", "every figure")

    def column(self, name: str, purpose: str) -> Array:
        """The column called `name`; InputError where it lacks (and what has it), or holds gaps."""
        if name not in self.columns:
            raise InputError(
                f"{self.name} lacks the column {name}, needed for {purpose}; {_has(name)}"
            )
        column = self.columns[name]
        if column.dtype.kind not in "fiub":
            raise InputError(f"{self.name} holds text in the column {name}, where numbers must be")
        numbers = np.asarray(column, np.float64)
        if not np.isfinite(numbers).all():
            row = int(np.argmin(np.isfinite(numbers))) + 1
            raise InputError(f"{self.name} holds no number in the column {name}, row {row}")
        return numbers

    def matrix(self, names: Sequence[str], purpose: str) -> Array:
        """Several columns side by side, shape (rows, names)."""
        return np.column_stack([self.column(name, purpose) for name in names])

    @property
    def numbers(self) -> Numbers:
        """What limits are about; InputError where a column lacks."""
        return limit_numbers(
            {**self.columns, **{name: self.column(name, "the limits") for name in AIR_AND_LINES}}
        )

    @property
    def any_beyond(self) -> NDArray[np.bool_]:
        """Which rows are beyond any limit, shape (rows,); none where columns lack to tell."""
        if not set(AIR_AND_LINES) <= set(self.columns):
            return np.zeros(len(self.t), np.bool_)
        limits, now = self.parameters.limits, self.numbers
        return np.asarray(~np.logical_and.reduce([limit.kept(limits, now) for limit in RECORDED]))

    @property
    def departure(self) -> Departure | None:
        """The first departure; None: within all limits, or nothing is known of them."""
        if not self.any_beyond.any():
            return None
        return departure_in(self.parameters.limits, self.t.tolist(), self.numbers, RECORDED)

    @property
    def parts(self) -> tuple[slice, slice]:
        """Two slices: rows up to the first beyond a limit, and from that one on."""
        beyond = self.any_beyond
        first = int(np.argmax(beyond)) if beyond.any() else len(beyond)
        return slice(0, first + 1), slice(first, None)

    @property
    def down(self) -> int:
        """The row at which it touches the ground; the number of rows if it never does."""
        touches = np.flatnonzero(self.columns.get("ground", ()))
        return int(touches[0]) if len(touches) else len(self.t)


def flight_of_motions(name: str, parameters: Parameters, motions: Sequence[Motion]) -> Flight:
    """A flight given as motions of any model."""
    numbers = np.array([motion_row(motion) for motion in motions]).reshape(-1, len(MOTION))
    columns: dict[str, NDArray[Any]] = dict(zip(MOTION, numbers.T.copy(), strict=True))
    columns["ground"] = np.array([touches_ground(parameters, motion) for motion in motions])
    return Flight(name, parameters, columns)


def flight_of_simulation(simulation: Simulation) -> Flight:
    """A scenario that was simulated."""
    name = f"{simulation.scenario.source}, {simulation.model}"
    return flight_of_motions(name, simulation.scenario.parameters, simulation.motions)


def flight_of_recording(recording: Recording, episode: int = 0) -> Flight:
    """Flight `episode` (from 0) of a recording, from its start even where it went back in time."""
    rows, count = recording.way_to(recording.episodes[episode]), len(recording.episodes)
    columns = {name: column[rows] for name, column in recording.columns.items()}
    number = f", flight {episode + 1} of {count}" if count > 1 else ""
    name = f"{recording.path.name}, {recording.header.model}{number}"
    return Flight(name, recording.parameters, columns)


def _has(column: str) -> str:
    """The kinds of files that would have the column, as text."""
    if column in COLUMNS:
        return "the tables of simulations and recordings have it"
    return "a recording, its exported table and a scenario have it"
