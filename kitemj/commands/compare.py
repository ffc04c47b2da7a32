"""`kitemj compare`: a scenario through all models, and how far apart they are."""

import argparse
from pathlib import Path

from kitemj.commands.arguments import MODELS, SCENARIO, Parser, add_json, add_step

HELP = "fly a scenario through the models and print how far apart they are"
EXAMPLE = "kitemj compare scenarios/steer_200m.toml"


def add(parser: Parser) -> None:
    """Adds its arguments."""
    parser.add_argument("scenario", type=Path, nargs="+", help=SCENARIO)
    says = "the last one is the reference"
    parser.add_argument("--models", default=",".join(MODELS), metavar="A,B", help=says)
    says = "from accelerations to the order of convergence"
    parser.add_argument("--ladder", action="store_true", help=says)
    parser.add_argument("--markdown", type=Path, metavar="FILE.md", help="write the table as well")
    parser.add_argument("--overwrite", action="store_true", help="replace FILE.md if it exists")
    add_json(parser)
    add_step(parser)


def run(args: argparse.Namespace) -> int:
    """Returns the exit status."""
    from kitemj.api import compare
    from kitemj.files import check_new, new_file
    from kitemj.flight import compare_table as as_table
    from kitemj.flight.ladder import ladder
    from kitemj.flight.scenario import read_scenario
    from kitemj.tables import json_text, markdown, print_table, titled_markdown

    if args.markdown:
        check_new(args.markdown, args.overwrite)
    scenarios = [read_scenario(path) for path in args.scenario]
    if args.ladder:
        rungs = {each.source: ladder(each, args.step) for each in scenarios}
        shown = [as_table.ladder_table(*each) for each in rungs.items()]
        numbers, tolerances = as_table.ladder_numbers(rungs), {}
        text = titled_markdown(shown)
    else:
        models = args.models.split(",")
        rows = [row for each in scenarios for row in compare(each, models, step=args.step)]
        shown = [as_table.comparison_table(rows)]
        numbers, tolerances = as_table.comparison_numbers(rows), as_table.TOLERANCES
        text = f"{markdown(shown[0])}\n{as_table.TOLERANCES_TOLD}\n"
    if args.json:
        print(json_text([numbers], {"tolerances": tolerances} if tolerances else {}))
    else:
        for table in shown:
            print_table(table, most=len(table.columns))
        if tolerances:
            print(as_table.TOLERANCES_TOLD)
        if still := [each.source for each in scenarios if not each.steered and not each.pilot]:
            print(f"No steering programme is named, so restless hands flew: {', '.join(still)}")
    if args.markdown:
        with new_file(args.markdown, args.overwrite) as part:
            part.write_text(text, encoding="utf-8")
    return 0 if all(row[-1] for row in numbers.rows) else 1
