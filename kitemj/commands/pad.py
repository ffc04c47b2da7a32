"""`kitemj pad`: which control of a gamepad does what."""

import argparse
from contextlib import suppress
from pathlib import Path
from typing import Any

from kitemj.commands.arguments import Parser

HELP = "ask for each control of a gamepad that has no known layout, and keep the answers"
EXAMPLE = "kitemj pad --list"


def add(parser: Parser) -> None:
    """Adds its arguments."""
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--list", action="store_true", help="which pads there are, who knows them")
    what.add_argument("--show", action="store_true", help="what they say now, until Ctrl-C")
    parser.add_argument("--settings", type=Path, metavar="FILE", help="default: the user's own")
    parser.add_argument("--overwrite", action="store_true", help="replace a damaged file")


def run(args: argparse.Namespace) -> None:
    """Lists the pads, shows what they say, or asks for a layout."""
    from kitemj.controls.pad_terminal import joysticks, show, summary
    from kitemj.controls.settings import settings_or_defaults, settings_path

    path = args.settings or settings_path()
    settings, problem = settings_or_defaults(path)
    with joysticks() as pads:
        if problem and (args.list or args.show):
            print(problem)
        if args.list:
            print(summary(pads, settings, path))
        elif args.show:
            print("Ctrl-C ends")
            with suppress(KeyboardInterrupt):
                show(pads, settings)
        else:
            _set_up(pads, path, args.overwrite)


def _set_up(pads: list[Any], path: Path, overwrite: bool) -> None:
    from kitemj.controls.pad_terminal import ask, choose, typed_lines
    from kitemj.controls.settings import check_writable, write_layout

    check_writable(path, overwrite)
    typed = typed_lines()
    pad, rest = choose(pads)
    print(f"the pad {pad.get_name()}: Enter skips a question, D and Enter skips the rest")
    write_layout(path, pad.get_guid(), ask(pad, rest, typed, print), overwrite)
    print(f"written to {path}; kitemj fly uses it")
