"""What the hand does: (ℓ, δ) with two derivatives, from a programme of time.

ℓ is the distance from O_E to the midpoint O_2 of the attachments, δ the angle by which
unequal lines tilt the triangle O_E A₊ A₋. A programme is a ``NamedTuple``; its law gives
the control at any time. Source: Sánchez-Arriaga et al. (2017), section 2.1.
"""

from math import cos, sin, sqrt
from typing import Annotated, NamedTuple

import numpy as np

from kitemj.physics.compiled import Array, compiled, law
from kitemj.physics.quantity import Quantity


class Control(NamedTuple):
    """ℓ [m], δ [rad] and their first and second time derivatives."""

    ell: float
    ell_dot: float
    ell_ddot: float
    delta: float
    delta_dot: float
    delta_ddot: float


class LineMotion(NamedTuple):
    """Length [m] of one line with its first and second time derivatives."""

    length: float
    rate: float
    acceleration: float


class Sines(NamedTuple):
    """ℓ = ell + ell_amplitude sin(ell_frequency t), δ likewise about `delta`."""

    ell: Annotated[float, Quantity("m", "mean ℓ", gt=0)]
    delta: Annotated[float, Quantity("rad", "mean δ")] = 0.0
    delta_amplitude: Annotated[float, Quantity("rad", "swing of δ")] = 0.0
    delta_frequency: Annotated[float, Quantity("rad/s", "angular frequency of δ")] = 0.0
    ell_amplitude: Annotated[float, Quantity("m", "swing of ℓ")] = 0.0
    ell_frequency: Annotated[float, Quantity("rad/s", "angular frequency of ℓ")] = 0.0


class Spline(NamedTuple):
    """Cubic pieces between `times` [s]; `ell` [m] and `delta` [rad] hold (4, n-1) coefficients.

    As ``scipy.interpolate.CubicSpline.c``: row 0 multiplies (t - times[i])³.
    """

    times: Array
    ell: Array
    delta: Array


class Segment(NamedTuple):
    """Constant ℓ̈ and δ̈ from the control at time `start` [s] on: one tick of a live flight."""

    start: float
    control: Control


Programme = Sines | Spline | Segment


def _control(programme: Programme, t: float) -> Control:
    """The control of `programme` at time `t` [s]."""
    raise NotImplementedError


control, programme_law = law(_control)


@programme_law.of(Sines)
@compiled
def sines_control(programme: Sines, t: float) -> Control:
    """ℓ and δ as sines of time."""
    w_l, w_d = programme.ell_frequency, programme.delta_frequency
    a_l, a_d = programme.ell_amplitude, programme.delta_amplitude
    return Control(
        programme.ell + a_l * sin(w_l * t),
        a_l * w_l * cos(w_l * t),
        -a_l * w_l * w_l * sin(w_l * t),
        programme.delta + a_d * sin(w_d * t),
        a_d * w_d * cos(w_d * t),
        -a_d * w_d * w_d * sin(w_d * t),
    )


@programme_law.of(Spline)
@compiled
def spline_control(programme: Spline, t: float) -> Control:
    """The cubic piece that holds `t`; the first and last pieces go on outside."""
    times, l, d = programme.times, programme.ell, programme.delta  # noqa: E741
    i = min(max(int(np.searchsorted(times, t, side="right")) - 1, 0), len(times) - 2)
    s = t - times[i]
    return Control(
        ((l[0, i] * s + l[1, i]) * s + l[2, i]) * s + l[3, i],
        (3 * l[0, i] * s + 2 * l[1, i]) * s + l[2, i],
        6 * l[0, i] * s + 2 * l[1, i],
        ((d[0, i] * s + d[1, i]) * s + d[2, i]) * s + d[3, i],
        (3 * d[0, i] * s + 2 * d[1, i]) * s + d[2, i],
        6 * d[0, i] * s + 2 * d[1, i],
    )


@programme_law.of(Segment)
@compiled
def segment_control(programme: Segment, t: float) -> Control:
    """Parabolas from the control at the segment's start."""
    c, s = programme.control, t - programme.start
    return Control(
        c.ell + s * (c.ell_dot + 0.5 * s * c.ell_ddot),
        c.ell_dot + s * c.ell_ddot,
        c.ell_ddot,
        c.delta + s * (c.delta_dot + 0.5 * s * c.delta_ddot),
        c.delta_dot + s * c.delta_ddot,
        c.delta_ddot,
    )


@compiled
def line_motion(y_A: float, c: Control, side: float) -> LineMotion:
    """L± = sqrt(ℓ² + Y_A² ± 2 ℓ Y_A sin δ) and its derivatives; `side` is +1 or -1.

    `y_A` [m] is half the distance between the attachments.
    """
    s, k, y = sin(c.delta), cos(c.delta), side * y_A
    length = sqrt(c.ell * c.ell + y_A * y_A + 2 * y * c.ell * s)
    half_rate = c.ell * c.ell_dot + y * (c.ell_dot * s + c.ell * c.delta_dot * k)
    half_acceleration = (
        c.ell_dot * c.ell_dot
        + c.ell * c.ell_ddot
        + y
        * (
            c.ell_ddot * s
            + 2 * c.ell_dot * c.delta_dot * k
            + c.ell * (c.delta_ddot * k - c.delta_dot * c.delta_dot * s)
        )
    )
    rate = half_rate / length
    return LineMotion(length, rate, (half_acceleration - rate * rate) / length)


def rest_ell(length: float, y_A: float) -> float:
    """ℓ₀ [m] = sqrt(L₀² - Y_A²): both lines `length` [m] long, δ = 0.

    Raises ValueError where the lines are too short to reach both attachments.
    """
    if length <= y_A:
        raise ValueError(f"the lines ({length} m) must be longer than y_A ({y_A} m)")
    return sqrt(length * length - y_A * y_A)


def ell_delta(length_plus: float, length_minus: float, y_A: float) -> tuple[float, float]:
    """(ℓ [m], δ [rad]) of the two line lengths [m]; the inverse of `line_motion`.

    Raises ValueError where no triangle has these sides.
    """
    ell_squared = (length_plus**2 + length_minus**2 - 2 * y_A**2) / 2
    sine = (length_plus**2 - length_minus**2) / (4 * sqrt(max(ell_squared, 1e-300)) * y_A)
    if ell_squared <= 0 or abs(sine) > 1:
        raise ValueError(
            f"lines of {length_plus} m and {length_minus} m do not reach attachments "
            f"{2 * y_A} m apart"
        )
    return sqrt(ell_squared), float(np.arcsin(sine))
