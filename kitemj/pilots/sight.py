"""What a pilot on the ground sees of the kite: where it is, where its nose points, its turns."""

from math import atan2, cos, hypot, pi, sin
from typing import NamedTuple

from kitemj.dynamics.motion import Motion


class Sight(NamedTuple):
    """What a pilot at O_E sees, in rad and rad/s; right is positive, unlike y_E.

    `azimuth` and `elevation` of G; `heading`: where the nose points on the sky, 0 up, π/2
    right, in (-π, π]; `turning`: how fast the nose turns to the right about z_B.
    """

    azimuth: float
    elevation: float
    heading: float
    turning: float


def sight(motion: Motion) -> Sight:
    """What is seen of `motion`; the heading has no meaning straight overhead."""
    p, nose = motion.body.p_G_E, motion.body.R_BE.x
    azimuth, elevation = atan2(-p.y, -p.x), atan2(-p.z, hypot(p.x, p.y))
    sa, ca, se, ce = sin(azimuth), cos(azimuth), sin(elevation), cos(elevation)
    right = sa * nose.x - ca * nose.y
    up = se * (ca * nose.x + sa * nose.y) - ce * nose.z
    return Sight(azimuth, elevation, atan2(right, up), -motion.body.omega_B.z)


def turned(angle: float, middle: float = 0.0) -> float:
    """`angle` [rad] less whole turns, within π of `middle`."""
    return middle + (angle - middle + pi) % (2 * pi) - pi


class Twist:
    """Whole turns of the nose to the right since the first look: each twists the lines once."""

    def __init__(self) -> None:
        self._last: float | None = None
        self.angle = 0.0

    def look(self, motion: Motion) -> float:
        """Turns (not whole) up to `motion`; to be asked at least every half turn."""
        heading = sight(motion).heading
        if self._last is not None:
            self.angle += turned(heading - self._last)
        self._last = heading
        return self.angle / (2 * pi)
