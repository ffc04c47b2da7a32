"""What commands such as `kitemj trim` do with what they find: show, write, draw."""

import argparse
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.arguments import Parser, add_json

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from kitemj.tables import Table


def add_results(parser: Parser) -> None:
    """``--output``, ``--save`` and ``--json``."""
    says = "numbers: .json, .csv or .parquet"
    parser.add_argument("--output", type=Path, metavar="FILE", help=says)
    parser.add_argument("--save", type=Path, metavar="FIGURE", help="figure: .png, .pdf, .svg")
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")
    add_json(parser)


def check_results(args: argparse.Namespace) -> None:
    """Raises InputError before work is done that could not be kept."""
    from kitemj.metadata import check_new_table
    from kitemj.plots.figure_output import check_figures
    from kitemj.tables import check_format

    if args.output:
        check_format(args.output)
        check_new_table(args.output, args.overwrite)
    if args.save:
        check_figures(args.save, [""], args.overwrite)


def give_results(
    args: argparse.Namespace,
    tables: "list[Table]",
    extra: Mapping[str, object],
    figure: "Callable[[], Figure]",
    notes: Sequence[str] = (),
    show: bool = True,
    about: "Mapping[str, object] | None" = None,
) -> None:
    """Prints tables and notes, writes the numbers, draws the figure: what of it was asked for.

    args: of `add_results`
    tables: what was found
    extra: goes into JSON beside the tables
    figure: draws it
    notes: sentences below the tables, the one that says most at the end
    show: whether the tables are short enough to be printed for people
    about: what a file of numbers says it is about; None: the scenario of that name
    """
    from kitemj.flight.motion_table import about_flight
    from kitemj.flight.scenario import read_scenario
    from kitemj.plots.figure_output import save_figures
    from kitemj.tables import json_text, print_table, write

    if args.json:
        print(json_text(tables, {**extra, "notes": [note for note in notes if note]}))
    else:
        for table in tables if show else []:
            print_table(table)
        for note in filter(None, notes):
            print(note)
    if args.output:
        about = about or about_flight(read_scenario(args.scenario))
        write(args.output, tables, extra, args.overwrite, about)
    if args.save:
        save_figures({"": figure()}, args.save, args.overwrite)
