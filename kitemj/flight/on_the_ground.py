"""The state of a kite that is about to be launched from the edge of the window."""

from math import asin, pi

from kitemj.dynamics.motion import State
from kitemj.flight.equilibrium import equilibrium
from kitemj.flight.gliding import gliding
from kitemj.physics.parameters import Parameters

UP = 0.2
"""rad; the nose of a kite that stands there is so far above the horizontal."""
TIP = 0.8
"""m above the ground of the lower tip, as high as a helper's hands."""


def launching(
    parameters: Parameters, side: float, inside: float = 0.05, nose: float = UP, tip: float = TIP
) -> State:
    """The state of a kite that a helper lets go at the edge: on its side, the nose out and up.

    The pilot has stepped back: the lines are taut. Where the nose points outward, the wind meets
    the kite from ahead, at the α of rest; with the nose up at the edge it would come from the
    side. Where the edge is slack, or the wind none, the tensions tell.

    parameters  the kite and its wind
    side        right +1, left -1
    inside      rad from the edge, where the kite would hang without weight, to the middle
    nose        rad above the horizontal
    tip         m of the lower tip above the ground
    """
    edge = pi / 2 - equilibrium(parameters).gamma
    elevation = asin((parameters.kite.span / 2 + tip) / parameters.lines.length)
    return gliding(parameters, side * (edge - inside), elevation, side * (pi / 2 - nose))
