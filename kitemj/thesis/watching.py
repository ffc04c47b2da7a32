"""A picture painted while a flight goes on, at a rate of its own."""

import time
from typing import NamedTuple

from kitemj.cockpit.picture import Picture, Readings
from kitemj.thesis.programmed_pacer import ProgrammedPacer


class Painted(NamedTuple):
    """A frame: begun at `t` [s] of the flight, painted in `duration` [s]."""

    t: float
    duration: float


def watch(pacer: ProgrammedPacer, picture: Picture, interval: float, begun: float) -> list[Painted]:
    """Paints every `interval` [s], or as soon as that can be done, until the flight ends.

    `begun` [s, perf_counter]: when the flight began.
    """
    frames: list[Painted] = []
    due = time.perf_counter()
    while pacer.is_alive():
        painting, moment = time.perf_counter(), pacer.moment
        picture.paint(moment.motion, moment.reference, readings_of(pacer, painting))
        done = time.perf_counter()
        frames.append(Painted(painting - begun, done - painting))
        pacer.history.add_frame(painting, done - painting)
        due = max(due + interval, done)
        pacer.join(due - done)
    return frames


def readings_of(pacer: ProgrammedPacer, now: float) -> Readings:
    """What the cockpit shows of the flight as it is at `now` [s, perf_counter]."""
    moment, times = pacer.moment, pacer.times
    return Readings(
        model=pacer.flight.kite.name,
        gap=moment.gap,
        delta_command=moment.wish,
        missed_ticks=times.missed,
        lateness=times.lateness,
        stick="programme",
        traces=pacer.history.traces(now),
    )
