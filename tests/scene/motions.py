"""Motions of a kite that stands somewhere, for what is drawn of it."""

from math import cos, radians, sin

from kitemj.dynamics.motion import Body, Motion, PerLine, straight_lines
from kitemj.physics.frames import R_1E, R_BE, Angles
from kitemj.physics.loads import air
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, rest_ell
from kitemj.physics.vectors import Vector, minus, unrotated

LAKSA = parameter_set("laksa")
EQUILIBRIUM = Angles(0.0, radians(22.882617), 0.0, radians(-15.136331))
SPORT = {
    "kite": {"mass": 0.22, "chord": 0.45, "span": 1.7, "area": 0.6}
    | {"x_A": 0.15, "y_A": 0.3, "z_A": 0.35},
    "lines": {"length": 20.0},
}


def motion_at(parameters: Parameters, q: Angles, delta: float = 0.0, slack: float = 0.0) -> Motion:
    kite = parameters.kite
    ell = rest_ell(parameters.lines.length, kite.y_A)
    arm = Vector(0.0, ell * sin(q.eta + delta), -ell * cos(q.eta + delta))
    middle = unrotated(R_1E(q.phi, q.gamma), arm)
    G = minus(middle, unrotated(R_BE(q), Vector(kite.x_A, 0.0, kite.z_A)))
    still = Vector(0.0, 0.0, 0.0)
    body = Body(G, R_BE(q), still, still)
    control = Control(ell, 0.0, 0.0, delta, 0.0, 0.0)
    pulls = PerLine(0.0 if slack else 43.8, 43.8)
    left, right = straight_lines(parameters, body, control, pulls)
    lines = (left._replace(length=left.length + slack), right)
    return Motion(0.0, q, body, control, lines, air(parameters, G, body.R_BE, still, 0.0))
