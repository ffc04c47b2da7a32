"""From what a stick asks for to how lines can move: C¹, within limits, without overshoot.

ruckig finds the quickest way to a target under limits on rate and acceleration. A tick
takes the mean acceleration of that way over its length, so that δ̈ and ℓ̈ are constant in a
tick and its numbers say exactly what was flown. The way is found anew at each tick.
"""

from functools import cache
from typing import Any

from ruckig import InputParameter, Ruckig, RuckigError, Synchronization, Trajectory

from kitemj.physics.parameters import StickLimits
from kitemj.physics.steering import Control, Segment

NUDGE = 1 + 1e-9
"""What the planner is given in place of a limit that it stumbles over; the result is cut."""


@cache
def _planner() -> tuple[Any, Any, Any]:
    wish = InputParameter(2)
    wish.synchronization = Synchronization.No
    return Ruckig(2), wish, Trajectory(2)


def shaped(
    limits: StickLimits,
    now: Control,
    start: float,
    tick: float,
    delta: float,
    ell: float,
    ell_rest: float,
) -> Segment:
    """The lines' motion from time `start` [s] on for one `tick` [s].

    `now` is the control at its start, `delta` [rad] and `ell` [m] what is asked for (cut to
    their limits; `ell_rest` is ℓ₀). |δ̇|, |δ̈|, |ℓ̇| and |ℓ̈| stay within `limits`; a target that
    stands still is reached to within limit tick²/4 and never passed by more.
    """
    planner, wish, way = _planner()
    wish.current_position = [now.delta, now.ell]
    wish.current_velocity = [now.delta_dot, now.ell_dot]
    wish.target_position = [
        _within(delta, limits.delta),
        ell_rest + _within(ell - ell_rest, limits.ell),
    ]
    wish.max_velocity = [limits.delta_dot, limits.ell_dot]
    wish.max_acceleration = [limits.delta_ddot, limits.ell_ddot]
    try:
        planner.calculate(wish, way)
    except RuckigError:
        # a state exactly on the braking parabola can fall between its cases by rounding
        wish.max_acceleration = [NUDGE * limits.delta_ddot, NUDGE * limits.ell_ddot]
        planner.calculate(wish, way)
    _, (delta_dot, ell_dot), _ = way.at_time(tick)
    return Segment(
        start,
        Control(
            now.ell,
            now.ell_dot,
            _within((ell_dot - now.ell_dot) / tick, limits.ell_ddot),
            now.delta,
            now.delta_dot,
            _within((delta_dot - now.delta_dot) / tick, limits.delta_ddot),
        ),
    )


def _within(value: float, limit: float) -> float:
    return max(-limit, min(limit, value))
