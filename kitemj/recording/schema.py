"""The columns that a recording must hold, and what must be true of them: checked on reading."""

import json

import numpy as np
import pyarrow as pa

from kitemj.errors import InputError
from kitemj.flight.guided_table import NOBODY, NUMBERS, PHASE
from kitemj.flight.pilot_settings import PHASES, PilotSettings
from kitemj.physics.rig import Rig
from kitemj.physics.shaping import StickLaw
from kitemj.recording.header import Header, to_json
from kitemj.recording.pilot import pilot_json
from kitemj.recording.table import ATTITUDE, HAND, LIMITS, PLACE, REFERENCE, Columns, all_columns

HEADER_KEY = b"kitemj"
"""Under which the header stands in the schema's metadata, as JSON."""
PILOT_KEY, PHASES_KEY = b"kitemj pilot", b"pilot_phase"
"""Likewise, where an autopilot flew by a scenario: its settings; what its phases are called."""
SOMETIMES = (*REFERENCE, "gap_m", HAND, *NUMBERS)
"""Columns that are not a number where there is no reference, no assist, or no autopilot."""
LATER = (HAND, *NUMBERS, PHASE)
"""Columns that recordings of this format did not have at first: without them there was none."""
BEYOND = 1e9
"""In any unit; a flight that comes near has diverged long before."""
ROUNDING = 1e-6
"""Of t_s [s], and of the products of the axes in R_BE, which models keep to 1e-9 or better."""


def schema(header: Header, rig: Rig, pilot: PilotSettings | None = None) -> pa.Schema:
    """The columns and, in the metadata, the header and the autopilot's settings as JSON."""
    about = {HEADER_KEY: to_json(header)}
    if pilot:
        about |= {PILOT_KEY: pilot_json(pilot), PHASES_KEY: json.dumps(PHASES).encode()}
    return pa.schema(_kinds(rig).items(), about)


def _kinds(rig: Rig) -> dict[str, pa.DataType]:
    kinds = dict.fromkeys((*PLACE, PHASE), pa.int32()) | dict.fromkeys(LIMITS, pa.bool_())
    return {name: kinds.get(name, pa.float64()) for name in all_columns(rig)}


def checked_columns(table: pa.Table, header: Header, rig: Rig, source: str) -> Columns:
    """Each column, shape (rows,); InputError, which names `source`, where no flight is in them."""
    columns = {}
    for name, kind in _kinds(rig).items():
        found = [field for field in table.schema if field.name == name]
        if not found and name in LATER:
            nobody = np.full(len(table), NOBODY, np.int32)
            columns[name] = nobody if name == PHASE else np.full(len(table), np.nan)
            continue
        if not found:
            raise InputError(f"{source} lacks the column {name}: another version wrote it")
        if len(found) > 1:
            raise InputError(f"{source} is damaged: it has two columns {name}")
        if found[0].type != kind:
            raise InputError(
                f"{source} is damaged: its column {name} holds {found[0].type}, where {kind} "
                f"must be"
            )
        column = table[name]
        numbers = column.to_numpy()
        wrong = column.is_null().to_numpy()
        if kind == pa.float64() and not column.null_count:
            wrong = ~(np.abs(numbers) < BEYOND)
            wrong &= ~np.isnan(numbers) | (name not in SOMETIMES)
        if wrong.any():
            raise InputError(
                f"{source} is damaged: {name} in row {_first(wrong)} is no number that a flight has"
            )
        columns[name] = numbers
    _check_places(columns, header, source)
    _check_motions(columns, header, source)
    return columns


def _check_places(columns: Columns, header: Header, source: str) -> None:
    """Raises InputError where a row does not follow the one before, or an episode another."""
    leg, tick, parent, start = (columns[name] for name in PLACE)
    begins = np.append(True, np.diff(leg) != 0)
    follows = np.append(False, np.diff(tick) == 1)
    wrong = (leg != np.cumsum(begins) - 1) | ~(begins | follows) | (tick < 0)
    if wrong.any():
        row = _first(wrong)
        raise InputError(
            f"{source} is damaged: row {row}, leg {leg[row - 1]}, tick {tick[row - 1]}, does not "
            f"follow the row before"
        )
    wrong = (start < 0) | (start >= len(header.starts))
    if wrong.any():
        row = _first(wrong)
        raise InputError(
            f"{source} is damaged: row {row} has start {start[row - 1]}, the header has starts "
            f"0 to {len(header.starts) - 1}"
        )
    first = np.flatnonzero(begins)
    last = np.append(first[1:], len(leg)) - 1
    for number, row in enumerate(first.tolist()):
        if tick[row] == 0:
            continue
        before = int(parent[row])
        if not 0 <= before < number:
            raise InputError(
                f"{source} is damaged: its flight {number + 1} goes on from flight "
                f"{before + 1}, which must be an earlier one"
            )
        if not tick[first[before]] <= tick[row] <= tick[last[before]]:
            raise InputError(
                f"{source} is damaged: its flight {number + 1} goes on from tick {tick[row]} of "
                f"flight {before + 1}, which has ticks {tick[first[before]]} to "
                f"{tick[last[before]]}"
            )


def _check_motions(columns: Columns, header: Header, source: str) -> None:
    """Raises InputError for rows that no flight can have."""
    reference = np.isfinite([columns[name] for name in REFERENCE])
    followed = reference.any(axis=0)
    with np.errstate(over="ignore"):
        late = np.abs(columns["t_s"] - header.tick * columns["tick"])
    known = (columns[PHASE] >= NOBODY) & (columns[PHASE] < len(PHASES))
    laws = ", ".join(str(int(law)) for law in StickLaw)
    for right, what in (
        (late < ROUNDING, f"t_s is not that of its tick of {1e3 * header.tick:g} ms"),
        (~(np.abs(columns[HAND]) > 1.0), f"{HAND} is not in -1..1"),
        (known, f"{PHASE} is none of {NOBODY} to {len(PHASES) - 1}"),
        (np.isin(columns["stick_law"], list(StickLaw)), f"stick_law is none of {laws}"),
        (_are_rotations(columns, ATTITUDE), "R_BE is no rotation"),
        (followed == reference.all(axis=0), "half a reference stands"),
        (_are_rotations(columns, REFERENCE[3:]) | ~followed, "ref_R_BE is no rotation"),
    ):
        if not right.all():
            raise InputError(f"{source} is damaged: in row {_first(~right)} {what}")


def _are_rotations(columns: Columns, names: tuple[str, ...]) -> np.typing.NDArray[np.bool_]:
    R = np.stack([columns[name] for name in names], axis=1).reshape(-1, 3, 3)
    apart = np.abs(R @ R.transpose(0, 2, 1) - np.eye(3)).max(axis=(1, 2))
    return np.asarray(apart < ROUNDING)


def _first(rows: np.typing.NDArray[np.bool_]) -> int:
    """The first of the rows that are true, counted from 1."""
    return int(np.argmax(rows)) + 1
