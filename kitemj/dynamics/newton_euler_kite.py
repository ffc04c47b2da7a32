"""The Newton-Euler model in flight: fixed steps beside a live flight, adaptive for a trajectory."""

from math import ceil, inf
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.adaptive import Room, carried, end_law, room_for, system_law
from kitemj.dynamics.batch import carry_law, present_law, rows_at
from kitemj.dynamics.formulation import DEFAULT_STEP, Instant
from kitemj.dynamics.ground import above, down_to_ground
from kitemj.dynamics.motion import (
    Motion,
    Snapshot,
    State,
    air_of,
    angles_of,
    straight_lines,
    told,
)
from kitemj.dynamics.newton_euler import (
    Free,
    accelerations,
    body_of,
    corrected,
    flown,
    placed,
    rates,
)
from kitemj.dynamics.straight import q_ddot_of, state_of
from kitemj.errors import FlightError
from kitemj.physics.compiled import Array, compiled
from kitemj.physics.frames import Quaternion
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import TWO_LINES, Rig
from kitemj.physics.steering import Control, Programme, Segment, control
from kitemj.physics.vectors import Vector

TOLERANCE = 1e-12
"""Of each of the 13 numbers [m, 1, m/s, rad/s], for one adaptive step."""


class NewtonEulerSystem(NamedTuple):
    """What the right-hand side depends on, and whether the flight ends on the ground."""

    parameters: Parameters
    programme: Programme
    lands: bool = False


class NewtonEulerFlight(NamedTuple):
    """A flight with error control: the 13 numbers in `room`, `tolerance` of a step."""

    system: NewtonEulerSystem
    room: Room
    tolerance: float


@compiled
def put(y: Free, x: Array) -> None:
    """The 13 numbers in a row, into `x` (13,)."""
    p, e, v, w = y
    x[0], x[1], x[2] = p
    x[3], x[4], x[5], x[6] = e
    x[7], x[8], x[9] = v
    x[10], x[11], x[12] = w


@compiled
def free(x: Array) -> Free:
    """The inverse of `put`."""
    return Free(
        Vector(x[0], x[1], x[2]),
        Quaternion(x[3], x[4], x[5], x[6]),
        Vector(x[7], x[8], x[9]),
        Vector(x[10], x[11], x[12]),
    )


@system_law.of(NewtonEulerSystem)
@compiled
def put_rates(system: NewtonEulerSystem, t: float, x: Array, out: Array) -> None:
    """d/dt of the 13 numbers `x` at time `t` [s], into `out` (13,)."""
    put(rates(system.parameters, system.programme, t, free(x)), out)


@end_law.of(NewtonEulerSystem)
@compiled
def room_below(system: NewtonEulerSystem, t: float, x: Array) -> float:
    """How far [m] the hull is above the ground, if that ends the flight."""
    return above(system.parameters, body_of(free(x))) if system.lands else inf


@compiled
def motion_of(parameters: Parameters, programme: Programme, t: float, y: Free) -> Motion:
    """All that is told of one instant."""
    body, c = body_of(y), control(programme, t)
    tensions = accelerations(parameters, programme, t, body).tensions
    lines = straight_lines(parameters, body, c, tensions)
    return Motion(t, angles_of(parameters, body), body, c, lines, air_of(parameters, body, t))


@compiled
def instant_at(parameters: Parameters, c: Control, t: float, state: State) -> Instant:
    """The accelerations at `state`, the lines at `c`, time `t` [s]."""
    body = body_of(placed(parameters, Segment(0.0, c), state))
    a_G_E, omega_dot_B, tensions = accelerations(parameters, Segment(t, c), t, body)
    q_ddot = q_ddot_of(parameters, body, a_G_E, omega_dot_B)
    wrench = aerodynamic_wrench(parameters, body.p_G_E, body.R_BE, body.v_G_E, body.omega_B, t)
    return Instant(body, a_G_E, omega_dot_B, q_ddot, tensions, wrench)


