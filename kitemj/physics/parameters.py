"""What a kite, its lines and its air are, in SI; each number with unit, meaning and limits.

Immutable ``NamedTuple``s, so that the compiled formulas read them like Python does. Checking
happens where a set is made (`kitemj.physics.parameter_files`); the named sets are in
``kitemj/physics/sets/``.
"""

from math import tau
from typing import Annotated, NamedTuple

from kitemj.physics.aerodynamics import LinearAero, TableAero
from kitemj.physics.kite import Kite, Lines
from kitemj.physics.quantity import Quantity
from kitemj.physics.wind import Wind


class Environment(NamedTuple):
    """What surrounds the kite."""

    gravity: Annotated[float, Quantity("m/s²", "acceleration of free fall, g", ge=0)]
    air_density: Annotated[float, Quantity("kg/m³", "ρ", ge=0)]


class Limits(NamedTuple):
    """Where the model stops being true: outside, numbers are printed but not vouched for."""

    alpha_stall: Annotated[float, Quantity("rad", "largest angle of attack", gt=0)]
    beta_max: Annotated[float, Quantity("rad", "largest sideslip angle", gt=0)]
    tension_max: Annotated[float, Quantity("N", "what one line may carry", gt=0)]
    twist_max: Annotated[float, Quantity("rad", "largest twist of the lines", gt=0)] = 5 * tau
    """An estimate: polyethylene lines slide on one another with some turns of twist."""


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
