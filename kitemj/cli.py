"""The command `kitemj`: thin; each subcommand reads its words and calls one room."""

import argparse
import sys
import time
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path
from typing import NoReturn

from kitemj.errors import FlightError, InputError

MODELS = ("mujoco", "newton-euler", "lagrange")
RAW = argparse.RawDescriptionHelpFormatter


class Parser(argparse.ArgumentParser):
    """One line for bad words, like for any other bad input."""

    def error(self, message: str) -> NoReturn:
        """Exit status 2."""
        self.exit(2, f"kitemj: {message}; see {self.prog} --help\n")


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command line; returns the exit status: 0 done, 1 a no, 2 bad input."""
    called = time.perf_counter()
    words = _parser().parse_args(arguments)
    words.called = called
    try:
        return int(words.run(words))
    except (InputError, FileExistsError, FileNotFoundError, PermissionError) as error:
        print(f"kitemj: {error}", file=sys.stderr)
        return 2
    except FlightError as error:
        print(f"kitemj: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("kitemj: interrupted; nothing was written", file=sys.stderr)
        return 130


def _parser() -> Parser:
    parser = Parser(prog="kitemj", description=__doc__.split(":")[0], formatter_class=RAW)
    parser.description = "A two-line kite in MuJoCo, flown in real time beside a reference."
    parser.add_argument("--version", action="version", version=f"kitemj {version('kitemj')}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    _add_fly(commands)
    _add_simulate(commands)
    _add_compare(commands)
    _add_film(commands)
    return parser


def _command(
    commands: "argparse._SubParsersAction[Parser]", name: str, says: str, example: str
) -> Parser:
    return commands.add_parser(
        name, help=says, description=says, epilog=f"example:\n  {example}", formatter_class=RAW
    )


def _add_step(parser: Parser) -> None:
    parser.add_argument(
        "--step", type=float, default=0.002, metavar="S", help="longest step [s], default 0.002"
    )


def _add_simulate(commands: "argparse._SubParsersAction[Parser]") -> None:
    parser = _command(
        commands,
        "simulate",
        "fly a scenario with no screen and write a table",
        "kitemj simulate scenarios/steer_200m.toml --model lagrange --output flight.csv",
    )
    parser.add_argument("scenario", type=Path, help="a scenario file (TOML)")
    parser.add_argument("--model", default="mujoco", help=f"one of {', '.join(MODELS)}")
    parser.add_argument("--output", type=Path, required=True, metavar="FILE.csv")
    parser.add_argument("--overwrite", action="store_true", help="replace FILE.csv if it exists")
    _add_step(parser)
    parser.set_defaults(run=_simulate)


def _simulate(words: argparse.Namespace) -> int:
    from kitemj.flight.output import check_new, write_csv
    from kitemj.flight.scenario import read_scenario
    from kitemj.flight.simulate import simulate
    from kitemj.flight.validity import Ending

    check_new(words.output, words.overwrite)
    flight = simulate(read_scenario(words.scenario), words.model, words.step)
    write_csv(words.output, flight.motions, words.overwrite)
    print(f"{words.output}: {len(flight.motions)} rows, {flight.model}; {flight.ending.value}")
    if flight.departure:
        print(f"left the limits of validity at {flight.departure}")
    if flight.ending is Ending.DIVERGED:
        print(f"kitemj: {flight.note}", file=sys.stderr)
        return 1
    return 0


def _add_compare(commands: "argparse._SubParsersAction[Parser]") -> None:
    parser = _command(
        commands,
        "compare",
        "fly a scenario through the models and print how far apart they are",
        "kitemj compare scenarios/steer_200m.toml",
    )
    parser.add_argument("scenario", type=Path, nargs="+", help="scenario files (TOML)")
    parser.add_argument(
        "--models", default=",".join(MODELS), metavar="A,B", help="the last one is the reference"
    )
    parser.add_argument("--markdown", type=Path, metavar="FILE.md", help="write the table as well")
    parser.add_argument("--overwrite", action="store_true", help="replace FILE.md if it exists")
    _add_step(parser)
    parser.set_defaults(run=_compare)


def _compare(words: argparse.Namespace) -> int:
    from kitemj.flight.compare import compare_models
    from kitemj.flight.compare_table import print_table, write_markdown
    from kitemj.flight.output import check_new
    from kitemj.flight.scenario import read_scenario

    if words.markdown:
        check_new(words.markdown, words.overwrite)
    scenarios = [read_scenario(path) for path in words.scenario]
    models = words.models.split(",")
    if len(models) < 2:
        raise InputError(f"--models needs two or more, got {words.models!r}")
    rows = [row for each in scenarios for row in compare_models(each, models, words.step)]
    print_table(rows)
    if words.markdown:
        write_markdown(words.markdown, rows, words.overwrite)
    return 0 if all(row.agrees for row in rows) else 1


def _add_film(commands: "argparse._SubParsersAction[Parser]") -> None:
    parser = _command(
        commands,
        "film",
        "fly a scenario with no screen and film it",
        "kitemj film scenarios/loops_20m.toml --output kite.mp4",
    )
    parser.add_argument("scenario", type=Path, help="a scenario file (TOML)")
    parser.add_argument("--output", type=Path, required=True, metavar="FILE.mp4")
    parser.add_argument("--overwrite", action="store_true", help="replace FILE.mp4 if it exists")
    parser.add_argument("--model", default="mujoco", help=f"one of {', '.join(MODELS)}")
    _add_picture(parser)
    _add_step(parser)
    parser.set_defaults(run=_film)


def _add_picture(parser: Parser) -> None:
    parser.add_argument("--view", default="chase", help="chase, pilot or side")
    parser.add_argument("--size", default="1280x720", metavar="WxH", help="default 1280x720")


def _size(text: str) -> tuple[int, int]:
    width, _, height = text.partition("x")
    if not (width.isdigit() and height.isdigit()):
        raise InputError(f"--size must be like 1280x720, got {text!r}")
    return int(width), int(height)


def _film(words: argparse.Namespace) -> int:
    from kitemj.cockpit.filming import film_scenario
    from kitemj.flight.output import check_new
    from kitemj.flight.scenario import read_scenario

    check_new(words.output, words.overwrite)
    scenario = read_scenario(words.scenario)
    size = _size(words.size)
    film_scenario(
        scenario, words.model, words.step, words.output, size, words.view, words.overwrite
    )
    return 0


def _add_fly(commands: "argparse._SubParsersAction[Parser]") -> None:
    parser = _command(
        commands,
        "fly",
        "fly in real time with a gamepad, the keys or the mouse; with no display, film a show",
        "kitemj fly scenarios/steer_80m.toml",
    )
    parser.epilog = (
        "Left stick, arrow keys or A/D, or the mouse with its button held: the lines.\n"
        "W/S or the right stick: let out and take in. V: view, R: start again, Esc: leave.\n\n"
        f"{parser.epilog}"
    )
    parser.add_argument("scenario", type=Path, nargs="?", help="a scenario file (TOML)")
    parser.add_argument("--duration", type=float, metavar="S", help="leave after S seconds")
    parser.add_argument("--headless", action="store_true", help="film a show, open no window")
    parser.add_argument("--film", type=Path, metavar="FILE.mp4", help="name of that film")
    parser.add_argument("--model", default="mujoco", help=f"one of {', '.join(MODELS)}")
    _add_picture(parser)
    _add_step(parser)
    parser.set_defaults(run=_fly)


def _fly(words: argparse.Namespace) -> int:
    from kitemj.cockpit.session import fly_session

    return fly_session(words, _size(words.size))
