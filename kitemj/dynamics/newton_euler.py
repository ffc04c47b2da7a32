"""The kite as a free rigid body, its two line forces solved together with the accelerations.

State: p_G [m, E], quaternion B -> E, v_G [m/s, E], ω [rad/s, B]; 13 numbers. With u the unit
vector from O_E to an attachment A, T what its line pulls, F and M the wrench of the air::

    m a_G = m g k_E + R_BEᵀ F - T₊ u₊ - T₋ u₋                           (Newton, in E)
    I ω̇ + ω x I ω = M - T₊ GA₊ x u₊ - T₋ GA₋ x u₋                       (Euler, about G in B)
    u · a_G + (GA x u) · ω̇ + u · (ω x (ω x GA)) + (|v_A|² - (u · v_A)²) / |O_E A| = L̈

The third, twice the time derivative of |O_E A±| = L±(t), holds for either line and makes two
linear equations for T₊ and T₋. Nothing here knows of the minimal coordinates except `placed`,
the start of a flight. Lines stay straight: a negative T says that a real line would be slack.

These hold the second derivative of the distances only: rounding and truncation make them
drift. After each fixed step, and at each output time of the adaptive integrator, pose and
velocity are put back on |O_E A±| = L± and its first derivative by the least change in the
metric of mass and inertia, and the quaternion on norm 1 (`corrected`). Measured over 60 s of
steering on 200 m lines and of loops on 20 m lines, the adaptive integrator drifts by less than
3e-13 m between outputs 5 s apart, 3e-11 m if left alone; so it needs no stabilising terms.
"""

from math import cos, sin, sqrt
from typing import NamedTuple

from kitemj.dynamics.motion import Body, PerLine, State
from kitemj.physics.compiled import compiled
from kitemj.physics.frames import R_1E, R_BE, Quaternion, R_BE_of, quaternion
from kitemj.physics.kite import Kite
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Programme, control, line_motion
from kitemj.physics.vectors import Vector, cross, dot, minus, norm, plus, rotated, times, unrotated


class Free(NamedTuple):
    """The 13 numbers of the free body, or their time derivatives; quaternion B -> E."""

    p_G_E: Vector
    e: Quaternion
    v_G_E: Vector
    omega_B: Vector


class Accelerations(NamedTuple):
    """Of G [m/s², E], of the rates [rad/s², B], and the forces [N] with which the lines pull."""

    a_G_E: Vector
    omega_dot_B: Vector
    tensions: PerLine


class Line(NamedTuple):
    """The straight way from O_E to one attachment.

    `distance` [m], its `rate` [m/s], the unit vector `u_E`, `lever_B` = GA x u [m], and
    `turning` [m/s²]: the second derivative of the distance when a_G and ω̇ are zero.
    """

    distance: float
    rate: float
    u_E: Vector
    lever_B: Vector
    turning: float


class Pull(NamedTuple):
    """Pulls of the two lines, and the change they make: linear part in E, angular part in B."""

    linear_E: Vector
    angular_B: Vector
    pulls: PerLine


@compiled
def spin(kite: Kite, omega_B: Vector) -> Vector:
    """Angular momentum I ω about G [N m s, B]; the tensor holds -I_xz."""
    w = omega_B
    return Vector(
        kite.inertia_x * w.x - kite.inertia_xz * w.z,
        kite.inertia_y * w.y,
        kite.inertia_z * w.z - kite.inertia_xz * w.x,
    )


@compiled
def unspin(kite: Kite, moment_B: Vector) -> Vector:
    """I⁻¹ M: the inverse of `spin`."""
    I_x, I_z, I_xz = kite.inertia_x, kite.inertia_z, kite.inertia_xz
    M, I_y, det = moment_B, kite.inertia_y, I_x * I_z - I_xz * I_xz
    return Vector((I_z * M.x + I_xz * M.z) / det, M.y / I_y, (I_xz * M.x + I_x * M.z) / det)


@compiled
def line(kite: Kite, body: Body, side: float) -> Line:
    """The line to A₊ (`side` +1) or A₋ (-1) at a pose and velocity."""
    GA_B = Vector(kite.x_A, side * kite.y_A, kite.z_A)
    p_A_E = plus(body.p_G_E, unrotated(body.R_BE, GA_B))
    swing_B = cross(body.omega_B, GA_B)
    v_A_E = plus(body.v_G_E, unrotated(body.R_BE, swing_B))
    distance = norm(p_A_E)
    u_E = times(1 / distance, p_A_E)
    u_B = rotated(body.R_BE, u_E)
    rate = dot(u_E, v_A_E)
    sideways = (dot(v_A_E, v_A_E) - rate * rate) / distance
    turning = dot(u_B, cross(body.omega_B, swing_B)) + sideways
    return Line(distance, rate, u_E, cross(GA_B, u_B), turning)


