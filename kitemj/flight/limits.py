"""Where the model stops being true, and how a flight can end."""

from collections.abc import Iterable
from enum import Enum
from math import degrees
from typing import NamedTuple

from kitemj.dynamics.motion import Motion, hull_corners_B
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import plus, unrotated

TOUCH = 1e-3
"""m; nearer than this to the ground the engine's contact is at work."""


class Ending(Enum):
    """How a flight ends, or what it first departs from; the value is the sentence."""

    FINISHED = "the flight lasted as long as was asked"
    SLACK = "a line went slack: models whose lines are rigid are not valid from here on"
    STALL = "the angle of attack left 0 < α < α_stall: the aerodynamic law is not valid"
    SIDESLIP = "the sideslip angle exceeded β_max: the aerodynamic law is not valid"
    GROUND = "the kite touched the ground"
    DIVERGED = "the numbers left the finite, or the equations their domain"


class Departure(NamedTuple):
    """The first moment outside the limits of validity: when [s], which, and by how much."""

    t: float
    ending: Ending
    reading: str

    def __str__(self) -> str:
        """One sentence."""
        return f"t = {self.t:.2f} s: {self.ending.value} ({self.reading})"


def departure_at(parameters: Parameters, motion: Motion) -> Departure | None:
    """What is outside its limits at this instant; None: nothing is."""
    limits, air = parameters.limits, motion.air
    left, right = motion.tensions
    if min(left, right) <= 0.0:
        return Departure(motion.t, Ending.SLACK, f"left {left:.2f} N, right {right:.2f} N")
    if not 0.0 < air.alpha < limits.alpha_stall:
        reading = f"α = {degrees(air.alpha):.2f}°, α_stall = {degrees(limits.alpha_stall):g}°"
        return Departure(motion.t, Ending.STALL, reading)
    if not abs(air.beta) < limits.beta_max:
        reading = f"β = {degrees(air.beta):.2f}°, β_max = {degrees(limits.beta_max):g}°"
        return Departure(motion.t, Ending.SIDESLIP, reading)
    return None


def first_departure(parameters: Parameters, motions: Iterable[Motion]) -> Departure | None:
    """The first departure among `motions`; None: all are valid."""
    found = (departure_at(parameters, motion) for motion in motions)
    return next((departure for departure in found if departure), None)


def touches_ground(parameters: Parameters, motion: Motion) -> bool:
    """Whether a corner of the kite's hull is on the ground (or below, with none to stop it)."""
    body = motion.body
    if -body.p_G_E.z > parameters.kite.span + parameters.kite.chord:
        return False
    corners = hull_corners_B(parameters.kite)
    return any(plus(body.p_G_E, unrotated(body.R_BE, corner)).z > -TOUCH for corner in corners)
