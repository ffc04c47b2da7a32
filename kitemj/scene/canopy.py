"""The kite that is drawn for a parameter set: a stunt kite with a frame, or a parafoil.

A sail that has a frame needs a short bridle only; a wing without one is held open along its
span by a bridle that is long. So the attachments tell which it is.
"""

from kitemj.physics.kite import Kite
from kitemj.physics.vectors import Vector
from kitemj.scene import foil, stunt
from kitemj.scene.cloth import Cloth

SHORT = 0.25
"""Spans: attachments nearer below the centre of mass than this are those of a framed kite.

Those of `sport` and `trainer` are at 0.08 and 0.16, those of `laksa` at 0.34.
"""


def framed(kite: Kite) -> bool:
    """Whether it is drawn as a stunt kite with a frame, else as a parafoil."""
    return abs(kite.z_A) < SHORT * kite.span


def canopy(kite: Kite) -> Cloth:
    """The cloth of a kite, from its span, chord and attachments."""
    return stunt.stunt(kite) if framed(kite) else foil.foil(kite)


def surface_point(kite: Kite, across: float, along: float) -> Vector:
    """Point [m, B] of the sail: `across` -1 (A₋) to 1 (A₊), `along` 0 (nose) to 1 (tail)."""
    point = stunt.point if framed(kite) else foil.point
    return point(kite, across, along)
