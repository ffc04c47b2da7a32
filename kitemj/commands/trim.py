"""`kitemj trim`: where a kite stands in a steady wind."""

import argparse
from pathlib import Path

from kitemj.commands.arguments import MODELS, SCENARIO, Parser
from kitemj.commands.results import add_results, check_results, give_results

HELP = "find every equilibrium of a scenario's kite in its steady wind, lines held"
EXAMPLE = "kitemj trim scenarios/steer_80m.toml"


def add(parser: Parser) -> None:
    """Adds its arguments."""
    parser.add_argument("scenario", type=Path, help=SCENARIO)
    parser.add_argument("--models", default=",".join(MODELS), metavar="A,B", help="which models")
    add_results(parser)


def run(args: argparse.Namespace) -> None:
    """Prints, writes and draws what is asked for."""
    from kitemj.api import trim
    from kitemj.equilibria import plots
    from kitemj.equilibria.modes import stability_of
    from kitemj.equilibria.tables import trim_table
    from kitemj.flight.scenario import read_scenario

    check_results(args)
    scenario = read_scenario(args.scenario)
    trims = [found for model in args.models.split(",") for found in trim(scenario, model)]
    first = [found for found in trims if found.model == trims[0].model]
    notes = [
        f"{each.in_words}: {stability_of(scenario.parameters, each).in_words}" for each in first
    ]
    give_results(args, [trim_table(trims)], {}, lambda: plots.trim_figure(trims), notes)
