"""`kitemj film`: a scenario on film, with no screen."""

import argparse
from pathlib import Path

from kitemj.commands.words import MODELS, Parser, add_picture, add_step, command, size


def add(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Adds the subcommand to the others."""
    parser = command(
        commands,
        "film",
        "fly a scenario with no screen and film it",
        "kitemj film scenarios/loops_20m.toml --output kite.mp4",
    )
    parser.add_argument("scenario", type=Path, help="a scenario file (TOML)")
    parser.add_argument("--output", type=Path, required=True, metavar="FILE.mp4")
    parser.add_argument("--overwrite", action="store_true", help="replace FILE.mp4 if it exists")
    parser.add_argument("--model", default="mujoco", help=f"one of {', '.join(MODELS)}")
    add_picture(parser)
    add_step(parser)
    parser.set_defaults(run=run)


def run(words: argparse.Namespace) -> int:
    """Returns the exit status."""
    from kitemj.cockpit.filming import film_scenario
    from kitemj.flight.output import check_new
    from kitemj.flight.scenario import read_scenario

    check_new(words.output, words.overwrite)
    scenario = read_scenario(words.scenario)
    pixels = size(words.size)
    film_scenario(
        scenario, words.model, words.step, words.output, pixels, words.view, words.overwrite
    )
    return 0
