"""The thesis's solver: Dormand and Prince of order 5(4) with the tolerances of section 4.1.

scipy's RK45 is the method of MATLAB's and Simulink's ode45. A step ends at every tick, as
Simulink's do where a discrete block changes, so that no pulse is stepped over.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.lagrange import accelerations
from kitemj.dynamics.lagrange_kite import motion_at, state_of
from kitemj.dynamics.motion import Motion, State
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Segment

RTOL, ATOL = 1e-3, 1e-6
"""Section 4.1 of the thesis."""

STAGES = 6
"""Right-hand sides of a step: the seventh is the first of the next one."""

REFUSED = 1e100
"""1/s; in place of rates that are not finite: no step with them is accepted."""

Steering = Callable[[float], Control]
Array = NDArray[np.float64]


class Solution(NamedTuple):
    """The motion at the start and at the end of each tick, and what it cost.

    Fewer motions than that where the solver gave up. `evaluations` of the right-hand side,
    `rejected` steps, the `smallest` step [s].
    """

    motions: list[Motion]
    evaluations: int
    rejected: int
    smallest: float


def solve(
    parameters: Parameters,
    start: State,
    steering: Sequence[Steering],
    tick: float,
    rtol: float = RTOL,
    atol: float = ATOL,
) -> Solution:
    """Lagrange's equations solved, one steering for each tick.

    parameters: the set
    start: q [rad] and q̇ [rad/s]
    steering: for each tick the control by time [s]
    tick: s
    rtol: relative tolerance of a step
    atol: absolute tolerance of a step, rad and rad/s
    """
    from scipy.integrate import RK45

    x, step, smallest = np.array([*start.q, *start.q_dot]), tick, tick
    motions = [_motion(parameters, steering[0], 0.0, x)]
    evaluations = attempts = steps = 0
    trouble: str | None = None
    for k, law in enumerate(steering):
        begin, end = k * tick, (k + 1) * tick

        def rates(t: float, x: Array, law: Steering = law) -> Array:
            q, v = state_of(x)
            rate = np.array([*v, *accelerations(parameters, law(t), t, q, v).q_ddot])
            return rate if np.isfinite(rate).all() else np.full(8, REFUSED)

        first = min(step, end - begin)
        with np.errstate(over="ignore", invalid="ignore"):  # what is tried may be absurd
            solver = RK45(rates, begin, x, end, rtol=rtol, atol=atol, first_step=first)
            while solver.status == "running":
                step = solver.h_abs
                trouble = solver.step()
                steps += trouble is None
                if solver.status == "running":
                    smallest = min(smallest, float(solver.step_size or tick))
        step = max(step, solver.h_abs)  # the last one was cut where the tick ends
        evaluations += solver.nfev
        attempts += (solver.nfev - 1) // STAGES
        if trouble:
            break
        x = solver.y
        motions.append(_motion(parameters, law, end, x))
    return Solution(motions, evaluations, attempts - steps, smallest)


def _motion(parameters: Parameters, law: Steering, t: float, x: Array) -> Motion:
    found: Motion = motion_at(parameters, Segment(t, law(t)), t, state_of(x))
    return found
