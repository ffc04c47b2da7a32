"""One instant of a flight, as every model tells it: pose, velocity, lines, air."""

from itertools import chain
from math import isfinite
from typing import NamedTuple

from kitemj.errors import FlightError
from kitemj.physics.compiled import compiled
from kitemj.physics.frames import Angles, angles
from kitemj.physics.kite import Kite
from kitemj.physics.loads import Air, air
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, line_motion
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


class LineState(NamedTuple):
    """One line: the `length` [m] paid out, what it pulls [N] at either end, where it runs.

    `points` [m, E] are what it is drawn through, from the ground to the kite. A slack line is
    longer than the way between them.
    """

    length: float
    tension_ground: float
    tension_kite: float
    points: tuple[Vector, ...]


class Motion(NamedTuple):
    """One instant of a flight; all that pictures, tables and comparisons are made of.

    `q` is None where the formulation has no such coordinates; `lines` are in the order of the
    rig's (`kitemj.physics.rig`), the pilot's left first.
    """

    t: float
    q: Angles | None
    body: Body
    control: Control
    lines: tuple[LineState, ...]
    air: Air

    @property
    def tensions(self) -> tuple[float, ...]:
        """What each line pulls at the kite [N]; positive is a pull."""
        return tuple(line.tension_kite for line in self.lines)

    @property
    def lengths(self) -> tuple[float, ...]:
        """How much of each line is paid out [m]."""
        return tuple(line.length for line in self.lines)


def told(model: str, motion: Motion) -> Motion:
    """`motion`, as `model` tells it: the one way out of a model.

    Raises FlightError that names the first number that is not finite.
    """
    body, lines = motion.body, motion.lines
    for name, numbers in (
        ("coordinates", motion.q or ()),
        ("position", body.p_G_E),
        ("attitude", chain(*body.R_BE)),
        ("velocity", chain(body.v_G_E, body.omega_B)),
        ("length of a line", motion.lengths),
        ("tension of a line", chain(*(line[1:3] for line in lines))),
        ("path of a line", chain(*chain(*(line.points for line in lines)))),
        ("air at the kite", motion.air),
        ("hands", motion.control),
    ):
        if not all(map(isfinite, numbers)):
            reason = f"the numbers left the finite ({name}); a shorter step may help"
            raise FlightError(model, motion.t, reason, [])
    return motion


class Snapshot(NamedTuple):
    """All that a model remembers of a flight at time `t` [s], in numbers of its own."""

    t: float
    numbers: tuple[float, ...]


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
    A_plus, A_minus = attachment_E(parameters, body, 1.0), attachment_E(parameters, body, -1.0)
    return angles(body.R_BE, times(0.5, plus(A_plus, A_minus)))


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


@compiled
def straight_lines(
    parameters: Parameters, body: Body, c: Control, tensions: PerLine
) -> tuple[LineState, LineState]:
    """Both straight, massless lines, which pull with `tensions` [N]; that to A₊ first."""
    y_A, ground = parameters.kite.y_A, Vector(0.0, 0.0, 0.0)
    A_plus, A_minus = attachment_E(parameters, body, 1.0), attachment_E(parameters, body, -1.0)
    left, right = line_motion(y_A, c, 1.0).length, line_motion(y_A, c, -1.0).length
    return (
        LineState(left, tensions.plus, tensions.plus, (ground, A_plus)),
        LineState(right, tensions.minus, tensions.minus, (ground, A_minus)),
    )
