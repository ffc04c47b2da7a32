"""The command `kitemj`: thin; the subcommands are in `kitemj.commands`."""

import errno
import sys
import time
from collections.abc import Sequence
from importlib import import_module
from importlib.metadata import version

from kitemj.commands.arguments import Parser, add_command
from kitemj.console import complain, flush, let_go, take_any_letter
from kitemj.errors import (
    NOT_WRITTEN,
    FlightError,
    InputError,
    NoGraphics,
    NothingFound,
    lacks_memory,
)
from kitemj.last_resort import UNFORESEEN, report, reporting
from kitemj.registry import use
from kitemj.signals import interrupted, orderly

COMMANDS = (
    *("fly", "simulate", "compare", "film", "replay", "info", "plot", "limits"),
    *("trim", "stability", "identify", "margins", "sweep", "pad", "reach", "realtime", "thesis"),
)

REFUSED = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EROFS)
"""The disk is full, or fails."""
NAMED = (
    *(FileExistsError, FileNotFoundError, PermissionError),
    *(IsADirectoryError, NotADirectoryError),
)
MISNAMED = (errno.ENAMETOOLONG, errno.ELOOP, errno.ENXIO)
"""A file is not what its name is given for."""


@orderly
def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command line; returns the exit status.

    0 done, 1 a no, 2 bad input, 70 a fault of the program's, 74 the system refused to write,
    128 + n ended by signal n.
    """
    called = time.perf_counter()
    words = sys.argv[1:] if arguments is None else list(arguments)
    take_any_letter()
    try:
        with reporting(words):
            return _run(words, called)
    except BrokenPipeError:  # whoever read what we print has seen enough
        return 0
    except (FlightError, NoGraphics) as error:
        complain(str(error))
        return 1
    except Exception as error:
        if interrupted():  # which comes out of compilers and imports as an error of theirs
            raise KeyboardInterrupt from error
        return _refused(error, words)
    finally:
        let_go()


def _run(words: Sequence[str], called: float) -> int:
    """The exit status of the command that `words` ask for; InputErrors are told."""
    args = _parser().parse_args(words)
    args.called = called
    try:
        for module in args.use:
            use(module)
        status = int(args.run(args) or 0)
        flush()
    except InputError as error:
        complain(error.worded(args.parser.words))
        return 1 if isinstance(error, NothingFound) else 2
    return status


def _refused(error: Exception, words: Sequence[str]) -> int:
    """The exit status for what the system does not do, which is told."""
    if lacks_memory(error):
        why = f" ({error})" if str(error) else ""
        needs = "a flight takes some 0.3 GB, a picture 0.4 GB"  # peaks, x86-64 Linux
        complain(f"there is not enough memory{why}: {needs}; ask for fewer rows, flights or pixels")
    elif isinstance(error, OSError) and error.errno in REFUSED:
        complain(f"cannot write {error.filename or 'standard output'}: {error.strerror}")
        return NOT_WRITTEN
    elif isinstance(error, OSError) and (isinstance(error, NAMED) or error.errno in MISNAMED):
        complain(f"{error.filename}: {error.strerror}" if error.filename else str(error))
        return 2
    else:
        report(error, words)
    return UNFORESEEN


def _parser() -> Parser:
    says = "A two-line kite in MuJoCo, flown in real time beside a reference."
    parser = Parser(prog="kitemj", description=says)
    parser.add_argument("--version", action="version", version=f"kitemj {version('kitemj')}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for name in COMMANDS:
        add_command(commands, name, import_module(f"kitemj.commands.{name}"))
    return parser
