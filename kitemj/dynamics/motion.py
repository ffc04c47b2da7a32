"""What every model answers: one instant of a flight, and the verbs to get there."""

from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from kitemj.physics.compiled import compiled
from kitemj.physics.frames import Angles, angles
from kitemj.physics.kite import Kite
from kitemj.physics.loads import Air, air
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Programme
from kitemj.physics.vectors import Rotation, Vector, cross, plus, times, unrotated


class PerLine(NamedTuple):
    """A number for each line: A₊ (the pilot's left) and A₋ (the pilot's right)."""

    plus: float
    minus: float


class State(NamedTuple):
    """Where a flight starts: q [rad] and its rates [rad/s]."""

    q: Angles
    q_dot: Angles


class Body(NamedTuple):
    """The rigid body's pose and velocity: G [m, E], attitude, v_G [m/s, E], rates [rad/s, B]."""

    p_G_E: Vector
    R_BE: Rotation
    v_G_E: Vector
    omega_B: Vector


class Motion(NamedTuple):
    """One instant of a flight; all that pictures, tables and comparisons are made of.

    `tensions` [N] pull when positive; `lengths` [m] are the lines paid out (a slack
    line is longer than the distance it spans).
    """

    t: float
    q: Angles
    body: Body
    control: Control
    lengths: PerLine
    tensions: PerLine
    air: Air


class Snapshot(NamedTuple):
    """All that a model remembers of a flight at time `t` [s], in numbers of its own."""

    t: float
    numbers: tuple[float, ...]


class Model(Protocol):
    """The same few verbs for every formulation."""

    name: str
    t: float

    def start(self, state: State, programme: Programme) -> None:
        """Puts the kite at `state` at t = 0 s, the lines moving as `programme` says."""

    def advance(self, programme: Programme, duration: float) -> None:
        """Flies on for `duration` [s] in equal steps not longer than the model's own."""

    def motion(self, programme: Programme) -> Motion:
        """The present instant."""

    def snapshot(self) -> Snapshot:
        """What `restore` needs to fly on from here to the same bits."""

    def restore(self, kept: Snapshot) -> None:
        """Back to a snapshot of a model with the same parameters and step."""

    def trajectory(self, programme: Programme, times: list[float]) -> list[Motion]:
        """The motion at each of `times` [s], ascending, not before now; the last becomes now."""

    def batch(
        self, programme: Programme, times: NDArray[np.float64], touch: float, tolerance: float
    ) -> NDArray[np.float64]:
        """The flight from its start through `times` (n,) [s] at one go: rows of a survey.

        Fewer than n where it leaves the finite or comes lower than `touch` [m].
        """


HULL = 0.05
"""m; half the thickness of the box that touches the ground."""


def hull_corners_B(kite: Kite) -> list[Vector]:
    """The eight corners [m, B] of the box of chord x span with which the kite meets the ground."""
    x, y = kite.chord / 2, kite.span / 2
    return [Vector(a * x, b * y, c * HULL) for a in (1, -1) for b in (1, -1) for c in (1, -1)]


@compiled
def attachment_E(parameters: Parameters, body: Body, side: float) -> Vector:
    """Position [m, E] of A₊ (`side` +1) or A₋ (-1)."""
    kite = parameters.kite
    GA_B = Vector(kite.x_A, side * kite.y_A, kite.z_A)
    return plus(body.p_G_E, unrotated(body.R_BE, GA_B))


@compiled
def attachment_velocity_E(parameters: Parameters, body: Body, side: float) -> Vector:
    """Velocity [m/s, E] of A₊ (`side` +1) or A₋ (-1)."""
    kite = parameters.kite
    GA_B = Vector(kite.x_A, side * kite.y_A, kite.z_A)
    return plus(body.v_G_E, unrotated(body.R_BE, cross(body.omega_B, GA_B)))


@compiled
def angles_of(parameters: Parameters, body: Body) -> Angles:
    """q [rad] of a pose; exact while both lines are straight."""
    middle = times(
        0.5, plus(attachment_E(parameters, body, 1.0), attachment_E(parameters, body, -1.0))
    )
    return angles(body.R_BE, middle)


@compiled
def air_of(parameters: Parameters, body: Body, t: float) -> Air:
    """Angles and speed of the air at the kite."""
    return air(parameters, body.p_G_E, body.R_BE, body.v_G_E, t)


@compiled
def energy(parameters: Parameters, body: Body) -> float:
    """Kinetic and potential energy [J]; the ground is zero height."""
    kite, w, v = parameters.kite, body.omega_B, body.v_G_E
    spin = (
        kite.inertia_x * w.x * w.x
        + kite.inertia_y * w.y * w.y
        + kite.inertia_z * w.z * w.z
        - 2 * kite.inertia_xz * w.x * w.z
    )
    height = -body.p_G_E.z
    translation = kite.mass * (v.x * v.x + v.y * v.y + v.z * v.z)
    return 0.5 * (translation + spin) + kite.mass * parameters.environment.gravity * height