@carry_law.of(NewtonEulerFlight)
@compiled
def carry(flight: NewtonEulerFlight, t: float, end: float) -> float:
    """On from time `t` to `end` [s] and back on the lines; the time that was reached."""
    (parameters, programme, _), room, tolerance = flight
    reached = carried(flight.system, room, t, end, tolerance)
    put(corrected(parameters, programme, reached, free(room.x)), room.x)
    return reached


@present_law.of(NewtonEulerFlight)
@compiled
def present(flight: NewtonEulerFlight, t: float) -> Motion:
    """The flight at its present time `t` [s]."""
    return motion_of(flight.system.parameters, flight.system.programme, t, free(flight.room.x))


class NewtonEulerKite:
    """A free body whose lines are always straight; they push where they must.

    `step` [s] is the longest step of `advance`; `trajectory` and `batch` choose their own.
    """

    name = "newton-euler"
    rigs: tuple[Rig, ...] = (TWO_LINES,)

    def __init__(self, parameters: Parameters, step: float = DEFAULT_STEP) -> None:
        self.parameters, self.step, self.t = parameters, step, 0.0
        self._y: Free

    def start(self, state: State, programme: Programme) -> None:
        """Puts the kite at `state` at t = 0 s, the lines moving as programmed."""
        self.t = 0.0
        self._y = placed(self.parameters, programme, state)

    def at(self, state: State, control: Control, t: float) -> Instant:
        """The instant at `state`."""
        return instant_at(self.parameters, control, t, state)

    @property
    def state(self) -> State:
        """The present q and q̇."""
        return state_of(self.parameters, body_of(self._y))

    def advance(self, programme: Programme, duration: float) -> None:
        """Flies on for `duration` [s] in equal Runge-Kutta steps, corrected after each."""
        n = max(1, ceil(duration / self.step - 1e-9))
        self._y = flown(self.parameters, programme, self.t, self._y, n, duration / n)
        self.t += duration

    def motion(self, programme: Programme) -> Motion:
        """The present instant; raises FlightError where it is not finite."""
        return told(self.name, motion_of(self.parameters, programme, self.t, self._y))

    def snapshot(self) -> Snapshot:
        """Position, attitude and both velocities."""
        x = np.empty(13)
        put(self._y, x)
        return Snapshot(self.t, tuple(x.tolist()))

    def restore(self, kept: Snapshot) -> None:
        """Back to a snapshot."""
        self.t, self._y = kept.t, free(np.array(kept.numbers))

    def trajectory(self, programme: Programme, times: list[float]) -> list[Motion]:
        """The motion at each of `times` [s] down to the ground, by DOP853 with error control.

        Raises FlightError, with what was flown until then, where the integrator cannot go on.
        """
        flight = self._adaptive(programme, TOLERANCE, lands=True)

        def fly(end: float) -> None:
            self.t = carry(flight, self.t, end)
            self._y = free(flight.room.x)
            if self.t < end and not above(self.parameters, body_of(self._y)) < 0.0:
                reason = "the motion is not a number, or too quick for any step"
                raise FlightError(self.name, self.t, reason, [])

        return down_to_ground(self, fly, programme, times)

    def batch(self, programme: Programme, times: Array, touch: float, tolerance: float) -> Array:
        """Rows of `rows_at`; `tolerance` of each step in each of the 13 numbers."""
        flight = self._adaptive(programme, tolerance, lands=False)
        return rows_at(flight, self.parameters, times, touch, len(TWO_LINES.lines))

    def _adaptive(
        self, programme: Programme, tolerance: float, *, lands: bool
    ) -> NewtonEulerFlight:
        system, x = NewtonEulerSystem(self.parameters, programme, lands), np.empty(13)
        put(self._y, x)
        return NewtonEulerFlight(system, room_for(x), tolerance)
