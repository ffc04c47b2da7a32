"""Lagrange's equations of the kite in the minimal coordinates q = (φ, γ, η, θ).

The coordinates are x = (φ, γ, η, θ, ℓ, δ): four move freely, two are prescribed by the hand.
With u = Σ U_i ẋ_i the velocity of G (components in frame 2) and w = Σ W_i ẋ_i the angular
velocity (components in B), T = ½ m u·u + ½ w·I w, and

    d/dt ∂T/∂ẋ_i - ∂T/∂x_i =
        Σ_j (m U_i·U_j + W_i·I W_j) ẍ_j
        + m (Σ_j U̇_j ẋ_j)·U_i + m u·(U̇_i - ∂u/∂x_i)
        + I (Σ_j Ẇ_j ẋ_j)·W_i + I w·(Ẇ_i - ∂w/∂x_i)  =  Q_i.

Rows 1-4 give the accelerations; rows 5 and 6, whose coordinates are prescribed, give the
forces that prescribe them, hence the two line tensions. No Coriolis term is written by
hand: only derivatives of components.

Source: Sánchez-Arriaga et al., Applied Mathematical Modelling 47 (2017), sections 2 and 3,
with ℓ and δ kept as coordinates (Lagrange multipliers in their simplest form).
"""

from math import cos, nan, sin
from typing import NamedTuple

from kitemj.dynamics.motion import Body, PerLine
from kitemj.dynamics.solve4 import Four, Symmetric, solved
from kitemj.physics.compiled import compiled
from kitemj.physics.frames import R_2E, R_B2, Angles
from kitemj.physics.kite import Kite
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, line_motion
from kitemj.physics.vectors import (
    Rotation,
    Vector,
    cross,
    dot,
    minus,
    plus,
    product,
    rotated,
    times,
    unrotated,
)

KEPT = 1e-8
"""Of the mass matrix's diagonal after elimination (`solve4`). φ and η turn about one axis at
γ = ±90°, where nothing is kept. q̈ and tensions were seen to be off by 3 x 2e-16 / kept at most,
relatively, so by less than 1e-7 up to here: within 0.6° of 90° for `laksa` and 0.3° for `sport`."""


class Columns(NamedTuple):
    """A vector for each coordinate."""

    phi: Vector
    gamma: Vector
    eta: Vector
    theta: Vector
    ell: Vector
    delta: Vector


class Kinematics(NamedTuple):
    """u, w linear in the rates: partial velocities, and how these change.

    `U`, `U_dot`, `u_x` (= ∂u/∂x_i) in frame 2, m or m/s; `W`, `W_dot`, `w_x` in B.
    """

    r: Vector
    u: Vector
    w: Vector
    U: Columns
    U_dot: Columns
    u_x: Columns
    W: Columns
    W_dot: Columns
    w_x: Columns


class Accelerations(NamedTuple):
    """q̈ [rad/s²] and the line tensions [N]."""

    q_ddot: Angles
    tensions: PerLine


@compiled
def _turn(v: Vector) -> Vector:
    """∂(R_B2 e)/∂θ for v = R_B2 e."""
    return Vector(-v.z, 0.0, v.x)


@compiled
def _sum(columns: Columns, x: Angles, c: Control) -> Vector:
    """Σ_i columns_i ẋ_i for the rates `x` of q and those of the control `c`."""
    q_part = plus(
        plus(times(x.phi, columns.phi), times(x.gamma, columns.gamma)),
        plus(times(x.eta, columns.eta), times(x.theta, columns.theta)),
    )
    return plus(q_part, plus(times(c.ell_dot, columns.ell), times(c.delta_dot, columns.delta)))


