"""The phase that untwists the lines: loops the other way, each from the top of the window."""

from math import copysign, cos, isnan, nan, pi, radians, sin, tau

from kitemj.autopilot.follow import LEAST_AIRSPEED, Estimate
from kitemj.autopilot.memory import Asked, Kite, Memory, ask_for, to_point
from kitemj.paths.sphere import direction
from kitemj.turning.gains import turn_gain

SPARE = tau
"""rad; of the twist that lines can take, so much is left when they are unwound."""
UNWOUND = pi
"""rad of twist; what is left after as many turns back."""
LOOP = 1.0
"""Of full stick, with which a loop is flown: the least height is lost."""
NEARLY = radians(60.0)
"""rad; what is left of a loop comes by itself while the stick goes back."""
STEEPER = 1.3
"""A kite that dives gets faster: its loop is so many times as wide as it begins."""
UPRIGHT, MIDDLE = radians(40.0), radians(15.0)
"""rad of the nose from up, and of azimuth, within which a loop begins."""
HIGHEST = 0.93
"""Of the elevation of rest; higher the kite does not come, and a loop is flown from there."""


def wound_up(kite: Kite, seen: Estimate, memory: Memory) -> bool:
    """Once the lines can take hardly one turn more."""
    return abs(seen.twist) > kite.most_twist - SPARE


def untwisted(kite: Kite, seen: Estimate, memory: Memory) -> bool:
    """Once the lines are straight again, and the nose up."""
    return abs(seen.twist) < UNWOUND and isnan(memory.goal)


def untwist(kite: Kite, seen: Estimate, memory: Memory) -> Asked:
    """Up to the middle of the window; from there a loop against the twist, and up again."""
    if isnan(memory.goal):
        if abs(seen.twist) < UNWOUND or not room(kite, seen):
            return to_point(kite, seen, memory, 0.0)
        memory = memory._replace(goal=seen.twist - copysign(tau, seen.twist))
    left = memory.goal - seen.twist
    if abs(left) < NEARLY:
        return to_point(kite, seen, memory._replace(goal=nan), 0.0)
    turning = copysign(loop_rate(kite, seen), left)
    return Asked(ask_for(turning, direction(0.0, kite.top), nan), memory)


def loop_rate(kite: Kite, seen: Estimate) -> float:
    """Turn rate [rad/s] of a loop."""
    return LOOP * turn_gain(kite.law, max(seen.airspeed, LEAST_AIRSPEED)) * kite.full


def room(kite: Kite, seen: Estimate) -> bool:
    """Whether the kite is up, and a loop would end high enough."""
    airspeed = max(seen.airspeed, LEAST_AIRSPEED)
    radius = STEEPER * airspeed / loop_rate(kite, seen)
    high = kite.length * sin(seen.elevation) > kite.low + 2.0 * radius + kite.law.lag
    up = cos(seen.heading) > cos(UPRIGHT) and abs(seen.azimuth) < MIDDLE
    return up and (high or seen.elevation > HIGHEST * kite.top)
