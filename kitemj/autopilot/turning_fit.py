"""The law of turning fitted to a flight by least squares, with what its numbers are uncertain by.

The residual of such a fit is what the law leaves out, not noise: it swings slowly, and the usual
covariance would call the numbers far too certain. Here the flight is cut into `BLOCKS`, and the
sums of residual times slope in each are what is taken to be independent (the cluster-robust
covariance of Liang & Zeger, Biometrika 73 (1986) 13).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import least_squares

from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.physics.compiled import Array

Rows = NDArray[np.bool_]

BLOCKS = 16
"""Of the fitted part: of some 1.5 s each for a kite of 2 m, thrice the time that it remembers."""
FITTED = 2 / 3
"""Of the flight, its beginning; the rest tells what share of the variance is explained."""
SLOWEST = 1.5
"""s; the longest delay with which a fit begins, in steps of a thirtieth of it. So much of a flight
is not fitted at its beginning: what the hands did before is not in it."""
EXPONENTS = (-1.0, 3.0)
"""Between which n is looked for, as `TurnRateLaw` has it."""
LONGEST = 30.0
"""m; the longest lag. No kite of some metres answers later."""
ROUNDING = 1e-6
"""s; of the times of ticks."""
NONE = 1e-6
"""m; a lag at its bound, which the search only comes near."""
EVEN = 0.02
"""Of the airspeed, one standard deviation; with less of change n cannot be told, and is 1."""


class Flown(NamedTuple):
    """Columns (n,) of a flight, a row a tick: s, rad/s, m/s, rad; right positive."""

    t: Array
    turning: Array
    airspeed: Array
    heading: Array
    elevation: Array
    delta: Array
    delta_dot: Array


class Numbers(NamedTuple):
    """c₁ [1/(m rad)], c₂ [m/s²], n, lag [m] and delay [s] at the law's airspeed."""

    c1: float
    c2: float
    exponent: float
    lag: float
    delay: float


class Fit(NamedTuple):
    """A law that was fitted: its numbers, one standard uncertainty of each, v₀ [m/s].

    The error of what was not fitted is not a number. `by_way`: whether the lag [m] is the same
    at every airspeed; else the delay [s] is. `fitted`, `explained`: shares of the turn rate's
    variance in the part that was fitted, and in the rest.
    """

    numbers: Numbers
    errors: Numbers
    airspeed: float
    by_way: bool
    fitted: float
    explained: float

    @property
    def law(self) -> TurnRateLaw:
        """The law, for an autopilot."""
        c1, c2, exponent, lag, _ = self.numbers
        return TurnRateLaw(c1, c2, exponent, self.airspeed, lag)


def fit_law(
    flown: Flown, *, by_way: bool = True, exponent: float | None = None, part: float = FITTED
) -> Fit:
    """The law that explains the first `part` of a flight best.

    flown     with a row a tick, all of it within the limits of validity
    by_way    whether a lag [m] is fitted, or a delay [s], the same at every airspeed
    exponent  n; None: fitted as well, if the airspeed changes enough to tell it
    part      of the flight, that is fitted; 1: all of it, and nothing is left to try the law on
    """
    looked = looked_at(flown)
    fitted = looked & (flown.t <= first(flown, part))
    airspeed = float(np.median(flown.airspeed[fitted]))
    if exponent is None and np.std(np.log(flown.airspeed[fitted])) < EVEN:
        exponent = 1.0
    law = _Law(flown, airspeed, by_way)
    start = law.start(fitted, 1.0 if exponent is None else exponent)
    free = np.array([True, True, exponent is None, True])

    def whole(z: Array) -> Array:
        found = start.copy()
        found[free] = z
        return found

    low, high = np.array([-np.inf, -np.inf, EXPONENTS[0], 0.0]), np.full(4, np.inf)
    high[2:] = EXPONENTS[1], LONGEST

    def left(z: Array) -> Array:
        return law.residual(whole(z))[fitted]

    def slopes(z: Array) -> Array:
        return law.slopes(whole(z))[fitted][:, free]

    room, size = (low[free], high[free]), np.array([0.1, 1.0, 1.0, 1.0])[free]
    z: Array = least_squares(left, start[free], slopes, bounds=room, x_scale=size).x
    found, errors = whole(z), np.full(4, np.nan)
    errors[free] = uncertainty(slopes(z), left(z))
    found[3] = found[3] if found[3] > NONE else 0.0
    rest = law.residual(found)
    tried = looked & ~fitted
    shares = [explained(rest[rows], flown.turning[rows]) for rows in (fitted, tried)]
    numbers, known = (Numbers(*map(float, [*x, x[3] / airspeed])) for x in (found, errors))
    return Fit(numbers, known, airspeed, by_way, *shares)


