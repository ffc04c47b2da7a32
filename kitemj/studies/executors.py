"""Executors of a study: processes of this machine, or the workers of a Dask cluster."""

import asyncio
import os
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
from contextlib import closing, contextmanager
from multiprocessing import get_context
from typing import Any

from kitemj.child import end_with_parent
from kitemj.errors import InputError
from kitemj.signals import ENDING
from kitemj.studies.design import Point
from kitemj.studies.flights import Row, fly_all
from kitemj.studies.study import Base

PATIENCE = 10
"""s; how long a scheduler may take to answer, and its first worker to come."""

SHORT = 5.0
"""s of work, for which it takes longer to start processes (some 3 s) and fly there."""
MOST_PROCESSES = 1024
"""Of one machine; each takes some 200 MB."""


class StudyExecutor:
    """Workers of a `pool` that fly what they are given; `deaths` are what a lost worker raises."""

    def __init__(
        self, workers: int, name: str, pool: Executor, deaths: tuple[type[BaseException], ...]
    ) -> None:
        self.workers, self.name, self.deaths, self._pool = workers, name, deaths, pool

    def submit(self, base: Base, flights: list[tuple[int, Point]]) -> "Future[list[Row]]":
        """A future of the rows of these flights."""
        return self._pool.submit(fly_all, base, flights)

    def renew(self) -> None:
        """Replaces a worker that was lost, where the pool does not by itself."""


class LocalExecutor(StudyExecutor):
    """Processes, started afresh (not forked) so that they are the same on every system."""

    def __init__(self, workers: int) -> None:
        name = f"{workers} process{'es' if workers > 1 else ''}"
        super().__init__(workers, name, _processes(workers), (BrokenExecutor,))

    def renew(self) -> None:
        """New processes in place of all."""
        self.close()
        self._pool = _processes(self.workers)

    def close(self) -> None:
        """Lets the processes end."""
        self._pool.shutdown(wait=True, cancel_futures=True)


class InProcess(Executor):
    """This process itself: soonest for a few flights; what is submitted is done at once."""

    def submit(self, done: Callable[..., Any], /, *args: Any, **named: Any) -> "Future[Any]":
        """The future of a call that is over."""
        future: Future[Any] = Future()
        future.set_result(done(*args, **named))
        return future


def _processes(workers: int) -> Executor:
    return ProcessPoolExecutor(workers, get_context("spawn"), _prepare)


def _prepare() -> None:
    """Prepares a worker to end its flights on an interrupt, and itself when its parent dies."""
    for number in set(ENDING) - {signal.SIGTERM}:  # by which the pool ends it
        signal.signal(number, signal.SIG_IGN)
    end_with_parent(0.0)


@contextmanager
def local_executor(processes: int | None = None) -> Iterator[StudyExecutor]:
    """A process for each core that this one may use, unless `processes` says otherwise."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    if processes is not None and not 1 <= processes <= MOST_PROCESSES:
        raise InputError(f"`processes` must be >= 1 and <= {MOST_PROCESSES}, got {processes}")
    try:
        executor = LocalExecutor(processes or cores or 1)
    except OSError as error:
        name = (
            f"this process alone, as others lack semaphores ({error.strerror}: is /dev/shm there?)"
        )
        yield StudyExecutor(1, name, InProcess(), ())
        return
    with closing(executor):
        yield executor


@contextmanager
def executor_for(seconds: float, processes: int | None) -> Iterator[StudyExecutor]:
    """What flies `seconds` [s] of work soonest, unless a number of `processes` is asked for."""
    if processes is None and seconds < SHORT:
        yield StudyExecutor(1, "this process", InProcess(), ())
        return
    with local_executor(processes) as executor:
        yield executor


async def _reach(address: str) -> None:
    """Connects once, since a Dask client that cannot begin is half there and cries at the end."""
    from distributed.comm import connect
    from distributed.security import Security

    secrets = Security().get_connection_args("client")
    await (await connect(address, timeout=PATIENCE, **secrets)).close()


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
        asyncio.run(_reach(address))
        client = Client(address, timeout=PATIENCE, set_as_default=False)
    except Exception as error:  # of any kind: TypeError for a scheme that is not set up
        what, hint = f"no Dask scheduler answers at {address}", "start one with: dask scheduler"
        raise InputError(f"{what} ({error}); {hint}") from None
    with client:
        try:
            client.wait_for_workers(1, timeout=PATIENCE)
        except TimeoutError:
            hint = f"start one with: dask worker {address}"
            raise InputError(f"the scheduler at {address} has no workers; {hint}") from None
        workers = sum(client.ncores().values())
        name = f"{workers} thread{'s' if workers > 1 else ''} of the cluster"
        # the scheduler itself replaces workers that are lost
        yield StudyExecutor(workers, name, client.get_executor(pure=False), (KilledWorker,))
