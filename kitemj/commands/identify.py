"""`kitemj identify`: how a kite turns for what the hands do."""

import argparse

from kitemj.commands.arguments import MODELS, Parser
from kitemj.commands.results import add_results, check_results, give_results

HELP = "fly a test signal and fit the law by which a kite turns, with what it is uncertain by"
EXAMPLE = "kitemj identify sport --save turning.pdf"


def add(parser: Parser) -> None:
    """Adds its arguments."""
    says = "a set, or a scenario: its kite and wind are flown"
    parser.add_argument("scenario", metavar="SET|FILE", help=says)
    parser.add_argument("--model", default="lagrange", help=f"one of {', '.join(MODELS)}")
    add_results(parser)


def run(args: argparse.Namespace) -> None:
    """Prints, writes and draws what is asked for; that no law holds is an answer, too."""
    from kitemj.api import identify
    from kitemj.physics.parameter_files import parameter_tables
    from kitemj.turning.identification_plot import identification_figure

    check_results(args)
    found = identify(args.scenario, args.model)
    extra: dict[str, object] = {}
    if args.json or args.output:
        law = found.fit.law._asdict() if found.fit and found.holds else None
        extra = {"holds": found.holds, "law": law}
    about = {
        "scenario": found.source,
        "model": found.model,
        "parameters": parameter_tables(found.parameters),
    }
    notes = [found.beside_rest, found.in_words]
    give_results(
        args, found.tables(), extra, lambda: identification_figure(found), notes, about=about
    )
