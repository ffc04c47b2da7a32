"""The law of turning fitted to a flight by least squares, with what its numbers are uncertain by.

The residual of such a fit is what the law leaves out, not noise: it swings slowly, and the usual
covariance would call the numbers four to nine times too certain. Here the flight is cut into
`BLOCKS`, and how much the numbers change where one of them is left out says how far they are known
(the jackknife of blocks: Künsch, Ann. Statist. 17 (1989) 1217).
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
EXPONENTS = (0.0, 3.0)
"""Between which n is looked for. Below 0 a kite would turn the quicker the slower it is, which may
fit the few speeds of a flight by a hair better and is far off at others."""
LONGEST = 30.0
"""m; the longest lag. No kite of some metres answers later."""
ROUNDING = 1e-6
"""s; of the times of ticks."""
NEAR = 1e-6
"""m, 1; a lag and an n so near its bound are at it."""
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
    found, errors = _solved(law, start, free, fitted), np.full(4, np.nan)
    free[2] &= found[2] not in EXPONENTS  # else it is as far as it may go
    errors[free] = uncertainty(law.slopes(found)[fitted][:, free], law.residual(found)[fitted])
    left, tried = law.residual(found), looked & ~fitted
    shares = [explained(left[rows], flown.turning[rows]) for rows in (fitted, tried)]
    numbers, known = (Numbers(*map(float, [*x, x[3] / airspeed])) for x in (found, errors))
    return Fit(numbers, known, airspeed, by_way, *shares)


def _solved(law: "_Law", start: Array, free: Rows, fitted: Rows) -> Array:
    """z whose `free` (4,) numbers leave least of the `fitted` (n,) rows, from a `start`."""

    def whole(z: Array) -> Array:
        found = start.copy()
        found[free] = z
        return found

    def left(z: Array) -> Array:
        return law.residual(whole(z))[fitted]

    def slopes(z: Array) -> Array:
        return law.slopes(whole(z))[fitted][:, free]

    low, high = np.array([-np.inf, -np.inf, EXPONENTS[0], 0.0]), np.full(4, np.inf)
    high[2:] = EXPONENTS[1], LONGEST
    room, size = (low[free], high[free]), np.array([0.1, 1.0, 1.0, 1.0])[free]
    z: Array = least_squares(left, start[free], slopes, bounds=room, x_scale=size).x
    found = whole(z)
    for k in (2, 3):  # the search only comes near a bound
        for bound in (low[k], high[k]):
            found[k] = bound if abs(found[k] - bound) < NEAR else found[k]
    return found


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
    """One standard uncertainty of each number (k,), of slopes (n, k) and residual (n,).

    The jackknife, to first order: how the numbers change where a block is left out.
    """
    whole, changes = slopes.T @ slopes, []
    for rows in np.array_split(np.arange(len(residual)), BLOCKS):
        block = slopes[rows]
        less = np.linalg.pinv(whole - block.T @ block, hermitian=True)
        changes.append(less @ block.T @ residual[rows])
    off = np.array(changes) - np.mean(changes, axis=0)
    return np.asarray(np.sqrt((BLOCKS - 1) / BLOCKS * np.sum(off**2, axis=0)))


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
