"""Turning the nose where it is wished: up from a dive, to the middle of the window, to a point."""

from math import cos, pi, radians, sin

from kitemj.autopilot.follow import LEAST_AIRSPEED, Estimate
from kitemj.autopilot.gains import Gains, lead_time, turn_gain
from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.physics.compiled import compiled

LEAN, STEEP = 0.5, radians(60.0)
"""rad that the nose leans to a side for each rad of azimuth, and at most."""
CREEP = 0.06
"""rad/s; a kite that moves more slowly across the sky has no course of its own, but a nose."""
CLEAR = 1.5
"""m above ground that every dive must end, for the kite's lowest corner."""


@compiled
def within_half_turn(angle: float) -> float:
    """`angle` [rad] less whole turns, in [-π, π)."""
    return float((angle + pi) % (2 * pi) - pi)


@compiled
def leaning(seen: Estimate, azimuth: float) -> float:
    """The heading [rad] of a kite that is to climb and go to `azimuth` [rad]."""
    return float(max(-STEEP, min(STEEP, LEAN * (azimuth - seen.azimuth))))


@compiled
def turn_rate_for(
    off: float, law: TurnRateLaw, gains: Gains, seen: Estimate, full_stick: float
) -> float:
    """The turn rate [rad/s] for a nose that is to turn by `off` [rad] to the right."""
    airspeed = max(seen.airspeed, LEAST_AIRSPEED)
    quick = gains.crossover / lead_time(law, gains, airspeed)
    most = gains.recovery * turn_gain(law, airspeed) * full_stick
    return float(max(-most, min(most, quick * off)))


@compiled
def heading_for(course: float, seen: Estimate) -> float:
    """The heading [rad] by which a kite gets on a `course` [rad]: as it drifts now."""
    moving = min(1.0, seen.speed / CREEP)
    return float(course + moving * within_half_turn(seen.heading - seen.course))


@compiled
def lowest(
    law: TurnRateLaw,
    gains: Gains,
    seen: Estimate,
    side: float,
    length: float,
    full_stick: float,
) -> float:
    """The least height [m] of a kite whose nose is turned up to one `side` (right +1) from now on.

    It flies straight on while the nose answers, then a circle of what the stick can do, until
    it is level.

    law         how the kite turns
    gains       of the loop
    seen        the kite now
    side        to which it turns
    length      of the lines [m]
    full_stick  largest |δ| [rad]
    """
    airspeed = max(seen.airspeed, LEAST_AIRSPEED)
    rate = gains.recovery * turn_gain(law, airspeed) * full_stick
    speed, dive = seen.speed * length, side * seen.course
    height = length * sin(seen.elevation)
    if cos(dive) >= 0.0:
        return float(height)
    already = max(-1.0, min(1.0, side * seen.turning / rate))
    straight = lead_time(law, gains, airspeed) * (1.5 - already)
    return float(height + speed * cos(dive) * straight - speed / rate * (1.0 + sin(dive)))
