"""The rates of the state, out of pose, velocity and body rates: exact, nothing is differenced."""

import numpy as np

from kitemj.dynamics.motion import Body
from kitemj.dynamics.straight import turning
from kitemj.physics.compiled import compiled
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Rotation, Vector
from kitemj.plots.flight import Array, Flight
from kitemj.recording.table import ATTITUDE, RATES, VELOCITY

POSE = ("x_E_m", "y_E_m", "z_E_m", *ATTITUDE, *VELOCITY, *RATES)


def q_dot(flight: Flight) -> Array:
    """φ̇, γ̇, η̇, θ̇ [rad/s] of each row, shape (rows, 4); not a number where i_2 is vertical.

    Raises InputError where a column lacks.
    """
    poses = flight.matrix(POSE, "the rates")
    with np.errstate(divide="ignore", invalid="ignore"):
        return _rates(flight.parameters, poses, np.empty((len(poses), 4)))


@compiled
def _rates(parameters: Parameters, poses: Array, rates: Array) -> Array:
    for i in range(len(poses)):
        p = poses[i]
        x, y, z = Vector(p[3], p[4], p[5]), Vector(p[6], p[7], p[8]), Vector(p[9], p[10], p[11])
        position, velocity = Vector(p[0], p[1], p[2]), Vector(p[12], p[13], p[14])
        body = Body(position, Rotation(x, y, z), velocity, Vector(p[15], p[16], p[17]))
        rates[i, 0], rates[i, 1], rates[i, 2], rates[i, 3] = turning(parameters, body).q_dot
    return rates
