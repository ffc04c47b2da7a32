"""The free body that hangs on two straight lines: where an engine flight starts."""

from math import cos, sin

from kitemj.dynamics.motion import Body
from kitemj.physics.compiled import compiled
from kitemj.physics.frames import R_1E, R_21, R_B2, Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control
from kitemj.physics.vectors import Vector, cross, plus, product, rotated, times, unrotated


@compiled
def straight_body(parameters: Parameters, q: Angles, q_dot: Angles, c: Control) -> Body:
    """Pose and velocity at `q` [rad], `q_dot` [rad/s] with both lines as `c` says.

    The midpoint of the attachments moves in frame 1, which turns by φ̇ k_E + γ̇ j_1; the
    kite turns about it by ω_B = φ̇ k_E + γ̇ j_1 + η̇ i_2 + θ̇ j_2.
    """
    kite, lean, lean_dot = parameters.kite, q.eta + c.delta, q_dot.eta + c.delta_dot
    R_1, R_2, R_B = R_1E(q.phi, q.gamma), R_21(q.eta), R_B2(q.theta)

    omega_1 = Vector(-q_dot.phi * sin(q.gamma), q_dot.gamma, q_dot.phi * cos(q.gamma))
    along = Vector(0.0, sin(lean), -cos(lean))
    across = Vector(0.0, cos(lean), sin(lean))
    p_O2_1 = times(c.ell, along)
    v_O2_1 = plus(
        plus(times(c.ell_dot, along), times(c.ell * lean_dot, across)), cross(omega_1, p_O2_1)
    )

    omega_2 = plus(rotated(R_2, omega_1), Vector(q_dot.eta, q_dot.theta, 0.0))
    omega_B = rotated(R_B, omega_2)
    O2_G_B = Vector(-kite.x_A, 0.0, -kite.z_A)
    R_BE = product(R_B, product(R_2, R_1))
    return Body(
        plus(unrotated(R_1, p_O2_1), unrotated(R_BE, O2_G_B)),
        R_BE,
        plus(unrotated(R_1, v_O2_1), unrotated(R_BE, cross(omega_B, O2_G_B))),
        omega_B,
    )
