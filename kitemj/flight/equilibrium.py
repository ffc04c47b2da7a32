"""Where the kite hangs still in a constant wind, from one scalar equation.

Source: Sánchez-Arriaga et al., Applied Mathematical Modelling 47 (2017), section 4; no
dynamics code is needed, so the models can be held against it.
"""

from math import atan2, cos, hypot, pi, sin
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from kitemj.dynamics.motion import State
from kitemj.errors import InputError
from kitemj.physics.aerodynamics import coefficients
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import rest_ell
from kitemj.physics.vectors import Vector

STILL = Vector(0.0, 0.0, 0.0)


class Equilibrium(NamedTuple):
    """Angle of attack, γ and θ [rad]; the tension [N] of each line."""

    alpha: float
    gamma: float
    theta: float
    tension: float


def _forces(parameters: Parameters, alpha: float) -> tuple[float, float, float]:
    """Air force X, Z [N, B] and pitching moment about the attachments [N m] at `alpha` [rad].

    In symmetric flight the kite's pitch angle is α = γ + θ: the wind is horizontal.
    """
    kite, V = parameters.kite, parameters.wind.speed
    C = coefficients(parameters.aero, kite, alpha, 0.0, STILL, V)
    qS = 0.5 * parameters.environment.air_density * V * V * kite.area
    X, Z = qS * C.x, qS * C.z
    weight = kite.mass * parameters.environment.gravity
    # all forces act at G, which sits at -(X_A, 0, Z_A) from the attachments
    X_all, Z_all = X - weight * sin(alpha), Z + weight * cos(alpha)
    moment = qS * kite.chord * C.m - kite.z_A * X_all + kite.x_A * Z_all
    return X, Z, moment


def equilibrium(parameters: Parameters, source: str = "parameters") -> Equilibrium:
    """The equilibrium with 0 < α < α_stall and both lines pulling, in `parameters.wind.speed`.

    Gusts, shear and the wind's azimuth are left out. Raises InputError where there is none.
    """
    angles = np.linspace(0.0, parameters.limits.alpha_stall, 400)
    moments = [_forces(parameters, float(alpha))[2] for alpha in angles]
    for low, high, m_low, m_high in zip(angles, angles[1:], moments, moments[1:], strict=False):
        if m_low * m_high < 0:
            alpha = float(brentq(lambda a: _forces(parameters, a)[2], low, high, xtol=1e-15))
            found = _hanging(parameters, alpha)
            if found.tension > 0 and abs(found.gamma) < pi / 2:
                return found
    raise InputError(
        f"there is no equilibrium with 0 < alpha < alpha_stall = "
        f"{np.degrees(parameters.limits.alpha_stall):g} deg in a wind of "
        f"{parameters.wind.speed} m/s ({source}); change the wind or the kite, or give "
        f'[start] at = "state"'
    )


def _hanging(parameters: Parameters, alpha: float) -> Equilibrium:
    """The lines point along the sum of all forces on the kite."""
    X, Z, _ = _forces(parameters, alpha)
    weight = parameters.kite.mass * parameters.environment.gravity
    F_x = X * cos(alpha) + Z * sin(alpha)
    F_z = -X * sin(alpha) + Z * cos(alpha) + weight
    gamma = atan2(-F_x, -F_z)
    length, y_A = parameters.lines.length, parameters.kite.y_A
    share = rest_ell(length, y_A) / length  # cosine of the angle between a line and their middle
    pull = hypot(F_x, F_z) / (2 * share)
    return Equilibrium(alpha, gamma, alpha - gamma, pull)


def equilibrium_state(parameters: Parameters, source: str = "parameters") -> State:
    """The equilibrium as a start: facing the wind, at rest."""
    found = equilibrium(parameters, source)
    q = Angles(parameters.wind.azimuth, found.gamma, 0.0, found.theta)
    return State(q, Angles(0.0, 0.0, 0.0, 0.0))
