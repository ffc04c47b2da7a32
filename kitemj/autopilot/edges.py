"""The phases without a path: launch at the edge of the window, hold a point, land."""

from math import cos, pi, radians, sin

from kitemj.autopilot.follow import Estimate
from kitemj.autopilot.memory import Asked, Kite, Memory, to_heading, to_point
from kitemj.autopilot.nose import leaning
from kitemj.autopilot.sketch import DOWNWIND
from kitemj.flight.live import TICK
from kitemj.paths.sphere import course, direction, tangential
from kitemj.physics.vectors import Vector, norm, times
from kitemj.pilots.sight import LEFT, RIGHT

AIRBORNE = radians(25.0)
"""Elevation at which a launch is over."""
TRIM, MOST = 0.1, 0.5
"""rad/s of the nose for each rad of azimuth that stays missing, and rad at most."""
CLOSE, FLYING = radians(20.0), 3.0
"""rad of azimuth, m/s of air; farther off, or slower, nothing is summed up."""
EDGE = 0.85
"""Of the angle from downwind at which the kite hangs; beyond, the strong wind is left behind."""
ASIDE, STILL = radians(30.0), 1.0
"""rad of azimuth, m/s: so far out and so slow, a kite of much drag is at its edge."""
EDGE_HEIGHT = radians(20.0)
"""Elevation of the way there."""
SINK, QUICKEST, FLARE = 1.3, 2.0, 0.3
"""m/s down at the ground, and at most at the edge; 1/s, how much more for each m of height.

A kite that sinks more slowly has too little air to be steered: `trainer` is blown back and up.
"""
AT_ONCE, PRESS, DEEPEST, STEEPEST = 0.12, 0.2, 1.2, 1.3
"""rad and rad/s of the nose for each m/s that is missing; rad that are summed up, and in all."""


def launch(kite: Kite, seen: Estimate, memory: Memory) -> Asked:
    """From the ground at the edge: the nose up, leaning to the middle."""
    return to_point(kite, seen, memory, 0.0)


def airborne(kite: Kite, seen: Estimate, memory: Memory) -> bool:
    """Once the kite is high enough to turn."""
    return seen.elevation > min(AIRBORNE, 0.8 * kite.top)


def hold(kite: Kite, seen: Estimate, memory: Memory) -> Asked:
    """At the azimuth of the settings, as high as the wind lifts the kite.

    Beside the middle the nose points away from downwind, or the wind would blow the kite back;
    what is missing then is summed up.
    """
    azimuth = kite.settings.azimuth
    missing, pressed = azimuth - seen.azimuth, memory.pressed
    if abs(missing) < CLOSE and seen.airspeed > FLYING:
        pressed = max(-MOST, min(MOST, pressed + TRIM * missing * TICK))
    hangs = away_from_downwind(direction(azimuth, seen.elevation))
    lean = hangs + leaning(seen, azimuth) + pressed
    guidance = to_heading(kite, seen, lean, direction(azimuth, kite.top))
    return Asked(guidance, memory._replace(pressed=pressed))


def away_from_downwind(p: Vector) -> float:
    """The heading [rad] with which a kite without weight hangs at `p`."""
    away = tangential(p, times(-1.0, DOWNWIND))
    return course(p, times(1.0 / max(norm(away), 1e-9), away))


def held(kite: Kite, seen: Estimate, memory: Memory) -> bool:
    """Once the point was held for as long as was asked."""
    return 0.0 < kite.settings.hold <= memory.t - memory.since


def land(kite: Kite, seen: Estimate, memory: Memory) -> Asked:
    """Low to the edge on the side of the settings, where the pull fades, and down.

    There the nose points out of the window, which is into the wind, and the kite meets little more
    air than the wind; how far it is below the horizontal is how fast it sinks. A kite that rights
    itself hangs there: its nose is pressed down until it sinks.
    """
    side = RIGHT if kite.settings.side == "right" else LEFT
    out, speed = side * seen.azimuth, seen.speed * kite.length
    at_edge = memory.at_edge or out > EDGE * kite.top or (out > ASIDE and speed < STILL)
    pressed = memory.pressed
    if at_edge:
        height = kite.length * sin(seen.elevation) - kite.low
        missing = max(SINK, min(QUICKEST, FLARE * height)) + speed * cos(seen.course)
        pressed = max(-DEEPEST, min(DEEPEST, pressed + PRESS * missing * TICK))
        sink = pressed + AT_ONCE * missing
    else:
        sink = max(-0.5, min(0.35, 1.2 * (seen.elevation - EDGE_HEIGHT)))
    wish = side * (pi / 2 + max(-STEEPEST, min(STEEPEST, sink)))
    # a nose that comes from the other side turns through up
    aim = direction(side * EDGE * kite.top, 0.0 if at_edge else EDGE_HEIGHT)
    guidance = to_heading(kite, seen, wish, aim, side * pi / 4)
    return Asked(guidance, memory._replace(at_edge=at_edge, pressed=pressed))


def never(kite: Kite, seen: Estimate, memory: Memory) -> bool:
    """A landing ends on the ground."""
    return False
