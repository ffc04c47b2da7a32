"""Sweeps: the flights of a study in batches on an executor, which may lose workers."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from time import perf_counter

from kitemj.errors import InputError
from kitemj.flight.scenario import scenario_of
from kitemj.studies.design import Point
from kitemj.studies.executors import StudyExecutor
from kitemj.studies.flights import Row, failed, fly
from kitemj.studies.journal import Journal
from kitemj.studies.study import Study

Batch = list[tuple[int, Point]]

LONG = 3600.0
"""s; what a flight is believed to take of which nothing is known: it goes out alone."""
BATCH_TIME = 0.5
"""s of work given out at once: long beside the giving, short beside a person's patience."""
MOST = 500
"""Flights in a batch."""


class StudyStopped(RuntimeError):  # noqa: N818  says what happened
    """Workers that cannot work at all, in one sentence; finished flights are kept."""


def check(study: Study) -> None:
    """Raises InputError where neither the first, the middle nor the last flight can begin."""
    errors = []
    for flight in {0, study.design.count // 2, study.design.count - 1}:
        try:
            scenario_of(study.base.at(study.design.point(flight))[0], study.base.source)
        except InputError as error:
            errors.append(error)
        else:
            return
    raise errors[0]


def tried(journal: Journal, count: int = 3) -> float:
    """Flies up to `count` of what remains, here and now; the mean time [s] of a flight.

    They are rows like all others. The first warms up, and counts only if it is alone.
    """
    costs = []
    for flight in _some(journal, count):
        started = perf_counter()
        row = fly(journal.study.base, flight, journal.study.design.point(flight))
        costs.append(perf_counter() - started)
        journal.add([row])
    return sum(costs[1:]) / len(costs[1:]) if len(costs) > 1 else costs[0]


def tried_together(journal: Journal, executor: StudyExecutor) -> float:
    """Flies a few of what remains, all workers at once; the mean time [s] of a flight and worker.

    They are rows like all others. The first for each worker warms it up and is not counted, so
    that what remains is estimated by what workers in flight get done together.
    """
    sweep(journal, executor, LONG, flights=_some(journal, executor.workers))
    flights = _some(journal, 2 * executor.workers)
    started = perf_counter()
    sweep(journal, executor, LONG, flights=flights)
    return (perf_counter() - started) * executor.workers / max(1, len(flights))


def _some(journal: Journal, count: int) -> list[int]:
    """Up to `count` of the flights that remain, from the first to the last."""
    remaining = list(journal.remaining())
    last = len(remaining) - 1
    places = {k * last // max(1, count - 1) for k in range(count)} if remaining else set()
    return [remaining[i] for i in sorted(places)]


def sweep(
    journal: Journal,
    executor: StudyExecutor,
    cost: float,
    tell: Callable[[int], None] = lambda done: None,
    flights: Sequence[int] | None = None,
) -> None:
    """Flies these `flights`, None: all that remain; `cost` [s] is what one is believed to take.

    `tell` is called with the number of flights done. On KeyboardInterrupt what is in the air
    is landed and kept. Raises StudyStopped where workers cannot work at all.
    """
    todo = list(journal.remaining()) if flights is None else flights
    most = len(todo) // (16 * executor.workers)
    size = max(1, min(MOST, int(BATCH_TIME / max(cost, 1e-6)), most))
    aloft: dict[Future[list[Row]], Batch] = {}
    suspects: Batch = []
    try:
        for batch in _batches(journal, todo, size):
            while len(aloft) >= 2 * executor.workers:
                suspects += _landed(journal, executor, aloft)
                tell(journal.count)
            try:
                aloft[executor.submit(journal.study.base, batch)] = batch
            except executor.deaths:  # one died since; those aloft are suspects, this one is not
                suspects += _landed(journal, executor, aloft)
                aloft[executor.submit(journal.study.base, batch)] = batch
        while aloft:
            suspects += _landed(journal, executor, aloft)
            tell(journal.count)
        for flight, point in suspects:
            _alone(journal, executor, flight, point)
            tell(journal.count)
    except KeyboardInterrupt:
        flying = [future for future in aloft if not future.cancel()]
        for future in wait(flying, timeout=20 * BATCH_TIME).done:
            if not future.cancelled() and future.exception() is None:
                journal.add(future.result())
        raise


def _batches(journal: Journal, flights: Sequence[int], size: int) -> Iterator[Batch]:
    for start in range(0, len(flights), size):
        yield [(i, journal.study.design.point(i)) for i in flights[start : start + size]]


def _landed(
    journal: Journal, executor: StudyExecutor, aloft: dict[Future[list[Row]], Batch]
) -> Batch:
    """Takes in the batches that are done; returns flights whose worker died."""
    landed = wait(aloft, return_when=FIRST_COMPLETED).done
    lost = any(isinstance(_error(future), executor.deaths) for future in landed)
    suspects: Batch = []
    for future in wait(aloft).done if lost else landed:
        batch = aloft.pop(future)
        if isinstance(_error(future), executor.deaths):
            suspects += batch
        else:
            journal.add(_rows(future))
    if lost:
        executor.renew()
    return suspects


def _error(future: Future[list[Row]]) -> BaseException | None:
    return None if future.cancelled() else future.exception()


def _rows(future: Future[list[Row]]) -> list[Row]:
    """The rows of a future. A flight never raises, so what does is the worker's own trouble."""
    try:
        return future.result()
    except (Exception, CancelledError) as error:
        raise StudyStopped(
            f"a worker cannot fly ({type(error).__name__}: {error}); "
            f"every worker needs the same kitemj as this machine"
        ) from None


def _alone(journal: Journal, executor: StudyExecutor, flight: int, point: Point) -> None:
    """Flies one flight at a time, to find out which of them ends the process that flies it."""
    future = executor.submit(journal.study.base, [(flight, point)])
    wait([future])
    if isinstance(_error(future), executor.deaths):
        journal.add([failed(flight, point, "the process that flew it died, twice")])
        executor.renew()
    else:
        journal.add(_rows(future))
