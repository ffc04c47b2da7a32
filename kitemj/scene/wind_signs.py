"""What shows the wind: a windsock, ribbons on poles, grass that bends, gusts over the field.

Functions of the parameters and of a motion's time, and of nothing else.
"""

from itertools import pairwise
from math import cos, pi, sin
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.mujoco_import import mujoco
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, cross, norm, plus, times
from kitemj.scene.airflow import Airflow, droop
from kitemj.scene.decor import Colour, add_stroke
from kitemj.scene.sun import land_to_E
from kitemj.scene.views import UP

BOX, CYLINDER = int(mujoco.mjtGeom.mjGEOM_BOX), int(mujoco.mjtGeom.mjGEOM_CYLINDER)
ORANGE, WHITE, YELLOW = (0.98, 0.45, 0.08), (0.96, 0.96, 0.93), (0.99, 0.80, 0.12)
POLE: Colour = (0.55, 0.50, 0.44)
SOCK_LIGHT, RIBBON_LIGHT = 3.2, 1.6  # m/s, in which the cloth stands at 45°
SOCK = 1.8  # m
RIBBON, RIBBON_WIDTH, PIECES = 2.2, 0.16, 7  # m, m, and of how many boxes it is made
WAVES = 1.6  # along a ribbon
SWING = 0.16  # rad, of a sock from side to side


class Pole(NamedTuple):
    """Where a pole stands [m, L], its height [m], and what is at its top."""

    ahead: float
    left: float
    height: float
    sock: bool


POLES = (
    Pole(9.0, 6.2, 4.2, True),
    Pole(6.5, -6.0, 3.0, False),
    Pole(17.0, -12.5, 3.6, False),
    Pole(19.0, 13.0, 3.6, False),
)


class WindSigns:
    """The signs of a parameter set's wind, added to scenes of its drawing model."""

    def __init__(self, parameters: Parameters) -> None:
        self._parameters, self._air = parameters, Airflow(parameters)
        self._poles = poles(parameters)

    def add(self, mjv: Any, t: float) -> None:
        """Adds socks and ribbons as they are at the time `t` [s]."""
        for number, pole in enumerate(self._poles):
            foot = land_to_E(self._parameters, Vector(pole.ahead, pole.left, 0.0))
            top = plus(foot, times(pole.height, UP))
            add_stroke(mjv, CYLINDER, 0.035, foot, top, POLE)
            v = self._air.at(Vector(pole.ahead, pole.left, pole.height), t)
            if pole.sock:
                _add_sock(mjv, sock(top, v, self._parameters.wind.speed, t))
            else:
                points = ribbon(top, v, self._parameters.wind.speed, t + 1.7 * number)
                _add_ribbon(mjv, points, YELLOW if number % 2 else ORANGE)


def poles(parameters: Parameters) -> list[Pole]:
    """The poles of the set; with short lines they stand nearer."""
    near = min(1.0, parameters.lines.length / 25.0)
    return [pole._replace(ahead=near * pole.ahead, left=near * pole.left) for pole in POLES]


def sock(top: Vector, v: Vector, usual: float, t: float) -> list[Vector]:
    """Points [m, E] along a sock from its mouth at `top`, in air of velocity `v` [m/s, E].

    usual: m/s, the speed that says how quickly it swings
    """
    along, aside = _level(v)
    down, phase = droop(norm(v), SOCK_LIGHT), 0.35 * usual * t
    points = [top]
    for piece in range(1, 6):
        lag = 0.5 * piece
        yaw = SWING * (sin(phase - lag) + 0.4 * sin(2.7 * phase - lag)) * (0.4 + 0.12 * piece)
        low = down + 0.05 * piece + 0.04 * sin(3.1 * phase - 2 * lag)
        step = plus(times(cos(yaw), along), times(sin(yaw), aside))
        step = plus(times(cos(low), step), times(-sin(low), UP))
        points.append(plus(points[-1], times(SOCK / 5, step)))
    return points


def ribbon(top: Vector, v: Vector, usual: float, t: float) -> NDArray[np.float64]:
    """Points (PIECES + 1, 3) [m, E] along a ribbon from `top`; arguments as of `sock`."""
    along, aside = (np.array(each) for each in _level(v))
    s = np.linspace(0.0, 1.0, PIECES + 1)[1:]
    down = droop(norm(v), RIBBON_LIGHT)
    phase = 2 * pi * (WAVES * s - 0.45 * usual * t)
    yaw = (0.25 + 0.65 * s) * np.sin(phase) * min(norm(v) / 3.0, 1.0)
    low = down + 0.16 * np.sin(0.6 * phase + 1.0) * s
    ahead = np.cos(yaw)[:, None] * along + np.sin(yaw)[:, None] * aside
    steps = np.cos(low)[:, None] * ahead - np.sin(low)[:, None] * np.array(UP)
    way = np.concatenate([[np.zeros(3)], RIBBON / PIECES * np.cumsum(steps, 0)])
    return np.asarray(np.array(top) + way)


def _add_sock(mjv: Any, points: list[Vector]) -> None:
    for piece, (a, b) in enumerate(pairwise(points)):
        add_stroke(mjv, CYLINDER, 0.23 - 0.028 * piece, a, b, WHITE if piece % 2 else ORANGE)


def _add_ribbon(mjv: Any, points: NDArray[np.float64], colour: Colour) -> None:
    """Adds thin boxes whose broad side is upright."""
    rgba = np.array([*colour, 1.0], np.float32)
    size = np.array([0.5 * RIBBON / PIECES + 0.01, 0.5 * RIBBON_WIDTH, 0.004])
    points = points * (1.0, -1.0, -1.0)  # W: as the engine has it
    middles, x = 0.5 * (points[1:] + points[:-1]), np.diff(points, axis=0)
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    z = np.stack([x[:, 1], -x[:, 0], np.zeros(len(x))], 1)
    z /= np.maximum(np.linalg.norm(z, axis=1, keepdims=True), 1e-9)
    turns = np.stack([x, np.cross(z, x), z], axis=2).reshape(-1, 9)
    for middle, turn in zip(middles, turns, strict=True):
        if mjv.ngeom < mjv.maxgeom:
            geom = mjv.geoms[mjv.ngeom]
            mujoco.mjv_initGeom(geom, BOX, size, middle, turn, rgba)
            geom.emission = 0.35
            mjv.ngeom += 1


def _level(v: Vector) -> tuple[Vector, Vector]:
    """Unit vectors [E] along the wind on the level and to its left; downwind along -x_E if none."""
    size = (v.x * v.x + v.y * v.y) ** 0.5
    along = Vector(v.x / size, v.y / size, 0.0) if size > 1e-6 else Vector(-1.0, 0.0, 0.0)
    return along, cross(UP, along)
