"""The rates φ̇, γ̇, η̇, θ̇ computed from pose, velocity and body rates."""

import numpy as np

from kitemj.plots.flight import Array, Flight
from kitemj.recording.table import ATTITUDE, RATES, VELOCITY

POSITION = ("x_E_m", "y_E_m", "z_E_m")


def q_dot(flight: Flight) -> Array:
    """φ̇, γ̇, η̇, θ̇ [rad/s] of each row, shape (rows, 4): the derivative of `frames.angles`.

    With p the midpoint of the attachments, moving at v, and j_2 = y_B: x_1 is along p x j_2,
    φ̇ and γ̇ are how x_1 turns, and ω - φ̇ k_E - γ̇ j_1 = η̇ i_2 + θ̇ j_2 leaves the others. Not
    a number where x_1 is vertical. Raises InputError where a column lacks.
    """
    needed = "the rates"
    R_BE = flight.matrix(ATTITUDE, needed).reshape(-1, 3, 3)
    omega_B, v_G = flight.matrix(RATES, needed), flight.matrix(VELOCITY, needed)
    kite = flight.parameters.kite
    to_O2 = np.array([kite.x_A, 0.0, kite.z_A])
    omega = _in_E(R_BE, omega_B)
    p = flight.matrix(POSITION, needed) + _in_E(R_BE, np.broadcast_to(to_O2, v_G.shape))
    v = v_G + _in_E(R_BE, np.cross(omega_B, to_O2))
    j_2 = R_BE[:, 1]
    normal = np.cross(p, j_2)
    turning = np.cross(v, j_2) + np.cross(p, np.cross(omega, j_2))
    x, y, z = normal.T
    dx, dy, dz = turning.T
    level = np.hypot(x, y)
    with np.errstate(divide="ignore", invalid="ignore"):
        phi_dot = (x * dy - y * dx) / level**2
        gamma_dot = -(dz * level - z * (x * dx + y * dy) / level) / (level**2 + z**2)
        i_2 = normal / np.linalg.norm(normal, axis=1)[:, None]
        j_1 = np.column_stack([-y / level, x / level, 0.0 * x])
    left = omega - gamma_dot[:, None] * j_1
    left[:, 2] -= phi_dot
    eta_dot, theta_dot = (np.einsum("ij,ij->i", left, axis) for axis in (i_2, j_2))
    return np.column_stack([phi_dot, gamma_dot, eta_dot, theta_dot])


def _in_E(R_BE: Array, v_B: Array) -> Array:
    """Components in E of vectors [B], shape (rows, 3)."""
    v_E: Array = np.einsum("nji,nj->ni", R_BE, v_B)
    return v_E
