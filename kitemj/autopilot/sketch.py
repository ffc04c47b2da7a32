"""A flight sketched ahead: a kite without mass that glides where its nose points.

Enough to see whether a way to a path ends on it, and how low a dive comes.
"""

from math import acos, sqrt
from typing import NamedTuple

from kitemj.autopilot.follow import LEAST_AIRSPEED, Estimate
from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.paths.sphere import ahead_of, direction, right_of, tangential
from kitemj.physics.compiled import compiled
from kitemj.physics.vectors import Vector, dot, minus, norm, plus, times
from kitemj.turning.gains import HANDS, Gains, turn_gain

DOWNWIND = Vector(1.0, 0.0, 0.0)
STEP, LONG = 0.05, 7.0
"""s; of a sketch."""
ASIDE = 0.1
"""Of the wind that is along the lines, at least: beyond 84° from downwind no kite glides."""
SLOWEST = 0.02
"""Of the wind's speed; a kite that would fly backwards along its course is said to fly so."""


class HandLimits(NamedTuple):
    """Largest |δ̇| [rad/s] and |δ̈| [rad/s²]."""

    rate: float
    acceleration: float


class Glider(NamedTuple):
    """What a sketch knows: `wind` [rad/s], its speed over the length of the lines; `glide` ratio;
    `length` [m] of the lines; how the kite turns, the gains, the largest |δ| [rad],
    the limits of the `hands`, and where they are now, δ [rad] and δ̇ [rad/s]."""

    wind: float
    glide: float
    length: float
    law: TurnRateLaw
    gains: Gains
    full: float
    hands: HandLimits
    delta: float
    delta_dot: float


class Sketch(NamedTuple):
    """An instant: direction `p`, where the nose points (a unit vector across it), turn rate
    [rad/s], δ [rad], δ̇ [rad/s]."""

    p: Vector
    nose: Vector
    turning: float
    delta: float
    delta_dot: float


@compiled
def wind_felt(seen: Estimate, glide: float, length: float) -> float:
    """The wind's speed [m/s] by the air and the way of a kite on lines of `length` [m].

    v_a² = |v - W x|², solved for W, with x downwind; the airspeed comes from the pull. Of two
    solutions that which is nearer to a steady glide's, v_a² = (1 + `glide`²) (W x·p)².
    """
    p = direction(seen.azimuth, seen.elevation)
    speed = seen.speed * length
    along = speed * ahead_of(p, seen.course).x
    root = sqrt(max(0.0, along**2 + seen.airspeed**2 - speed**2))
    steady = seen.airspeed / (max(p.x, ASIDE) * sqrt(1.0 + glide**2))
    more, less = along + root, max(0.0, along - root)
    return float(more if abs(more - steady) <= abs(less - steady) else less)


@compiled
def begun(kite: Glider, seen: Estimate) -> Sketch:
    """The sketch of the present."""
    p = direction(seen.azimuth, seen.elevation)
    return Sketch(p, ahead_of(p, seen.heading), seen.turning, kite.delta, kite.delta_dot)


@compiled
def velocity(kite: Glider, now: Sketch) -> Vector:
    """rad/s across the sky: through the air where the nose points, and with the air."""
    across = tangential(now.p, DOWNWIND)
    pulled = kite.glide * max(0.0, now.p.x)
    return times(kite.wind, plus(times(pulled, now.nose), across))


@compiled
def airspeed(kite: Glider, p: Vector) -> float:
    """m/s at `p`."""
    inflow = kite.wind * kite.length * max(0.0, p.x)
    return max(LEAST_AIRSPEED, inflow * sqrt(1.0 + kite.glide**2))


@compiled
def most_turning(kite: Glider, p: Vector) -> float:
    """rad/s that errors may ask for at `p`."""
    return kite.gains.recovery * turn_gain(kite.law, airspeed(kite, p)) * kite.full


@compiled
def nose_for(kite: Glider, p: Vector, ahead: Vector) -> Vector:
    """Where the nose points of a kite that goes `ahead` over the ground at `p`, as it drifts there.

    Where no nose does that, the one that comes nearest.
    """
    across = tangential(p, DOWNWIND)
    along = dot(across, ahead)
    room = (kite.glide * max(0.0, p.x)) ** 2 - dot(across, across) + along**2
    speed = max(SLOWEST, along + sqrt(max(0.0, room)))
    nose = minus(times(speed, ahead), across)
    return times(1.0 / max(norm(nose), 1e-9), nose)


@compiled
def off_nose(now: Sketch, wish: Vector) -> float:
    """rad by which the nose must turn right to point to `wish`, the shorter way."""
    angle = acos(max(-1.0, min(1.0, dot(now.nose, wish))))
    return float(angle if dot(wish, right_of(now.p, now.nose)) >= 0.0 else -angle)


@compiled
def flown_on(kite: Glider, now: Sketch, asked: float) -> Sketch:
    """One `STEP` later, while a turn rate is `asked` [rad/s]."""
    air = airspeed(kite, now.p)
    gain = turn_gain(kite.law, air)
    wish = (asked + kite.gains.ease * (asked - now.turning)) / gain
    wish = max(-kite.full, min(kite.full, wish))
    rate = max(-kite.hands.rate, min(kite.hands.rate, (wish - now.delta) / HANDS))
    change = kite.hands.acceleration * STEP
    rate = now.delta_dot + max(-change, min(change, rate - now.delta_dot))
    delta = max(-kite.full, min(kite.full, now.delta + STEP * rate))
    answer = min(1.0, STEP * air / max(kite.law.lag, 1e-9))
    turning = now.turning + (gain * delta - now.turning) * answer
    p = plus(now.p, times(STEP, velocity(kite, now)))
    p = times(1.0 / norm(p), p)
    nose = plus(now.nose, times(STEP * turning, right_of(now.p, now.nose)))
    nose = tangential(p, nose)
    return Sketch(p, times(1.0 / max(norm(nose), 1e-9), nose), turning, delta, rate)


@compiled
def lowest(kite: Glider, seen: Estimate, side: float) -> float:
    """The least height [m] of a kite that is turned to one `side` (right +1) until it rises."""
    now = begun(kite, seen)
    least = now.p.z
    for _ in range(round(LONG / STEP)):
        now = flown_on(kite, now, side * most_turning(kite, now.p))
        if now.p.z > least and velocity(kite, now).z > 0.0:
            break
        least = min(least, now.p.z)
    return float(kite.length * least)
