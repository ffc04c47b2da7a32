"""Steering for a scenario that names none: hands that are never still, within the stick's limits.

Formulations agree at rest whatever they get wrong about motion, so rest is no test of them.
"""

from dataclasses import replace
from math import pi, sqrt
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline

from kitemj.flight.scenario import Scenario
from kitemj.physics.compiled import Array
from kitemj.physics.steering import Spline, control

SHARE = 0.3
"""Of what the stick may do: enough that every term of the equations is at work, and little
enough that kites which turn do not fly into the ground at once."""
GOLDEN = (1 + sqrt(5)) / 2
"""Ratio of the two frequencies; the swings never repeat."""
ROWS = 8
"""Of the spline in half a swing."""


def restless(scenario: Scenario) -> Scenario:
    """`scenario`, its ℓ and δ swinging about what they are held at; from rest, without a jerk."""
    parameters, held = scenario.parameters, control(scenario.programme, 0.0)
    stick, y_A = parameters.stick, parameters.kite.y_A
    delta = min(SHARE * stick.delta, 0.5 * (pi / 2 - abs(held.delta)))
    ell = min(SHARE * stick.ell, 0.5 * (held.ell - y_A))
    quick = _quickest(delta, stick.delta_dot, stick.delta_ddot)
    slow = _quickest(ell, stick.ell_dot, stick.ell_ddot)
    count = int(ROWS * scenario.times.duration * max(quick, slow) / pi) + ROWS
    t = np.linspace(0.0, scenario.times.duration, count)
    columns = (held.ell + ell * _swings(slow * t), held.delta + delta * _swings(quick * t))
    still: Any = ((1, 0.0), (2, 0.0))  # no speed at the start, no acceleration at the end
    pieces = (CubicSpline(t, column, bc_type=still).c for column in columns)
    return replace(scenario, programme=Spline(t, *map(np.ascontiguousarray, pieces)))


def _quickest(size: float, rate: float, acceleration: float) -> float:
    """The frequency [rad/s] at which swings of `size` take up `SHARE` of what is allowed."""
    return min(SHARE * rate / size, sqrt(SHARE * acceleration / size))


def _swings(phase: Array) -> Array:
    """Between -1 and 1; 0 at 0, with slope 0."""
    return np.asarray(0.5 * (np.cos(phase / GOLDEN) - np.cos(phase)))
