"""The three models in the same eight coordinates x = (q, q̇), for what needs a state vector.

Lagrange's equations are written in them. The two free bodies are put at (q, q̇) by their own
start kinematics V = J(q) q̇ + V_0, V = (v_G in E, ω in B); their accelerations V̇ come back
as q̈ from J q̈ = V̇ - (dV/dt at constant q̇), and after a flight q̇ from J q̇ = V - V_0. Both
systems have six rows for four unknowns and are solved by least squares; their remainder is
zero as long as the lines are straight. Time does not occur: the wind has no gusts here.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable
from math import ceil
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.lagrange import accelerations, body
from kitemj.dynamics.lagrange_kite import flown
from kitemj.dynamics.motion import Body, PerLine, State, angles_of
from kitemj.errors import InputError
from kitemj.physics.compiled import compiled
from kitemj.physics.frames import Angles, world
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Segment, control

Array = NDArray[np.float64]

FLOW_STEP = 0.005
"""s; Runge-Kutta steps of `flow`. The fastest decay of the named kites is 25/s, for which a
step errs by 1e-7 of what is left of it."""

PATH_STEP = 0.05
"""s; along q + q̇ s, for dV/dt at constant q̇."""

ENGINE_STEP = 0.1
"""s; sets the stiffness of the engine's lines where only accelerations are asked: soft lines
turn rounding of positions into 1e-13 m/s², those of 2 ms steps into 1e-9."""


class Answer(NamedTuple):
    """ẋ (8,) in rad/s and rad/s², the tensions [N], the pose."""

    x_dot: Array
    tensions: PerLine
    body: Body


class Minimal(ABC):
    """One model; `control` holds the inputs ℓ, δ and their derivatives."""

    name: str

    def __init__(self, parameters: Parameters) -> None:
        self.parameters = parameters

    @abstractmethod
    def answer(self, x: Array, control: Control) -> Answer:
        """Rates, tensions and pose at `x` (8,) [rad, rad/s]."""

    @abstractmethod
    def flow(self, x: Array, control: Control, duration: float, steps: int = 0) -> Array:
        """`x` after `duration` [s] with `control` held, in `steps` (0: of FLOW_STEP each)."""


def state_of(x: Array) -> State:
    """(q, q̇) of `x` (8,)."""
    return State(Angles(*map(float, x[:4])), Angles(*map(float, x[4:])))


def steps_for(duration: float) -> int:
    """The number of steps, each at most FLOW_STEP long."""
    return max(1, ceil(duration / FLOW_STEP - 1e-9))


@compiled
def lagrange_answer(parameters: Parameters, c: Control, x: Array) -> tuple[Array, PerLine, Body]:
    """`Minimal.answer` of Lagrange's equations."""
    q, v = Angles(x[0], x[1], x[2], x[3]), Angles(x[4], x[5], x[6], x[7])
    a, tensions = accelerations(parameters, c, 0.0, q, v)
    x_dot = np.array([v.phi, v.gamma, v.eta, v.theta, a.phi, a.gamma, a.eta, a.theta])
    return x_dot, tensions, body(parameters, q, v, c)


class Lagrange(Minimal):
    """Lagrange's equations."""

    name = "lagrange"

    def answer(self, x: Array, control: Control) -> Answer:
        """See `Minimal`."""
        return Answer(*lagrange_answer(self.parameters, control, x))

    def flow(self, x: Array, control: Control, duration: float, steps: int = 0) -> Array:
        """See `Minimal`."""
        n = steps or steps_for(duration)
        end = flown(self.parameters, Segment(0.0, control), 0.0, state_of(x), n, duration / n)
        return np.array([*end.q, *end.q_dot])


