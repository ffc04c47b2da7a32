"""How a flight met the ground: which part first, how fast, where, and what that breaks.

Speeds are facts of the flight. What breaks is an estimate for fun: nobody has measured how
hard these kites can be dropped; only the order of the damages is sure.
"""

from dataclasses import dataclass
from math import atan2, cos, degrees, hypot, sin, sqrt

from kitemj.dynamics.motion import Body, Motion, energy, hull_corners_B
from kitemj.flight.limits import touches_ground
from kitemj.physics.kite import Kite
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, cross, norm, plus, unrotated

SOFT = 3.0
"""m/s; no faster is a landing: a fall from half a metre."""

DAMAGES = (
    (6.0, "Nothing broke, but it will have grass stains"),
    (9.0, "A spreader popped out of its fitting"),
    (13.0, "A spreader snapped"),
    (18.0, "The {edge} broke"),
    (1e9, "The {edge} is in three pieces, the sail in two"),
)
"""Below which speed [m/s] of the whole kite with the same energy, what breaks."""

LEVEL = 0.1
"""An edge whose ends differ in height by less than this part of its length meets whole."""


@dataclass(frozen=True)
class Touch:
    """The first touch of a flight, as it was just before the ground began to push.

    `speed` and `sinking` [m/s] of the part that met the ground, the latter downwards;
    `azimuth` [rad] from downwind, right positive, and `distance` [m] along the ground from
    the pilot; `energy` [J] of motion; `hardness` [m/s]: the speed of a kite that has this
    energy and does not turn.
    """

    t: float
    part: str
    speed: float
    sinking: float
    azimuth: float
    distance: float
    energy: float
    hardness: float

    @property
    def gentle(self) -> bool:
        """Whether this is a landing."""
        return max(self.speed, self.hardness) < SOFT

    @property
    def harmless(self) -> bool:
        """Whether nothing broke, an estimate."""
        return max(self.speed, self.hardness) < DAMAGES[0][0]

    @property
    def damage(self) -> str:
        """What broke, an estimate."""
        if self.gentle:
            return "A soft landing"
        edge = "spine" if self.part in ("nose", "tail", "belly") else "leading edge"
        broken = next(what for limit, what in DAMAGES if self.hardness < limit)
        return broken.format(edge=edge)

    @property
    def pace(self) -> str:
        """How fast."""
        return f"at {self.speed:.1f} m/s, {max(self.sinking, 0.0):.1f} m/s of it downwards"

    @property
    def place(self) -> str:
        """Where, seen from the pilot."""
        angle = round(abs(degrees(self.azimuth)))
        side = "to the right" if self.azimuth > 0 else "to the left"
        return f"{self.distance:.0f} m away, " + (f"{angle}° {side}" if angle else "straight ahead")

    @property
    def reason(self) -> str:
        """What the damage is estimated from."""
        return f"an estimate, from {self.energy:.1f} J"

    def __str__(self) -> str:
        """All of it in a line."""
        guess = "" if self.gentle else f" ({self.reason})"
        how = f"The {self.part} touched first, {self.pace}, {self.place}"
        return f"{self.damage}{guess}. {how}."


def touch_at(parameters: Parameters, motion: Motion, before: Motion | None = None) -> Touch | None:
    """How the hull touches the ground in `motion`; None: it does not.

    In `motion` the ground may have slowed the kite already, to a tenth within a tick: the
    speeds are those of `before`, the last motion without a touch, where that is given.
    """
    if not touches_ground(parameters, motion):
        return None
    kite, free = parameters.kite, (before or motion).body
    corners = hull_corners_B(kite)
    first = min(corners, key=lambda corner: _height(motion.body, corner))
    velocity = plus(free.v_G_E, unrotated(free.R_BE, cross(free.omega_B, first)))
    place = plus(motion.body.p_G_E, unrotated(motion.body.R_BE, first))
    weight = kite.mass * parameters.environment.gravity
    moving = energy(parameters, free) + weight * free.p_G_E.z  # z_E is down
    s, c = sin(parameters.wind.azimuth), cos(parameters.wind.azimuth)
    right, ahead = s * place.x - c * place.y, -c * place.x - s * place.y
    return Touch(
        motion.t,
        _part(kite, motion.body),
        norm(velocity),
        velocity.z,
        atan2(right, ahead),
        hypot(right, ahead),
        moving,
        sqrt(2 * moving / kite.mass),
    )


def _height(body: Body, corner: Vector) -> float:
    """Above ground [m]."""
    return -plus(body.p_G_E, unrotated(body.R_BE, corner)).z


def _part(kite: Kite, body: Body) -> str:
    """The corner, edge or face of the kite's rectangle that is lowest."""
    front, back = (
        [_height(body, Vector(x, y, 0.0)) for y in (kite.span / 2, -kite.span / 2)]
        for x in (kite.chord / 2, -kite.chord / 2)
    )
    nose, side = front[0] - back[0], front[0] - front[1]
    along = "leading" if nose < 0 else "trailing"
    across = "left" if side < 0 else "right"
    steep = abs(nose) > LEVEL * kite.chord, abs(side) > LEVEL * kite.span
    if steep == (True, True):
        return f"{across} wing's {along} corner"
    if steep == (True, False):
        return "nose" if nose < 0 else "tail"
    return f"{across} tip" if steep[1] else "belly"


class FirstTouch:
    """Watches a flight; `touch` is its first, until time jumps back.

    To be told of every tick where that can be: a hard kite bounces off within 50 ms.
    """

    def __init__(self, parameters: Parameters) -> None:
        self._parameters = parameters
        self._before: Motion | None = None
        self.touch: Touch | None = None

    def watch(self, motion: Motion) -> Touch | None:
        """The first touch of the flight up to `motion`."""
        if self._before and motion.t < self._before.t:
            self._before = self.touch = None
        self.touch = self.touch or touch_at(self._parameters, motion, self._before)
        self._before = motion
        return self.touch
