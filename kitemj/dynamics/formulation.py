"""The contract of a formulation, and the list of those there are."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Protocol

from kitemj.errors import InputError
from kitemj.registry import Registry

if TYPE_CHECKING:  # the command line lists the models before anything heavy is loaded
    from kitemj.dynamics.motion import Body, Motion, Snapshot, State
    from kitemj.physics.compiled import Array
    from kitemj.physics.frames import Angles
    from kitemj.physics.loads import Wrench
    from kitemj.physics.parameters import Parameters
    from kitemj.physics.rig import Rig
    from kitemj.physics.steering import Control, Programme
    from kitemj.physics.vectors import Vector

DEFAULT_STEP = 0.002
"""s; holds the MuJoCo kite within 1 µm of the reference over a minute."""
MAX_STEP = 0.1
"""s; the fastest motion of a kite of this size would not be resolved beyond."""

MIN_STEP = 1e-6
"""s; a second is a million of them, and shorter ones add no digit."""


class Instant(NamedTuple):
    """The accelerations at one state.

    Of G [m/s², E], of the body's rates [rad/s², B] and of q [rad/s²]; `tensions` [N] at the kite,
    a number for each line; the `wrench` of the air.
    """

    body: Body
    a_G_E: Vector
    omega_dot_B: Vector
    q_ddot: Angles
    tensions: tuple[float, ...]
    wrench: Wrench


class Model(Protocol):
    """The same few verbs for every formulation; made from parameters and a step [s].

    `rigs` are those that it can fly; `step` [s] is the longest of `advance`, `t` [s] the present.
    """

    name: str
    rigs: tuple[Rig, ...]
    parameters: Parameters
    step: float
    t: float

    def __init__(self, parameters: Parameters, step: float = DEFAULT_STEP) -> None: ...

    def start(self, state: State, programme: Programme) -> None:
        """Puts the kite at `state` at t = 0 s, the lines moving as `programme` says."""

    def at(self, state: State, control: Control, t: float) -> Instant:
        """The instant at `state` with the lines at `control` at time `t` [s]; flies nowhere."""

    def advance(self, programme: Programme, duration: float) -> None:
        """Flies on for `duration` [s] in equal steps not longer than the model's own."""

    def motion(self, programme: Programme) -> Motion:
        """The present instant as pictures and tables show it, all of it finite.

        Raises FlightError where that would not be (`kitemj.dynamics.motion.told`).
        """

    @property
    def state(self) -> State:
        """The present q [rad] and q̇ [rad/s]; exact while the lines are straight."""

    def snapshot(self) -> Snapshot:
        """What `restore` needs to fly on from here to the same bits."""

    def restore(self, kept: Snapshot) -> None:
        """Back to a snapshot of a model with the same parameters and step."""

    def trajectory(self, programme: Programme, times: list[float]) -> list[Motion]:
        """The motion at each of `times` [s], ascending, not before now; the last becomes now.

        The flight ends where the kite touches the ground (`kitemj.dynamics.ground`): the last
        motion is then that of the touch. Raises FlightError with what was flown until then.
        """

    def batch(self, programme: Programme, times: Array, touch: float, tolerance: float) -> Array:
        """The flight from its start through `times` (n,) [s] at one go: rows of `batch.py`.

        Fewer than n where it leaves the finite or comes lower than `touch` [m].
        """


MODELS: Registry[type[Model]] = Registry(
    "model",
    "kitemj.models",
    {
        "mujoco": "kitemj.dynamics.mujoco_kite:MujocoKite",
        "newton-euler": "kitemj.dynamics.newton_euler_kite:NewtonEulerKite",
        "lagrange": "kitemj.dynamics.lagrange_kite:LagrangeKite",
    },
)
"""To add one: its files, and a line here."""


def check_model(name: str, step: float) -> None:
    """Raises InputError for an unknown model, and a step [s] that is too short, or too long."""
    MODELS.check(name)
    if not 0 < step <= MAX_STEP:
        raise InputError(f"`step` must be > 0 s and <= {MAX_STEP} s, got {step} s")
    if step < MIN_STEP:
        raise InputError(f"`step` must be >= {MIN_STEP:g} s, got {step} s: shorter is no better")


def make_model(name: str, parameters: Parameters, step: float = DEFAULT_STEP) -> Model:
    """The model called `name` with steps of at most `step` [s].

    Raises InputError as `check_model`, and for a rig that the model cannot fly.
    """
    from kitemj.physics.rig import rig_of

    check_model(name, step)
    kind, rig = MODELS[name], rig_of(parameters)
    if rig not in kind.rigs:
        flies = " or ".join(each.name for each in kind.rigs)
        raise InputError(f"the model {name} flies {flies}, not {rig.name}: choose another model")
    return kind(parameters, step)
