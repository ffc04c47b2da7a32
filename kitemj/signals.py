"""Signals that end the program: each is an orderly end, as Ctrl-C is, and the status tells which.

A terminal that is closed hangs up, a system that shuts down terminates: what is being written
is completed all the same, and nothing is left behind.
"""

import signal
import sys
from _thread import interrupt_main
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import wraps
from threading import Timer, current_thread, main_thread
from types import FrameType
from typing import ClassVar

from kitemj.console import complain

ENDING = tuple(getattr(signal, n) for n in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, n))
"""Those that ask a program to end."""
RESULTS = ("numba.core.serialize", "namedtuple_")
"""Modules in which compiled code makes its result, where numba does not survive an exception."""


class _Received:
    """The first signal that came (0: none), and whether what it asks for is put off, or was lost.

    `again`: what sends a signal once more, because its interrupt was lost.
    """

    first, held, due, lost = 0, 0, False, False
    again: ClassVar[list[Timer]] = []


def orderly(main: Callable[[Sequence[str] | None], int]) -> Callable[..., int]:
    """`main`, in which the first signal n of these is a KeyboardInterrupt, its status 128 + n."""

    @wraps(main)
    def run(arguments: Sequence[str] | None = None) -> int:
        if current_thread() is not main_thread():
            return main(arguments)
        _Received.first, _Received.held, _Received.due, _Received.lost = 0, 0, False, False
        before = {number: signal.getsignal(number) for number in ENDING}
        for number, handler in before.items():
            if handler not in (signal.SIG_IGN, None):  # nohup: who asked for that goes on
                signal.signal(number, _receive)
        status = 128 + signal.SIGINT
        try:
            status = main(arguments)
        except KeyboardInterrupt:
            _Received.held += 1
            with suppress(OSError):
                complain("interrupted; nothing was written")
        except OSError:
            if not _Received.first:
                raise  # otherwise the terminal is gone, and nobody can be told anything
        finally:
            _Received.held += 1  # what comes now has come too late
            while _Received.again:
                timer = _Received.again.pop()
                timer.cancel()
                timer.join()
            for number, handler in before.items():
                if handler is not None:
                    signal.signal(number, handler)
        if not _Received.first:
            return status
        exec("")  # else Python dies of SIGINT if the last text that it executed was interrupted
        return 128 + _Received.first

    return run


def interrupted() -> bool:
    """Whether a signal has come: what fails from now on may fail for that alone."""
    return _Received.first != 0


def _receive(number: int, frame: FrameType | None) -> None:
    """Interrupts once; a hangup is often followed by a second, or by a termination."""
    if _Received.first and number != signal.SIGINT and not _Received.lost:
        return
    _Received.first, _Received.lost = _Received.first or number, False
    if _Received.held:
        _Received.due = True
    elif frame and frame.f_back and _makes_result(frame):
        while frame.f_back and _makes_result(frame):
            frame = frame.f_back
        _interrupt_in(frame)
    else:
        raise KeyboardInterrupt


def _makes_result(frame: FrameType) -> bool:
    return str(frame.f_globals.get("__name__")).startswith(RESULTS)


def _interrupt_in(frame: FrameType) -> None:
    """Interrupts `frame` where it goes on."""
    before = sys.gettrace()

    def raising(*event: object) -> None:
        sys.settrace(before)
        raise KeyboardInterrupt

    sys.settrace(before or (lambda *event: None))
    frame.f_trace = raising


def interrupt_again() -> None:
    """Interrupts the main thread a moment from now: an interrupt was lost."""
    _Received.lost = True
    _Received.again.append(Timer(0.01, _interrupt))
    _Received.again[-1].start()


def _interrupt() -> None:
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(main_thread().ident or 0, _Received.first)
    else:
        interrupt_main(signal.Signals(_Received.first))


@contextmanager
def held() -> Iterator[None]:
    """Puts a signal's interrupt off until the block has ended."""
    _Received.held += 1
    try:
        yield
    finally:
        _Received.held -= 1
    if _Received.due and not _Received.held:
        _Received.due = False
        raise KeyboardInterrupt
