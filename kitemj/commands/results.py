"""What `kitemj trim` and `kitemj stability` do with what they find: show, write, draw."""

import argparse
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.words import Parser

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from kitemj.stability.tables import Table


def add_results(parser: Parser) -> None:
    """``--output`` and ``--save``."""
    parser.add_argument(
        "--output", type=Path, metavar="FILE", help="numbers: .json, .csv or .parquet"
    )
    parser.add_argument("--save", type=Path, metavar="FIGURE", help="figure: .png, .pdf, .svg")
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")


def check_results(words: argparse.Namespace) -> None:
    """Raises InputError before work is done that could not be kept."""
    from kitemj.flight.output import check_new
    from kitemj.stability.results import check_format

    if words.output:
        check_format(words.output)
    for path in (words.output, words.save):
        if path:
            check_new(path, words.overwrite)


def give_results(
    words: argparse.Namespace,
    tables: "list[Table]",
    extra: Mapping[str, object],
    figure: "Callable[[], Figure]",
    show: bool = True,
) -> None:
    """Prints the tables, writes the numbers, draws the figure: what of it was asked for."""
    from kitemj.stability import plots
    from kitemj.stability.results import print_table, write

    for table in tables if show else []:
        print_table(table)
    if words.output:
        write(words.output, tables, extra, words.overwrite)
    if words.save:
        plots.save(figure(), words.save, words.overwrite)
