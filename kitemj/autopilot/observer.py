"""From measurements to what the pilot believes of the kite now: an extended Kalman filter.

It keeps the kite as it was when it was measured last, and from there goes on to now by the stick
that was held since, which the hands know. Directions are vectors, so nothing breaks at the zenith.
(Multiplicative errors as in Lefferts, Markley & Shuster, J. Guidance 5 (1982) 417.)
"""

from math import cos, hypot, pi, sin
from typing import NamedTuple

import numpy as np

from kitemj.autopilot.flight_model import (
    STATES,
    Flying,
    Glide,
    air_met,
    airspeed_by_pull,
    errors_grow,
    glide_of,
    moved_on,
)
from kitemj.autopilot.follow import Estimate
from kitemj.autopilot.sensors import Measurement, Sensors, Underway
from kitemj.dynamics.motion import Motion
from kitemj.flight.pilot_settings import SensorSettings, TurnRateLaw
from kitemj.paths.sphere import (
    ahead_of,
    azimuth_of,
    course,
    direction,
    elevation_of,
    right_of,
)
from kitemj.physics.compiled import Array, compiled
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, dot, norm, plus, times
from kitemj.pilots.sight import turned

KEPT = 256
"""Ticks of which the stick is remembered: the longest delay, and the longest time between two
measurements, 1 s each, and some."""
FINEST = 1e-5
"""rad; no angle is trusted more than that."""
TRIM = 0.1
"""Of the airspeed; so far from trim a kite is that follows a path, and so wrong is its pull."""
OVERHEAD = 0.1
"""Cosine of the elevation; nearer to the zenith a measured heading says nothing."""
PUSHES = 5.0
"""(m/s)/√s of velocity that the model does not know of."""
TURNS, BIASES = 0.8, 1.5
"""(rad/s)/√s of turning, and of what the law does not know, per its square root of time."""
BLOWS = 1.5
"""(m/s)/√s; a gust of 0.3 in 6.5 m/s at 1 rad/s goes 2 m/s in a second."""
GUESS = (0.02, 0.02, 0.05, 4.0, 4.0, 1.0, 0.5, 2.0)
"""rad, m/s, rad/s: how wrong the belief may be that begins with the first measurement."""


class Known(NamedTuple):
    """What does not change: kite, law, noise [rad] of angles and part of pull."""

    glide: Glide
    law: TurnRateLaw
    noise: float
    pull_noise: float


class Held(NamedTuple):
    """The observer's memory at `t` [s]: the kite when it was measured last, (STATES, STATES) how
    sure that is, when [s] which δ [rad] was held, oldest first, the length [m] of the lines, the
    heading now, and what it turned so far [rad]."""

    t: float
    kite: Flying
    covariance: Array
    times: Array
    stick: Array
    length: float
    heading: float
    twist: float


class SavedObserver(NamedTuple):
    """All that is remembered by sensors and observer."""

    sensors: Underway | None
    held: Held | None


class Observer:
    """Tells what is believed of the kite, tick by tick, from what its sensors measure."""

    def __init__(
        self, parameters: Parameters, law: TurnRateLaw, settings: SensorSettings, seed: int = 0
    ) -> None:
        """Raises InputError for sensors that there cannot be, and a kite without trim."""
        self._sensors = Sensors(settings, seed)
        self._known = Known(glide_of(parameters), law, settings.noise, settings.pull_noise)
        self._wind = parameters.wind.speed
        self._held: Held | None = None

    def save(self) -> SavedObserver:
        """All that is remembered."""
        return SavedObserver(self._sensors.save(), self._held)

    def resume(self, saved: SavedObserver) -> None:
        """Goes on from what was saved, to the same bits."""
        self._sensors.resume(saved.sensors)
        self._held = saved.held

    def look(self, motion: Motion) -> Estimate:
        """What is believed at the time of `motion`, of which sensors and hands tell alone."""
        arrived, held = self._sensors.look(motion), self._held
        if held is None or motion.t < held.t:
            held = _began(self._known, arrived[0], self._wind, motion.control.delta)
            arrived = arrived[1:]
        elif motion.t > held.t:
            held = _reminded(held, motion.t, motion.control.delta)
        for one in arrived:
            held = _corrected(self._known, held, one)
        now = ahead(self._known, held.kite, held, motion.t)
        self._held, found = believed(held, now)
        return found

    @property
    def covariance(self) -> Array:
        """(STATES, STATES) of the errors at the last measurement that arrived, as
        `kitemj.autopilot.flight_model.STATES` has them."""
        assert self._held
        return self._held.covariance

    @property
    def kite(self) -> Flying:
        """The kite at the last measurement that arrived, as it is believed to have been."""
        assert self._held
        return self._held.kite


def _length(known: Known, one: Measurement) -> float:
    return sum(one.lengths) / len(one.lengths) + known.glide.beyond


def _began(known: Known, one: Measurement, wind: float, delta: float) -> Held:
    """The first belief: the kite where it is seen, gliding steadily where its nose points."""
    g, p = known.glide, direction(one.azimuth, one.elevation)
    nose = ahead_of(p, one.heading)
    along = max(0.0, wind * (g.lift / g.drag * p.x + nose.x))
    kite = Flying(one.t, p, nose, along, wind * right_of(p, nose).x, 0.0, 0.0, wind)
    sure = np.diag(np.square(np.array(GUESS)))
    when, stick = np.full(KEPT, one.t), np.full(KEPT, delta)
    heading = course(p, nose)
    return Held(one.t, kite, sure, when, stick, _length(known, one), heading, 0.0)


