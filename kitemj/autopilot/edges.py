"""The phases without a path: launch at the edge of the window, hold a point, land."""

from math import cos, pi, radians

from kitemj.autopilot.follow import Estimate
from kitemj.autopilot.memory import Asked, Kite, Memory, to_heading, to_point
from kitemj.autopilot.sphere import direction
from kitemj.flight.live import TICK
from kitemj.pilots.sight import LEFT, RIGHT

AIRBORNE = radians(25.0)
"""Elevation at which a launch is over."""
EDGE = radians(62.0)
"""Azimuth beyond which a kite of usual glide has left the strong wind behind."""
ASIDE, STILL = radians(30.0), 1.0
"""rad of azimuth, m/s: so far out and so slow, a kite of much drag is at its edge."""
EDGE_HEIGHT = radians(20.0)
"""Elevation of the way there."""
SINK, PRESS, DEEPEST = 1.0, 0.3, 1.2
"""m/s down at the edge; rad/s of the nose for each m/s that is missing, and rad at most."""


def launch(kite: Kite, seen: Estimate, memory: Memory) -> Asked:
    """From the ground at the edge: the nose up, leaning to the middle."""
    return to_point(kite, seen, memory, 0.0)


def airborne(kite: Kite, seen: Estimate, memory: Memory) -> bool:
    """Once the kite is high enough to turn."""
    return seen.elevation > min(AIRBORNE, 0.8 * kite.top)


def hold(kite: Kite, seen: Estimate, memory: Memory) -> Asked:
    """At the azimuth of the settings, as high as the wind lifts the kite."""
    return to_point(kite, seen, memory, kite.settings.azimuth)


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
    at_edge = memory.at_edge or out > EDGE or (out > ASIDE and speed < STILL)
    pressed = memory.pressed
    if at_edge:
        sinking = -speed * cos(seen.course)
        pressed += PRESS * (SINK - sinking) * TICK
        pressed = max(0.0, min(DEEPEST, pressed))
    below = 0.0 if at_edge else EDGE_HEIGHT
    sink = max(-0.5, min(0.35, 1.2 * (seen.elevation - below))) + pressed
    wish = side * (pi / 2 + sink)
    # a nose that comes from the other side turns through up
    aim = direction(side * EDGE, below)
    guidance = to_heading(kite, seen, wish, aim, side * pi / 4)
    return Asked(guidance, memory._replace(at_edge=at_edge, pressed=pressed))


def never(kite: Kite, seen: Estimate, memory: Memory) -> bool:
    """A landing ends on the ground."""
    return False
