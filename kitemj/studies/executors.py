"""Executors of a study: processes of this machine, or the workers of a Dask cluster."""

import os
import signal
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context, parent_process
from threading import Thread
from typing import Any, Protocol

from kitemj.errors import InputError
from kitemj.studies.design import Point
from kitemj.studies.flights import Row, fly_all
from kitemj.studies.study import Base

PATIENCE = 10
"""s; how long a scheduler may take to answer, and its first worker to come."""

SHORT = 5.0
"""s of work, for which it takes longer to start processes (some 3 s) and fly there."""


class StudyExecutor(Protocol):
    """Workers that fly what they are given; `deaths` are what a lost worker raises."""

    workers: int
    name: str
    deaths: tuple[type[BaseException], ...]

    def submit(self, base: Base, flights: list[tuple[int, Point]]) -> "Future[list[Row]]":
        """A future of the rows of these flights."""

    def renew(self) -> None:
        """Replaces a worker that was lost."""


class LocalExecutor:
    """Processes, started afresh (not forked) so that they are the same on every system."""

    deaths: tuple[type[BaseException], ...] = (BrokenExecutor,)

    def __init__(self, workers: int) -> None:
        self.workers, self.name = workers, f"{workers} process{'es' if workers > 1 else ''}"
        self._pool: Executor = self._new()

    def _new(self) -> Executor:
        return ProcessPoolExecutor(self.workers, get_context("spawn"), _prepare)

    def submit(self, base: Base, flights: list[tuple[int, Point]]) -> "Future[list[Row]]":
        """See `StudyExecutor`."""
        return self._pool.submit(fly_all, base, flights)

    def renew(self) -> None:
        """See `StudyExecutor`."""
        self.close()
        self._pool = self._new()

    def close(self) -> None:
        """Lets the processes end."""
        self._pool.shutdown(wait=True, cancel_futures=True)


class InProcessExecutor:
    """This process itself: soonest for a few flights."""

    workers, name = 1, "this process"
    deaths: tuple[type[BaseException], ...] = ()

    def submit(self, base: Base, flights: list[tuple[int, Point]]) -> "Future[list[Row]]":
        """See `StudyExecutor`; the rows are there at once."""
        future: Future[list[Row]] = Future()
        future.set_result(fly_all(base, flights))
        return future

    def renew(self) -> None:
        """See `StudyExecutor`."""


def _prepare() -> None:
    """Prepares a worker to end its flights on an interrupt, and itself when its parent dies."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


class DaskExecutor:
    """The workers of a cluster; the scheduler itself replaces those that are lost."""

    def __init__(self, client: Any, deaths: tuple[type[BaseException], ...]) -> None:
        self.deaths = deaths
        self.workers = sum(client.ncores().values())
        self.name = f"{self.workers} thread{'s' if self.workers > 1 else ''} of the cluster"
        self._pool: Executor = client.get_executor(pure=False)

    def submit(self, base: Base, flights: list[tuple[int, Point]]) -> "Future[list[Row]]":
        """See `StudyExecutor`."""
        return self._pool.submit(fly_all, base, flights)

    def renew(self) -> None:
        """See `StudyExecutor`."""


@contextmanager
def local_executor(processes: int | None = None) -> Iterator[StudyExecutor]:
    """A process for each core that this one may use, unless `processes` says otherwise."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    if processes is not None and processes < 1:
        raise InputError(f"`processes` must be >= 1, got {processes}")
    executor = LocalExecutor(processes or cores or 1)
    try:
        yield executor
    finally:
        executor.close()


@contextmanager
def executor_for(seconds: float, processes: int | None) -> Iterator[StudyExecutor]:
    """What flies `seconds` [s] of work soonest, unless a number of `processes` is asked for."""
    if processes is None and seconds < SHORT:
        yield InProcessExecutor()
        return
    with local_executor(processes) as executor:
        yield executor


@contextmanager
def dask_executor(address: str) -> Iterator[StudyExecutor]:
    """The workers of the Dask scheduler at `address` (``tcp://host:8786``).

    Raises InputError where dask is not installed, or scheduler or workers do not answer.
    """
    try:
        from distributed import Client, KilledWorker
    except ImportError:
        raise InputError('a cluster needs dask: pip install "kitemj[cluster]"') from None
    try:
        client = Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise InputError(
            f"no Dask scheduler answers at {address} ({error}); start one with: dask scheduler"
        ) from None
    with client:
        try:
            client.wait_for_workers(1, timeout=PATIENCE)
        except TimeoutError:
            raise InputError(
                f"the scheduler at {address} has no workers; start one with: dask worker {address}"
            ) from None
        yield DaskExecutor(client, (KilledWorker,))
