"""How a path is followed: where on it the kite is, the attractor ahead, the turn rate asked for.

The kite flies on the great circle to an attractor on the path ahead (Fernandes et al., Energies
15 (2022) 1390), and its nose turns as the path turns there where it will be when the nose answers.
What errors had to ask for in a lap is learnt as a function of the place on the path: so much the
path itself asks for in the next.
"""

from math import atan2, cos, inf, pi, sin
from typing import NamedTuple

import numpy as np

from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.paths.path import Path
from kitemj.paths.sphere import ahead_of, direction, right_of, tangential
from kitemj.physics.compiled import Array, compiled
from kitemj.physics.vectors import Vector, dot, norm, plus, times
from kitemj.turning.gains import Gains, lead_time, turn_gain

HARMONICS = 5
"""Of a lap, up to which is learnt; quicker ones the loop cannot follow in phase."""
NEAR = 0.12
"""rad off the path; farther away the path's own turning fades."""
SURE = 0.06
"""rad off the path; farther away nothing is learnt, since the kite is still on its way there."""
LEAST_AIRSPEED = 1.0
"""m/s; below that there is nothing to steer with, and nothing is divided by it."""
LONGEST_STRIDE = 0.1
"""rad; so far, at most, the place on the path moves at once."""


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
    """What following a path asks for at an instant.

    `turning`, `turning_ahead` [rad/s]: of the nose now, and when it answers; `feedback` [rad/s],
    the part of both that errors ask for. `progress` [rad] along the path, laps included; `error`
    [rad] to its right; `attractor`, a direction.
    """

    turning: float
    turning_ahead: float
    feedback: float
    progress: float
    error: float
    attractor: Vector


@compiled
def at(path: Path, values: Array, progress: float) -> float:
    """A column of the path at `progress` [rad], between its points."""
    n, place = len(values), progress / path.spacing
    i = int(place // 1.0)
    f = place - i
    return float((1.0 - f) * values[i % n] + f * values[(i + 1) % n])


@compiled
def vector_at(path: Path, values: Array, progress: float) -> Vector:
    """A vector of the path at `progress` [rad], between its points."""
    n, place = len(values), progress / path.spacing
    i = int(place // 1.0)
    f = place - i
    a, b = values[i % n], values[(i + 1) % n]
    e = 1.0 - f
    return Vector(e * a[0] + f * b[0], e * a[1] + f * b[1], e * a[2] + f * b[2])


@compiled
def length_of(path: Path) -> float:
    """Once around [rad]."""
    return path.spacing * len(path.points)


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
    """The progress [rad] of the point beside `p`, looked for from where it was.

    That is the memory at a crossing: the other branch is not taken.
    """
    for _ in range(3):
        apart = plus(p, times(-1.0, vector_at(path, path.points, progress)))
        along = dot(apart, vector_at(path, path.ahead, progress))
        progress += max(-LONGEST_STRIDE, min(LONGEST_STRIDE, along))
    return progress


@compiled
def follow(
    path: Path,
    law: TurnRateLaw,
    gains: Gains,
    seen: Estimate,
    progress: float,
    learnt: Array,
    full_stick: float,
) -> Guidance:
    """How to follow `path` from where it was followed last, `progress` [rad].

    path        what is flown
    law         how the kite turns
    gains       of the loop
    seen        the kite now
    progress    [rad] where on the path it was
    learnt      (2 HARMONICS + 1,) turning that the path asks for beside its own, of `learn`
    full_stick  largest |δ| [rad]
    """
    p = direction(seen.azimuth, seen.elevation)
    progress = advanced(path, progress, p)
    ahead = tangential(p, vector_at(path, path.ahead, progress))
    ahead = times(1.0 / norm(ahead), ahead)
    right, flown = right_of(p, ahead), ahead_of(p, seen.course)
    error = dot(plus(p, times(-1.0, vector_at(path, path.points, progress))), right)
    off = atan2(dot(flown, right), dot(flown, ahead))
    airspeed = max(seen.airspeed, LEAST_AIRSPEED)
    lead = lead_time(law, gains, airspeed)
    quick = gains.crossover / lead
    outlook = max(gains.outlook * seen.speed / quick, NEAR / 4)
    wrong = (-atan2(error, outlook) - off + pi) % (2 * pi) - pi
    near = max(0.0, min(1.0, 2.0 - abs(error) / NEAR)) * max(0.0, cos(off))
    share = near * gains.feedback + (1.0 - near) * gains.recovery
    most = share * turn_gain(law, airspeed) * full_stick
    feedback = max(-most, min(most, quick * wrong))
    then = progress + lead * seen.speed
    soon = seen.speed * at(path, path.speed, then) / at(path, path.speed, progress)
    now = near * seen.speed * (at(path, path.turning, progress) + taught(path, learnt, progress))
    later = near * soon * (at(path, path.turning, then) + taught(path, learnt, then))
    attractor = vector_at(path, path.points, progress + outlook)
    return Guidance(now + feedback, later + feedback, feedback, progress, error, attractor)


@compiled
def stick_for(law: TurnRateLaw, gains: Gains, seen: Estimate, asked: Guidance) -> float:
    """δ [rad] for what is asked: the law of turning, solved for it, and eased."""
    airspeed = max(seen.airspeed, LEAST_AIRSPEED)
    by_weight = law.c2 / airspeed * sin(seen.heading) * cos(seen.elevation)
    too_slow = asked.turning - seen.turning
    turning = asked.turning_ahead - by_weight + gains.ease * too_slow
    return float(turning / turn_gain(law, airspeed))


@compiled
def taught(path: Path, learnt: Array, progress: float) -> float:
    """How much more than by its shape the path turns at `progress` [rad], for each rad of way."""
    angle = 2 * pi * progress / length_of(path)
    found = learnt[0]
    for h in range(1, HARMONICS + 1):
        found += learnt[2 * h - 1] * cos(h * angle) + learnt[2 * h] * sin(h * angle)
    return float(found)


@compiled
def learn(
    path: Path,
    law: TurnRateLaw,
    gains: Gains,
    seen: Estimate,
    asked: Guidance,
    flown: float,
    learnt: Array,
) -> Array:
    """What is learnt once `flown` [rad] more of the way is known.

    Each harmonic of what errors asked for, where the kite was when the stick was moved for it:
    a gradient step that makes the next lap's feedback less. (Learning over laps: Cobb et al.,
    IEEE Trans. Control Syst. Technol. 28 (2020) 1853.)
    """
    found = learnt.copy()
    if abs(asked.error) > SURE or abs(flown) > LONGEST_STRIDE:
        return found
    lead = lead_time(law, gains, max(seen.airspeed, LEAST_AIRSPEED))
    angle = 2 * pi * (asked.progress - lead * seen.speed) / length_of(path)
    step = gains.learning * flown / length_of(path) * asked.feedback / max(seen.speed, 0.1)
    found[0] += step
    for h in range(1, HARMONICS + 1):
        found[2 * h - 1] += 2.0 * step * cos(h * angle)
        found[2 * h] += 2.0 * step * sin(h * angle)
    return found


def nothing_learnt() -> Array:
    """Of a path that was not flown yet."""
    return np.zeros(2 * HARMONICS + 1)
