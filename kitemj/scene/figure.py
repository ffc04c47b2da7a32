"""The person who flies: turned to the kite, leaning against its pull, the lines in the hands.

For the eye only. The formulas let the lines begin at one point of the ground, O_E; drawn, they
begin in two hands above it, and the difference fades along them to nothing at the kite.

Places on the body are (ahead, left, up) in m from O_E.
"""

from math import atan2, cos, sin, tanh
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, cross, minus, times
from kitemj.scene.cloth import DARK, Colour
from kitemj.scene.strokes import Strokes
from kitemj.scene.views import UP, bearing_of, turned_to

Place = NDArray[np.float64]

SHIRT: Colour = (0.95, 0.50, 0.10)
TROUSERS: Colour = (0.18, 0.22, 0.32)
SKIN: Colour = (0.80, 0.60, 0.46)
HAIR: Colour = (0.22, 0.15, 0.10)
SHOES: Colour = (0.90, 0.90, 0.88)

WEIGHT = 75.0 * 9.81  # N, of a person
LEAN = 0.35  # rad, at most
HANDS = np.array([0.40, 0.24, 1.24])  # at rest, the left one
RAISED = 0.30  # m, how much higher the hands are for a kite overhead
ARM = 0.36  # m, how far a hand moves to and fro at most
SHOULDER = np.array([0.0, 0.20, 1.41])
UPPER_ARM, FOREARM = 0.31, 0.33  # m
ELBOW = np.array([-0.3, 0.7, -1.0])  # where it goes: out and down
GRIP = np.array([0.0, 0.0, 0.09])  # half of what holds a line
Limb = tuple[ArrayLike, ArrayLike, float, Colour]
"""From where to where, radius, colour."""
BODY: tuple[Limb, ...] = (
    ((0.0, 0.07, 0.92), (0.0, -0.07, 0.92), 0.115, TROUSERS),
    ((0.0, 0.0, 1.44), (0.02, 0.0, 1.64), 0.055, SKIN),
    ((0.03, 0.0, 1.66), (0.03, 0.0, 1.66), 0.105, SKIN),
    ((0.005, 0.0, 1.69), (0.005, 0.0, 1.69), 0.108, HAIR),
    ((0.16, 0.15, 0.09), (0.16, 0.13, 0.5), 0.062, TROUSERS),  # one foot before the other
    ((0.16, 0.13, 0.5), (0.0, 0.09, 0.92), 0.082, TROUSERS),
    ((0.16, 0.15, 0.07), (0.33, 0.18, 0.06), 0.055, SHOES),
    ((-0.12, -0.15, 0.09), (0.02, -0.13, 0.5), 0.062, TROUSERS),
    ((0.02, -0.13, 0.5), (0.0, -0.09, 0.92), 0.082, TROUSERS),
    ((-0.12, -0.15, 0.07), (0.05, -0.18, 0.06), 0.055, SHOES),
)
CHEST, WAIST = (0.0, 0.0, 1.25), (0.0, 0.0, 1.02)
CHEST_SIZE, WAIST_SIZE = (0.125, 0.21, 0.24), (0.115, 0.165, 0.22)


class Hands(NamedTuple):
    """Where the lines begin [m, E]: in the left hand and in the right."""

    left: Vector
    right: Vector


def hands(parameters: Parameters, motion: Motion) -> Hands:
    """Where the hands are: one goes back by what its line is shorter than L₀, as far as arms go."""
    left, right = _held(parameters, motion) @ _axes(parameters, motion)
    return Hands(Vector(*map(float, left)), Vector(*map(float, right)))


def add_pilot(strokes: Strokes, parameters: Parameters, motion: Motion, scale: float = 1.0) -> None:
    """Draws a person of 1.8 m, or `scale` times as tall, and in the hands what holds the lines."""
    axes = scale * _axes(parameters, motion)
    limbs = list(BODY)
    mirror = np.array([1.0, -1.0, 1.0])
    for side, hand in zip((np.ones(3), mirror), _held(parameters, motion), strict=True):
        shoulder = side * SHOULDER
        elbow = _elbow(shoulder, hand, side * ELBOW)
        limbs += [
            (shoulder, elbow, 0.058, SHIRT),
            (elbow, hand, 0.043, SKIN),
            (hand, hand, 0.052, SKIN),
            (hand - GRIP, hand + GRIP, 0.02, DARK),
        ]
    ends = np.array([limb[:2] for limb in limbs]) @ axes
    for middle, size in ((CHEST, CHEST_SIZE), (WAIST, WAIST_SIZE)):
        strokes.egg(np.array(middle) @ axes, np.array(size)[:, None] * axes, SHIRT)
    for both, (_, _, radius, colour) in zip(ends, limbs, strict=True):
        strokes.limb(both, scale * radius, colour)


def _held(parameters: Parameters, motion: Motion) -> Place:
    """Places (2, 3) of the left and the right hand."""
    _, elevation = bearing_of(parameters, motion.body.p_G_E)
    out = [ARM * tanh((length - parameters.lines.length) / ARM) for length in motion.lengths[:2]]
    places = HANDS * [[1, 1, 1], [1, -1, 1]]
    places[:, 0] += out
    places[:, 2] += RAISED * max(sin(elevation), 0.0)
    return places


def _axes(parameters: Parameters, motion: Motion) -> Place:
    """Unit vectors (3, 3) [E] ahead, to the left and up of one who faces the kite.

    "Up" leans back as far as the pull at the height of the hands asks for.
    """
    yaw, elevation = bearing_of(parameters, motion.body.p_G_E)
    pull = sum(max(pull, 0.0) for pull in motion.tensions) * max(cos(elevation), 0.0)
    lean = LEAN * tanh(atan2(pull, WEIGHT) / LEAN)
    ahead = turned_to(parameters, yaw, 0.0)
    up = minus(times(cos(lean), UP), times(sin(lean), ahead))
    return np.array([ahead, cross(UP, ahead), up])


def _elbow(shoulder: Place, hand: Place, outwards: Place) -> Place:
    """Where the elbow is: arms have their length."""
    reach = hand - shoulder
    distance = float(np.linalg.norm(reach))
    straight, far = reach / distance, min(distance, UPPER_ARM + FOREARM - 1e-3)
    along = (UPPER_ARM**2 - FOREARM**2 + far**2) / (2 * far)
    aside = max(UPPER_ARM**2 - along**2, 0.0) ** 0.5
    across = outwards - (outwards @ straight) * straight
    elbow: Place = shoulder + along * straight + aside * across / np.linalg.norm(across)
    return elbow
