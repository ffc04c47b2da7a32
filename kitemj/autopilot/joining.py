"""Where a path is joined, and on which way: a great circle that bends into the path."""

from math import acos, inf
from typing import NamedTuple

from kitemj.autopilot.follow import Estimate, length_of, vector_at
from kitemj.autopilot.nose import within_half_turn
from kitemj.autopilot.paths import Path
from kitemj.autopilot.sphere import course, direction, tangential
from kitemj.physics.compiled import compiled
from kitemj.physics.vectors import Vector, dot, norm, plus, times

PLACES = 48
"""Of a path, at which it may be joined."""
BEFORE = 0.4
"""Of the way that is left, so far before the place it is aimed, so that the way bends into the
path."""
TURN, ARRIVAL = 0.25, 0.6
"""rad of way that a rad of turning is worth, now and on arrival: who turns less arrives sooner."""
STAY = 0.15
"""rad of way by which another place must be better."""


class Joining(NamedTuple):
    """The way to a path: the place `progress` [rad] where it is joined, and what is aimed at."""

    progress: float
    aim: Vector


@compiled
def aim_at(path: Path, p: Vector, progress: float) -> Vector:
    """What is aimed at, from `p`, to join at `progress` [rad]."""
    place = vector_at(path, path.points, progress)
    left = acos(max(-1.0, min(1.0, dot(p, place))))
    before = plus(place, times(-BEFORE * left, vector_at(path, path.ahead, progress)))
    return times(1.0 / norm(before), before)


@compiled
def course_to(p: Vector, aim: Vector) -> float:
    """The course [rad] of the great circle from `p`."""
    return course(p, tangential(p, aim))


@compiled
def effort(path: Path, p: Vector, heading: float, progress: float) -> float:
    """What joining at `progress` [rad] takes, as a way [rad]."""
    place, ahead = vector_at(path, path.points, progress), vector_at(path, path.ahead, progress)
    left = acos(max(-1.0, min(1.0, dot(p, place))))
    there = course_to(p, aim_at(path, p, progress))
    back = tangential(place, times(-1.0, p))
    back = times(1.0 / max(norm(back), 1e-9), back)
    askew = acos(max(-1.0, min(1.0, dot(back, ahead))))
    return float(left + TURN * abs(within_half_turn(there - heading)) + ARRIVAL * askew)


@compiled
def joining(path: Path, seen: Estimate, before: float) -> Joining:
    """How to join `path`, so far to be joined at `before` [rad] (not a number: nowhere)."""
    p, best, found = direction(seen.azimuth, seen.elevation), inf, before
    if before == before:
        best = effort(path, p, seen.heading, before) - STAY
    for i in range(PLACES):
        progress = i * length_of(path) / PLACES
        took = effort(path, p, seen.heading, progress)
        if took < best:
            best, found = took, progress
    return Joining(found, aim_at(path, p, found))
