"""Any model in the eight coordinates x = (q, q̇), for what needs a state vector.

Time does not occur: the wind has no gusts here, and the lines are held or move as told.
"""

from math import atan2, ceil, hypot
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.formulation import MAX_STEP, make_model
from kitemj.dynamics.motion import Body, Motion, State
from kitemj.errors import FlightError, InputError
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Segment
from kitemj.physics.vectors import Vector

Array = NDArray[np.float64]

FLOW_STEP = 0.005
"""s; Runge-Kutta steps of `flow`. The fastest decay of the named kites is 25/s, for which a
step errs by 1e-7 of what is left of it."""


class Answer(NamedTuple):
    """ẋ (8,) in rad/s and rad/s², the tensions [N], the pose."""

    x_dot: Array
    tensions: tuple[float, ...]
    body: Body


class Minimal:
    """The model called `name`; `control` holds the inputs ℓ, δ and their derivatives.

    Raises InputError for an unknown model.
    """

    def __init__(self, name: str, parameters: Parameters) -> None:
        self.name, self.parameters = name, parameters
        # the engine's lines hold the more softly the longer the step: those of 2 ms steps turn
        # rounding of positions into 1e-9 m/s², these into 1e-13
        self._still = make_model(name, parameters, MAX_STEP)
        self._flying = make_model(name, parameters, FLOW_STEP)

    def answer(self, x: Array, control: Control) -> Answer:
        """Rates, tensions and pose at `x` (8,) [rad, rad/s]."""
        now = self._still.at(state_of(x), control, 0.0)
        return Answer(np.array([*x[4:], *now.q_ddot]), now.tensions, now.body)

    def flow(self, x: Array, control: Control, duration: float, steps: int = 0) -> Array:
        """`x` after `duration` [s] with `control` held, in `steps` (0: of FLOW_STEP each).

        Not a number where the model cannot go on; a line that goes slack makes x mean little.
        """
        programme, model = Segment(0.0, control), self._flying
        model.step = duration / (steps or steps_for(duration))
        model.start(state_of(x), programme)
        try:
            model.advance(programme, duration)
        except FlightError:
            return np.full(8, np.nan)
        q, q_dot = model.state
        return np.array([*q, *q_dot])

    def motions(self, x: Array, control: Control, duration: float, count: int) -> list[Motion]:
        """`count` + 1 motions of one flight from `x`, evenly from its start to `duration` [s]."""
        programme, model, h = Segment(0.0, control), self._flying, duration / count
        model.step = h / steps_for(h)
        model.start(state_of(x), programme)
        motions = [model.motion(programme)]
        for _ in range(count):
            model.advance(programme, h)
            motions.append(model.motion(programme))
        return motions


def finite(numbers: Array, what: str, model: str) -> Array:
    """`numbers`, of any shape; raises InputError where one of them is not finite."""
    if np.isfinite(numbers).all():
        return numbers
    raise InputError(
        f"the model {model} finds no finite {what}: ask another model, or give the kite sizes "
        f"that can be"
    )


def state_of(x: Array) -> State:
    """(q, q̇) of `x` (8,)."""
    return State(Angles(*map(float, x[:4])), Angles(*map(float, x[4:])))


def steps_for(duration: float) -> int:
    """The number of steps, each at most FLOW_STEP long."""
    return max(1, ceil(duration / FLOW_STEP - 1e-9))


def seen(p: Vector) -> tuple[float, float]:
    """Elevation and azimuth [rad] of `p` [m] from O_E; the azimuth is positive to the left."""
    return atan2(-p.z, hypot(p.x, p.y)), atan2(p.y, -p.x)


def held(ell: float, delta: float = 0.0) -> Control:
    """ℓ [m] and δ [rad] that do not move."""
    return Control(ell, 0.0, 0.0, delta, 0.0, 0.0)
