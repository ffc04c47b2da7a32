"""How a path is followed: where on it the kite is, the attractor ahead, the turn rate asked for."""

from math import atan2, cos, inf, pi
from typing import NamedTuple

from kitemj.autopilot.paths import Path
from kitemj.autopilot.sphere import (
    ahead_of,
    azimuth_of,
    direction,
    elevation_of,
    right_of,
    tangential,
)
from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.physics.compiled import Array, compiled
from kitemj.physics.vectors import Vector, dot, norm, plus, times


class Estimate(NamedTuple):
    """What the pilot believes of the kite at an instant; rad, s; right positive.

    `speed` [rad/s] of G across the sky in the direction `course` (from up, as `heading`);
    `turning` [rad/s] of the nose about the line; `airspeed` [m/s]; `twist` [rad] of the lines.
    """

    azimuth: float
    elevation: float
    speed: float
    course: float
    heading: float
    turning: float
    airspeed: float
    twist: float


class Guidance(NamedTuple):
    """What is asked for: the turn rate now and when the nose answers [rad/s], and for the record
    the place `progress` [rad] along the path, the `error` [rad] to its right, the attractor."""

    turning: float
    turning_ahead: float
    progress: float
    error: float
    attractor: Vector


@compiled
def at(path: Path, values: Array, progress: float) -> float:
    """A column of the path at `progress` [rad], between its points."""
    n = len(values)
    place = progress / path.spacing
    i = int(place // 1.0)
    f = place - i
    return float((1.0 - f) * values[i % n] + f * values[(i + 1) % n])


@compiled
def vector_at(path: Path, values: Array, progress: float) -> Vector:
    """A vector of the path at `progress` [rad], between its points."""
    n = len(values)
    place = progress / path.spacing
    i = int(place // 1.0)
    f = place - i
    a, b = values[i % n], values[(i + 1) % n]
    return Vector(
        (1.0 - f) * a[0] + f * b[0], (1.0 - f) * a[1] + f * b[1], (1.0 - f) * a[2] + f * b[2]
    )


@compiled
def nearest(path: Path, p: Vector, ahead: Vector) -> float:
    """The progress [rad] of the nearest point that is flown in about the direction `ahead`."""
    best, found = inf, 0
    for i in range(len(path.points)):
        point, way = path.points[i], path.ahead[i]
        apart = (p.x - point[0]) ** 2 + (p.y - point[1]) ** 2 + (p.z - point[2]) ** 2
        with_it = ahead.x * way[0] + ahead.y * way[1] + ahead.z * way[2]
        if apart + 0.1 * (1.0 - with_it) < best:
            best, found = apart + 0.1 * (1.0 - with_it), i
    return found * path.spacing


@compiled
def advanced(path: Path, progress: float, p: Vector) -> float:
    """`progress` [rad] of the point beside `p`, looked for from where it was: the other branch
    of a crossing is not taken."""
    for _ in range(3):
        apart = plus(p, times(-1.0, vector_at(path, path.points, progress)))
        along = dot(apart, vector_at(path, path.ahead, progress))
        progress += max(-0.1, min(0.1, along))
    return progress


@compiled
def follow(
    path: Path, seen: Estimate, progress: float, look_ahead: float, lead: float, quick: float
) -> Guidance:
    """How to follow `path` from where it was followed last, `progress` [rad].

    `look_ahead` [rad] to the attractor, `lead` [s] from stick to nose, `quick` [1/s] how fast
    errors of the course are taken away.
    """
    p = direction(seen.azimuth, seen.elevation)
    progress = advanced(path, progress, p)
    beside = vector_at(path, path.points, progress)
    ahead = tangential(p, vector_at(path, path.ahead, progress))
    ahead = times(1.0 / norm(ahead), ahead)
    right = right_of(p, ahead)
    error = dot(plus(p, times(-1.0, beside)), right)
    flown = ahead_of(p, seen.course)
    off = atan2(dot(flown, right), dot(flown, ahead))
    wish = -atan2(error, look_ahead)
    wrong = (wish - off + pi) % (2 * pi) - pi
    near = max(0.0, min(1.0, 2.0 - abs(error) / 0.2)) * max(0.0, cos(off))
    winds = seen.speed / at(path, path.speed, progress)
    then = progress + lead * seen.speed
    now = near * at(path, path.turning, progress) * seen.speed
    soon = near * at(path, path.turning, then) * at(path, path.speed, then) * winds
    attractor = vector_at(path, path.points, progress + look_ahead)
    return Guidance(now + quick * wrong, soon + quick * wrong, progress, error, attractor)


@compiled
def stick_for(law: TurnRateLaw, seen: Estimate, asked: Guidance, ease: float) -> float:
    """δ [rad] for what is asked; `ease` damps by what the nose turns already."""
    from_weight = 0.0
    gain = law.c1 * law.airspeed * (seen.airspeed / law.airspeed) ** law.exponent
    turning = asked.turning_ahead - from_weight + ease * (asked.turning - seen.turning)
    return float(turning / gain)


@compiled
def place_of(v: Vector) -> tuple[float, float]:
    """Azimuth and elevation of a vector."""
    return azimuth_of(v), elevation_of(v)
