"""Velocity of the air; one law for each type of `wind`.

To add a wind: a ``NamedTuple`` of its numbers, among them `speed` [m/s], for which an
equilibrium is sought and forces are scaled, and `azimuth` [rad], which turns the whole field
about z_E; and a compiled function of the contract of `wind_velocity`, registered with
``@wind_law.of(MyWind)``.
"""

from math import cos, pow, sin
from typing import Annotated, NamedTuple

from kitemj.physics.compiled import compiled, law
from kitemj.physics.quantity import Quantity
from kitemj.physics.vectors import Vector


class Wind(NamedTuple):
    """V (h/H₀)^a (1 + ε sin Ωt) along -x_E, the whole turned by `azimuth` about z_E.

    Source: Sánchez-Arriaga et al., Applied Mathematical Modelling 47 (2017), section 2.3.
    """

    speed: Annotated[float, Quantity("m/s", "V_w at the reference height", ge=0)]
    exponent: Annotated[float, Quantity("", "a of the power law; 0: no shear", ge=0)] = 0.0
    reference_height: Annotated[float, Quantity("m", "H₀", gt=0)] = 10.0
    gust_amplitude: Annotated[float, Quantity("", "ε, part of the speed", ge=0)] = 0.0
    gust_frequency: Annotated[float, Quantity("rad/s", "Ω", ge=0)] = 0.6
    azimuth: Annotated[float, Quantity("rad", "turns the wind about z_E, as φ turns")] = 0.0


def _wind_velocity(wind: Wind, p_E: Vector, t: float) -> Vector:
    """Velocity [m/s, E] of the air at the point `p_E` [m, E] and time `t` [s]."""
    raise NotImplementedError


wind_velocity, wind_law = law(_wind_velocity)


@compiled
def wind_speed(wind: Wind, height: float, t: float) -> float:
    """Speed [m/s] at `height` [m] above ground (below it: as on it) and time `t` [s]."""
    shear = pow(max(height, 0.0) / wind.reference_height, wind.exponent)
    return wind.speed * shear * (1 + wind.gust_amplitude * sin(wind.gust_frequency * t))


@wind_law.of(Wind)
@compiled
def power_law_velocity(wind: Wind, p_E: Vector, t: float) -> Vector:
    """As the docstring of `Wind` says."""
    V = wind_speed(wind, -p_E.z, t)
    return Vector(-V * cos(wind.azimuth), -V * sin(wind.azimuth), 0.0)
