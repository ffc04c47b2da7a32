"""`kitemj reach`: what arms can do to two lines."""

import argparse

from kitemj.commands.arguments import Parser, add_json

HELP = "print the largest δ of someone whose arms move each line so far, and as a set has it"
EXAMPLE = "kitemj reach thesis --arm 0.25 --length 200"


def add(parser: Parser) -> None:
    """Adds its arguments."""
    says = "a set, or a scenario"
    parser.add_argument("kite", nargs="?", default="trainer", metavar="SET|FILE", help=says)
    parser.add_argument("--arm", type=float, metavar="M", help="to each side, default: the set's")
    parser.add_argument("--length", type=float, metavar="M", help="of each line, L₀")
    parser.add_argument("--attachments", type=float, metavar="M", help="between them, 2 Y_A")
    add_json(parser)


def run(args: argparse.Namespace) -> None:
    """Prints it."""
    from kitemj.flight.reach import COLUMNS, reach_of, told
    from kitemj.flight.scenario import parameters_named
    from kitemj.tables import json_text

    parameters = parameters_named(args.kite)
    own = (parameters.stick.arm, parameters.lines.length, 2 * parameters.kite.y_A)
    given = (args.arm, args.length, args.attachments)
    found = reach_of(*(a if b is None else b for a, b in zip(own, given, strict=True)))
    print(json_text([], dict(zip(COLUMNS, found, strict=True))) if args.json else told(found))
