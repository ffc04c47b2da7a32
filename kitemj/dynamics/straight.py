"""A free body on two straight lines: its pose and velocity from (q, q̇), and the way back."""

from math import cos, hypot, sin
from typing import NamedTuple

from kitemj.dynamics.motion import Body, State, angles_of
from kitemj.physics.compiled import compiled
from kitemj.physics.frames import R_1E, R_21, R_B2, R_BE, Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control
from kitemj.physics.vectors import Vector, cross, dot, minus, norm, plus, rotated, times, unrotated


@compiled
def straight_body(parameters: Parameters, q: Angles, q_dot: Angles, c: Control) -> Body:
    """Pose and velocity at `q` [rad], `q_dot` [rad/s] with both lines as `c` says.

    The midpoint of the attachments moves in frame 1, which turns by φ̇ k_E + γ̇ j_1; the
    kite turns about it by ω_B = φ̇ k_E + γ̇ j_1 + η̇ i_2 + θ̇ j_2.
    """
    kite, lean, lean_dot = parameters.kite, q.eta + c.delta, q_dot.eta + c.delta_dot
    R_1, R_2, R_B = R_1E(q.phi, q.gamma), R_21(q.eta), R_B2(q.theta)

    omega_1 = Vector(-q_dot.phi * sin(q.gamma), q_dot.gamma, q_dot.phi * cos(q.gamma))
    along, across = Vector(0.0, sin(lean), -cos(lean)), Vector(0.0, cos(lean), sin(lean))
    p_O2_1 = times(c.ell, along)
    v_O2_1 = plus(
        plus(times(c.ell_dot, along), times(c.ell * lean_dot, across)), cross(omega_1, p_O2_1)
    )

    omega_2 = plus(rotated(R_2, omega_1), Vector(q_dot.eta, q_dot.theta, 0.0))
    omega_B = rotated(R_B, omega_2)
    attitude, O2_G_B = R_BE(q), Vector(-kite.x_A, 0.0, -kite.z_A)
    return Body(
        plus(unrotated(R_1, p_O2_1), unrotated(attitude, O2_G_B)),
        attitude,
        plus(unrotated(R_1, v_O2_1), unrotated(attitude, cross(omega_B, O2_G_B))),
        omega_B,
    )


class Turning(NamedTuple):
    """How the coordinates of a free body change: their rates, and the axes they turn about [E].

    `normal` = p x j_2 [m], with p from O_E to the midpoint O_2, lies along i_2 and so says φ and γ.
    """

    q_dot: Angles
    normal: Vector
    normal_dot: Vector
    i_2: Vector
    j_1: Vector
    omega_E: Vector


@compiled
def turning(parameters: Parameters, body: Body) -> Turning:
    """The rates [rad/s] of q: ω = φ̇ k_E + γ̇ j_1 + η̇ i_2 + θ̇ j_2, with φ̇ and γ̇ those of i_2.

    Not a number where i_2 is vertical.
    """
    kite, j_2 = parameters.kite, body.R_BE.y
    omega = unrotated(body.R_BE, body.omega_B)
    r = unrotated(body.R_BE, Vector(kite.x_A, 0.0, kite.z_A))
    p, v = plus(body.p_G_E, r), plus(body.v_G_E, cross(omega, r))
    n, n_dot = cross(p, j_2), plus(cross(v, j_2), cross(p, cross(omega, j_2)))
    level = hypot(n.x, n.y)
    outward = (n.x * n_dot.x + n.y * n_dot.y) / level
    phi_dot = (n.x * n_dot.y - n.y * n_dot.x) / (level * level)
    gamma_dot = -(n_dot.z * level - n.z * outward) / (level * level + n.z * n.z)
    i_2, j_1 = times(1.0 / norm(n), n), Vector(-n.y / level, n.x / level, 0.0)
    rest = minus(minus(omega, times(gamma_dot, j_1)), Vector(0.0, 0.0, phi_dot))
    q_dot = Angles(phi_dot, gamma_dot, dot(rest, i_2), dot(rest, j_2))
    return Turning(q_dot, n, n_dot, i_2, j_1, omega)


@compiled
def state_of(parameters: Parameters, body: Body) -> State:
    """(q, q̇) of a body; the inverse of `straight_body`."""
    return State(angles_of(parameters, body), turning(parameters, body).q_dot)


@compiled
def q_ddot_of(parameters: Parameters, body: Body, a_G_E: Vector, omega_dot_B: Vector) -> Angles:
    """q̈ [rad/s²] of accelerations [m/s², E; rad/s², B]: the time derivative of `turning`."""
    kite, j_2, now = parameters.kite, body.R_BE.y, turning(parameters, body)
    (phi_dot, gamma_dot, eta_dot, theta_dot), n, n_dot, i_2, j_1, omega = now
    omega_dot = unrotated(body.R_BE, omega_dot_B)
    r = unrotated(body.R_BE, Vector(kite.x_A, 0.0, kite.z_A))
    p, v = plus(body.p_G_E, r), plus(body.v_G_E, cross(omega, r))
    a = plus(plus(a_G_E, cross(omega_dot, r)), cross(omega, cross(omega, r)))
    j_2_dot = cross(omega, j_2)
    j_2_ddot = plus(cross(omega_dot, j_2), cross(omega, j_2_dot))
    n_ddot = plus(plus(cross(a, j_2), times(2.0, cross(v, j_2_dot))), cross(p, j_2_ddot))

    level = hypot(n.x, n.y)
    level_dot = (n.x * n_dot.x + n.y * n_dot.y) / level
    level_ddot = (
        n_dot.x * n_dot.x
        + n.x * n_ddot.x
        + n_dot.y * n_dot.y
        + n.y * n_ddot.y
        - level_dot * level_dot
    ) / level
    size, size_dot = level * level + n.z * n.z, 2 * (level * level_dot + n.z * n_dot.z)
    phi_ddot = ((n.x * n_ddot.y - n.y * n_ddot.x) / level - 2 * phi_dot * level_dot) / level
    gamma_ddot = -(n_ddot.z * level - n.z * level_ddot + gamma_dot * size_dot) / size

    k_E = Vector(0.0, 0.0, 1.0)
    omega_1 = plus(times(phi_dot, k_E), times(gamma_dot, j_1))
    of_axes = plus(
        times(gamma_dot * phi_dot, cross(k_E, j_1)),
        plus(times(eta_dot, cross(omega_1, i_2)), times(theta_dot, j_2_dot)),
    )
    rest = minus(minus(omega_dot, of_axes), plus(times(phi_ddot, k_E), times(gamma_ddot, j_1)))
    return Angles(phi_ddot, gamma_ddot, dot(rest, i_2), dot(rest, j_2))
