"""The person who flies: turned to the kite, leaning against its pull, the hands at the lines.

For the eye only. The formulas let the lines begin at one point of the ground, O_E; drawn, they
begin in two hands above it, and the difference fades along them to nothing at the kite.
"""

from itertools import pairwise
from math import atan2, cos, sin, tanh
from typing import NamedTuple

from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, dot, minus, norm, plus, times
from kitemj.scene.cloth import DARK, Colour
from kitemj.scene.strokes import Strokes
from kitemj.scene.views import UP, bearing_of, turned_to

SHIRT: Colour = (0.95, 0.50, 0.10)
TROUSERS: Colour = (0.18, 0.22, 0.32)
SKIN: Colour = (0.80, 0.60, 0.46)
HAIR: Colour = (0.22, 0.15, 0.10)
SHOES: Colour = (0.90, 0.90, 0.88)

WEIGHT = 75.0 * 9.81  # N, of a person
LEAN = 0.35  # rad, at most
REST, HANDS_APART, HANDS_HIGH = 0.42, 0.17, 1.22  # m: ahead of the body, from its middle, high
ARM = 0.36  # m, how far a hand moves to and fro at most
RAISED = 0.30  # m, how much higher the hands are for a kite overhead
SHOULDER, SHOULDERS_APART, HIP, NECK, HEAD = 1.42, 0.19, 0.92, 1.50, 1.68  # m above ground
UPPER_ARM, FOREARM = 0.31, 0.33  # m


class Hands(NamedTuple):
    """Where the lines begin [m, E]: in the left hand and in the right."""

    left: Vector
    right: Vector


class Stance(NamedTuple):
    """How the pilot stands: `yaw` to the right of downwind, `lean` back, `rise` of the hands."""

    yaw: float
    lean: float
    rise: float


def stance(parameters: Parameters, motion: Motion) -> Stance:
    """Turned to the kite, and leaning as far as the pull at the height of the hands asks for."""
    yaw, elevation = bearing_of(parameters, motion.body.p_G_E)
    level = sum(max(pull, 0.0) for pull in motion.tensions) * max(cos(elevation), 0.0)
    lean = LEAN * tanh(atan2(level, WEIGHT) / LEAN)
    return Stance(yaw, lean, RAISED * max(sin(elevation), 0.0))


def hands(parameters: Parameters, motion: Motion) -> Hands:
    """Where the hands are: one goes back by what its line is shorter than L₀, as far as arms go."""
    body, L = stance(parameters, motion), parameters.lines.length
    places = []
    for side, length in zip((1.0, -1.0), motion.lengths, strict=False):
        out = ARM * tanh((length - L) / ARM)
        places.append(_at(parameters, body, REST + out, side * HANDS_APART, HANDS_HIGH + body.rise))
    return Hands(*places)


def add_pilot(strokes: Strokes, parameters: Parameters, motion: Motion, scale: float = 1.0) -> None:
    """Draws a person of 1.8 m, or `scale` times as tall, and in the hands what holds the lines."""
    body = stance(parameters, motion)

    def at(ahead: float, left: float, height: float) -> Vector:
        return times(scale, _at(parameters, body, ahead, left, height))

    def limb(*points: Vector, radius: float, colour: Colour) -> None:
        for a, b in pairwise(points):
            strokes.limb(a, b, radius * scale, colour)

    for side, ahead in ((1.0, 0.16), (-1.0, -0.12)):  # one foot before the other
        ankle = times(scale, _standing(parameters, body.yaw, ahead, side * 0.15, 0.09))
        toe = times(scale, _standing(parameters, body.yaw, ahead + 0.17, side * 0.18, 0.06))
        knee = at(0.5 * ahead + 0.08, side * 0.13, 0.5)
        limb(ankle, knee, radius=0.062, colour=TROUSERS)
        limb(knee, at(0.0, side * 0.09, HIP), radius=0.082, colour=TROUSERS)
        limb(ankle, toe, radius=0.055, colour=SHOES)
    limb(at(0, 0.07, HIP), at(0, -0.07, HIP), radius=0.115, colour=TROUSERS)
    limb(at(0, 0, HIP + 0.12), at(0, 0, 1.26), radius=0.145, colour=SHIRT)
    limb(at(0, 0.09, 1.33), at(0, -0.09, 1.33), radius=0.12, colour=SHIRT)
    limb(at(0, 0, NECK - 0.04), at(0.02, 0, HEAD), radius=0.05, colour=SKIN)
    strokes.ball(at(0.03, 0, HEAD), 0.105 * scale, SKIN)
    strokes.ball(at(0.005, 0, HEAD + 0.03), 0.108 * scale, HAIR)
    for side, hand in zip((1.0, -1.0), hands(parameters, motion), strict=True):
        shoulder = _at(parameters, body, 0.0, side * SHOULDERS_APART, SHOULDER)
        elbow = _elbow(parameters, body, side, shoulder, hand)
        joints = [times(scale, each) for each in (shoulder, elbow, hand)]
        limb(*joints[:2], radius=0.058, colour=SHIRT)
        limb(*joints[1:], radius=0.043, colour=SKIN)
        strokes.ball(joints[2], 0.052 * scale, SKIN)
        grip = plus(hand, times(0.09, UP)), plus(hand, times(-0.09, UP))
        limb(*(times(scale, each) for each in grip), radius=0.02, colour=DARK)


def _elbow(
    parameters: Parameters, body: Stance, side: float, shoulder: Vector, hand: Vector
) -> Vector:
    """Where the elbow is: arms have their length, and elbows go down and out."""
    reach = minus(hand, shoulder)
    far = min(norm(reach), UPPER_ARM + FOREARM - 1e-3)
    along = (UPPER_ARM**2 - FOREARM**2 + far**2) / (2 * far)
    aside = max(UPPER_ARM**2 - along**2, 0.0) ** 0.5
    straight = times(1 / norm(reach), reach)
    out = turned_to(parameters, body.yaw - side * 1.5708, 0.0)
    down = plus(times(-1.0, UP), times(0.7, out))
    across = minus(down, times(dot(down, straight), straight))
    bent = times(aside / norm(across), across)
    return plus(shoulder, plus(times(along, straight), bent))


def _standing(
    parameters: Parameters, yaw: float, ahead: float, left: float, height: float
) -> Vector:
    """Point [m, E] of one who stands upright at O_E, turned by `yaw` [rad]."""
    level = plus(
        times(ahead, turned_to(parameters, yaw, 0.0)),
        times(-left, turned_to(parameters, yaw + 1.5707963, 0.0)),
    )
    return plus(level, times(height, UP))


def _at(parameters: Parameters, body: Stance, ahead: float, left: float, height: float) -> Vector:
    """Point [m, E] of one who leans back about the feet."""
    s, c = sin(body.lean), cos(body.lean)
    return _standing(parameters, body.yaw, c * ahead - s * height, left, c * height + s * ahead)
