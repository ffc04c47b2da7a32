"""Rigs: by which lines a kite is held; columns of tables and pictures follow from that."""

from typing import NamedTuple

from kitemj.physics.kite import Lines
from kitemj.physics.parameters import Parameters


class Rig(NamedTuple):
    """`name` for people; names of its `lines`, the pilot's left first, and of its coordinates."""

    name: str
    lines: tuple[str, ...]
    coordinates: tuple[str, ...] = ()


TWO_LINES = Rig("two straight lines", ("plus", "minus"), ("phi", "gamma", "eta", "theta"))

RIGS: dict[type, Rig] = {Lines: TWO_LINES}
"""The rig of each type of ``parameters.lines``."""


def rig_of(parameters: Parameters) -> Rig:
    """The rig that the parameters describe."""
    return RIGS[type(parameters.lines)]
