"""How long things take on a machine that others use too: medians, spread, ratios in one run."""

import os
import platform
import subprocess
import sys
from collections.abc import Callable, Sequence
from importlib.metadata import version
from pathlib import Path
from statistics import median, quantiles
from time import perf_counter, process_time
from typing import NamedTuple


class Spread(NamedTuple):
    """Median and the quartiles around it."""

    middle: float
    low: float
    high: float

    def __str__(self) -> str:
        """Three digits each."""
        return f"{self.middle:.3g} ({self.low:.3g}-{self.high:.3g})"

    def times(self, factor: float) -> "Spread":
        """In another unit."""
        return Spread(*(factor * value for value in self))


def spread(values: Sequence[float]) -> Spread:
    """Of two or more values."""
    low, _, high = quantiles(values, n=4, method="inclusive")
    return Spread(median(values), low, high)


def seconds(work: Callable[[], object]) -> float:
    """How long `work` takes."""
    started = perf_counter()
    work()
    return perf_counter() - started


def processor_seconds(work: Callable[[], object]) -> float:
    """How long the processor is at `work`, whoever else it serves meanwhile."""
    started = process_time()
    work()
    return process_time() - started


def interleaved(
    works: Sequence[Callable[[], object]],
    rounds: int,
    clock: Callable[[Callable[[], object]], float] = processor_seconds,
) -> list[list[float]]:
    """Times [s] of each of `works`, taken in turn, so that what disturbs one disturbs all."""
    for work in works:
        work()
    rows = [[clock(work) for work in works] for _ in range(rounds)]
    return [list(column) for column in zip(*rows, strict=True)]


def ratios(a: Sequence[float], b: Sequence[float]) -> Spread:
    """a over b, round by round."""
    return spread([x / y for x, y in zip(a, b, strict=True)])


def program(*words: str, rounds: int = 5, **environment: str) -> Spread:
    """Wall time [s] of ``python WORDS`` from its start to its end."""
    command = [sys.executable, *words]
    both = {**os.environ, **environment}

    def run() -> None:
        subprocess.run(command, env=both, check=True, capture_output=True)

    return spread(interleaved([run], rounds, seconds)[0])


def table(head: Sequence[str], rows: Sequence[Sequence[object]]) -> list[str]:
    """Markdown; the first column is text, the others are numbers."""
    rule = "|---|" + "---:|" * (len(head) - 1)
    return [
        "| " + " | ".join(head) + " |",
        rule,
        *("| " + " | ".join(map(str, row)) + " |" for row in rows),
        "",
    ]


def machine() -> str:
    """This machine and what runs on it, in a sentence."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.exists() else []
    models = [line.split(":")[1].strip() for line in lines if line.startswith("model name")]
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    packages = ", ".join(f"{name} {version(name)}" for name in ("mujoco", "numpy", "numba"))
    load = f"; load {os.getloadavg()[0]:.1f} at the start" if hasattr(os, "getloadavg") else ""
    return (
        f"{models[0] if models else platform.processor()}, {cores} cores, {platform.system()} "
        f"{platform.machine()}, Python {platform.python_version()}, {packages}{load}."
    )


def resident() -> float:
    """Memory of this process [MiB]."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20
