"""The land's frame, which turns with the wind, and where the sun stands in it.

L  the land: ahead (downwind), left, up. In it the sea is ahead, whatever the wind's azimuth.
"""

from math import cos, pi, sin

from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector

SUN = Vector(-0.36, 0.36, 0.86)
"""L, towards it: behind the pilot's left shoulder, 59° up, as kite flyers stand."""


def land_turn(azimuth: float) -> float:
    """Angle [rad] about z_W that takes L to W, for the wind's `azimuth` [rad]."""
    return pi - azimuth


def land_to_E(parameters: Parameters, v_L: Vector) -> Vector:
    """Components in E of components in L."""
    a = parameters.wind.azimuth
    x, y, z = v_L
    return Vector(-cos(a) * x - sin(a) * y, -sin(a) * x + cos(a) * y, -z)


def sun(parameters: Parameters) -> Vector:
    """Direction [E] towards the sun."""
    return land_to_E(parameters, SUN)
