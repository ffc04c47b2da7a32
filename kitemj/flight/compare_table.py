"""Comparisons and ladders as tables: in words for people, in numbers for machines."""

from collections.abc import Mapping, Sequence
from itertools import chain
from math import isnan

from kitemj.flight.compare import (
    ATTITUDE_TOLERANCE,
    GUIDED_TOLERANCE,
    POSITION_TOLERANCE,
    TENSION_TOLERANCE,
    Comparison,
)
from kitemj.flight.ladder import Rung
from kitemj.tables import Cell, Table

HEADINGS = (
    *("scenario", "models", "until [s]", "valid [s]", "position [µm]", "at [s]"),
    *("attitude [µrad]", "at [s]", "tension [mN]", "at [s]", "agree"),
)
COLUMNS = (
    *("scenario", "model", "reference", "until_s", "valid_s", "moved_m"),
    *("position_m", "position_at_s", "attitude_rad", "attitude_at_s", "tension_N", "tension_at_s"),
    *("verdict", "agree"),
)
RUNG_HEADINGS = ("rung", "model", "measured", "limit", "unit", "holds")
RUNG_COLUMNS = ("scenario", "rung", "model", "measured", "limit", "unit", "at_least", "holds")
TOLERANCES = {
    "position_m": POSITION_TOLERANCE,
    "attitude_rad": ATTITUDE_TOLERANCE,
    "tension_N": TENSION_TOLERANCE,
}
TOLERANCES_TOLD = (
    f"Tolerances: position {POSITION_TOLERANCE * 1e6:g} µm, attitude "
    f"{ATTITUDE_TOLERANCE * 1e6:g} µrad, with an autopilot in the loop {GUIDED_TOLERANCE * 1e6:g} "
    f"of each; tension {TENSION_TOLERANCE * 1e3:g} mN. "
    "Compared until "
    "a line goes slack or the kite touches the ground; valid: within all limits until then. "
    '"at rest": the kite never moved, which shows nothing of how it moves.'
)


def comparison_table(rows: Sequence[Comparison]) -> Table:
    """For people; without a title."""
    return Table("", HEADINGS, [_cells(row) for row in rows])


def _cells(row: Comparison) -> tuple[Cell, ...]:
    gaps = ((row.position, 1e6), (row.attitude, 1e6), (row.tension, 1e3))
    told = ((f"{gap.value * scale:.3g}", f"{gap.t:.1f}") for gap, scale in gaps)
    models, times = f"{row.model} / {row.reference}", (f"{row.until:.1f}", f"{row.valid:.1f}")
    return (row.scenario, models, *times, *chain(*told), row.verdict)


def comparison_numbers(rows: Sequence[Comparison]) -> Table:
    """For machines."""
    cells: list[tuple[Cell, ...]] = [
        (*row[:6], *row.position, *row.attitude, *row.tension, row.verdict, row.agrees)
        for row in rows
    ]
    return Table("comparisons", COLUMNS, cells)


def ladder_table(scenario: str, rungs: list[Rung]) -> Table:
    """For people; its title is the scenario's."""
    return Table(scenario, RUNG_HEADINGS, [_rung_cells(rung) for rung in rungs])


def _rung_cells(rung: Rung) -> tuple[Cell, ...]:
    measured = "-" if isnan(rung.measured) else f"{rung.measured:.2g}"
    limit = f"{'≥' if rung.at_least else '≤'} {rung.limit:g}"
    return (rung.name, rung.model, measured, limit, rung.unit, "yes" if rung.holds else "NO")


def ladder_numbers(ladders: Mapping[str, list[Rung]]) -> Table:
    """For machines: the rungs of all scenarios, by their names."""
    cells: list[tuple[Cell, ...]] = [
        (name, *rung, rung.holds) for name, rungs in ladders.items() for rung in rungs
    ]
    return Table("rungs", RUNG_COLUMNS, cells)
