"""The comparison as a table: for a terminal, and as Markdown."""

from pathlib import Path

from kitemj.flight.compare import (
    ATTITUDE_TOLERANCE,
    POSITION_TOLERANCE,
    TENSION_TOLERANCE,
    Comparison,
)
from kitemj.flight.output import new_file

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


def print_table(rows: list[Comparison]) -> None:
    """The table in a terminal, with the tolerances below."""
    from rich import box
    from rich.console import Console
    from rich.table import Table

    table = Table(*HEADINGS, box=box.SIMPLE)
    for row in rows:
        table.add_row(*cells(row))
    console = Console(width=None if Console().is_terminal else 140)
    console.print(table)
    console.print(TOLERANCES)


def write_markdown(path: Path, rows: list[Comparison], overwrite: bool = False) -> None:
    """The table as Markdown."""
    lines = [HEADINGS, ["---"] * len(HEADINGS), *(cells(row) for row in rows)]
    text = "\n".join(f"| {' | '.join(line)} |" for line in lines)
    with new_file(path, overwrite) as part:
        part.write_text(f"{text}\n\n{TOLERANCES}\n", encoding="utf-8")
