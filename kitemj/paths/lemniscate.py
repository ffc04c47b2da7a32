"""A figure of eight lying in the sky: of all of one family, the one with the widest bends."""

from collections.abc import Callable
from functools import lru_cache
from math import pi, sqrt, tan

import numpy as np
from scipy.optimize import minimize_scalar

from kitemj.flight.pilot_settings import PathSettings
from kitemj.paths.sphere import axes_at
from kitemj.physics.compiled import Array

Curve = Callable[[Array], tuple[Array, Array, Array]]
"""Of t [rad], once around in 2π: r (n, 3), its first and second derivative. The curve in the sky
is r/|r|."""

STEPS = 256
"""Points of half a lap among which the sharpest bend is looked for."""
BLENDS = (-0.45, 12.0)
"""m between which the widest bends are looked for; at -0.5 the sides get dented."""
DIGITS = 2
"""Of m; finer nobody sees, and rounding is the same in all processes."""
HEIGHT_STEPS = 5
"""Of the height; each takes its error down to a tenth or less."""


def lemniscate(settings: PathSettings) -> Curve:
    """The eight of `settings.width` and `height` [rad], from the crossing to the right.

    x = a sin t / (1 + m cos² t), y = b √(1 + m) sin 2t / (1 + m cos² t) in a stereographic
    picture of the sky around the middle: of Gerono for m = 0, of Bernoulli for m = 1. m is the one
    that makes the sharpest bend widest.
    """
    middle, right, up = axes_at(settings.azimuth, settings.elevation)
    side = -1.0 if settings.turn in ("up", "left") else 1.0
    m, b = widest(settings.width, settings.height)
    a = tan(settings.width / 4)

    def curve(t: Array) -> tuple[Array, Array, Array]:
        (x, x_1, x_2), (y, y_1, y_2) = flat(t, a, side * b, m)
        inward = 1.0 - x * x - y * y, -2 * (x * x_1 + y * y_1)
        inward_2 = -2 * (x_1 * x_1 + x * x_2 + y_1 * y_1 + y * y_2)
        return (
            np.outer(inward[0], middle) + 2 * (np.outer(x, right) + np.outer(y, up)),
            np.outer(inward[1], middle) + 2 * (np.outer(x_1, right) + np.outer(y_1, up)),
            np.outer(inward_2, middle) + 2 * (np.outer(x_2, right) + np.outer(y_2, up)),
        )

    return curve


Parts = tuple[Array, Array, Array]


def flat(t: Array, a: float, b: float, m: float) -> tuple[Parts, Parts]:
    """x and y of half-width `a` and half-height `b` at `t`, each with two derivatives."""
    c = b * sqrt(1.0 + m)
    lap = 1.0 + m * np.cos(t) ** 2, -m * np.sin(2 * t), -2 * m * np.cos(2 * t)
    x = a * np.sin(t), a * np.cos(t), -a * np.sin(t)
    y = c * np.sin(2 * t), 2 * c * np.cos(2 * t), -4 * c * np.sin(2 * t)
    return _ratio(x, lap), _ratio(y, lap)


def _ratio(u: Parts, v: Parts) -> Parts:
    """u/v and its two derivatives."""
    q = u[0] / v[0]
    q_1 = (u[1] - q * v[1]) / v[0]
    return q, q_1, (u[2] - 2 * q_1 * v[1] - q * v[2]) / v[0]


@lru_cache(maxsize=256)
def widest(width: float, height: float) -> tuple[float, float]:
    """m, and b that makes the eight as high in the sky as is said, for the widest bends."""

    def sharpest(m: float) -> float:
        return sharpest_bend(width, height, m)

    found = minimize_scalar(sharpest, bounds=BLENDS, method="bounded", options={"xatol": 1e-3})
    m = round(float(found.x), DIGITS)
    return m, half_height(width, height, m)


def half_height(width: float, height: float, m: float) -> float:
    """b: the highest point is `height`/2 from the great circle through middle and sides."""
    t, a, wanted = np.linspace(0.0, pi / 2, STEPS), tan(width / 4), np.sin(height / 2)
    b = tan(height / 4)
    for _ in range(HEIGHT_STEPS):
        (x, *_), (y, *_) = flat(t, a, b, m)
        b *= float(wanted / np.max(2 * y / (1.0 + x * x + y * y)))
    return b


def sharpest_bend(width: float, height: float, m: float) -> float:
    """The largest geodesic curvature [1] of the eight of a family's `m`."""
    t = np.linspace(0.0, pi / 2, STEPS)
    (x, x_1, x_2), (y, y_1, y_2) = flat(t, tan(width / 4), half_height(width, height, m), m)
    pace = np.hypot(x_1, y_1)
    # of a curve in a stereographic picture: that in the plane, and what the picture adds
    bend = (1.0 + x * x + y * y) / 2 * (x_1 * y_2 - y_1 * x_2) / pace**3 + (
        x_1 * y - y_1 * x
    ) / pace
    return float(np.abs(bend).max())
