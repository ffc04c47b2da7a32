"""Turning the nose where it is wished: up from a dive, to the middle of the window, to a point."""

from math import asin, pi, radians, sin

from kitemj.autopilot.follow import LEAST_AIRSPEED, Estimate
from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.physics.compiled import compiled
from kitemj.turning.gains import Gains, lead_time, turn_gain

LEAN, STEEP = 0.5, radians(60.0)
"""rad that the nose leans to a side for each rad of azimuth, and at most."""
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
def most_delta(seen: Estimate, inflow: float, beta: float) -> float:
    """The largest |δ| [rad] for a sideslip angle of `beta` [rad].

    A kite that is rolled by δ meets the `inflow` [m/s], the wind along the lines, from the side:
    sin β = sin δ inflow / v_a. A kite that has no speed yet must not be rolled much.
    """
    return float(asin(min(1.0, sin(beta) * seen.airspeed / max(inflow, LEAST_AIRSPEED))))
