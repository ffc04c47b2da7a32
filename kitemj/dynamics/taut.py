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
from kitemj.dynamics.motion import Body, attachment_E, attachment_velocity_E
from kitemj.physics.compiled import compiled
from kitemj.physics.frames import world
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Programme, control, line_motion
from kitemj.physics.vectors import (
    Vector,
    cross,
    dot,
    norm,
    rotated,
    times,
    unrotated,
)

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

    a, alpha = engine.qacc[:3], engine.qacc[3:]
    for i in range(2):
        if engine.eq_active[i]:
            stretch = engine.ten_length[i] - engine.ten_length_0[i] - engine.eq_data[i, 0]
            asked = -engine.damping[i] * engine.ten_velocity[i] - engine.stiffness[i] * stretch
            u_W, arm = world(lines[i].u_E), lines[i].arm_B
            done = dot(u_W, Vector(a[0], a[1], a[2])) + dot(
                arm, Vector(alpha[0], alpha[1], alpha[2])
            )
            engine.softness[i] = asked - done


@compiled
def settle(engine: Engine, parameters: Parameters, programme: Programme, t: float) -> None:
    """Evaluates until R f is that of the present state: each time it is 10⁻⁴ of before."""
    for _ in range(4):
        evaluate(engine, parameters, programme, t)


@compiled
def tension(engine: Engine, i: int) -> float:
    """Tension [N] of line `i` (0: A₊, 1: A₋) at the evaluation before; 0 when slack."""
    return -engine.softness[i] / engine.R[i] if engine.eq_active[i] else 0.0
