"""How busy other programs keep the machine: what a measured time has to be read beside."""

import os
import time
from math import nan
from pathlib import Path
from typing import NamedTuple


class Work(NamedTuple):
    """At the time `wall` [s]: processor time [s] used by this process and by all, ever.

    `everyone` is not a number where the system does not tell (only Linux does, in a file).
    """

    wall: float
    own: float
    everyone: float


def work(stat: Path = Path("/proc/stat")) -> Work:
    """What was done until now."""
    return Work(time.perf_counter(), time.process_time(), _everyone(stat))


def others(before: Work, after: Work) -> float:
    """How many cores others used in between, on average; by clocks of 10 ms."""
    own, everyone = after.own - before.own, after.everyone - before.everyone
    cores = (everyone - own) / (after.wall - before.wall)
    return max(cores, 0.0)  # in this order: not a number stays what it is


def _everyone(stat: Path) -> float:
    try:
        words = stat.read_text(encoding="ascii").split("\n", 1)[0].split()[1:]
    except OSError:
        return nan
    user, nice, system, _idle, _waiting, hard, soft, stolen = map(int, words[:8])
    ticks = user + nice + system + hard + soft + stolen
    return ticks / os.sysconf("SC_CLK_TCK")
