"""The Lagrangian model in flight: fixed steps beside a live flight, adaptive for a trajectory."""

from math import ceil, cos, degrees, inf, isfinite
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.adaptive import Room, carried, end_law, room_for, system_law
from kitemj.dynamics.batch import carry_law, present_law, rows_at
from kitemj.dynamics.formulation import DEFAULT_STEP, Instant
from kitemj.dynamics.ground import above, down_to_ground
from kitemj.dynamics.lagrange import accelerations, body, spatial
from kitemj.dynamics.motion import Motion, Snapshot, State, air_of, straight_lines, told
from kitemj.errors import FlightError
from kitemj.physics.compiled import Array, compiled
from kitemj.physics.frames import Angles
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import TWO_LINES, Rig
from kitemj.physics.steering import Control, Programme, control

TOLERANCE = 1e-13
"""Of q [rad] and q̇ [rad/s], for one adaptive step: three orders below what 0.1 µm on a 200 m
line asks for."""
EDGE = 0.03
"""cos γ; nearer to 90° numbers are lost to the coordinates, if they are lost."""


@compiled
def _moved(x: Angles, h: float, rate: Angles) -> Angles:
    """x + h rate."""
    return Angles(
        x.phi + h * rate.phi,
        x.gamma + h * rate.gamma,
        x.eta + h * rate.eta,
        x.theta + h * rate.theta,
    )


@compiled
def _mean(a: Angles, b: Angles, c: Angles, d: Angles) -> Angles:
    """The weights of the classical Runge-Kutta method."""
    return Angles(
        (a.phi + 2 * b.phi + 2 * c.phi + d.phi) / 6,
        (a.gamma + 2 * b.gamma + 2 * c.gamma + d.gamma) / 6,
        (a.eta + 2 * b.eta + 2 * c.eta + d.eta) / 6,
        (a.theta + 2 * b.theta + 2 * c.theta + d.theta) / 6,
    )


@compiled
def flown(
    parameters: Parameters, programme: Programme, t: float, state: State, steps: int, h: float
) -> State:
    """The state after `steps` classical Runge-Kutta steps of `h` [s] from time `t` [s]."""
    q, v = state
    for i in range(steps):
        start, middle, end = t + i * h, t + (i + 0.5) * h, t + (i + 1) * h
        c_start, c_middle = control(programme, start), control(programme, middle)
        c_end = control(programme, end)
        a1 = accelerations(parameters, c_start, start, q, v).q_ddot
        v2 = _moved(v, h / 2, a1)
        a2 = accelerations(parameters, c_middle, middle, _moved(q, h / 2, v), v2).q_ddot
        v3 = _moved(v, h / 2, a2)
        a3 = accelerations(parameters, c_middle, middle, _moved(q, h / 2, v2), v3).q_ddot
        v4 = _moved(v, h, a3)
        a4 = accelerations(parameters, c_end, end, _moved(q, h, v3), v4).q_ddot
        q = _moved(q, h, _mean(v, v2, v3, v4))
        v = _moved(v, h, _mean(a1, a2, a3, a4))
    return State(q, v)


@compiled
def motion_at(parameters: Parameters, programme: Programme, t: float, state: State) -> Motion:
    """All that is asked of one instant."""
    c = control(programme, t)
    tensions = accelerations(parameters, c, t, state.q, state.q_dot).tensions
    pose = body(parameters, state.q, state.q_dot, c)
    lines = straight_lines(parameters, pose, c, tensions)
    return Motion(t, state.q, pose, c, lines, air_of(parameters, pose, t))


@compiled
def instant_at(parameters: Parameters, c: Control, t: float, state: State) -> Instant:
    """The accelerations at `state`, the lines at `c`, time `t` [s]."""
    q_ddot, tensions = accelerations(parameters, c, t, state.q, state.q_dot)
    a_G_E, omega_dot_B = spatial(parameters.kite, state.q, state.q_dot, q_ddot, c)
    pose = body(parameters, state.q, state.q_dot, c)
    wrench = aerodynamic_wrench(parameters, pose.p_G_E, pose.R_BE, pose.v_G_E, pose.omega_B, t)
    return Instant(pose, a_G_E, omega_dot_B, q_ddot, tensions, wrench)


class LagrangeSystem(NamedTuple):
    """What the right-hand side depends on, and whether the flight ends on the ground."""

    parameters: Parameters
    programme: Programme
    lands: bool = False


class LagrangeFlight(NamedTuple):
    """A flight with error control: x = (q, q̇) in `room`, `tolerance` of a step."""

    system: LagrangeSystem
    room: Room
    tolerance: float


@compiled
def state_of(x: Array) -> State:
    """The state of x = (q, q̇), shape (8,)."""
    return State(Angles(x[0], x[1], x[2], x[3]), Angles(x[4], x[5], x[6], x[7]))


