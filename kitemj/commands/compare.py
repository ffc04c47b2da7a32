"""`kitemj compare`: a scenario through all models, and how far apart they are."""

import argparse
from pathlib import Path

from kitemj.commands.arguments import MODELS, Parser, add_step, command


def add(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Adds the subcommand to the others."""
    parser = command(
        commands,
        "compare",
        "fly a scenario through the models and print how far apart they are",
        "kitemj compare scenarios/steer_200m.toml",
    )
    parser.add_argument("scenario", type=Path, nargs="+", help="scenario files (TOML)")
    parser.add_argument(
        "--models", default=",".join(MODELS), metavar="A,B", help="the last one is the reference"
    )
    parser.add_argument(
        "--ladder", action="store_true", help="from accelerations to the order of convergence"
    )
    parser.add_argument("--markdown", type=Path, metavar="FILE.md", help="write the table as well")
    parser.add_argument("--overwrite", action="store_true", help="replace FILE.md if it exists")
    add_step(parser)
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Returns the exit status."""
    from kitemj.api import compare
    from kitemj.files import check_new, new_file
    from kitemj.flight.compare_table import (
        ladders_markdown,
        markdown,
        print_ladders,
        print_table,
    )
    from kitemj.flight.ladder import ladder
    from kitemj.flight.scenario import read_scenario

    if args.markdown:
        check_new(args.markdown, args.overwrite)
    scenarios = [read_scenario(path) for path in args.scenario]
    if args.ladder:
        rungs = {each.source: ladder(each, args.step) for each in scenarios}
        print_ladders(rungs)
        text, good = ladders_markdown(rungs), all(r.holds for each in rungs.values() for r in each)
    else:
        models = args.models.split(",")
        rows = [row for each in scenarios for row in compare(each, models, step=args.step)]
        print_table(rows)
        text, good = markdown(rows), all(row.agrees for row in rows)
    if args.markdown:
        with new_file(args.markdown, args.overwrite) as part:
            part.write_text(text, encoding="utf-8")
    return 0 if good else 1
