"""`kitemj reach`: what arms can do to two lines."""

import argparse

from kitemj.commands.arguments import Parser, command


def add(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Adds the subcommand to the others."""
    parser = command(
        commands,
        "reach",
        "print the largest δ of someone whose arms move each line so far, and as a set has it",
        "kitemj reach thesis --arm 0.25 --length 200",
    )
    parser.add_argument(
        "kite", nargs="?", default="sport", metavar="SET|FILE", help="a set, or a scenario"
    )
    parser.add_argument("--arm", type=float, metavar="M", help="to each side, default: the set's")
    parser.add_argument("--length", type=float, metavar="M", help="of each line, L₀")
    parser.add_argument("--attachments", type=float, metavar="M", help="between them, 2 Y_A")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Returns the exit status."""
    from kitemj.flight.reach import reach_of, told
    from kitemj.flight.scenario import parameters_named

    parameters = parameters_named(args.kite)
    own = (parameters.stick.arm, parameters.lines.length, 2 * parameters.kite.y_A)
    given = (args.arm, args.length, args.attachments)
    print(told(reach_of(*(a if b is None else b for a, b in zip(own, given, strict=True)))))
    return 0
