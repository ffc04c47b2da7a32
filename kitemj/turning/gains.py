"""The gains of the loop: all of them follow from the law of turning and one number, ω_c T."""

from typing import NamedTuple

from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.physics.compiled import compiled

ACTUATOR, DAMPING = 15.0, 0.8
"""rad/s, 1; the hands follow the wished δ like a damped spring, within their limits."""
HANDS = 2 * DAMPING / ACTUATOR
"""s; by so much they are behind."""


class Gains(NamedTuple):
    """What makes the loop quick and firm.

    `crossover`: ω_c T, where T is the delay of the whole loop and ω_c [rad/s] how quickly an
    error of the course is taken away; `waiting` [s]: of T, what sensors and hands take.
    `outlook`: the attractor is so many times farther ahead than is flown in 1/ω_c. `ease`: of a
    turn rate that is too high, how much is taken back at once. `feedback`: of full stick, what
    errors may ask for on the path, which asks for most of the rest, and `recovery` far from it.
    `learning`: of what errors asked for, how much is
    kept for the next lap.
    """

    crossover: float = 0.4
    waiting: float = HANDS
    outlook: float = 2.0
    ease: float = 0.2
    feedback: float = 0.2
    recovery: float = 0.7
    learning: float = 0.5


@compiled
def turn_gain(law: TurnRateLaw, airspeed: float) -> float:
    """Turn rate [rad/s] for each rad of δ at an `airspeed` [m/s]; as `TurnRateLaw.gain`."""
    return float(law.c1 * law.airspeed * (airspeed / law.airspeed) ** law.exponent)


@compiled
def lead_time(law: TurnRateLaw, gains: Gains, airspeed: float) -> float:
    """T [s], from what is seen to the nose that answers, at an `airspeed` [m/s]."""
    return law.lag / airspeed + gains.waiting
