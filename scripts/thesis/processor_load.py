"""How many processor cores other programs use while a time is measured."""

import os
import time
from math import nan
from multiprocessing import active_children
from pathlib import Path
from typing import NamedTuple


class ProcessorTime(NamedTuple):
    """At the time `wall` [s]: processor time [s] used by this program and by all, ever.

    `own` is that of this process and of those that it began and that still run. Both are not a
    number where the system does not tell (only Linux does, in files).
    """

    wall: float
    own: float
    everyone: float


def processor_time(proc: Path = Path("/proc")) -> ProcessorTime:
    """What was done until now."""
    children = sum(_of_process(proc / str(child.pid) / "stat") for child in active_children())
    return ProcessorTime(
        time.perf_counter(), time.process_time() + children, _of_all(proc / "stat")
    )


def other_load(before: ProcessorTime, after: ProcessorTime) -> float:
    """How many cores others used in between, on average; by clocks of 10 ms."""
    own, everyone = after.own - before.own, after.everyone - before.everyone
    cores = (everyone - own) / (after.wall - before.wall)
    return max(cores, 0.0)  # in this order: not a number stays what it is


def _of_all(stat: Path) -> float:
    """All work of the machine [s], that of its host for others included."""
    try:
        words = stat.read_text(encoding="ascii").split("\n", 1)[0].split()[1:]
    except OSError:
        return nan
    user, nice, system, _idle, _waiting, hard, soft, stolen = map(int, words[:8])
    return (user + nice + system + hard + soft + stolen) / os.sysconf("SC_CLK_TCK")


def _of_process(stat: Path) -> float:
    """The work [s] of one process."""
    try:
        words = stat.read_text(encoding="utf-8").rpartition(")")[2].split()
    except OSError:
        return nan
    user, system = int(words[11]), int(words[12])
    return (user + system) / os.sysconf("SC_CLK_TCK")
