"""The command `kitemj`: thin; the subcommands are in `kitemj.commands`."""

import os
import sys
import time
from collections.abc import Sequence
from importlib import import_module
from importlib.metadata import version

from kitemj.commands.arguments import Parser, add_command
from kitemj.errors import FlightError, InputError, NoGraphics
from kitemj.registry import use
from kitemj.signals import orderly

COMMANDS = (
    *("fly", "simulate", "compare", "film", "replay", "info", "plot", "limits"),
    *("trim", "stability", "sweep", "pad", "reach", "realtime", "thesis"),
)


@orderly
def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command line; returns the exit status: 0 done, 1 a no, 2 bad input."""
    called = time.perf_counter()
    words = _parser().parse_args(arguments)
    words.called = called
    try:
        for module in words.use:
            use(module)
        return int(words.run(words) or 0)
    except InputError as error:
        print(f"kitemj: {error.worded(words.parser.words)}", file=sys.stderr)
        return 2
    except (FileExistsError, FileNotFoundError, PermissionError) as error:
        print(f"kitemj: {error}", file=sys.stderr)
        return 2
    except (FlightError, NoGraphics) as error:
        print(f"kitemj: {error}", file=sys.stderr)
        return 1
    except BrokenPipeError:  # whoever read what we print has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0


def _parser() -> Parser:
    says = "A two-line kite in MuJoCo, flown in real time beside a reference."
    parser = Parser(prog="kitemj", description=says)
    parser.add_argument("--version", action="version", version=f"kitemj {version('kitemj')}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for name in COMMANDS:
        add_command(commands, name, import_module(f"kitemj.commands.{name}"))
    return parser
