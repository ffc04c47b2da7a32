"""`kitemj margins`: how far the loop of a scenario's pilot is from instability."""

import argparse
from pathlib import Path

from kitemj.commands.arguments import SCENARIO, Parser
from kitemj.commands.results import add_results, check_results, give_results

HELP = "gain, phase, delay and disk margins of the pilot's loop on its path, and its multipliers"
EXAMPLE = "kitemj margins scenarios/trainer_home.toml --save margins.pdf"


def add(parser: Parser) -> None:
    """Adds its arguments."""
    parser.add_argument("scenario", type=Path, help=SCENARIO)
    says = "points of a lap at which the loop is frozen (16)"
    parser.add_argument("--points", type=int, default=16, help=says)
    add_results(parser)


def run(args: argparse.Namespace) -> None:
    """Prints, writes and draws what is asked for."""
    from kitemj.api import margins
    from kitemj.robustness.figure import margins_figure

    check_results(args)
    found = margins(args.scenario, args.points)
    extra: dict[str, object] = {"met": found.met} if args.json or args.output else {}
    give_results(args, found.tables(), extra, lambda: margins_figure(found), [found.in_words])
