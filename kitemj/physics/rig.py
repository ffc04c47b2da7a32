"""Rigs: by which lines a kite is held; columns of tables and pictures follow from that."""

from collections.abc import Callable
from typing import NamedTuple

from kitemj.physics.kite import Kite, Lines
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector


class Rig(NamedTuple):
    """`name` for people; names of its `lines`, the pilot's left first, and of its coordinates.

    `attachments` are where each line ends on the kite, from G [m, B].
    """

    name: str
    lines: tuple[str, ...]
    attachments: Callable[[Kite], tuple[Vector, ...]]
    coordinates: tuple[str, ...] = ()


def _tips(kite: Kite) -> tuple[Vector, ...]:
    """A₊ and A₋."""
    return tuple(Vector(kite.x_A, side * kite.y_A, kite.z_A) for side in (1.0, -1.0))


TWO_LINES = Rig("two straight lines", ("plus", "minus"), _tips, ("phi", "gamma", "eta", "theta"))

RIGS: dict[type, Rig] = {Lines: TWO_LINES}
"""The rig of each type of ``parameters.lines``."""


def rig_of(parameters: Parameters) -> Rig:
    """The rig that the parameters describe."""
    return RIGS[type(parameters.lines)]