class FreeBody(Minimal):
    """What the two free bodies share: the way from q̇ to V and back."""

    @abstractmethod
    def placed(self, x: Array, control: Control) -> Body:
        """The body at `x`, by the model's own kinematics."""

    @abstractmethod
    def accelerated(self, x: Array, control: Control) -> tuple[Array, PerLine]:
        """V̇ (6,) and the tensions at `x`."""

    def _V(self, q: Array, q_dot: Array, control: Control) -> Array:
        placed = self.placed(np.concatenate((q, q_dot)), control)
        return np.array([*placed.v_G_E, *placed.omega_B])

    def _J(self, q: Array, control: Control) -> tuple[Array, Array]:
        """J (6, 4) and V_0 (6,): V is linear in q̇."""
        V_0 = self._V(q, np.zeros(4), control)
        return np.column_stack([self._V(q, e, control) - V_0 for e in np.eye(4)]), V_0

    def _turning(self, q: Array, q_dot: Array, c: Control) -> Array:
        """dV/dt (6,) along the path with q̈ = 0; a central difference, once extrapolated."""
        if not q_dot.any() and c[1:3] == (0.0, 0.0) and c[4:] == (0.0, 0.0):
            return np.zeros(6)

        def slope(s: float) -> Array:
            ends = [
                self._V(q + r * q_dot, q_dot, Control(*map(float, control(Segment(0.0, c), r))))
                for r in (s, -s)
            ]
            return (ends[0] - ends[1]) / (2 * s)

        return (4 * slope(PATH_STEP / 2) - slope(PATH_STEP)) / 3

    def answer(self, x: Array, control: Control) -> Answer:
        """See `Minimal`."""
        q, q_dot = x[:4], x[4:]
        V_dot, tensions = self.accelerated(x, control)
        J, _ = self._J(q, control)
        q_ddot = np.linalg.lstsq(J, V_dot - self._turning(q, q_dot, control), rcond=None)[0]
        return Answer(np.concatenate((q_dot, q_ddot)), tensions, self.placed(x, control))

    def _x_of(self, body: Body, control: Control) -> Array:
        q = np.array(angles_of(self.parameters, body))
        J, V_0 = self._J(q, control)
        V = np.array([*body.v_G_E, *body.omega_B])
        return np.concatenate((q, np.linalg.lstsq(J, V - V_0, rcond=None)[0]))


class NewtonEuler(FreeBody):
    """The free body whose line forces are solved with its accelerations."""

    name = "newton-euler"

    def placed(self, x: Array, control: Control) -> Body:
        """See `FreeBody`."""
        from kitemj.dynamics.newton_euler import body_of, placed

        return body_of(placed(self.parameters, Segment(0.0, control), state_of(x)))

    def accelerated(self, x: Array, control: Control) -> tuple[Array, PerLine]:
        """See `FreeBody`."""
        from kitemj.dynamics.newton_euler import accelerations

        now = accelerations(self.parameters, Segment(0.0, control), 0.0, self.placed(x, control))
        return np.array([*now.a_G_E, *now.omega_dot_B]), now.tensions

    def flow(self, x: Array, control: Control, duration: float, steps: int = 0) -> Array:
        """See `Minimal`."""
        from kitemj.dynamics.newton_euler import body_of, flown, placed

        n, programme = steps or steps_for(duration), Segment(0.0, control)
        start = placed(self.parameters, programme, state_of(x))
        end = flown(self.parameters, programme, 0.0, start, n, duration / n)
        return self._x_of(body_of(end), control)


class Mujoco(FreeBody):
    """The MuJoCo body on its two tendons."""

    name = "mujoco"

    def __init__(self, parameters: Parameters) -> None:
        from kitemj.dynamics.engine import build

        super().__init__(parameters)
        self._still = build(parameters, ENGINE_STEP)
        self._flying = build(parameters, FLOW_STEP)

    def placed(self, x: Array, control: Control) -> Body:
        """See `FreeBody`."""
        from kitemj.dynamics.straight import straight_body

        q, q_dot = state_of(x)
        return straight_body(self.parameters, q, q_dot, control)

    def accelerated(self, x: Array, control: Control) -> tuple[Array, PerLine]:
        """See `FreeBody`."""
        from kitemj.dynamics.engine import body_of
        from kitemj.dynamics.mujoco_kite import put
        from kitemj.dynamics.taut import tensions
        from kitemj.physics.vectors import Vector

        engine = self._still[2]
        put(engine, self.parameters, Segment(0.0, control), state_of(x))
        a_E = world(Vector(*map(float, engine.qacc[:3])))
        pull = tensions(engine, self.parameters, body_of(engine))
        return np.array([*a_E, *engine.qacc[3:]]), pull

    def flow(self, x: Array, control: Control, duration: float, steps: int = 0) -> Array:
        """See `Minimal`; a line that would push goes slack, and `x` then means little."""
        from kitemj.dynamics.engine import body_of
        from kitemj.dynamics.mujoco_kite import flown, put

        n, programme, engine = steps or steps_for(duration), Segment(0.0, control), self._flying[2]
        put(engine, self.parameters, programme, state_of(x))
        flown(engine, self.parameters, programme, 0.0, n, duration / n)
        return self._x_of(body_of(engine), control)


KINDS: dict[str, Callable[[Parameters], Minimal]] = {
    kind.name: kind for kind in (Lagrange, NewtonEuler, Mujoco)
}


def minimal(name: str, parameters: Parameters) -> Minimal:
    """The model called `name`; raises InputError where there is none."""
    if name not in KINDS:
        raise InputError(f"there is no model {name!r}; there are: {', '.join(KINDS)}")
    return KINDS[name](parameters)


def held(ell: float, delta: float = 0.0) -> Control:
    """ℓ [m] and δ [rad] that do not move."""
    return Control(ell, 0.0, 0.0, delta, 0.0, 0.0)
