"""From what a stick asks for to how lines can move: C¹, within limits, without overshoot.

ruckig finds the quickest way to a target under limits on rate and acceleration. A tick
takes the mean acceleration of that way over its length, so that δ̈ and ℓ̈ are constant in a
tick and its numbers say exactly what was flown. The way is found anew at each tick.
"""

from enum import IntEnum
from functools import cache
from math import copysign, inf
from typing import Any

import ruckig

from kitemj.physics.parameters import StickLimits
from kitemj.physics.steering import Control, Segment

NUDGE = 1 + 1e-9
"""What the planner is given in place of a limit that it stumbles over; the result is cut."""

STILL = 1e-9
"""rad/s; who asks for less asks to stop where the brakes allow."""

AHEAD = 1000.0
"""s; how far is planned: ruckig refuses ways of more than 7,600 s, and a tick needs little."""


class StickLaw(IntEnum):
    """What a stick's deflection means, in parts of the limit: δ, δ̇ or δ̈."""

    ANGLE = 0
    RATE = 1
    ACCELERATION = 2

    @property
    def symbol(self) -> str:
        """What the stick commands."""
        return ("δ", "δ̇", "δ̈")[self]


def asked(
    limits: StickLimits, law: StickLaw, stick: float, now: Control, tick: float
) -> tuple[float, float]:
    """(δ [rad], largest |δ̇| [rad/s] on the way there) that a `stick` in -1..1 asks for.

    A rate is a way to the limit on its side, no faster than that; at the limit it ends. An
    acceleration is a rate that grows through the `tick` [s], and stays when the stick rests.
    """
    if law is StickLaw.ANGLE:
        return stick * limits.delta, limits.delta_dot
    rate = stick * limits.delta_dot
    if law is StickLaw.ACCELERATION:
        rate = _within(now.delta_dot + stick * limits.delta_ddot * tick, limits.delta_dot)
    return copysign(limits.delta, rate), abs(rate)


@cache
def _planner() -> tuple[Any, Any, Any]:
    wish = ruckig.InputParameter(2)
    wish.synchronization = ruckig.Synchronization.No
    return ruckig.Ruckig(2), wish, ruckig.Trajectory(2)


def shaped(
    limits: StickLimits,
    now: Control,
    start: float,
    tick: float,
    delta: float,
    ell: float,
    ell_rest: float,
    delta_dot: float = inf,
) -> Segment:
    """The lines' motion from time `start` [s] on for one `tick` [s].

    `now` is the control at its start, `delta` [rad] and `ell` [m] what is asked for (cut to
    their limits; `ell_rest` is ℓ₀), `delta_dot` [rad/s] how fast δ may go there. |δ̇|, |δ̈|, |ℓ̇|
    and |ℓ̈| stay within `limits`; a target that stands still is reached to within
    limit tick²/4 and never passed by more.
    """
    planner, wish, way = _planner()
    stops, kinds = delta_dot < STILL, ruckig.ControlInterface
    wish.per_dof_control_interface = [kinds.Velocity if stops else kinds.Position, kinds.Position]
    wish.current_position = [now.delta, now.ell]
    wish.current_velocity = [now.delta_dot, now.ell_dot]
    reach = ell_rest + _within(ell - ell_rest, limits.ell)
    delta = _within(delta, limits.delta)
    asked_rate = limits.delta_dot if stops else delta_dot
    fastest = min(asked_rate, limits.delta_dot, AHEAD * limits.delta_ddot)
    reel = min(limits.ell_dot, AHEAD * limits.ell_ddot)
    wish.target_position = [
        _ahead(delta, now.delta, now.delta_dot, fastest, limits.delta_ddot),
        _ahead(reach, now.ell, now.ell_dot, reel, limits.ell_ddot),
    ]
    wish.max_velocity = [fastest, reel]
    wish.max_acceleration = [limits.delta_ddot, limits.ell_ddot]
    try:
        planner.calculate(wish, way)
    except ruckig.RuckigError:
        # a state exactly on the braking parabola can fall between its cases by rounding
        wish.max_acceleration = [NUDGE * limits.delta_ddot, NUDGE * limits.ell_ddot]
        planner.calculate(wish, way)
    _, (delta_dot, ell_dot), _ = way.at_time(tick)
    ell_ddot = _within((ell_dot - now.ell_dot) / tick, limits.ell_ddot)
    delta_ddot = _within((delta_dot - now.delta_dot) / tick, limits.delta_ddot)
    return Segment(start, now._replace(ell_ddot=ell_ddot, delta_ddot=delta_ddot))


def _ahead(target: float, place: float, rate: float, fastest: float, brakes: float) -> float:
    """The `target`, or what lies on the way there, `AHEAD` at the `fastest` past the braking."""
    rests, far = place + rate * abs(rate) / (2 * brakes), AHEAD * fastest
    return max(rests - far, min(rests + far, target))


def _within(value: float, limit: float) -> float:
    return max(-limit, min(limit, value))