def looked_at(flown: Flown) -> Rows:
    """Rows (n,) for which it is known what the hands did before."""
    return np.asarray(flown.t >= flown.t[0] + SLOWEST - ROUNDING)


def first(flown: Flown, part: float = FITTED) -> float:
    """When [s] the first `part` of what is looked at is over."""
    start = float(flown.t[0]) + SLOWEST
    return start + part * (float(flown.t[-1]) - start) + ROUNDING


def predicted(flown: Flown, fit: Fit) -> Array:
    """The turn rate [rad/s] of a law along a flight, (n,)."""
    law = _Law(flown, fit.airspeed, fit.by_way)
    return law.residual(np.array(fit.numbers[:4])) + flown.turning


def delayed(flown: Flown, fit: Fit) -> Array:
    """δ [rad] that acts at each row of a flight, by a law's lag, (n,)."""
    return _Law(flown, fit.airspeed, fit.by_way).delta(fit.numbers.lag)


def explained(left: Array, turning: Array) -> float:
    """The share of the variance of `turning` that is not `left` over, both (n,); n = 0: nan."""
    return float(1.0 - np.var(left) / np.var(turning)) if len(left) else np.nan


def uncertainty(slopes: Array, residual: Array) -> Array:
    """One standard uncertainty of each number (k,), of slopes (n, k) and residual (n,)."""
    parts = np.array_split(np.arange(len(residual)), BLOCKS)
    sums = np.array([slopes[part].T @ residual[part] for part in parts])
    bread = np.linalg.pinv(slopes.T @ slopes, hermitian=True)
    few = BLOCKS / (BLOCKS - 1)
    covariance = few * bread @ sums.T @ sums @ bread
    return np.asarray(np.sqrt(np.diag(covariance)))


class _Law:
    """The law along a flight; z = (c₁, c₂, n, lag [m])."""

    def __init__(self, flown: Flown, airspeed: float, by_way: bool) -> None:
        self._flown, self._v0 = flown, airspeed
        self._u = CubicHermiteSpline(flown.t, flown.delta, flown.delta_dot)
        self._u_dot = self._u.derivative()
        self._speed = flown.airspeed if by_way else np.full(len(flown.t), airspeed)
        self._weight = np.sin(flown.heading) * np.cos(flown.elevation) / flown.airspeed

    def start(self, fitted: Rows, exponent: float) -> Array:
        """z that is best among some delays, by linear least squares in c₁ and c₂."""
        least, best = np.inf, np.zeros(4)
        for delay in np.linspace(0.0, SLOWEST, 31):
            z = np.array([1.0, 0.0, exponent, delay * self._v0])
            slopes = self.slopes(z)[fitted][:, :2]
            found, *_ = np.linalg.lstsq(slopes, self._flown.turning[fitted])
            left = np.sum((slopes @ found - self._flown.turning[fitted]) ** 2)
            if left < least:
                least, best = left, np.array([*found, exponent, min(z[3], 0.9 * LONGEST)])
        return best

    def residual(self, z: Array) -> Array:
        """What the law has too much of the turn rate [rad/s], (n,)."""
        slopes = self.slopes(z)
        return np.asarray(slopes[:, :2] @ z[:2] - self._flown.turning)

    def slopes(self, z: Array) -> Array:
        """Derivatives of the law's turn rate by z, (n, 4)."""
        c1, _, exponent, lag = z
        part = self._flown.airspeed / self._v0
        gain, then = self._v0 * part**exponent, self._then(lag)
        by_c1 = gain * self._u(then)
        by_lag = -c1 * gain * self._u_dot(then) / self._speed
        return np.column_stack((by_c1, self._weight, c1 * by_c1 * np.log(part), by_lag))

    def delta(self, lag: float) -> Array:
        """δ [rad] that acts now, (n,)."""
        return np.asarray(self._u(self._then(lag)))

    def _then(self, lag: float) -> Array:
        """When δ was what acts now [s], (n,); not before the flight."""
        return np.asarray(np.maximum(self._flown.t - lag / self._speed, self._flown.t[0]))
