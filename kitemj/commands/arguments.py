"""Words that several subcommands share."""

import argparse
import re
import sys
from math import isfinite, nan
from pathlib import Path
from types import ModuleType
from typing import Any, NoReturn

from kitemj.console import complain, flush
from kitemj.controls.actions import VIEWS
from kitemj.dynamics.formulation import DEFAULT_STEP
from kitemj.dynamics.formulation import MODELS as REGISTRY
from kitemj.errors import InputError

LEAST_SIDE, MOST_SIDE = 16, 8192
"""px; of a picture: below, nothing shows; beyond, neither H.264 nor graphics cards go along."""
MODELS = tuple(REGISTRY.shipped)
QUALITY_NAMES = ("auto", "low", "medium", "high")
SCENARIO = "a scenario file (TOML), or the name of one that ships: steer_200m"


class Parser(argparse.ArgumentParser):
    """One line for bad words, like for any other bad input."""

    def __init__(self, *given: Any, **named: Any) -> None:
        super().__init__(*given, **named)
        self.register("type", float, _finite)
        self.register("type", Path, _path)

    def _print_message(self, message: str, file: Any = None) -> None:
        """As argparse does, but a full disk and a closed pipe are not passed over."""
        print(message, end="", file=file or sys.stderr)

    def exit(self, status: int = 0, message: str | None = None) -> NoReturn:
        """After all that was printed has got out."""
        flush()
        super().exit(status, message)

    def error(self, message: str) -> NoReturn:
        """Exit status 2."""
        complain(f"{message}; see {self.prog} --help")
        self.exit(2)

    @property
    def words(self) -> dict[str, str]:
        """What a person types for an argument: `--step` for step."""
        return {each.dest: each.option_strings[0] for each in self._actions if each.option_strings}


def add_command(
    commands: "argparse._SubParsersAction[Parser]", name: str, module: ModuleType
) -> None:
    """Adds the subcommand of a module: its `HELP`, `EXAMPLE`, `NOTES`, arguments, and ``--use``."""
    notes = f"{module.NOTES}\n\n" if hasattr(module, "NOTES") else ""
    parser = commands.add_parser(
        name,
        help=module.HELP,
        description=module.HELP,
        epilog=f"{notes}example:\n  {module.EXAMPLE}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    says = "a module of your own, which adds laws of the air, winds, models or pilots"
    parser.add_argument("--use", action="append", default=[], metavar="MODULE", help=says)
    module.add(parser)
    parser.set_defaults(parser=parser, run=module.run)


def add_json(parser: Parser) -> None:
    """``--json``."""
    parser.add_argument("--json", action="store_true", help="print one JSON document, for machines")


def add_step(parser: Parser) -> None:
    """``--step``."""
    says = f"longest step [s], default {DEFAULT_STEP:g}"
    parser.add_argument("--step", type=float, default=DEFAULT_STEP, metavar="S", help=says)


def add_pilot(parser: Parser) -> None:
    """``--pilot``."""
    says = "has the stick: hold, loop, eight, assist, land, show, or your own as FILE.py:NAME"
    parser.add_argument("--pilot", metavar="WHO", help=says)


def add_picture(parser: Parser, usual: str = "") -> None:
    """``--view`` and ``--size``; `usual`: the sizes of films, which depend on their kind."""
    parser.add_argument("--view", choices=VIEWS, default=VIEWS[0], help="where from")
    default = None if usual else "1280x720"
    says = f"default {usual or default}"
    parser.add_argument("--size", default=default, metavar="WxH", help=says)


def add_quality(parser: Parser) -> None:
    """``--quality``."""
    says = "of the picture; auto: what this machine paints at 30 frames/s"
    parser.add_argument("--quality", choices=QUALITY_NAMES, default="auto", help=says)


def size(text: str) -> tuple[int, int]:
    """(width, height) [px] of a text like 1280x720; InputError for any other."""
    sides = re.fullmatch("([0-9]{1,5})x([0-9]{1,5})", text)
    if not sides or not all(LEAST_SIDE <= int(side) <= MOST_SIDE for side in sides.groups()):
        known = f"like 1280x720, each side {LEAST_SIDE} to {MOST_SIDE}"
        raise InputError(f"--size must be {known}, got {text!r}")
    return int(sides[1]), int(sides[2])


def number(text: str, word: str) -> float:
    """The number that `text` says; InputError, which names `word`, where it is none."""
    try:
        return _finite(text)
    except argparse.ArgumentTypeError as error:
        raise InputError(f"{word} {error}") from None


def _finite(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = nan
    if not isfinite(value):
        raise argparse.ArgumentTypeError(f"must be a number, got {text!r}")
    return value


def _path(text: str) -> Path:
    if not text or "\0" in text:
        raise argparse.ArgumentTypeError(f"must be the name of a file, got {text!r}")
    return Path(text)
