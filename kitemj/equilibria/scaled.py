"""The residual of an equilibrium: scaled equations of motion at q̇ = 0, for any model."""

import numpy as np

from kitemj.dynamics.lagrange import body
from kitemj.equilibria.minimal import Array, state_of
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control


def mass_matrix(parameters: Parameters, x: Array, control: Control) -> Array:
    """M (4, 4) [kg m²] of the kinetic energy ½ q̇ᵀ M q̇ at `x` (8,) with the lines held."""
    kite, (q, _) = parameters.kite, state_of(x)
    moving = [body(parameters, q, Angles(*map(float, e)), control) for e in np.eye(4)]
    J = np.array([(*each.v_G_E, *each.omega_B) for each in moving]).T
    inertia = np.diag([kite.inertia_x, kite.inertia_y, kite.inertia_z])
    inertia[0, 2] = inertia[2, 0] = -kite.inertia_xz
    M: Array = kite.mass * J[:3].T @ J[:3] + J[3:].T @ inertia @ J[3:]
    return M


def residual(parameters: Parameters, x: Array, x_dot: Array, control: Control) -> float:
    """The largest |M q̈| / (m g ℓ): forces that are left over, in the paper's scaled equations.

    `x_dot` (8,) is what a model answers at `x`. Without gravity the dynamic pressure on the
    kite takes the weight's place.
    """
    kite, air = parameters.kite, parameters.environment
    force = kite.mass * air.gravity
    if force == 0.0:
        force = 0.5 * air.air_density * parameters.wind.speed**2 * kite.area
    left_over = mass_matrix(parameters, x, control) @ x_dot[4:]
    return float(np.abs(left_over).max() / (force * control.ell))
