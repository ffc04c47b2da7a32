"""The Newton-Euler model in flight: fixed steps beside a live flight, adaptive for a trajectory."""

from math import ceil

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from kitemj.dynamics.motion import Motion, Pair, State, air_of, angles_of
from kitemj.dynamics.newton_euler import (
    Free,
    accelerations,
    body_of,
    corrected,
    flown,
    placed,
    rates,
)
from kitemj.errors import FlightError
from kitemj.physics.compiled import compiled
from kitemj.physics.frames import Quaternion
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Programme, control, line_motion
from kitemj.physics.vectors import Vector

RTOL, ATOL = 1e-12, 1e-12
"""Of each of the 13 numbers [m, 1, m/s, rad/s], for one adaptive step."""


@compiled
def flat(y: Free) -> NDArray[np.float64]:
    """The 13 numbers in a row."""
    p, e, v, w = y
    return np.array((p.x, p.y, p.z, e.w, e.x, e.y, e.z, v.x, v.y, v.z, w.x, w.y, w.z))


@compiled
def free(y: NDArray[np.float64]) -> Free:
    """The inverse of `flat`."""
    return Free(
        Vector(y[0], y[1], y[2]),
        Quaternion(y[3], y[4], y[5], y[6]),
        Vector(y[7], y[8], y[9]),
        Vector(y[10], y[11], y[12]),
    )


@compiled
def flat_rates(
    t: float, y: NDArray[np.float64], parameters: Parameters, programme: Programme
) -> NDArray[np.float64]:
    """dy/dt of the 13 numbers in a row."""
    return flat(rates(parameters, programme, t, free(y)))


@compiled
def motion_of(parameters: Parameters, programme: Programme, t: float, y: Free) -> Motion:
    """All that is told of one instant."""
    body, c = body_of(y), control(programme, t)
    y_A = parameters.kite.y_A
    return Motion(
        t,
        angles_of(parameters, body),
        body,
        c,
        Pair(line_motion(y_A, c, 1.0).length, line_motion(y_A, c, -1.0).length),
        accelerations(parameters, programme, t, body).tensions,
        air_of(parameters, body, t),
    )


class NewtonEulerKite:
    """A free body whose lines are always straight; they push where they must.

    `step` [s] is the longest step of `advance`; `trajectory` chooses its own.
    """

    name = "newton-euler"

    def __init__(self, parameters: Parameters, step: float = 0.002) -> None:
        self.parameters, self.step = parameters, step
        self.t = 0.0
        self._y: Free

    def start(self, state: State, programme: Programme) -> None:
        """Puts the kite at `state` at t = 0 s, the lines moving as programmed."""
        self.t = 0.0
        self._y = placed(self.parameters, programme, state)

    def advance(self, programme: Programme, duration: float) -> None:
        """Flies on for `duration` [s] in equal Runge-Kutta steps, corrected after each."""
        n = max(1, ceil(duration / self.step - 1e-9))
        self._y = flown(self.parameters, programme, self.t, self._y, n, duration / n)
        self.t += duration

    def motion(self, programme: Programme) -> Motion:
        """The present instant."""
        return motion_of(self.parameters, programme, self.t, self._y)

    def trajectory(self, programme: Programme, times: list[float]) -> list[Motion]:
        """The motion at each of `times` [s], by DOP853 with error control.

        Raises FlightError, with what was flown until then, where the integrator cannot go on.
        """
        motions: list[Motion] = []
        for time in times:
            if time > self.t:
                try:
                    self._y = self._carried(programme, time)
                except ArithmeticError as error:
                    raise FlightError(self.name, self.t, str(error), motions) from None
                self.t = time
            motions.append(self.motion(programme))
        return motions

    def _carried(self, programme: Programme, end: float) -> Free:
        """The body taken from now to `end` [s] and put back on the lines."""
        given = (self.parameters, programme)
        # scipy never returns from a right-hand side that starts as not-a-number
        if not np.isfinite(flat_rates(self.t, flat(self._y), *given)).all():
            raise ArithmeticError("the motion is not a number")
        found = solve_ivp(
            flat_rates,
            (self.t, end),
            flat(self._y),
            method="DOP853",
            rtol=RTOL,
            atol=ATOL,
            args=given,
        )
        if not found.success:
            raise ArithmeticError(found.message)
        return corrected(*given, end, free(found.y[:, -1]))
