"""The one door through which every model asks what the air does to the kite.

motion and time -> wind -> angles of attack and sideslip -> coefficients -> force and moment
"""

from math import asin, atan2
from typing import NamedTuple

from kitemj.physics.aerodynamics import coefficients
from kitemj.physics.compiled import compiled
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Rotation, Vector, minus, norm, rotated
from kitemj.physics.wind import wind_velocity


class Air(NamedTuple):
    """The air as the kite meets it: `alpha`, `beta` [rad], `speed` [m/s]."""

    alpha: float
    beta: float
    speed: float


class Wrench(NamedTuple):
    """Force [N, B] and moment about G [N m, B]."""

    force: Vector
    moment: Vector


@compiled
def air(parameters: Parameters, p_G_E: Vector, R_BE: Rotation, v_G_E: Vector, t: float) -> Air:
    """α = atan2(v_z, v_x), β = asin(v_y / |v|) of v = R_BE (v_G - v_wind); 0 in still air.

    `p_G_E` [m], `v_G_E` [m/s], `t` [s]. LAKSA takes atan for α; both agree for |α| < 90°.
    """
    v_B = rotated(R_BE, minus(v_G_E, wind_velocity(parameters.wind, p_G_E, t)))
    speed = norm(v_B)
    if speed == 0.0:
        return Air(0.0, 0.0, 0.0)
    return Air(atan2(v_B.z, v_B.x), asin(max(-1.0, min(1.0, v_B.y / speed))), speed)


@compiled
def aerodynamic_wrench(
    parameters: Parameters, p_G_E: Vector, R_BE: Rotation, v_G_E: Vector, omega_B: Vector, t: float
) -> Wrench:
    """Force and moment of the air, for a pose [m], velocity [m/s, E] and rates [rad/s, B]."""
    alpha, beta, speed = air(parameters, p_G_E, R_BE, v_G_E, t)
    if speed == 0.0:
        return Wrench(Vector(0.0, 0.0, 0.0), Vector(0.0, 0.0, 0.0))
    C = coefficients(parameters.aero, parameters.kite, alpha, beta, omega_B, speed)
    size = parameters.kite
    qS = 0.5 * parameters.environment.air_density * speed * speed * size.area
    return Wrench(
        Vector(qS * C.x, qS * C.y, qS * C.z),
        Vector(qS * size.span * C.l, qS * size.chord * C.m, qS * size.span * C.n),
    )