@compiled
def kinematics(kite: Kite, q: Angles, x: Angles, c: Control) -> Kinematics:
    """Partial velocities and their changes at `q` [rad], rates `x` [rad/s], control `c`."""
    sg, cg, se, ce = sin(q.gamma), cos(q.gamma), sin(q.eta), cos(q.eta)
    st, ct, sd, cd = sin(q.theta), cos(q.theta), sin(c.delta), cos(c.delta)
    X, Z, zero = kite.x_A, kite.z_A, Vector(0.0, 0.0, 0.0)

    # G seen from O_E, in frame 2, and its derivatives by θ, ℓ and δ
    r = Vector(-(X * ct + Z * st), c.ell * sd, -c.ell * cd + X * st - Z * ct)
    r_theta = Vector(X * st - Z * ct, 0.0, X * ct + Z * st)
    r_theta_theta = Vector(X * ct + Z * st, 0.0, -X * st + Z * ct)
    r_ell, r_ell_delta = Vector(0.0, sd, -cd), Vector(0.0, cd, sd)
    r_delta = Vector(0.0, c.ell * cd, c.ell * sd)
    r_delta_delta = Vector(0.0, -c.ell * sd, c.ell * cd)
    r_dot = plus(
        times(x.theta, r_theta), plus(times(c.ell_dot, r_ell), times(c.delta_dot, r_delta))
    )

    # the axes about which φ, γ and η turn (k_E, j_1, i_2), in frame 2, and their derivatives
    e_phi, e_gamma = Vector(-sg, se * cg, ce * cg), Vector(0.0, ce, -se)
    e_eta, e_gamma_eta = Vector(1.0, 0.0, 0.0), Vector(0.0, -se, -ce)
    e_phi_gamma, e_phi_eta = Vector(-cg, -se * sg, -ce * sg), Vector(0.0, ce * cg, -se * cg)
    e_phi_dot = plus(times(x.gamma, e_phi_gamma), times(x.eta, e_phi_eta))
    e_gamma_dot = times(x.eta, e_gamma_eta)
    spin = plus(plus(times(x.phi, e_phi), times(x.gamma, e_gamma)), times(x.eta, e_eta))
    spin_gamma = times(x.phi, e_phi_gamma)
    spin_eta = plus(times(x.phi, e_phi_eta), times(x.gamma, e_gamma_eta))

    U = Columns(cross(e_phi, r), cross(e_gamma, r), cross(e_eta, r), r_theta, r_ell, r_delta)
    U_dot = Columns(
        plus(cross(e_phi_dot, r), cross(e_phi, r_dot)),
        plus(cross(e_gamma_dot, r), cross(e_gamma, r_dot)),
        cross(e_eta, r_dot),
        times(x.theta, r_theta_theta),
        times(c.delta_dot, r_ell_delta),
        plus(times(c.ell_dot, r_ell_delta), times(c.delta_dot, r_delta_delta)),
    )
    u_x = Columns(
        zero,
        cross(spin_gamma, r),
        cross(spin_eta, r),
        plus(cross(spin, r_theta), U_dot.theta),
        plus(cross(spin, r_ell), U_dot.ell),
        plus(cross(spin, r_delta), U_dot.delta),
    )

    R = R_B2(q.theta)
    W = Columns(
        rotated(R, e_phi), rotated(R, e_gamma), rotated(R, e_eta), Vector(0.0, 1.0, 0.0), zero, zero
    )
    W_dot = Columns(
        plus(rotated(R, e_phi_dot), times(x.theta, _turn(W.phi))),
        plus(rotated(R, e_gamma_dot), times(x.theta, _turn(W.gamma))),
        times(x.theta, _turn(W.eta)),
        zero,
        zero,
        zero,
    )
    w_x = Columns(
        zero, rotated(R, spin_gamma), rotated(R, spin_eta), _turn(rotated(R, spin)), zero, zero
    )
    return Kinematics(r, _sum(U, x, c), _sum(W, x, c), U, U_dot, u_x, W, W_dot, w_x)


@compiled
def body(parameters: Parameters, q: Angles, q_dot: Angles, c: Control) -> Body:
    """Pose and velocity of the kite at `q` [rad], `q_dot` [rad/s] and control `c`."""
    k = kinematics(parameters.kite, q, q_dot, c)
    R = R_2E(q)
    return Body(unrotated(R, k.r), product(R_B2(q.theta), R), unrotated(R, k.u), k.w)


@compiled
def _inertia(kite: Kite, w: Vector) -> Vector:
    """I w."""
    return Vector(
        kite.inertia_x * w.x - kite.inertia_xz * w.z,
        kite.inertia_y * w.y,
        kite.inertia_z * w.z - kite.inertia_xz * w.x,
    )


