"""What a kite, its lines and its air are, in SI; each number with unit, meaning and limits.

Immutable ``NamedTuple``s, so that the compiled formulas read them like Python does. Checking
happens where a set is made (`kitemj.physics.parameter_files`); the two named sets are in
``kitemj/physics/sets/``.
"""

from typing import Annotated, NamedTuple

from kitemj.physics.aerodynamics import LinearAero, TableAero
from kitemj.physics.quantity import Quantity
from kitemj.physics.wind import Wind


class Kite(NamedTuple):
    """The rigid kite about its centre of mass G, in the body frame B."""

    mass: Annotated[float, Quantity("kg", "mass of the kite", gt=0)]
    inertia_x: Annotated[float, Quantity("kg m²", "I_x about G", gt=0)]
    inertia_y: Annotated[float, Quantity("kg m²", "I_y about G", gt=0)]
    inertia_z: Annotated[float, Quantity("kg m²", "I_z about G", gt=0)]
    inertia_xz: Annotated[float, Quantity("kg m²", "I_xz; the tensor holds -I_xz")]
    chord: Annotated[float, Quantity("m", "mean chord, c", gt=0)]
    span: Annotated[float, Quantity("m", "span, b", gt=0)]
    area: Annotated[float, Quantity("m²", "reference area, S", gt=0)]
    x_A: Annotated[float, Quantity("m", "attachments ahead of G, X_A")]
    y_A: Annotated[float, Quantity("m", "half the distance between attachments, Y_A", gt=0)]
    z_A: Annotated[float, Quantity("m", "attachments below G, Z_A")]


class Lines(NamedTuple):
    """The two lines: massless, straight, inextensible; they only pull, unless `rigid`.

    Models in minimal coordinates always have rigid lines; the flag makes the MuJoCo kite's
    push as well, to be held against such models where a line would be slack.
    """

    length: Annotated[float, Quantity("m", "length of each line at δ = 0, L₀", gt=0)]
    rigid: Annotated[bool, Quantity("", "true: lines that push as well as pull")] = False


class Environment(NamedTuple):
    """What surrounds the kite."""

    gravity: Annotated[float, Quantity("m/s²", "acceleration of free fall, g", ge=0)]
    air_density: Annotated[float, Quantity("kg/m³", "ρ", ge=0)]


class Limits(NamedTuple):
    """Where the model stops being true: outside, numbers are printed but not vouched for."""

    alpha_stall: Annotated[float, Quantity("rad", "largest angle of attack", gt=0)]
    beta_max: Annotated[float, Quantity("rad", "largest sideslip angle", gt=0)]
    tension_max: Annotated[float, Quantity("N", "what one line may carry", gt=0)]


class StickLimits(NamedTuple):
    """How far and how fast the hand (through the stick) may move the lines.

    `mirrored` is for a kite that drifts away from the hand that pulls: the stick then says
    where the kite is to go. `arm` is the way of a stick that holds one line.
    """

    delta: Annotated[float, Quantity("rad", "largest |δ|", gt=0, lt=1.5)]
    delta_dot: Annotated[float, Quantity("rad/s", "largest |δ̇|", gt=0)]
    delta_ddot: Annotated[float, Quantity("rad/s²", "largest |δ̈|", gt=0)]
    ell: Annotated[float, Quantity("m", "largest |ℓ - ℓ₀|", gt=0)]
    ell_dot: Annotated[float, Quantity("m/s", "largest |ℓ̇|", gt=0)]
    ell_ddot: Annotated[float, Quantity("m/s²", "largest |ℓ̈|", gt=0)]
    arm: Annotated[float, Quantity("m", "how far a hand moves its line to each side", gt=0)] = 0.25
    mirrored: Annotated[bool, Quantity("", "true: the left hand pulls for stick right")] = False


class Parameters(NamedTuple):
    """One complete set; `aero` may be any type that the law of `aerodynamics` knows."""

    kite: Kite
    aero: LinearAero | TableAero
    lines: Lines
    environment: Environment
    wind: Wind
    limits: Limits
    stick: StickLimits
