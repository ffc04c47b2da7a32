"""Words that several subcommands share."""

import argparse
from types import ModuleType
from typing import NoReturn

from kitemj.controls.actions import VIEWS
from kitemj.dynamics.formulation import DEFAULT_STEP
from kitemj.dynamics.formulation import MODELS as REGISTRY
from kitemj.errors import InputError

MODELS = tuple(REGISTRY.shipped)
SCENARIO = "a scenario file (TOML), or the name of one that ships: steer_200m"


class Parser(argparse.ArgumentParser):
    """One line for bad words, like for any other bad input."""

    def error(self, message: str) -> NoReturn:
        """Exit status 2."""
        self.exit(2, f"kitemj: {message}; see {self.prog} --help\n")

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
    says = "has the stick: hold, loop, eight, land, or one of your own as FILE.py:NAME"
    parser.add_argument("--pilot", metavar="WHO", help=says)


def add_picture(parser: Parser) -> None:
    """``--view`` and ``--size``."""
    parser.add_argument("--view", choices=VIEWS, default=VIEWS[0], help="where from")
    parser.add_argument("--size", default="1280x720", metavar="WxH", help="default 1280x720")


def size(text: str) -> tuple[int, int]:
    """(width, height) [px] of a text like 1280x720; InputError for any other."""
    width, _, height = text.partition("x")
    if not (width.isdigit() and height.isdigit()):
        raise InputError(f"--size must be like 1280x720, got {text!r}")
    return int(width), int(height)


def number(text: str, word: str) -> float:
    """The number that `text` says; InputError, which names `word`, where it is none."""
    try:
        return float(text)
    except ValueError:
        raise InputError(f"{word} must be a number, got {text!r}") from None
