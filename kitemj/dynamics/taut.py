"""A straight, inextensible line of moving length as a MuJoCo equality, made exact.

MuJoCo solves J q̈ = -b J q̇ - k (length - target) - R f for a tendon equality. It damps the
line's own velocity rather than that relative to the moving target, leaves out J̇ q̇ (the
acceleration that a straight line has from turning) and softens with R. All three are fed
forward at every evaluation:

    target = L + (b/k) L̇ + (L̈ - J̇q̇ + R f)/k

with R f of the evaluation before, found from what the engine did: R f = -b J q̇ -
k (length - target) - J q̈. What is left is the change of R f from one evaluation to the
next, a ten-thousandth of the change of the line's force.
"""

from typing import NamedTuple

from kitemj.dynamics.engine import Engine, body_of, forward
from kitemj.dynamics.motion import Body, PerLine, attachment_E, attachment_velocity_E
from kitemj.physics.compiled import compiled
from kitemj.physics.frames import world
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Programme, control, line_motion
from kitemj.physics.vectors import Vector, cross, dot, norm, rotated, times, unrotated

SIDES = (1.0, -1.0)


class Line(NamedTuple):
    """One line as the kite stretches it.

    `u_E`: unit vector from O_E to the attachment; `arm_B` = GA x u [m, B]; `distance` [m]
    and its `rate` [m/s]; `turning` = J̇ q̇ [m/s²].
    """

    u_E: Vector
    arm_B: Vector
    distance: float
    rate: float
    turning: float


@compiled
def line_of(parameters: Parameters, body: Body, side: float) -> Line:
    """The line to A₊ (`side` +1) or A₋ (-1)."""
    kite = parameters.kite
    GA_B = Vector(kite.x_A, side * kite.y_A, kite.z_A)
    p, v = attachment_E(parameters, body, side), attachment_velocity_E(parameters, body, side)
    distance = norm(p)
    u_E = times(1.0 / distance, p)
    u_B = rotated(body.R_BE, u_E)
    rate = dot(u_E, v)
    centripetal = cross(body.omega_B, cross(body.omega_B, GA_B))
    turning = (dot(v, v) - rate * rate) / distance + dot(u_B, centripetal)
    return Line(u_E, cross(GA_B, u_B), distance, rate, turning)


@compiled
def evaluate(engine: Engine, parameters: Parameters, programme: Programme, t: float) -> None:
    """Accelerations of the engine's present state at time `t` [s], into its ``qacc``."""
    body = body_of(engine)
    wrench = aerodynamic_wrench(parameters, body.p_G_E, body.R_BE, body.v_G_E, body.omega_B, t)
    force = world(unrotated(body.R_BE, wrench.force))
    engine.qfrc_applied[0], engine.qfrc_applied[1], engine.qfrc_applied[2] = force
    engine.qfrc_applied[3], engine.qfrc_applied[4], engine.qfrc_applied[5] = wrench.moment

    c = control(programme, t)
    lines = (line_of(parameters, body, 1.0), line_of(parameters, body, -1.0))
    for i in range(2):
        if engine.eq_active[i]:
            wanted = line_motion(parameters.kite.y_A, c, SIDES[i])
            ahead = (
                engine.damping[i] * wanted.rate
                + wanted.acceleration
                - lines[i].turning
                + engine.softness[i]
            ) / engine.stiffness[i]
            engine.eq_data[i, 0] = wanted.length + ahead - engine.ten_length_0[i]

    forward(engine.model, engine.data)

    a = engine.qacc
    for i in range(2):
        if engine.eq_active[i]:
            stretch = engine.ten_length[i] - engine.ten_length_0[i] - engine.eq_data[i, 0]
            asked = -engine.damping[i] * engine.ten_velocity[i] - engine.stiffness[i] * stretch
            u_W, arm = world(lines[i].u_E), lines[i].arm_B
            done = dot(u_W, Vector(a[0], a[1], a[2])) + dot(arm, Vector(a[3], a[4], a[5]))
            engine.softness[i] = asked - done


@compiled
def settle(engine: Engine, parameters: Parameters, programme: Programme, t: float) -> None:
    """Evaluates until R f is that of the present state: each time it is 10⁻⁴ of before."""
    for _ in range(4):
        evaluate(engine, parameters, programme, t)


@compiled
def mobility(parameters: Parameters, a: Line, b: Line) -> float:
    """J_a M⁻¹ J_bᵀ [1/kg]: what a unit impulse along b does to the rate of a."""
    return dot(a.u_E, b.u_E) / parameters.kite.mass + dot(a.arm_B, spin_of(parameters, b.arm_B))


@compiled
def spin_of(parameters: Parameters, H_B: Vector) -> Vector:
    """I⁻¹ H: the rates [rad/s] that an angular momentum [N m s] means."""
    kite = parameters.kite
    I_x, I_y, I_z, I_xz = kite.inertia_x, kite.inertia_y, kite.inertia_z, kite.inertia_xz
    D = I_x * I_z - I_xz * I_xz
    return Vector((I_z * H_B.x + I_xz * H_B.z) / D, H_B.y / I_y, (I_xz * H_B.x + I_x * H_B.z) / D)


@compiled
def tensions(engine: Engine, parameters: Parameters, body: Body) -> PerLine:
    """Tensions [N] at the evaluation before; 0 for a slack line.

    From what the constraints did to the accelerations, J M⁻¹ Jᵀ f = J (q̈ - q̈_smooth), which
    keeps more digits than R f / R. Off the ground only: contacts accelerate the kite too.
    """
    left, right = line_of(parameters, body, 1.0), line_of(parameters, body, -1.0)
    a, b = mobility(parameters, left, left), mobility(parameters, right, right)
    c = mobility(parameters, left, right)
    by_left, by_right = _constrained(engine, left), _constrained(engine, right)
    if engine.eq_active[0] and engine.eq_active[1]:
        D = a * b - c * c
        return PerLine((c * by_right - b * by_left) / D, (c * by_left - a * by_right) / D)
    return PerLine(
        -by_left / a if engine.eq_active[0] else 0.0, -by_right / b if engine.eq_active[1] else 0.0
    )


@compiled
def _constrained(engine: Engine, line: Line) -> float:
    """J (q̈ - q̈_smooth) [m/s²] of one line."""
    a, b, u_W = engine.qacc, engine.qacc_smooth, world(line.u_E)
    linear = Vector(a[0] - b[0], a[1] - b[1], a[2] - b[2])
    angular = Vector(a[3] - b[3], a[4] - b[4], a[5] - b[5])
    return dot(u_W, linear) + dot(line.arm_B, angular)
