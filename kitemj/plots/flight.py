"""One flight as columns, wherever it came from: what figures are drawn of and tables made of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.flight.guided_table import guided_columns
from kitemj.flight.limits import RECORDED, Departure, Ending, Numbers, departure_in, touches_ground
from kitemj.flight.motion_table import COLUMNS
from kitemj.flight.pilot_settings import Guided
from kitemj.flight.simulate import Simulation
from kitemj.physics.checked import unknown_key
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import rig_of
from kitemj.plots.figures import FIGURES
from kitemj.recording.file import Recording
from kitemj.recording.table import Columns, limit_numbers, motion_columns, motion_row
from kitemj.tables import Cell, Table, Tabled, unit_of_column

if TYPE_CHECKING:
    import pyarrow as pa
    from matplotlib.figure import Figure

Array = NDArray[np.float64]


@dataclass(frozen=True, repr=False, eq=False)
class Flight(Tabled):
    """Columns of shape (rows,), named and in units as in a recording; `t_s` rises.

    `name` is what titles call the flight. Not all columns of a recording must be there.
    `model`, `motions` (one a row) and `ending` are those of a flight that was simulated just
    now, else "", empty and None; `guided`: what an autopilot told at each of them, if one flew;
    `notes` are sentences on what is to be known of it.
    """

    name: str
    parameters: Parameters
    columns: Columns
    notes: tuple[str, ...] = ()
    model: str = ""
    motions: Sequence[Motion] = ()
    ending: Ending | None = None
    guided: Sequence[Guided | None] = ()

    def __getitem__(self, name: str) -> NDArray[Any]:
        """The column called `name`; InputError, with the names there are, for another."""
        if name not in self.columns:
            raise unknown_key(name, list(self.columns), "", self.name)
        return self.columns[name]

    def __len__(self) -> int:
        """Number of rows."""
        return len(self.t)

    def table(self) -> pa.Table:
        """All columns; the metadata of each field tell its `unit`."""
        import pyarrow as pa

        arrays = {name: pa.array(column) for name, column in self.columns.items()}
        fields = [
            pa.field(name, array.type, metadata={"unit": unit_of_column(name)})
            for name, array in arrays.items()
        ]
        return pa.table(list(arrays.values()), schema=pa.schema(fields, {"name": self.name}))

    def plot(self, what: str = "state") -> Figure:
        """The figure called `what`, one of `FIGURES`; InputError where its columns lack."""
        return FIGURES[what](self)

    def tables(self) -> list[Table]:
        """How long it lasted, how it ended, where it left its limits."""
        t = self.t
        rows: list[tuple[Cell, ...]] = [
            ("time", f"{t[0]:g} s to {t[-1]:g} s, {len(t)} rows"),
            ("limits of validity", f"left at {self.departure}" if self.departure else "kept"),
        ]
        if self.ending:
            rows.append(("ending", self.ending.value))
        return [Table(self.name, ("", ""), [*rows, *(("note", note) for note in self.notes)])]

    __repr__ = Tabled.in_short

    def _repr_html_(self) -> str:
        try:
            return super()._repr_html_() + (self.plot("window")._repr_html_() or "")
        except InputError:  # a table without a position or attitude
            return super()._repr_html_()

    @property
    def t(self) -> Array:
        """The times [s], shape (rows,); InputError where there are none."""
        return self.column("t_s", "every figure")

    def column(self, name: str, purpose: str) -> Array:
        """The column called `name`; InputError where it lacks (and what has it), or holds gaps."""
        if name not in self.columns:
            kinds = "the tables of simulations and recordings have it"
            if name not in COLUMNS:
                kinds = "a recording, its exported table and a scenario have it"
            raise InputError(f"{self.name} lacks the column {name}, needed for {purpose}; {kinds}")
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
    def _limited(self) -> list[str]:
        """Columns that the limits of validity are about."""
        lines = rig_of(self.parameters).lines
        return ["alpha_deg", "beta_deg", *(f"tension_{name}_N" for name in lines)]

    @property
    def numbers(self) -> Numbers:
        """What limits are about; InputError where a column lacks."""
        checked = {name: self.column(name, "the limits") for name in self._limited}
        return limit_numbers({**self.columns, **checked})

    @property
    def any_beyond(self) -> NDArray[np.bool_]:
        """Which rows are beyond any limit, shape (rows,); none where columns lack to tell."""
        if not set(self._limited) <= set(self.columns):
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
    names = motion_columns(rig_of(parameters))
    numbers = np.array([motion_row(motion) for motion in motions]).reshape(-1, len(names))
    columns: dict[str, NDArray[Any]] = dict(zip(names, numbers.T.copy(), strict=True))
    columns["ground"] = np.array([touches_ground(parameters, motion) for motion in motions])
    return Flight(name, parameters, columns)


def flight_of_simulation(simulation: Simulation) -> Flight:
    """A scenario that was simulated."""
    if not simulation.motions:
        raise InputError(f"{simulation.scenario.source} could not be flown: {simulation.note}")
    name = f"{simulation.scenario.source}, {simulation.model}"
    flight = flight_of_motions(name, simulation.scenario.parameters, simulation.motions)
    notes = (simulation.note,) if simulation.note else ()
    told = simulation.model, simulation.motions, simulation.ending
    columns = dict(flight.columns)
    if simulation.guided:
        columns |= guided_columns(simulation.guided)
    return Flight(name, flight.parameters, columns, notes, *told, guided=simulation.guided)


def flight_of_recording(recording: Recording, episode: int = 0) -> Flight:
    """Flight `episode` (from 0) of a recording, from its start even where it went back in time."""
    rows, count = recording.way_to(recording.episodes[episode]), len(recording.episodes)
    columns = {name: column[rows] for name, column in recording.columns.items()}
    number = f", flight {episode + 1} of {count}" if count > 1 else ""
    name = f"{recording.path.name}, {recording.header.model}{number}"
    return Flight(name, recording.parameters, columns)
