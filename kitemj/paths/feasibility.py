"""What a path asks of a kite, worked out before the flight by its glide and the law of turning."""

from math import hypot, inf, radians
from typing import NamedTuple

import numpy as np

from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.paths.glide import airspeeds, with_weight
from kitemj.paths.path import Path, courses, drifts, periodic_slope
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import Parameters
from kitemj.turning.gains import turn_gain

AUTHORITY = 0.9
"""Of the stick's way, rate and acceleration, what a path may ask for; the rest is for errors."""
STRAY = radians(4.0)
"""How far below its path a kite may be: the largest error allowed with a real kite's sensors."""
SLOWEST = 0.25
"""winds over the ground, at least: a slower kite hangs, and where it goes is decided by weight."""


class Feasibility(NamedTuple):
    """What flying a path asks for, at worst; each `..._at` is the direction (3,) of the place.

    `stick`, `rate`, `acceleration`: |δ|, |δ̇|, |δ̈| in parts of the hands' limits.
    `radius` [m]: on which the nose has to turn where the stick is needed most, and `least` [m], on
    which it can there with `AUTHORITY`; `speed` over the ground [m/s], the least, and in `winds`;
    `height` [m] above ground of the kite's lowest corner where it strays lowest.
    """

    stick: float
    stick_at: Array
    rate: float
    rate_at: Array
    acceleration: float
    acceleration_at: Array
    radius: float
    least: float
    speed: float
    winds: float
    speed_at: Array
    height: float
    height_at: Array

    @property
    def share(self) -> float:
        """The largest part of a limit of the hands that is asked for."""
        return max(self.stick, self.rate, self.acceleration)

    def excess(self, share: float = AUTHORITY, slowest: float = SLOWEST) -> float:
        """By what part the worst number is beyond what is allowed; 0 or less: none is."""
        return max(self.share / share, slowest / self.winds, 1.0 - self.height) - 1.0


def feasibility(path: Path, parameters: Parameters, law: TurnRateLaw) -> Feasibility:
    """What flying `path` asks for in the steady wind of the set."""
    wind, length, limits = parameters.wind.speed, parameters.lines.length, parameters.stick
    path = with_weight(path, parameters)
    pace = path.speed * wind / length  # rad/s
    turning, gain, by_weight = turning_on(path, parameters, law)
    delta = (turning - by_weight) / gain
    rate = periodic_slope(delta, path.spacing) * pace
    acceleration = periodic_slope(rate, path.spacing) * pace
    i, j, k = (int(np.abs(each).argmax()) for each in (delta, rate, acceleration))
    slow, low = int(path.speed.argmin()), int(path.points[:, 2].argmin())
    can = AUTHORITY * limits.delta * gain[i] + np.sign(delta[i]) * by_weight[i]
    speed = float(pace[i]) * length
    corner = hypot(parameters.kite.span, parameters.kite.chord) / 2
    lowest = float(np.arcsin(path.points[low, 2])) - STRAY
    return Feasibility(
        abs(float(delta[i])) / limits.delta,
        path.points[i],
        abs(float(rate[j])) / limits.delta_dot,
        path.points[j],
        abs(float(acceleration[k])) / limits.delta_ddot,
        path.points[k],
        speed / max(abs(float(turning[i])), 1e-9),
        speed / float(can) if can > 0.0 else inf,
        wind * float(path.speed[slow]),
        float(path.speed[slow]),
        path.points[slow],
        length * float(np.sin(lowest)) - corner,
        path.points[low],
    )


def turning_on(path: Path, parameters: Parameters, law: TurnRateLaw) -> tuple[Array, Array, Array]:
    """Of the nose (n,): rad/s along `path`, for each rad of δ there, and by weight alone."""
    wind, length = parameters.wind.speed, parameters.lines.length
    air = wind * airspeeds(path)
    gain = np.array([turn_gain(law, float(v)) for v in air])
    heading = courses(path) + drifts(path, path.speed)
    level = np.hypot(path.points[:, 0], path.points[:, 1])  # cosine of the elevation
    by_weight = law.c2 / air * np.sin(heading) * level
    return path.turning * path.speed * wind / length, gain, by_weight
