"""Where the kite meets the ground: with the lowest corner of its hull."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from kitemj.dynamics.motion import HULL, Body, Motion
from kitemj.errors import FlightError
from kitemj.physics.compiled import compiled
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Rotation, Vector, plus, unrotated
from kitemj.progress_bar import with_progress

if TYPE_CHECKING:
    from kitemj.dynamics.formulation import Model
    from kitemj.physics.steering import Programme

LONG = 600.0
"""s; a longer flight shows how far it is."""
TOUCH = 1e-3
"""m; nearer than this to the ground the engine's contact is at work."""
CLOSE = 1e-9
"""m; a flight is ended no further beyond `TOUCH` than this; half of it is aimed at."""


@compiled
def clearance(chord: float, span: float, p_G_E: Vector, R_BE: Rotation) -> float:
    """Height [m] above ground of the lowest corner of a hull of `chord` x `span` [m]."""
    lowest = np.inf
    for a in (-0.5, 0.5):
        for b in (-0.5, 0.5):
            for c in (-HULL, HULL):
                corner = plus(p_G_E, unrotated(R_BE, Vector(a * chord, b * span, c)))
                lowest = min(lowest, -corner.z)
    return lowest


@compiled
def above(parameters: Parameters, body: Body) -> float:
    """How far [m] the hull is above `TOUCH`; negative: the kite touches the ground."""
    kite, height = parameters.kite, -body.p_G_E.z
    if height > kite.span + kite.chord:  # no corner is near the ground
        return height
    return clearance(kite.chord, kite.span, body.p_G_E, body.R_BE) - TOUCH


def down_to_ground(
    model: "Model", fly: Callable[[float], None], programme: "Programme", times: list[float]
) -> list[Motion]:
    """The motion of `model` at each of `times` [s], ascending, or to where it touches the ground.

    ``fly(end)`` takes the model on to `end` [s], or to the touch: its motion is then the last.
    Raises FlightError with what was flown until then.
    """
    motions: list[Motion] = []
    try:
        long = times and times[-1] - model.t > LONG
        for t in with_progress("rows flown", times, len(times)) if long else times:
            if t > model.t:
                fly(t)
            motions.append(model.motion(programme))
            if above(model.parameters, motions[-1].body) < 0.0:
                break
    except FlightError as error:
        error.motions = motions
        raise
    return motions
