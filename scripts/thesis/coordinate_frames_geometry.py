"""Section 3: origins and axes of the coordinate frames, by the rotations of the models."""

from math import radians
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.lagrange import body
from kitemj.dynamics.motion import attachment_E
from kitemj.equilibria.minimal import held
from kitemj.physics.frames import R_1E, R_2E, R_BE, Angles
from kitemj.physics.parameter_files import parameter_set

Array = NDArray[np.float64]

Q = Angles(*map(radians, (30.0, 25.0, 25.0, -35.0)))
"""rad; far more of each angle than a calm flight has, so that each can be seen."""
ELL, DELTA = 7.0, radians(20.0)
"""m, rad; lines so short that kite and ground fit on one drawing."""
ZERO = Angles(0.0, 0.0, 0.0, 0.0)


class FrameGeometry(NamedTuple):
    """Points [m, E], and the axes of each frame as rows of unit vectors [E]."""

    points: dict[str, Array]
    axes: dict[str, Array]
    origins: dict[str, str]


def frame_geometry() -> FrameGeometry:
    """Everything that is drawn."""
    parameters = parameter_set("thesis")
    pose = body(parameters, Q, ZERO, held(ELL, DELTA))
    ends = {
        name: np.array(attachment_E(parameters, pose, side))
        for name, side in (("A₊", 1.0), ("A₋", -1.0))
    }
    points = {"O_E": np.zeros(3), "O_2": (ends["A₊"] + ends["A₋"]) / 2, **ends}
    points["G"] = np.array(pose.p_G_E)
    rotations = {"E": np.eye(3), "1": R_1E(Q.phi, Q.gamma), "2": R_2E(Q), "B": R_BE(Q)}
    axes = {name: np.array(R) for name, R in rotations.items()}
    return FrameGeometry(points, axes, {"E": "O_E", "1": "O_E", "2": "O_2", "B": "G"})
