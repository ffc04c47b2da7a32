"""Tables of named columns, printed for people and written as JSON, CSV or Parquet.

Every column's name ends in its unit (`_rad` and `_deg` are told apart, 1/s is `_per_s`);
numbers are rounded only where they are printed.
"""

import csv
import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from html import escape
from io import StringIO
from math import isfinite
from pathlib import Path
from textwrap import wrap
from typing import Any, NamedTuple, TypeVar

from kitemj.console import printable
from kitemj.errors import InputError
from kitemj.metadata import KEY, new_csv, told

Cell = float | str | bool
T = TypeVar("T")

FORMATS = (".json", ".csv", ".parquet")
WIDE = 8
"""Columns that fit side by side in a terminal."""
PIPED = 200
"""Characters of a line that goes to a file or a pipe."""
NOISE = 1e-13
"""Angles and shares below are shown as 0: some hundred roundings of numbers of the size of 1."""
MEASURED = 100_000
"""Characters of a line in which any table fits, to see how many it needs."""


UNITS = {
    **{"rad_s2": "rad/s²", "m_s2": "m/s²"},
    **{"rad_per_s": "rad/s", "rad_s": "rad/s", "per_s": "1/s", "per_m": "1/m", "m_s": "m/s"},
    **{unit: unit for unit in ("rad", "deg", "Hz", "s", "m", "N")},
}
"""What a column's name ends in, and the unit that this means; the first that fits counts."""


def unit_of_column(name: str) -> str:
    """The unit of the column called `name`; "1" where it has none."""
    return next((unit for end, unit in UNITS.items() if name.endswith(f"_{end}")), "1")


class Table(NamedTuple):
    """`title` for people; one name a column; rows as long as `columns`."""

    title: str
    columns: tuple[str, ...]
    rows: list[tuple[Cell, ...]]

    def records(self) -> list[dict[str, Cell]]:
        """A dictionary for each row, as JSON has them."""
        return [dict(zip(self.columns, row, strict=True)) for row in self.rows]

    def texts(self) -> list[list[str]]:
        """The rows for people: rounded, and noise of rounding is 0."""
        return [list(map(_text, self.columns, row)) for row in self.rows]

    def html(self) -> str:
        """For a notebook: on its side if it is wide, as in a terminal."""
        lines: list[Sequence[str]] = [self.columns, *self.texts()]
        if len(self.columns) > WIDE:
            lines = list(zip(*lines, strict=True))
        body = "".join(
            f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in line)}</tr>" for line in lines
        )
        return f"<table><caption>{escape(self.title)}</caption>{body}</table>"


class Tabled:
    """A result that a notebook shows as its tables."""

    def tables(self) -> list[Table]:
        """What it holds, in short, for people."""
        raise NotImplementedError

    def _repr_html_(self) -> str:
        return "".join(table.html() for table in self.tables())

    def in_short(self) -> str:
        """The first table in one line."""
        table = self.tables()[0]
        told = "; ".join(map(" ".join, table.texts()))
        return f"<{type(self).__name__} {table.title}: {told}>"


class Results(list[T], Tabled):
    """Several results, which make one table."""

    def __init__(self, results: Iterable[T], table: Callable[[Sequence[T]], Table]) -> None:
        super().__init__(results)
        self._table = table

    def tables(self) -> list[Table]:
        """A row for each."""
        return [self._table(self)]


def check_format(path: Path) -> None:
    """Raises InputError for a name that says no known format."""
    if path.suffix.lower() not in FORMATS:
        known = ", ".join(FORMATS)
        raise InputError(f"{path.name} must end in one of {known} to say what to write")


def print_table(table: Table, most: int = WIDE) -> None:
    """Prints a table for people; each number in it is whole, however narrow the terminal.

    On its side, a column for each row, if it has more columns than `most` or does not fit; one
    value a line where that does not fit either.
    """
    from rich.console import Console

    console = Console()
    width = console.width if console.is_terminal else PIPED
    print("\n".join(lines_of(table, width, most)))


def lines_of(table: Table, width: int, most: int = WIDE) -> list[str]:
    """What `print_table` prints where lines of `width` characters fit."""
    from rich import box
    from rich.console import Console
    from rich.measure import Measurement
    from rich.table import Table as Shown

    names = [printable(name) for name in table.columns]
    rows = [list(map(printable, row)) for row in table.texts()]
    title = _wrapped(printable(table.title), width)
    console = Console(width=MEASURED, file=StringIO(), markup=False, highlight=False)
    for wide in (False, True) if len(names) <= most else (True,):
        shown = Shown(*([] if wide else names), box=box.SIMPLE, show_header=not wide)
        for line in zip(names, *rows, strict=True) if wide else rows:
            shown.add_row(*line)
        if Measurement.get(console, console.options, shown).maximum <= width:
            with console.capture() as text:
                console.print(shown)
            return [*title, *map(str.rstrip, printable(text.get()).splitlines())]
    values = ([f"{name}: {cell}" for name, cell in zip(names, row, strict=True)] for row in rows)
    return [
        *title,
        *(line for row in values for each in ["", *row] for line in _wrapped(each, width)),
    ]


def _wrapped(text: str, width: int) -> list[str]:
    """`text` in lines of `width`, or of one word that is longer."""
    return wrap(text, width, break_long_words=False, break_on_hyphens=False) or [text]


def _text(column: str, cell: Cell) -> str:
    if not isinstance(cell, float):
        return str(cell)
    noise = unit_of_column(column) in ("rad", "deg") or column.startswith("share_")
    return "0" if noise and abs(cell) < NOISE else f"{cell:.7g}"


def markdown(table: Table) -> str:
    """The table in Markdown, without its title."""
    lines = [table.columns, ["---"] * len(table.columns), *table.texts()]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def titled_markdown(tables: Iterable[Table]) -> str:
    """Each table in Markdown, under its title."""
    return "\n".join(f"**{table.title}**\n\n{markdown(table)}" for table in tables)


def json_text(tables: Iterable[Table], extra: Mapping[str, object]) -> str:
    """One document: the rows of each table under its title, and `extra`."""
    content = {**{table.title: table.records() for table in tables}, **extra}
    return json.dumps(_finite(content), indent=1, allow_nan=False)


def _finite(value: Any) -> Any:
    """JSON has no NaN and no infinity: null."""
    if isinstance(value, Mapping):
        return {key: _finite(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(each) for each in value]
    return None if isinstance(value, float) and not isfinite(value) else value


def write(
    path: Path,
    tables: list[Table],
    extra: Mapping[str, object],
    overwrite: bool,
    about: Mapping[str, object] | None = None,
) -> None:
    """JSON holds all `tables` and `extra`; CSV and Parquet hold the first table.

    They say its title and what it is `about`, as `kitemj.metadata` has it.
    """
    kind, first = path.suffix.lower(), tables[0]
    about = {"holds": first.title, **(about or {})}
    with new_csv(path, about, overwrite) as part:
        if kind == ".json":
            part.write_text(json_text(tables, extra) + "\n", encoding="utf-8")
        elif kind == ".csv":
            with part.open("w", newline="", encoding="utf-8") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerows([first.columns, *first.rows])
        else:
            from pyarrow import Table as Columns
            from pyarrow import parquet

            columns = Columns.from_pylist(first.records())
            parquet.write_table(columns.replace_schema_metadata({KEY: told(about)}), part)