@system_law.of(LagrangeSystem)
@compiled
def rates(system: LagrangeSystem, t: float, x: Array, out: Array) -> None:
    """d/dt of x = (q, q̇) at time `t` [s], into `out` (8,)."""
    q, v = state_of(x)
    a = accelerations(system.parameters, control(system.programme, t), t, q, v).q_ddot
    out[0], out[1], out[2], out[3] = v.phi, v.gamma, v.eta, v.theta
    out[4], out[5], out[6], out[7] = a.phi, a.gamma, a.eta, a.theta


@end_law.of(LagrangeSystem)
@compiled
def room_below(system: LagrangeSystem, t: float, x: Array) -> float:
    """How far [m] the hull is above the ground, if that ends the flight."""
    if not system.lands:
        return inf
    (q, v), c = state_of(x), control(system.programme, t)
    return above(system.parameters, body(system.parameters, q, v, c))


@carry_law.of(LagrangeFlight)
@compiled
def carry(flight: LagrangeFlight, t: float, end: float) -> float:
    """On from time `t` to `end` [s]; the time that was reached."""
    return carried(flight.system, flight.room, t, end, flight.tolerance)


@present_law.of(LagrangeFlight)
@compiled
def present(flight: LagrangeFlight, t: float) -> Motion:
    """The flight at its present time `t` [s]."""
    parameters, programme, _ = flight.system
    return motion_at(parameters, programme, t, state_of(flight.room.x))


class LagrangeKite:
    """Minimal coordinates: both lines are always straight, and push where they must.

    `step` [s] is the longest step of `advance`; `trajectory` and `batch` choose their own.
    """

    name = "lagrange"
    rigs: tuple[Rig, ...] = (TWO_LINES,)

    def __init__(self, parameters: Parameters, step: float = DEFAULT_STEP) -> None:
        self.parameters, self.step, self.t = parameters, step, 0.0
        self.state = State(Angles(0.0, 0.0, 0.0, 0.0), Angles(0.0, 0.0, 0.0, 0.0))

    def start(self, state: State, programme: Programme) -> None:
        """Puts the kite at `state` at t = 0 s."""
        self.t, self.state = 0.0, state

    def at(self, state: State, control: Control, t: float) -> Instant:
        """The instant at `state`."""
        return instant_at(self.parameters, control, t, state)

    def advance(self, programme: Programme, duration: float) -> None:
        """Flies on for `duration` [s] in equal Runge-Kutta steps.

        Raises FlightError where the coordinates end (γ = ±90°) or the numbers leave the finite.
        """
        steps, before = max(1, ceil(duration / self.step - 1e-9)), self.state
        h = duration / steps
        self.state = flown(self.parameters, programme, self.t, before, steps, h)
        self.t += duration
        if not isfinite(sum(self.state.q_dot)):
            raise FlightError(self.name, self.t, _why_not(before), [])

    def motion(self, programme: Programme) -> Motion:
        """The present instant; raises FlightError where it is not finite."""
        return told(self.name, motion_at(self.parameters, programme, self.t, self.state))

    def snapshot(self) -> Snapshot:
        """q and q̇."""
        return Snapshot(self.t, (*self.state.q, *self.state.q_dot))

    def restore(self, kept: Snapshot) -> None:
        """Back to a snapshot."""
        self.t, self.state = kept.t, State(Angles(*kept.numbers[:4]), Angles(*kept.numbers[4:]))

    def trajectory(self, programme: Programme, times: list[float]) -> list[Motion]:
        """The motion at each of `times` [s] down to the ground, by DOP853 with error control.

        Raises FlightError, with what was flown until then, where the equations become
        singular (γ = ±90°) or diverge.
        """
        flight = self._adaptive(programme, TOLERANCE, lands=True)

        def fly(end: float) -> None:
            self.t = carry(flight, self.t, end)
            self.state = state_of(flight.room.x)
            if self.t < end and not room_below(flight.system, self.t, flight.room.x) < 0.0:
                raise FlightError(self.name, self.t, _why_not(self.state), [])

        return down_to_ground(self, fly, programme, times)

    def batch(self, programme: Programme, times: Array, touch: float, tolerance: float) -> Array:
        """Rows of `rows_at`; `tolerance` of each step in q [rad] and q̇ [rad/s]."""
        flight = self._adaptive(programme, tolerance, lands=False)
        return rows_at(flight, self.parameters, times, touch, len(TWO_LINES.lines))

    def _adaptive(self, programme: Programme, tolerance: float, *, lands: bool) -> LagrangeFlight:
        x = np.array([*self.state.q, *self.state.q_dot])
        system = LagrangeSystem(self.parameters, programme, lands)
        return LagrangeFlight(system, room_for(x), tolerance)


def _why_not(last: State) -> str:
    """Why a flight cannot go on from its `last` state, in words."""
    if abs(cos(last.q.gamma)) > EDGE:
        return "the motion is not a number, or too quick for any step"
    return (
        f"γ = {degrees(last.q.gamma):.2f}° is too near 90°, where φ and η turn about one axis: "
        f"these coordinates would keep less than half of their digits; ask newton-euler or mujoco"
    )
