"""Margins that are known, through the code that measures those of the kite."""

from math import degrees, exp, log10, pi

import numpy as np
import pytest

from kitemj.physics.compiled import Array
from kitemj.robustness.frozen import margins_of

TICK = 0.01
CROSSOVER, DELAY = 2.0, 0.1
GRID = 0.01
"""Relative; a crossing lies between two of 2,000 frequencies that are 0.4 % apart."""


def integrator(gain: float = CROSSOVER, delay: float = DELAY) -> tuple[Array, Array, Array]:
    """ω_c/s with a delay [s] of whole ticks, sampled: half a tick later in all."""
    ticks = round(delay / TICK)
    A, B, C = np.zeros((ticks + 1, ticks + 1)), np.zeros(ticks + 1), np.zeros(ticks + 1)
    A[0, 0], A[0, 1], B[ticks], C[0] = 1.0, gain * TICK, 1.0, 1.0
    for j in range(1, ticks):
        A[j, j + 1] = 1.0
    return A, B, C


def test_integrator_with_delay() -> None:
    """Phase margin 90° - ω_c T, gain margin π/(2 ω_c T), delay margin by the phase."""
    found, late = margins_of(*integrator()), DELAY + TICK / 2
    assert found.phase == pytest.approx(90 - degrees(CROSSOVER * late), rel=GRID)
    assert found.gain_up == pytest.approx(20 * log10(pi / (2 * CROSSOVER * late)), rel=GRID)
    assert found.delay == pytest.approx((pi / 2 - CROSSOVER * late) / CROSSOVER, rel=GRID)
    assert found.crossover == pytest.approx(CROSSOVER, rel=GRID)
    assert found.growth < 0


def test_disk_is_within_the_classical_margins() -> None:
    """The disk changes gain and phase together, so each alone is less than what the loop has."""
    found = margins_of(*integrator())
    assert 0 < found.disk_gain <= found.gain_up
    assert 0 < found.disk_phase <= found.phase


def test_doubled_gain_costs_6_dB() -> None:
    """And the wrong sign makes it unstable."""
    A, B, C = integrator()
    once, twice = margins_of(A, B, C), margins_of(A, 2 * B, C)
    assert once.gain_up - twice.gain_up == pytest.approx(20 * log10(2), rel=GRID)
    assert margins_of(A, B, -C).growth > 0


def test_growth_of_an_unstable_loop() -> None:
    """x' = e^(λ tick) x grows with λ [1/s], whatever is fed back nowhere."""
    rate = 0.7
    A = np.array([[exp(rate * TICK)]])
    assert margins_of(A, np.array([1.0]), np.array([0.0])).growth == pytest.approx(rate)
