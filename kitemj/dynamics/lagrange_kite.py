"""The Lagrangian model in flight: fixed steps beside a live flight, adaptive for a trajectory."""

from math import ceil

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from kitemj.dynamics.lagrange import accelerations, body
from kitemj.dynamics.motion import Motion, Pair, State, air_of
from kitemj.errors import FlightError
from kitemj.physics.compiled import compiled
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Programme, control, line_motion

RTOL, ATOL = 1e-12, 1e-13
"""Of q [rad] and q̇ [rad/s]: three orders below what 0.1 µm on a 200 m line asks for."""


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
        c_start, c_middle, c_end = (
            control(programme, start),
            control(programme, middle),
            control(programme, end),
        )
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
def derivative(
    parameters: Parameters, programme: Programme, t: float, y: NDArray[np.float64]
) -> NDArray[np.float64]:
    """d/dt of y = (q, q̇), shape (8,), for integrators that want arrays."""
    q, v = Angles(y[0], y[1], y[2], y[3]), Angles(y[4], y[5], y[6], y[7])
    a = accelerations(parameters, control(programme, t), t, q, v).q_ddot
    return np.array([v.phi, v.gamma, v.eta, v.theta, a.phi, a.gamma, a.eta, a.theta])


@compiled
def motion_at(parameters: Parameters, programme: Programme, t: float, state: State) -> Motion:
    """All that is asked of one instant."""
    c = control(programme, t)
    tensions = accelerations(parameters, c, t, state.q, state.q_dot).tensions
    pose = body(parameters, state.q, state.q_dot, c)
    y_A = parameters.kite.y_A
    lengths = Pair(line_motion(y_A, c, 1.0).length, line_motion(y_A, c, -1.0).length)
    return Motion(t, state.q, pose, c, lengths, tensions, air_of(parameters, pose, t))


class LagrangeKite:
    """Minimal coordinates: both lines are always straight, and push where they must.

    `step` [s] is the longest step of `advance`; `trajectory` chooses its own.
    """

    name = "lagrange"

    def __init__(self, parameters: Parameters, step: float = 0.002) -> None:
        self.parameters, self.step = parameters, step
        self.t = 0.0
        self.state = State(Angles(0.0, 0.0, 0.0, 0.0), Angles(0.0, 0.0, 0.0, 0.0))

    def start(self, state: State, programme: Programme) -> None:
        """Puts the kite at `state` at t = 0 s."""
        self.t, self.state = 0.0, state

    def advance(self, programme: Programme, duration: float) -> None:
        """Flies on for `duration` [s] in equal Runge-Kutta steps."""
        steps = max(1, ceil(duration / self.step - 1e-9))
        h = duration / steps
        self.state = flown(self.parameters, programme, self.t, self.state, steps, h)
        self.t += duration

    def motion(self, programme: Programme) -> Motion:
        """The present instant."""
        return motion_at(self.parameters, programme, self.t, self.state)

    def trajectory(self, programme: Programme, times: list[float]) -> list[Motion]:
        """The motion at each of `times` [s], by DOP853 with error control.

        Raises FlightError where the equations become singular (γ = ±90°) or diverge.
        """
        solution = solve_ivp(
            lambda t, y: derivative(self.parameters, programme, t, y),
            (self.t, times[-1]),
            np.array([*self.state.q, *self.state.q_dot]),
            method="DOP853",
            t_eval=times,
            rtol=RTOL,
            atol=ATOL,
        )
        motions = [
            motion_at(self.parameters, programme, t, State(Angles(*y[:4]), Angles(*y[4:])))
            for t, y in zip(solution.t, solution.y.T.tolist(), strict=True)
        ]
        if not solution.success:
            raise FlightError("lagrange", float(solution.t[-1]), solution.message, motions)
        self.t, self.state = (
            times[-1],
            State(Angles(*solution.y[:4, -1]), Angles(*solution.y[4:, -1])),
        )
        return motions
