"""`kitemj simulate`: a scenario, a model, a table."""

import argparse
import sys
from pathlib import Path

from kitemj.commands.arguments import MODELS, SCENARIO, Parser, add_pilot, add_step

HELP = "fly a scenario with no screen and write a table"
EXAMPLE = "kitemj simulate scenarios/steer_200m.toml --model lagrange --output flight.csv"


def add(parser: Parser) -> None:
    """Adds its arguments."""
    parser.add_argument("scenario", type=Path, help=SCENARIO)
    parser.add_argument("--model", default="mujoco", help=f"one of {', '.join(MODELS)}")
    parser.add_argument("--output", type=Path, required=True, metavar="FILE.csv")
    parser.add_argument("--overwrite", action="store_true", help="replace FILE.csv if it exists")
    add_pilot(parser)
    add_step(parser)


def run(args: argparse.Namespace) -> int:
    """Returns the exit status: 1 where the flight broke off."""
    from kitemj.autopilot.guided_flight import simulate_as_said
    from kitemj.flight.limits import Ending, left_limits
    from kitemj.flight.motion_table import write_csv
    from kitemj.flight.scenario import read_scenario
    from kitemj.metadata import check_new_table
    from kitemj.pilots.piloted import simulate_pilot
    from kitemj.pilots.registry import as_pilot

    check_new_table(args.output, args.overwrite)
    scenario = read_scenario(args.scenario)
    if args.pilot:
        flight = simulate_pilot(scenario, as_pilot(args.pilot), args.model, args.step)
    else:
        flight = simulate_as_said(scenario, args.model, args.step)
    write_csv(args.output, flight, args.overwrite)
    print(f"{args.output}: {len(flight.motions)} rows, {flight.model}; {flight.ending.value}")
    if flight.departure:
        print(left_limits(flight.departure))
    if flight.ending is Ending.DIVERGED:
        print(f"kitemj: {flight.note}", file=sys.stderr)
        return 1
    return 0
