"""Motions whose every number is written down, and attitudes of whole words."""

from math import cos, radians, sin

from kitemj.dynamics.motion import Body, LineState, Motion
from kitemj.physics.loads import Air
from kitemj.physics.steering import Control
from kitemj.physics.vectors import Rotation, Vector

ZERO = Vector(0.0, 0.0, 0.0)
AHEAD, LEFT, DOWN = Vector(1.0, 0.0, 0.0), Vector(0.0, 1.0, 0.0), Vector(0.0, 0.0, 1.0)
UPWIND, UP, RIGHT = AHEAD, Vector(0.0, 0.0, -1.0), Vector(0.0, -1.0, 0.0)
LEVEL = Rotation(AHEAD, LEFT, DOWN)
"""Axes of B in E: the nose upwind, the left wing (y_B) to the pilot's left."""


def rolled(degrees: float) -> Rotation:
    """The right-hand turn about the nose: y_B goes down."""
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return Rotation(AHEAD, Vector(0.0, c, s), Vector(0.0, -s, c))


def pitched(degrees: float) -> Rotation:
    """The nose goes up."""
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return Rotation(Vector(c, 0.0, -s), LEFT, Vector(s, 0.0, c))


def motion(
    p_G_E: Vector,
    R_BE: Rotation = LEVEL,
    v_G_E: Vector = ZERO,
    omega_B: Vector = ZERO,
    air: tuple[float, float, float] = (10.0, 0.0, 9.0),
    tensions: tuple[float, float] = (20.0, 20.0),
    lengths: tuple[float, float] = (50.0, 50.0),
    control: Control | None = None,
    t: float = 0.0,
) -> Motion:
    """The motion with these numbers; `air` is α [deg], β [deg], speed [m/s]."""
    lines = tuple(
        LineState(length, pull, pull, (ZERO, p_G_E))
        for length, pull in zip(lengths, tensions, strict=True)
    )
    met = Air(radians(air[0]), radians(air[1]), air[2])
    hands = control or Control(50.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    return Motion(t, None, Body(p_G_E, R_BE, v_G_E, omega_B), hands, lines, met)