def _reminded(held: Held, t: float, delta: float) -> Held:
    """With the stick as it is at `t` [s]."""
    when, stick = np.append(held.times[1:], t), np.append(held.stick[1:], delta)
    return held._replace(t=t, times=when, stick=stick)


def _corrected(known: Known, held: Held, one: Measurement) -> Held:
    """With one more measurement."""
    length = _length(known, one)
    kite, sure = gone_on(known, held.kite, held.covariance, held, one.t)
    seen = Vector(one.azimuth, one.elevation, one.heading)
    kite, sure = corrected(known, kite, sure, length, seen, float(sum(one.pulls)))
    return held._replace(kite=kite, covariance=sure, length=length)


@compiled
def ahead(known: Known, kite: Flying, held: Held, t: float) -> Flying:
    """The kite at `t` [s], by the stick that was held."""
    before = held.stick[0]
    for i in range(KEPT):
        h = min(held.times[i], t) - kite.t
        if h > 0.0:
            delta = 0.5 * (before + held.stick[i])
            kite = moved_on(kite, h, delta, held.length, known.glide, known.law)
        before = held.stick[i]
    return kite


@compiled
def gone_on(known: Known, kite: Flying, sure: Array, held: Held, t: float) -> tuple[Flying, Array]:
    """The same, and how sure that is."""
    before = held.stick[0]
    for i in range(KEPT):
        h = min(held.times[i], t) - kite.t
        if h > 0.0:
            F = errors_grow(kite, h, held.length, known.glide, known.law)
            sure = F @ sure @ F.T
            sure[3, 3] += h * PUSHES**2
            sure[4, 4] += h * PUSHES**2
            sure[5, 5] += h * TURNS**2
            sure[6, 6] += h * BIASES**2
            sure[7, 7] += h * BLOWS**2
            delta = 0.5 * (before + held.stick[i])
            kite = moved_on(kite, h, delta, held.length, known.glide, known.law)
        before = held.stick[i]
    return kite, sure


@compiled
def corrected(
    known: Known, kite: Flying, sure: Array, length: float, seen: Vector, pull: float
) -> tuple[Flying, Array]:
    """The kite, and how sure, once azimuth, elevation, heading `seen` [rad] and pull [N] are
    taken into account, all at once."""
    right, at = right_of(kite.p, kite.nose), direction(seen.x, seen.y)
    level = Vector(-sin(seen.x), cos(seen.x), 0.0)
    up = Vector(-sin(seen.y) * cos(seen.x), -sin(seen.y) * sin(seen.x), cos(seen.y))
    off = plus(at, times(-1.0, kite.p))
    noise = known.noise * known.noise + FINEST * FINEST
    H, R, y = np.zeros((4, STATES)), np.zeros((4, 4)), np.zeros(4)
    H[0, 0], H[0, 1], R[0, 0] = dot(level, kite.nose), dot(level, right), noise
    R[0, 0] = noise * max(cos(seen.y) ** 2, 1e-4)
    H[1, 0], H[1, 1], R[1, 1] = dot(up, kite.nose), dot(up, right), noise
    y[0], y[1] = dot(level, off), dot(up, off)
    H[2, 2], R[2, 2] = 1.0, noise
    if cos(seen.y) > OVERHEAD:
        steep = sin(seen.y) / cos(seen.y)
        H[2, 0], H[2, 1] = steep * H[0, 0], steep * H[0, 1]
        y[2] = (seen.z - course(kite.p, kite.nose) + pi) % (2 * pi) - pi
    else:
        R[2, 2] = pi * pi
    air = air_met(kite)
    v, by_pull = max(norm(air), 1.0), airspeed_by_pull(pull, kite, length, known.glide)
    H[3, 3], H[3, 4] = air.x / v, air.y / v
    H[3, 7] = (air.z * kite.p.x - air.x * kite.nose.x - air.y * right.x) / v
    y[3] = by_pull - v
    R[3, 3] = (TRIM**2 + known.pull_noise**2 / 8) * v * v + 0.25
    K = np.linalg.solve(H @ sure @ H.T + R, H @ sure).T
    x = K @ y
    A = np.eye(STATES) - K @ H
    sure = A @ sure @ A.T + K @ R @ K.T
    p = plus(kite.p, plus(times(x[0], kite.nose), times(x[1], right)))
    p = times(1.0 / norm(p), p)
    nose = plus(kite.nose, times(x[2], right))
    nose = plus(nose, times(-dot(nose, p), p))
    nose = times(1.0 / norm(nose), nose)
    along, across = kite.along + x[3], kite.across + x[4]
    turning, bias, wind = kite.turning + x[5], kite.bias + x[6], max(kite.wind + x[7], 0.0)
    return Flying(kite.t, p, nose, along, across, turning, bias, wind), sure


def believed(held: Held, now: Flying) -> tuple[Held, Estimate]:
    """What is believed of the kite, and the memory with its heading."""
    right = right_of(now.p, now.nose)
    speed, heading = hypot(now.along, now.across), course(now.p, now.nose)
    way = plus(times(now.along, now.nose), times(now.across, right))
    flown = course(now.p, times(1.0 / max(speed, 1e-9), way))
    twist = held.twist + turned(heading - held.heading)
    at = azimuth_of(now.p), elevation_of(now.p), speed / held.length, flown
    found = Estimate(*at, heading, now.turning, norm(air_met(now)), twist)
    return held._replace(heading=heading, twist=twist), found
