"""A kite that flies straight on: the state at which a flight begins in the middle of the sky."""

from math import cos, sin, tan

import numpy as np

from kitemj.dynamics.motion import State
from kitemj.flight.equilibrium import equilibrium
from kitemj.physics.frames import Angles, angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import rest_ell
from kitemj.physics.vectors import Rotation, Vector


def gliding(parameters: Parameters, azimuth: float, elevation: float, heading: float) -> State:
    """The state of a kite that flies where it points, at the α of rest.

    All in rad as the pilot sees them: azimuth positive to the right, heading 0 up, π/2 right. Its
    speed is the one at which the air meets it as at rest; none where the wind is too weak.
    """
    az, el, nose = azimuth, elevation, heading
    out = np.array([-cos(el) * cos(az), -cos(el) * sin(az), -sin(el)])
    right = np.array([sin(az), -cos(az), 0.0])
    up = np.array([sin(el) * cos(az), sin(el) * sin(az), -cos(el)])
    ahead = cos(nose) * up + sin(nose) * right
    rest, wind = equilibrium(parameters), np.array([-parameters.wind.speed, 0.0, 0.0])
    speed = max(0.0, max(0.0, wind @ out) / tan(rest.gamma) + wind @ ahead)
    ell = rest_ell(parameters.lines.length, parameters.kite.y_A)
    across = np.cross(-out, ahead)
    s, c = sin(rest.theta), cos(rest.theta)
    x_B, z_B = c * ahead + s * out, s * ahead - c * out
    attitude = Rotation(*(Vector(*map(float, axis)) for axis in (x_B, across, z_B)))
    q = angles(attitude, Vector(*map(float, ell * out)))._replace(theta=rest.theta)
    j_1 = np.array([-sin(q.phi), cos(q.phi), 0.0])
    turning = np.cross(out, speed / ell * ahead)  # = φ̇ k_E + γ̇ j_1 + η̇ i_2
    axes = np.column_stack(([0.0, 0.0, 1.0], j_1, ahead))
    phi, gamma, eta = map(float, np.linalg.solve(axes, turning))
    return State(q, Angles(phi, gamma, eta, 0.0))
