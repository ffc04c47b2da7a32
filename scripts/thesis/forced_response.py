"""The periodic flight under δ = δ₀ sin ωt, and its stability by Floquet multipliers.

Once in each period T = 2π/ω of the hands the state x is looked at; a flight that repeats is a
fixed point of the map from one look to the next, x = Φ_T(x). It attracts where all eigenvalues
μ of dΦ_T/dx (Floquet multipliers) are smaller than 1; a disturbance then dies out as
exp(t ln|μ|/T). With δ₀ = 0 this is the equilibrium, and ln|μ|/T the real part of its modes.
"""

from math import log, nan, pi
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from kitemj.dynamics.lagrange_kite import flown
from kitemj.equilibria.linearise import state_units
from kitemj.equilibria.minimal import Array, Minimal, held, state_of
from kitemj.equilibria.shooting import monodromy
from kitemj.equilibria.trim import trimmed
from kitemj.equilibria.vary import with_value
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Sines, rest_ell

STEP = 0.04
"""s; Runge-Kutta steps. Half of it moves the thresholds by less than 1e-5."""
CLOSED = 1e-9
"""Largest |Φ_T(x) - x| that counts as closed, in rad and scaled rates."""
SETTLING = 150.0
"""s; flown before the fixed point is looked for, several times what the slowest mode needs."""
FIRST, LAST, STRIDE = -0.20, -0.60, -0.02
"""1/rad; the values of C_lβ between which a threshold is looked for."""


class SineSteering(NamedTuple):
    """δ₀ [rad] and ω [rad/s]."""

    delta: float
    omega: float

    @property
    def period(self) -> float:
        """T [s]."""
        return 2 * pi / self.omega

    def programme(self, parameters: Parameters) -> Sines:
        """ℓ = ℓ₀, δ = δ₀ sin ωt."""
        ell = rest_ell(parameters.lines.length, parameters.kite.y_A)
        return Sines(ell, 0.0, self.delta, self.omega)


class PeriodicFlight(NamedTuple):
    """The state `x` (8,) at t = 0, T, 2T ..., dΦ_T/dx, and the growth rate [1/s] beside it."""

    x: Array
    monodromy: Array
    growth: float


class ForcedLagrange(Minimal):
    """Lagrange's equations under a swing; the control that is handed over says nothing."""

    def __init__(self, parameters: Parameters, steering: SineSteering) -> None:
        super().__init__("lagrange", parameters)
        self.programme = steering.programme(parameters)

    def flow(self, x: Array, control: Control, duration: float, steps: int = 0) -> Array:
        """`x` after `duration` [s] from t = 0 on, in `steps`."""
        end = flown(self.parameters, self.programme, 0.0, state_of(x), steps, duration / steps)
        return np.array([*end.q, *end.q_dot])


def settled_state(parameters: Parameters, steering: SineSteering) -> Array:
    """x (8,) at a whole number of periods after a start from the equilibrium."""
    kite, x = ForcedLagrange(parameters, steering), trimmed(parameters)[0]
    steps = _steps(steering)
    for _ in range(max(2, round(SETTLING / steering.period))):
        x = kite.flow(x, held(1.0), steering.period, steps)
    return x


def periodic_flight(
    parameters: Parameters, steering: SineSteering, x: Array, slope: Array | None = None
) -> PeriodicFlight | None:
    """The fixed point next to `x` (8,); None where Newton's method does not close it.

    `slope`: dΦ_T/dx of a flight near by, used as long as it serves.
    """
    kite, T, steps = ForcedLagrange(parameters, steering), steering.period, _steps(steering)
    still = held(1.0)
    units = state_units(parameters, kite.programme.ell)
    before = np.inf
    for _ in range(30):
        gap = (kite.flow(x, still, T, steps) - x) / units
        size = float(np.abs(gap).max())
        if size < CLOSED:
            break
        if not np.isfinite(size) or size > 1e3:
            return None
        if slope is None or size > 0.3 * before:
            slope = monodromy(kite, x, T, still, steps, units)
        before = size
        x = x + units * np.linalg.solve(np.eye(8) - slope, gap)
    else:
        return None
    slope = monodromy(kite, x, T, still, steps, units)
    return PeriodicFlight(x, slope, log(float(np.abs(np.linalg.eigvals(slope)).max())) / T)


class StabilityThreshold(NamedTuple):
    """`value` of C_lβ [1/rad] beyond which the repeating flight repels, nan where none was met.

    `stable_to`: the last C_lβ at which it attracts for certain.
    """

    value: float
    stable_to: float


def stability_threshold(parameters: Parameters, steering: SineSteering) -> StabilityThreshold:
    """The repeating flight is followed from `FIRST` in strides of `STRIDE`, as far as `LAST`."""

    def at(value: float, near: PeriodicFlight) -> PeriodicFlight | None:
        there = with_value(parameters, "aero.Cl_beta", value)
        return periodic_flight(there, steering, near.x, near.monodromy)

    there = with_value(parameters, "aero.Cl_beta", FIRST)
    found, value = periodic_flight(there, steering, settled_state(there, steering)), FIRST
    if found is None or found.growth > 0:
        return StabilityThreshold(nan, nan)
    while value + STRIDE > LAST + STRIDE / 2:
        ahead = at(value + STRIDE, found)
        if ahead is None:
            break
        if ahead.growth > 0:

            def growth(value: float, near: PeriodicFlight = found) -> float:
                here = at(value, near)
                return here.growth if here else nan

            exact = float(brentq(growth, value + STRIDE, value, xtol=1e-6))
            return StabilityThreshold(exact, value)
        found, value = ahead, value + STRIDE
    return StabilityThreshold(nan, value)


def _steps(steering: SineSteering) -> int:
    return round(steering.period / STEP)
