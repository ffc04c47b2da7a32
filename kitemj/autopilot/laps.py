"""The phases of a path: climb to it, fly along it, untwist the lines."""

from math import cos, inf, isnan, nan, sin, tau

from kitemj.autopilot.follow import (
    NEAR,
    Estimate,
    at,
    follow,
    learn,
    length_of,
    nearest,
    vector_at,
)
from kitemj.autopilot.joining import ALIGNED, approach, pointed, soonest
from kitemj.autopilot.memory import Asked, Kite, Memory, ask_for, glider_of, to_point, upward
from kitemj.autopilot.sketch import begun
from kitemj.flight.live import TICK
from kitemj.paths.path import Path
from kitemj.paths.sphere import ahead_of, direction
from kitemj.physics.vectors import dot, norm, plus, times

SEARCH, SEARCHED = 0.5, 12.0
"""rad of azimuth, s; how far and how long to a side and back a way is looked for from the top."""
MATCHED = 1.0
"""rad/s between how the nose turns and how the path does, at most, when it is joined."""
CAPTURED, STEADY = 0.035, 0.2
"""rad off the path and of the course to its, at most, when the kite is on it."""
LOST, ACROSS = 0.2, 1.2
"""rad off the path, and of the course to its; who is farther away joins it anew."""
PLANNED = 0.3
"""s; so often the way to the path is looked for anew."""
SAFE = 1.0
"""Of the height of the path's lowest place, what a way to it must keep."""


def climb(kite: Kite, seen: Estimate, memory: Memory) -> Asked:
    """From wherever it is to the path, on a way that bends into it; beside it, along it."""
    if isnan(memory.progress) and not beside(kite.path, seen):
        return join(kite, seen, memory, kite.path)
    if not isnan(memory.progress) and lost(kite, seen, memory):
        return join(kite, seen, memory._replace(progress=nan), kite.path)
    return along(kite, seen, memory, kite.path)


def joined(kite: Kite, seen: Estimate, memory: Memory) -> bool:
    """Once the kite is on the path and flies as it goes."""
    if isnan(memory.progress) or distance(kite.path, seen, memory.progress) > CAPTURED:
        return False
    return flies_as(kite.path, seen, memory.progress) > cos(STEADY)


def path(kite: Kite, seen: Estimate, memory: Memory) -> Asked:
    """Along the path, and learning."""
    return along(kite, seen, memory, kite.path)


def flown(kite: Kite, seen: Estimate, memory: Memory) -> bool:
    """Once the laps that were asked for are flown."""
    return 0.0 < kite.settings.laps <= laps(kite, memory)


def lost(kite: Kite, seen: Estimate, memory: Memory) -> bool:
    """Once the kite is too far from the path to follow it, or flies across it or back."""
    astray = flies_as(kite.path, seen, memory.progress) < cos(ACROSS)
    return astray or distance(kite.path, seen, memory.progress) > LOST


def join(kite: Kite, seen: Estimate, memory: Memory, path: Path) -> Asked:
    """The way to `path`; where there is none from here, up and from side to side, to find one."""
    glider, way = glider_of(kite, seen, memory), memory.way
    now = begun(glider, seen)
    if not memory.t < memory.planned + PLANNED:
        lowest = kite.length * float(path.points[:, 2].min())
        way = soonest(glider, path, seen, way, max(kite.low, SAFE * lowest))
        memory = memory._replace(planned=memory.t)
    left = way._replace(first=max(0.0, way.first - TICK))
    if not way.after < inf:
        memory = memory._replace(way=left)
        if cos(seen.course) >= 0.0:
            aside = SEARCH * sin(tau * (memory.t - memory.since) / SEARCHED)
            return to_point(kite, seen, memory._replace(refused=0.0), aside)
        up, side, _ = upward(kite, seen, memory)
        return Asked(up, memory._replace(refused=side))
    if way.first > 0.0:
        turning = pointed(glider, now, way.heading)
        aim = now.nose
        return Asked(ask_for(turning, aim, nan), memory._replace(way=left))
    asked = approach(glider, path, now, way.progress)
    aim = vector_at(path, path.points, asked.progress)
    left = left._replace(progress=asked.progress)
    return Asked(ask_for(asked.turning, aim, asked.error), memory._replace(way=left))


def along(kite: Kite, seen: Estimate, memory: Memory, path: Path) -> Asked:
    """Along `path` from where it was followed last, else from the nearest place."""
    before = memory.progress
    if isnan(before):
        p = direction(seen.azimuth, seen.elevation)
        before = nearest(path, p, ahead_of(p, seen.course))
        memory = memory._replace(began=before)
    learnt = memory.learnt
    asked = follow(path, kite.law, kite.gains, seen, before, learnt, kite.full)
    way = asked.progress - before
    learnt = learn(path, kite.law, kite.gains, seen, asked, way, learnt)
    memory = memory._replace(learnt=learnt)
    return Asked(asked, memory._replace(progress=asked.progress))


def laps(kite: Kite, memory: Memory) -> float:
    """Laps of the path flown so far, not whole; not a number before it was joined."""
    if isnan(memory.progress):
        return memory.laps
    return memory.laps + (memory.progress - memory.began) / length_of(kite.path)


def beside(path: Path, seen: Estimate) -> bool:
    """Whether the kite is near `path`, flies as it goes, and turns about as it turns."""
    p = direction(seen.azimuth, seen.elevation)
    progress = nearest(path, p, ahead_of(p, seen.course))
    apart = seen.speed * at(path, path.turning, progress) - seen.turning
    aligned = flies_as(path, seen, progress) > cos(ALIGNED)
    return aligned and abs(apart) < MATCHED and distance(path, seen, progress) < NEAR


def flies_as(path: Path, seen: Estimate, progress: float) -> float:
    """The cosine of the angle between the kite's course and the path's at `progress` [rad]."""
    ahead = ahead_of(direction(seen.azimuth, seen.elevation), seen.course)
    return dot(ahead, vector_at(path, path.ahead, progress))


def distance(path: Path, seen: Estimate, progress: float) -> float:
    """rad to the place `progress` [rad] of the path."""
    p = direction(seen.azimuth, seen.elevation)
    return norm(plus(p, times(-1.0, vector_at(path, path.points, progress))))
