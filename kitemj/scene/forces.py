"""Arrows of the forces on the kite, and their scale."""

from itertools import chain, repeat

import numpy as np

from kitemj.dynamics.motion import Motion
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, minus, norm, times, unrotated
from kitemj.scene.cloth import DARK, usual_force
from kitemj.scene.lines import COLOURS
from kitemj.scene.strokes import Strokes

AIR = (1.0, 0.86, 0.20)
WEIGHT = (0.97, 0.97, 0.97)
THICK = 0.018  # spans, half the thickness of an arrow


def add_forces(strokes: Strokes, parameters: Parameters, motion: Motion) -> None:
    """Draws what acts: air and weight at the centre of mass, the pull of each line at its end."""
    p, body = parameters, motion.body
    metres, thick = 1.0 / newtons_per_metre(p), THICK * p.kite.span
    wrench = aerodynamic_wrench(p, body.p_G_E, body.R_BE, body.v_G_E, body.omega_B, motion.t)
    air = unrotated(body.R_BE, wrench.force)
    weight = Vector(0.0, 0.0, p.kite.mass * p.environment.gravity)
    strokes.arrow(body.p_G_E, times(metres, air), thick, AIR)
    strokes.arrow(body.p_G_E, times(metres, weight), thick, WEIGHT)
    for line, colour in zip(motion.lines, chain(COLOURS, repeat(DARK)), strict=False):
        *_, before, A = line.points
        pull = max(line.tension_kite, 0.0) * metres / norm(minus(before, A))
        strokes.arrow(A, times(pull, minus(before, A)), thick, colour)


def newtons_per_metre(parameters: Parameters) -> float:
    """The scale of the force arrows, a round number.

    The air's force of usual flight is about a span long, a line's ceiling at most eight.
    """
    ceiling = parameters.limits.tension_max / 8.0
    wanted = max(usual_force(parameters) / 0.9, ceiling) / parameters.kite.span
    decade = 10.0 ** np.floor(np.log10(wanted))
    return float(min((s * decade for s in (1, 1.5, 2, 3, 5, 10)), key=lambda s: abs(s - wanted)))
