"""`kitemj limits`: how much of each physical limit a flight takes up."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.arguments import Parser
from kitemj.commands.plot import add_file, add_save
from kitemj.commands.results import check_results

if TYPE_CHECKING:
    from kitemj.tables import Cell

HELP = "print and draw T₊/T_max, T₋/T_max, α/α_stall and |β|/β_max of a flight"
EXAMPLE = "kitemj limits scenarios/steer_80m.toml --save limits.pdf"
NOTES = """\
Above 1, or with a tension or an α of 0 or less, the model is not valid: the figure is
hatched there, and the table says from when on. The exit status is 0 all the same."""


def add(parser: Parser) -> None:
    """Adds its arguments."""
    add_file(parser)
    add_save(parser, "the figure: .png, .pdf or .svg")
    says = "the table: .json, .csv or .parquet"
    parser.add_argument("--output", type=Path, metavar="FILE", help=says)


def run(args: argparse.Namespace) -> None:
    """Prints the table; writes and draws what is asked for."""
    from kitemj.flight.limits import left_limits
    from kitemj.physics.parameter_files import parameter_tables
    from kitemj.plots.figure_output import save_figures
    from kitemj.plots.limits import Extremes, beside_rest, extremes, headroom, limits_figure
    from kitemj.plots.sources import read_flight
    from kitemj.tables import Table, print_table, write

    check_results(args)
    flight = read_flight(args.file, args.model, args.episode, args.kite)
    for note in flight.notes:
        print(note)
    print_table(headroom(flight))
    if rest := beside_rest(flight):
        print(rest)
    print(left_limits(flight.departure))
    if args.output:
        rows: list[tuple[Cell, ...]] = [*extremes(flight)]
        about = {"flight": flight.name, "parameters": parameter_tables(flight.parameters)}
        table = Table("limits", Extremes._fields, rows)
        write(args.output, [table], {}, args.overwrite, about)
    if args.save:
        print(*save_figures({"limits": limits_figure(flight)}, args.save, args.overwrite))
