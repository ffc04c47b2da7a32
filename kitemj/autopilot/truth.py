"""What a pilot without errors would believe: the yardstick of sensors and observer."""

from kitemj.autopilot.follow import Estimate
from kitemj.dynamics.motion import Motion
from kitemj.paths.sphere import course, tangential
from kitemj.physics.vectors import Vector, norm, times
from kitemj.pilots.sight import sight


def true_estimate(motion: Motion) -> Estimate:
    """The `Estimate` of a motion; its twist is not known from one, and 0."""
    seen, g, v = sight(motion), motion.body.p_G_E, motion.body.v_G_E
    length = norm(g)
    p = Vector(-g.x / length, -g.y / length, -g.z / length)
    across = tangential(p, Vector(-v.x / length, -v.y / length, -v.z / length))
    speed = norm(across)
    flown = course(p, times(1.0 / max(speed, 1e-9), across))
    at = seen.azimuth, seen.elevation, speed, flown
    return Estimate(*at, seen.heading, seen.turning, motion.air.speed, 0.0)