@compiled
def pull(kite: Kite, a: Line, b: Line, shortening: PerLine) -> Pull:
    """The pulls T on lines `a` and `b` that together give a wanted `shortening`, and -M⁻¹JᵀT.

    (J M⁻¹ Jᵀ) T = shortening: forces [N] for second derivatives [m/s²] of the distances,
    impulses [N s] for their rates [m/s], kg m for the distances [m] themselves.
    """
    turn_a, turn_b = unspin(kite, a.lever_B), unspin(kite, b.lever_B)
    aa = 1 / kite.mass + dot(a.lever_B, turn_a)
    ab = dot(a.u_E, b.u_E) / kite.mass + dot(a.lever_B, turn_b)
    bb = 1 / kite.mass + dot(b.lever_B, turn_b)
    det = aa * bb - ab * ab
    T_a = (bb * shortening.plus - ab * shortening.minus) / det
    T_b = (aa * shortening.minus - ab * shortening.plus) / det
    return Pull(
        plus(times(-T_a / kite.mass, a.u_E), times(-T_b / kite.mass, b.u_E)),
        plus(times(-T_a, turn_a), times(-T_b, turn_b)),
        PerLine(T_a, T_b),
    )


@compiled
def accelerations(
    parameters: Parameters, programme: Programme, t: float, body: Body
) -> Accelerations:
    """Accelerations and line forces at time `t` [s], both lines straight."""
    kite, omega_B, c = parameters.kite, body.omega_B, control(programme, t)
    air = aerodynamic_wrench(parameters, body.p_G_E, body.R_BE, body.v_G_E, omega_B, t)
    fall_E = Vector(0.0, 0.0, parameters.environment.gravity)
    a_E = plus(fall_E, times(1 / kite.mass, unrotated(body.R_BE, air.force)))
    omega_dot_B = unspin(kite, minus(air.moment, cross(omega_B, spin(kite, omega_B))))

    a, b = line(kite, body, 1.0), line(kite, body, -1.0)
    loose_a = dot(a.u_E, a_E) + dot(a.lever_B, omega_dot_B) + a.turning
    loose_b = dot(b.u_E, a_E) + dot(b.lever_B, omega_dot_B) + b.turning
    wanted_a = line_motion(kite.y_A, c, 1.0).acceleration
    wanted_b = line_motion(kite.y_A, c, -1.0).acceleration
    held = pull(kite, a, b, PerLine(loose_a - wanted_a, loose_b - wanted_b))
    return Accelerations(plus(a_E, held.linear_E), plus(omega_dot_B, held.angular_B), held.pulls)


@compiled
def unit(e: Quaternion) -> Quaternion:
    """e / |e|."""
    s = 1 / sqrt(e.w * e.w + e.x * e.x + e.y * e.y + e.z * e.z)
    return Quaternion(s * e.w, s * e.x, s * e.y, s * e.z)


@compiled
def turned(e: Quaternion, v_B: Vector) -> Quaternion:
    """½ e (0, v): the derivative of `e` at the rates `v_B`, or its change by a small turn."""
    return Quaternion(
        -0.5 * (e.x * v_B.x + e.y * v_B.y + e.z * v_B.z),
        0.5 * (e.w * v_B.x + e.y * v_B.z - e.z * v_B.y),
        0.5 * (e.w * v_B.y + e.z * v_B.x - e.x * v_B.z),
        0.5 * (e.w * v_B.z + e.x * v_B.y - e.y * v_B.x),
    )


@compiled
def body_of(y: Free) -> Body:
    """Pose and velocity of the 13 numbers, whatever the quaternion's norm."""
    return Body(y.p_G_E, R_BE_of(unit(y.e)), y.v_G_E, y.omega_B)


@compiled
def rates(parameters: Parameters, programme: Programme, t: float, y: Free) -> Free:
    """dy/dt."""
    now = accelerations(parameters, programme, t, body_of(y))
    return Free(y.v_G_E, turned(y.e, y.omega_B), now.a_G_E, now.omega_dot_B)