@compiled
def accelerations(
    parameters: Parameters, c: Control, t: float, q: Angles, q_dot: Angles
) -> Accelerations:
    """q̈ and tensions at `q` [rad], `q_dot` [rad/s], control `c` and time `t` [s].

    Not numbers where the coordinates keep too few digits (`KEPT`).
    """
    kite = parameters.kite
    r, u, w, U, U_dot, u_x, W, W_dot, w_x = kinematics(kite, q, q_dot, c)
    R_2 = R_2E(q)
    R_2B: Rotation = R_B2(q.theta)  # rows: axes of B in 2
    state = Body(unrotated(R_2, r), product(R_2B, R_2), unrotated(R_2, u), w)
    wrench = aerodynamic_wrench(parameters, state.p_G_E, state.R_BE, state.v_G_E, state.omega_B, t)

    # weight acts along k_E, whose components in 2 are the axis that φ turns about
    k_E = Vector(R_2.x.z, R_2.y.z, R_2.z.z)
    weight = times(kite.mass * parameters.environment.gravity, k_E)
    force = plus(unrotated(R_2B, wrench.force), weight)

    # what does not multiply ẍ: f = Q - h, with momentum p = m u and spin s = I w
    p, s = times(kite.mass, u), _inertia(kite, w)
    f_u = minus(force, times(kite.mass, _sum(U_dot, q_dot, c)))
    f_w = minus(wrench.moment, _inertia(kite, _sum(W_dot, q_dot, c)))
    f_phi = _row(f_u, f_w, p, s, U.phi, W.phi, U_dot.phi, W_dot.phi, u_x.phi, w_x.phi)
    f_gamma = _row(f_u, f_w, p, s, U.gamma, W.gamma, U_dot.gamma, W_dot.gamma, u_x.gamma, w_x.gamma)
    f_eta = _row(f_u, f_w, p, s, U.eta, W.eta, U_dot.eta, W_dot.eta, u_x.eta, w_x.eta)
    f_theta = _row(f_u, f_w, p, s, U.theta, W.theta, U_dot.theta, W_dot.theta, u_x.theta, w_x.theta)
    f_ell = _row(f_u, f_w, p, s, U.ell, W.ell, U_dot.ell, W_dot.ell, u_x.ell, w_x.ell)
    f_delta = _row(f_u, f_w, p, s, U.delta, W.delta, U_dot.delta, W_dot.delta, u_x.delta, w_x.delta)

    # ẍ: the prescribed part first, then q̈ from rows 1-4
    u_given = plus(times(c.ell_ddot, U.ell), times(c.delta_ddot, U.delta))
    p_given = times(kite.mass, u_given)
    mass = Symmetric(
        _mass(kite, U.phi, W.phi, U.phi, W.phi),
        _mass(kite, U.phi, W.phi, U.gamma, W.gamma),
        _mass(kite, U.phi, W.phi, U.eta, W.eta),
        _mass(kite, U.phi, W.phi, U.theta, W.theta),
        _mass(kite, U.gamma, W.gamma, U.gamma, W.gamma),
        _mass(kite, U.gamma, W.gamma, U.eta, W.eta),
        _mass(kite, U.gamma, W.gamma, U.theta, W.theta),
        _mass(kite, U.eta, W.eta, U.eta, W.eta),
        _mass(kite, U.eta, W.eta, U.theta, W.theta),
        _mass(kite, U.theta, W.theta, U.theta, W.theta),
    )
    force_free = Four(
        f_phi - dot(p_given, U.phi),
        f_gamma - dot(p_given, U.gamma),
        f_eta - dot(p_given, U.eta),
        f_theta - dot(p_given, U.theta),
    )
    a = solved(mass, force_free)
    if not a.kept >= KEPT:
        return Accelerations(Angles(nan, nan, nan, nan), PerLine(nan, nan))

    # rows 5 and 6: -T₊ ∂L₊/∂ℓ - T₋ ∂L₋/∂ℓ and the same by δ
    u_free = plus(
        plus(times(a.a, U.phi), times(a.b, U.gamma)), plus(times(a.c, U.eta), times(a.d, U.theta))
    )
    p_dot = times(kite.mass, plus(u_free, u_given))
    Q_ell, Q_delta = dot(p_dot, U.ell) - f_ell, dot(p_dot, U.delta) - f_delta
    return Accelerations(Angles(a.a, a.b, a.c, a.d), _tensions(kite.y_A, c, Q_ell, Q_delta))


@compiled
def spatial(
    kite: Kite, q: Angles, q_dot: Angles, q_ddot: Angles, c: Control
) -> tuple[Vector, Vector]:
    """a_G [m/s², E] and ω̇ [rad/s², B] that `q_ddot` [rad/s²] means."""
    k = kinematics(kite, q, q_dot, c)
    faster = Control(0.0, c.ell_ddot, 0.0, 0.0, c.delta_ddot, 0.0)
    u_dot = plus(_sum(k.U, q_ddot, faster), _sum(k.U_dot, q_dot, c))
    omega_dot = plus(_sum(k.W, q_ddot, faster), _sum(k.W_dot, q_dot, c))
    # u is told in frame 2, which turns like the body but for θ̇ about y_2
    omega_2 = minus(unrotated(R_B2(q.theta), k.w), Vector(0.0, q_dot.theta, 0.0))
    return unrotated(R_2E(q), plus(u_dot, cross(omega_2, k.u))), omega_dot


@compiled
def _row(
    f_u: Vector,
    f_w: Vector,
    p: Vector,
    s: Vector,
    U: Vector,
    W: Vector,
    U_dot: Vector,
    W_dot: Vector,
    u_x: Vector,
    w_x: Vector,
) -> float:
    """Q_i - h_i of one coordinate."""
    return dot(f_u, U) + dot(f_w, W) - dot(p, minus(U_dot, u_x)) - dot(s, minus(W_dot, w_x))


@compiled
def _mass(kite: Kite, U_i: Vector, W_i: Vector, U_j: Vector, W_j: Vector) -> float:
    return kite.mass * dot(U_i, U_j) + dot(W_i, _inertia(kite, W_j))


@compiled
def _tensions(y_A: float, c: Control, Q_ell: float, Q_delta: float) -> PerLine:
    """Tensions [N] whose virtual work is Q_ℓ dℓ + Q_δ dδ: a line does -T dL."""
    L_plus, L_minus = line_motion(y_A, c, 1.0).length, line_motion(y_A, c, -1.0).length
    # L± ∂L±/∂ℓ = ℓ ± y_A sin δ, L± ∂L±/∂δ = ±ℓ y_A cos δ
    difference = -Q_delta / (c.ell * y_A * cos(c.delta))  # T₊/L₊ - T₋/L₋
    total = (-Q_ell - y_A * sin(c.delta) * difference) / c.ell  # T₊/L₊ + T₋/L₋
    return PerLine(0.5 * (total + difference) * L_plus, 0.5 * (total - difference) * L_minus)
