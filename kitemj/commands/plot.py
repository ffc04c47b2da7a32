"""`kitemj plot`: a flight drawn for print."""

import argparse
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.arguments import MODELS, Parser
from kitemj.errors import InputError
from kitemj.plots.figures import FIGURES

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from kitemj.plots.flight import Flight

HELP = "draw a recording, a scenario or a table: state, rates, tensions, angles, path, ..."
EXAMPLE = "kitemj plot scenarios/steer_80m.toml --what state,window --save flight.pdf"
NOTES = """\
Of several figures, NAME.pdf has a page for each; NAME.png and NAME.svg are one sheet of all,
and NAME-state.png, NAME-rates.png, ... have each alone. What was written is listed.
Red and solid is the pilot's left, A₊; blue and dashed the right, A₋. Grey: beyond the
limits of validity."""

ALL = "all"


def add(parser: Parser) -> None:
    """Adds its arguments."""
    add_file(parser)
    says = f"which of {', '.join(FIGURES.shipped)}; default {ALL} that the file has numbers for"
    parser.add_argument("--what", default=ALL, metavar="A,B", help=says)
    add_save(parser, "figures: .png, .pdf or .svg; without it they are shown in windows")


def add_file(parser: Parser) -> None:
    """The flight, and what can be chosen of it."""
    says = (
        "a recording (*.arrows), a scenario (*.toml), which is flown, or a table (*.csv, "
        "*.parquet) of kitemj simulate or replay --export"
    )
    parser.add_argument("file", type=Path, metavar="FILE", help=says)
    says = f"flies a scenario: {', '.join(MODELS)}; default lagrange"
    parser.add_argument("--model", default="", help=says)
    says = "which flight of a recording, as kitemj info counts them; default the longest"
    parser.add_argument("--leg", dest="episode", type=int, default=0, metavar="N", help=says)
    says = "which kite flew a table: a set or a scenario's file; default as it says, else a guess"
    parser.add_argument("--kite", default="", metavar="SET", help=says)


def add_save(parser: Parser, says: str) -> None:
    """``--save``."""
    parser.add_argument("--save", type=Path, metavar="NAME", help=says)
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")


def run(args: argparse.Namespace) -> None:
    """Draws the figures."""
    from kitemj.flight.limits import left_limits
    from kitemj.plots.figure_output import check_figures, check_windows, save_figures, show
    from kitemj.plots.sources import read_flight

    names = _names(args.what)
    if args.save:
        check_figures(args.save, names or list(FIGURES), args.overwrite)
    else:
        check_windows()
    flight = read_flight(args.file, args.model, args.episode, args.kite)
    figures, lacking = _drawn(flight, names)
    for note in (*flight.notes, *lacking):
        print(note)
    if flight.departure:
        print(left_limits(flight.departure))
    if args.save:
        for path, shows in zip(
            save_figures(figures, args.save, args.overwrite), _shown(figures), strict=False
        ):
            print(f"{path}: {shows}")
    else:
        show(figures)


def _shown(figures: Mapping[str, "Figure"]) -> list[str]:
    """What each file shows, the sheet of all first; a single figure has no sheet."""
    return [", ".join(figures), *(figures if len(figures) > 1 else ())]


def _names(what: str) -> list[str]:
    """The figures that were named, each once; none: all."""
    names = list(dict.fromkeys(what.split(",")))
    for name in names:
        if name != ALL and name not in FIGURES:
            known = ", ".join(FIGURES)
            raise InputError(f"there is no figure {name!r}; there are: {known}, and {ALL}")
    return [] if ALL in names else names


def _drawn(flight: "Flight", names: list[str]) -> "tuple[dict[str, Figure], list[str]]":
    """The figures called `names`; none of them: all that can be drawn, and why others cannot."""
    figures, lacking = {}, []
    for name in names or FIGURES:
        try:
            figures[name] = flight.plot(name)
        except InputError as error:
            if names:
                raise
            lacking.append(f"without {name}: {error}")
    if not figures:
        raise InputError(lacking[0])
    return figures, lacking
