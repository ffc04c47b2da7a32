"""What a pilot on the ground sees of the kite (place, nose, turns), and what a lesson sees."""

from math import atan2, cos, hypot, inf, pi, radians, sin
from typing import NamedTuple

from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.pilots.crash import Touch

LEFT, RIGHT = -1.0, 1.0
WORDS = {LEFT: "left", RIGHT: "right"}

UPRIGHT = radians(30.0)
THOUGHT = 1.0
"""s; from seeing that it goes wrong to the stick on the other side."""
FULL = 0.85
"""Of the stick's way: nearly all of it."""


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


class Observation(NamedTuple):
    """One instant as a lesson sees it.

    `turned` [rad]: how far the nose has turned to the right since it last pointed up;
    `twist`: its turns to the right, not whole, since the attempt began; `pulling` [s]: for
    how long the stick has been held nearly full; `touch`: the flight's first of the ground;
    `assist`: whether the assist flies what the stick asks for; `said` [s]: the pushes that were
    asked for, parts of the stick's way, times how long; only those that may not be seen yet.
    """

    motion: Motion
    sight: Sight
    turned: float
    twist: float
    pulling: float
    touch: Touch | None = None
    assist: bool = False
    said: float = 0.0

    @property
    def upright(self) -> bool:
        """Whether the nose points up, more or less."""
        return abs(self.sight.heading) < UPRIGHT

    @property
    def falling(self) -> bool:
        """Whether the kite will be in the grass before a beginner has thought."""
        return -self.motion.body.p_G_E.z < THOUGHT * self.motion.body.v_G_E.z


class Held:
    """For how long [s] something has been so without a break."""

    def __init__(self) -> None:
        self._since = inf

    def look(self, so: bool, t: float) -> float:
        """Up to `t` [s]."""
        self._since = min(self._since, t) if so else inf
        return t - self._since if so else 0.0


class Observer:
    """Looks at the motions of one attempt, in order."""

    def __init__(self, parameters: Parameters) -> None:
        self._limit, self._twist, self._pull = parameters.stick.delta, Twist(), Held()
        self._up: float | None = None  # turns of the nose when it last pointed up

    def look(self, motion: Motion) -> Observation:
        """The next instant; to be asked every half turn of the nose or more often."""
        seen, twist = sight(motion), self._twist.look(motion)
        pulling = self._pull.look(abs(motion.control.delta) > FULL * self._limit, motion.t)
        nearest = twist - seen.heading / (2 * pi)
        up = nearest if self._up is None else self._up
        look = Observation(motion, seen, 2 * pi * (twist - up), twist, pulling)
        self._up = nearest if look.upright else up
        return look
