"""Whatever was not foreseen: one sentence, and a file with all that is needed to mend it."""

import os
import platform
import sys
import tempfile
import threading
import traceback
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib.metadata import version
from pathlib import Path
from typing import Any

from kitemj.console import complain
from kitemj.signals import interrupt_again, interrupted

UNFORESEEN = 70
"""The exit status; EX_SOFTWARE of sysexits.h."""


def report(error: BaseException, words: Sequence[str]) -> None:
    """Says in one sentence that `error` was not foreseen, and where the details are.

    `words`: of the command line.
    """
    what = f"{type(error).__name__}: {error}".rstrip(": ")
    try:
        details = f"they are in {_file(error, words)}: report the fault with that file"
    except OSError as refused:
        details = f"they could not be written ({refused.strerror or refused})"
    complain(f"this should not happen, and is a fault of the program ({what}); details: {details}")


@contextmanager
def reporting(words: Sequence[str]) -> Iterator[None]:
    """Meanwhile a fault in a thread, or of something that is being thrown away, is reported."""
    before = threading.excepthook, sys.unraisablehook

    def hook(fault: Any) -> None:
        if isinstance(fault.exc_value, KeyboardInterrupt):
            # it came while something was thrown away, and is lost with it: once more
            interrupt_again()
        elif not (interrupted() or isinstance(fault.exc_value, SystemExit | None)):
            report(fault.exc_value, words)

    threading.excepthook = sys.unraisablehook = hook
    try:
        yield
    finally:
        threading.excepthook, sys.unraisablehook = before


def _file(error: BaseException, words: Sequence[str]) -> Path:
    """A new file in the temporary folder: command line, versions, machine, and the traceback."""
    facts = (
        f"kitemj {version('kitemj')}: {list(words)}",
        f"Python {sys.version}",
        f"{platform.platform()}, {os.cpu_count()} cores",
        "".join(traceback.format_exception(error)),
    )
    handle, name = tempfile.mkstemp(prefix="kitemj-fault-", suffix=".txt")
    os.close(handle)
    path = Path(name)
    path.write_text("\n".join(facts), encoding="utf-8", errors="replace")
    return path
