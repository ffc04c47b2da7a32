"""The comparison as a table, and the ladder: for a terminal, and as Markdown."""

from collections.abc import Sequence
from math import isnan

from kitemj.flight.compare import (
    ATTITUDE_TOLERANCE,
    POSITION_TOLERANCE,
    TENSION_TOLERANCE,
    Comparison,
)
from kitemj.flight.ladder import Rung
from kitemj.tables import Table

HEADINGS = (
    "scenario",
    "models",
    "until [s]",
    "valid [s]",
    "position [µm]",
    "at [s]",
    "attitude [µrad]",
    "at [s]",
    "tension [mN]",
    "at [s]",
    "agree",
)
RUNG_HEADINGS = ("rung", "model", "measured", "limit", "unit", "holds")
TOLERANCES = (
    f"Tolerances: position {POSITION_TOLERANCE * 1e6:g} µm, attitude "
    f"{ATTITUDE_TOLERANCE * 1e6:g} µrad, tension {TENSION_TOLERANCE * 1e3:g} mN. Compared until "
    "a line goes slack or the kite touches the ground; valid: within all limits until then."
)


def cells(row: Comparison) -> list[str]:
    """One row of the table, in the order of `HEADINGS`."""
    return [
        row.scenario,
        f"{row.model} / {row.reference}",
        f"{row.until:.1f}",
        f"{row.valid:.1f}",
        f"{row.position.value * 1e6:.3g}",
        f"{row.position.t:.1f}",
        f"{row.attitude.value * 1e6:.3g}",
        f"{row.attitude.t:.1f}",
        f"{row.tension.value * 1e3:.3g}",
        f"{row.tension.t:.1f}",
        "yes" if row.agrees else "NO",
    ]


def comparison_table(rows: Sequence[Comparison]) -> Table:
    """A row for each."""
    return Table("comparison", HEADINGS, [tuple(cells(row)) for row in rows])


def print_table(rows: list[Comparison]) -> None:
    """The table in a terminal, with the tolerances below."""
    from rich import box
    from rich.console import Console
    from rich.table import Table as RichTable

    table = RichTable(*HEADINGS, box=box.SIMPLE)
    for row in rows:
        table.add_row(*cells(row))
    console = Console(width=None if Console().is_terminal else 140)
    console.print(table)
    console.print(TOLERANCES)


def markdown(rows: list[Comparison]) -> str:
    """The table as Markdown, with the tolerances below."""
    return f"{_markdown_table(HEADINGS, [cells(row) for row in rows])}\n{TOLERANCES}\n"


def print_ladders(ladders: dict[str, list[Rung]]) -> None:
    """For each scenario (by its name) its rungs, in a terminal."""
    from rich import box
    from rich.console import Console
    from rich.table import Table as RichTable

    for scenario, rungs in ladders.items():
        table = RichTable(*RUNG_HEADINGS, title=scenario, title_justify="left", box=box.SIMPLE)
        for rung in rungs:
            table.add_row(*rung_cells(rung))
        Console(width=None if Console().is_terminal else 140).print(table)


def rung_cells(rung: Rung) -> list[str]:
    """One rung, in the order of `RUNG_HEADINGS`."""
    measured = "-" if isnan(rung.measured) else f"{rung.measured:.2g}"
    limit = f"{'≥' if rung.at_least else '≤'} {rung.limit:g}"
    return [rung.name, rung.model, measured, limit, rung.unit, "yes" if rung.holds else "NO"]


def ladders_markdown(ladders: dict[str, list[Rung]]) -> str:
    """The same as Markdown."""
    return "\n".join(
        f"**{scenario}**\n\n{_markdown_table(RUNG_HEADINGS, [rung_cells(r) for r in rungs])}"
        for scenario, rungs in ladders.items()
    )


def _markdown_table(headings: Sequence[str], rows: list[list[str]]) -> str:
    lines = [headings, ["---"] * len(headings), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)
