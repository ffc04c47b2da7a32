"""A process that works for this one, and ends with it, however that ends.

Only a pipe joins them: no shared memory and no semaphore, which a system may lack, and which a
killed program would leave behind.
"""

import atexit
import os
import signal
import time
from collections.abc import Callable
from contextlib import suppress
from multiprocessing import get_context, parent_process
from multiprocessing.connection import Connection
from threading import Thread
from typing import Any

from kitemj.closing import Closing
from kitemj.signals import ENDING

GRACE = 10.0
"""s; that a child may take to complete what it does, once nobody is at the other end."""


class Child(Closing):
    """A process, started afresh, that does `work(link, *given)`; `link` leads to its own.

    Signals are this process's to obey; a closed `link` (EOFError there) tells the child to end.
    """

    def __init__(self, work: Callable[..., None], *given: Any) -> None:
        context = get_context("spawn")
        self.link, theirs = context.Pipe()
        self._process = context.Process(target=_run, args=(work, theirs, given), daemon=True)
        self._process.start()
        theirs.close()
        atexit.register(self.close)

    @property
    def pid(self) -> int:
        """Of the process."""
        return self._process.pid or 0

    def wake(self) -> None:
        """Has it go on if somebody stopped it."""
        if hasattr(signal, "SIGCONT"):
            with suppress(ProcessLookupError):
                os.kill(self.pid, signal.SIGCONT)

    def kill(self) -> None:
        """Ends it at once; `link` says EOFError then."""
        self._process.kill()

    def close(self) -> None:
        """Lets it end, and ends it after `GRACE`."""
        atexit.unregister(self.close)
        self.link.close()
        self._process.join(GRACE)
        self._process.kill()
        self._process.join()


def end_with_parent(grace: float) -> None:
    """From now on this process ends `grace` [s] after the one that started it."""
    parent = parent_process()
    if parent is not None:
        Thread(target=_end_after, args=(parent.join, grace), daemon=True).start()


def _end_after(join: Callable[[], None], grace: float) -> None:
    join()
    time.sleep(grace)
    os._exit(1)


def _run(work: Callable[..., None], link: Connection, given: tuple[Any, ...]) -> None:
    for number in ENDING:
        signal.signal(number, signal.SIG_IGN)  # they go to all at once; the parent tells us
    end_with_parent(GRACE)
    work(link, *given)