@compiled
def moved(y: Free, h: float, k: Free) -> Free:
    """y + h k."""
    return Free(
        plus(y.p_G_E, times(h, k.p_G_E)),
        Quaternion(y.e.w + h * k.e.w, y.e.x + h * k.e.x, y.e.y + h * k.e.y, y.e.z + h * k.e.z),
        plus(y.v_G_E, times(h, k.v_G_E)),
        plus(y.omega_B, times(h, k.omega_B)),
    )


@compiled
def corrected(parameters: Parameters, programme: Programme, t: float, y: Free) -> Free:
    """`y` put back on the lines: |q| = 1, distances L±, rates L̇±, by pulls along the lines.

    One Newton step for the pose: what remains is of the square of what was removed.
    """
    kite, c = parameters.kite, control(programme, t)
    want_a, want_b = line_motion(kite.y_A, c, 1.0), line_motion(kite.y_A, c, -1.0)

    body = body_of(y)
    a, b = line(kite, body, 1.0), line(kite, body, -1.0)
    excess = PerLine(a.distance - want_a.length, b.distance - want_b.length)
    shift = pull(kite, a, b, excess)
    p_G_E, e = plus(y.p_G_E, shift.linear_E), unit(y.e)
    small = turned(e, shift.angular_B)
    e = unit(Quaternion(e.w + small.w, e.x + small.x, e.y + small.y, e.z + small.z))

    body = Body(p_G_E, R_BE_of(e), y.v_G_E, y.omega_B)
    a, b = line(kite, body, 1.0), line(kite, body, -1.0)
    excess = PerLine(a.rate - want_a.rate, b.rate - want_b.rate)
    kick = pull(kite, a, b, excess)
    return Free(p_G_E, e, plus(y.v_G_E, kick.linear_E), plus(y.omega_B, kick.angular_B))


@compiled
def flown(
    parameters: Parameters, programme: Programme, t: float, y: Free, steps: int, h: float
) -> Free:
    """`y` after `steps` steps of the classical Runge-Kutta method, each `h` [s] long."""
    for i in range(steps):
        s = t + i * h
        k1 = rates(parameters, programme, s, y)
        k2 = rates(parameters, programme, s + h / 2, moved(y, h / 2, k1))
        k3 = rates(parameters, programme, s + h / 2, moved(y, h / 2, k2))
        k4 = rates(parameters, programme, s + h, moved(y, h, k3))
        y = moved(moved(moved(moved(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4)
        y = corrected(parameters, programme, s + h, y)
    return y


@compiled
def placed(parameters: Parameters, programme: Programme, state: State) -> Free:
    """The free body at minimal coordinates q, q̇ and t = 0, on lines that move as programmed.

    O_E -> O_2 = ℓ n, n = (0, sin(η+δ), -cos(η+δ)) in frame 1, which turns at φ̇ k_E + γ̇ j_1.
    """
    kite, (q, q_dot), c = parameters.kite, state, control(programme, 0.0)
    R_1, R_B = R_1E(q.phi, q.gamma), R_BE(q)
    k_E = Vector(0.0, 0.0, 1.0)
    omega_1_E = plus(times(q_dot.phi, k_E), times(q_dot.gamma, R_1.y))
    # i_2 = i_1 and j_2 = j_B: each turn is about an axis that it leaves where it is.
    turn_E = plus(times(q_dot.eta, R_1.x), times(q_dot.theta, R_B.y))
    omega_E = plus(omega_1_E, turn_E)

    tilt, tilt_dot = q.eta + c.delta, q_dot.eta + c.delta_dot
    n_E = minus(times(sin(tilt), R_1.y), times(cos(tilt), R_1.z))
    n_dot_1_E = plus(times(cos(tilt), R_1.y), times(sin(tilt), R_1.z))
    p_O2_E = times(c.ell, n_E)
    v_O2_E = plus(
        plus(times(c.ell_dot, n_E), times(c.ell * tilt_dot, n_dot_1_E)), cross(omega_1_E, p_O2_E)
    )
    O2G_E = unrotated(R_B, Vector(-kite.x_A, 0.0, -kite.z_A))
    return Free(
        plus(p_O2_E, O2G_E),
        quaternion(R_B),
        plus(v_O2_E, cross(omega_E, O2G_E)),
        rotated(R_B, omega_E),
    )
