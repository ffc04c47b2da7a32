"""How a path is joined: approached where a sketch of the flight says that it is joined soonest."""

from math import atan2, cos, inf, radians, sin
from typing import NamedTuple

from kitemj.autopilot.follow import NEAR, Estimate, advanced, at, length_of, vector_at
from kitemj.autopilot.sketch import (
    LONG,
    STEP,
    Glider,
    Sketch,
    airspeed,
    begun,
    flown_on,
    most_turning,
    nose_for,
    off_nose,
    velocity,
)
from kitemj.paths.path import Path
from kitemj.paths.sphere import ahead_of, right_of, tangential
from kitemj.physics.compiled import compiled
from kitemj.physics.vectors import dot, minus, norm, plus, times
from kitemj.turning.gains import lead_time

PLACES = 4
"""Of a path, beside which it is approached: both sides of an eight, up and down."""
HEADINGS = (-1.2, -0.7, -0.2, 0.2, 0.7, 1.2)
"""rad from up, in which the kite may go first ..."""
FIRST = (0.0, 1.0, 2.0, 3.0)
"""s; ... for so long."""
OUTLOOK = 0.2
"""rad along the path to what is aimed at, at least."""
ALIGNED = radians(35.0)
"""Of the course to the path's, at most, when the path is joined."""
KEPT = 0.75
"""Of the height that a way must keep, what one must keep that is flown already."""
STAY = 0.5
"""s; so much sooner another place must be joined, to be flown to instead."""


class Joining(NamedTuple):
    """A way to a path: the nose to `heading` [rad] from up for `first` [s], and then to the path
    beside `progress` [rad]; joined `after` s, inf: never."""

    heading: float
    first: float
    progress: float
    after: float


NOWHERE = Joining(0.0, 0.0, 0.0, inf)
"""Before a way was looked for."""


class Approach(NamedTuple):
    """What a kite asks for on its way to a path: turn rate [rad/s], `progress` [rad] of the place
    beside it, `error` [rad] to the right of it."""

    turning: float
    progress: float
    error: float


@compiled
def approach(kite: Glider, path: Path, now: Sketch, progress: float) -> Approach:
    """How to come nearer to `path` from beside `progress` [rad], and then along it.

    As when it is followed, but for the nose and not the course, which a slow kite does not have;
    and all that errors may ask for far from a path.
    """
    progress = advanced(path, progress, now.p)
    ahead = tangential(now.p, vector_at(path, path.ahead, progress))
    ahead = times(1.0 / max(norm(ahead), 1e-9), ahead)
    right = right_of(now.p, ahead)
    error = dot(minus(now.p, vector_at(path, path.points, progress)), right)
    lead = lead_time(kite.law, kite.gains, airspeed(kite, now.p))
    quick, speed = kite.gains.crossover / lead, norm(velocity(kite, now))
    outlook = max(OUTLOOK, kite.gains.outlook * speed / quick)
    angle = -atan2(error, outlook)
    wish = plus(times(cos(angle), ahead), times(sin(angle), right))
    off = off_nose(now, nose_for(kite, now.p, wish))
    near = max(0.0, min(1.0, 2.0 - abs(error) / NEAR)) * max(0.0, cos(off))
    curving = near * at(path, path.turning, progress + lead * speed) * speed
    most = most_turning(kite, now.p)
    return Approach(max(-most, min(most, curving + quick * off)), progress, error)


@compiled
def pointed(kite: Glider, now: Sketch, heading: float) -> float:
    """The turn rate [rad/s] of a kite whose nose is to point to `heading` [rad] from up."""
    quick = kite.gains.crossover / lead_time(kite.law, kite.gains, airspeed(kite, now.p))
    most = most_turning(kite, now.p)
    off = off_nose(now, ahead_of(now.p, heading))
    return float(max(-most, min(most, quick * off)))


@compiled
def joined_after(kite: Glider, path: Path, seen: Estimate, way: Joining, low: float) -> float:
    """In how many s the path is joined on this way; inf: never, or not above `low` [m]."""
    now, progress = begun(kite, seen), way.progress
    for i in range(round(LONG / STEP)):
        t = i * STEP
        if now.p.z * kite.length < low:
            return inf
        if t < way.first:
            now = flown_on(kite, now, pointed(kite, now, way.heading))
            continue
        asked = approach(kite, path, now, progress)
        progress = asked.progress
        if abs(asked.error) < NEAR / 2:
            v, ahead = velocity(kite, now), vector_at(path, path.ahead, progress)
            apart = norm(minus(now.p, vector_at(path, path.points, progress)))
            if apart < NEAR and dot(v, ahead) > cos(ALIGNED / 2) * norm(v):
                return float(t)
        now = flown_on(kite, now, asked.turning)
    return inf


@compiled
def soonest(kite: Glider, path: Path, seen: Estimate, before: Joining, low: float) -> Joining:
    """The way on which `path` is joined soonest; so far it was `before`.

    `low` [m]: how high the kite must stay on the way.
    """
    best = Joining(
        before.heading,
        before.first,
        before.progress,
        joined_after(kite, path, seen, before, KEPT * low) - STAY,
    )
    for i in range(PLACES):
        progress = i * length_of(path) / PLACES
        for first in FIRST:
            for heading in HEADINGS:
                way = Joining(heading, first, progress, 0.0)
                after = joined_after(kite, path, seen, way, low)
                if after < best.after:
                    best = Joining(heading, first, progress, after)
                if first == 0.0:
                    break
    return best
