"""Multipliers and margins over a lap, of loops where they are known."""

from math import exp, pi

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from kitemj.physics.compiled import Array
from kitemj.robustness.floquet import (
    delay_margin,
    disk_margin,
    gain_margins,
    monodromy,
    multipliers,
    phase_margin,
)
from kitemj.robustness.frozen import margins_of
from kitemj.robustness.linear import Opened

from .test_frozen import CROSSOVER, TICK, integrator

TICKS = 300
CLOSE = 0.02
"""Relative; the frozen loop's frequencies are 0.4 % apart, and angles are looked for by 5°."""


def constant(A: Array, B: Array, C: Array) -> tuple[Opened, Array]:
    """A loop closed by u = -y that is the same at each tick, beside a place that stays."""
    m = len(A) + 1
    whole, b, c = np.eye(m), np.zeros(m), np.zeros(m)
    whole[1:, 1:], b[1:], c[1:] = A, B, -C
    A_, B_, C_, none = (np.repeat(x[None], TICKS, axis=0) for x in (whole, b, c, np.zeros(m)))
    frame = np.repeat(np.eye(m)[None], TICKS + 1, axis=0)
    return Opened(A_, B_, C_, none, frame), np.eye(m)[0]


def test_constant_system() -> None:
    """Its multipliers are e^(λ T)."""
    rates = np.array([-0.5, -2.0, 0.1])
    ticks = np.repeat(np.diag(np.exp(rates * TICK))[None], TICKS, axis=0)
    found = multipliers(ticks)
    assert sorted(found.others.real) == pytest.approx(sorted(np.exp(rates * TICKS * TICK)))


def test_mathieu() -> None:
    """Ẍ + (a + b cos 2t) x = 0 against scipy's integration; the product is 1 (Liouville)."""
    a, b, n = 1.2, 0.6, 4000

    def at(t: float) -> Array:
        return np.array([[0.0, 1.0], [-(a + b * np.cos(2 * t)), 0.0]])

    h = pi / n
    found = monodromy(np.array([expm(h * at((i + 0.5) * h)) for i in range(n)]))
    columns = [
        solve_ivp(lambda t, x: at(t) @ x, (0, pi), start, rtol=1e-11, atol=1e-12).y[:, -1]
        for start in np.eye(2)
    ]
    assert found == pytest.approx(np.array(columns).T, abs=1e-5)  # midpoint: h² = 6e-7
    assert np.linalg.det(found) == pytest.approx(1.0)


def test_lap_of_a_constant_loop_has_its_classical_margins() -> None:
    """What is measured over a lap is what is measured in frequencies, where both are right."""
    A, B, C = integrator()
    loop, along = constant(A, B, C)
    known = margins_of(A, B, C)
    assert 20 * np.log10(gain_margins(loop, along)[1]) == pytest.approx(known.gain_up, rel=CLOSE)
    assert phase_margin(loop, along) == pytest.approx(known.phase, rel=CLOSE)
    assert disk_margin(loop, along) == pytest.approx(known.disk, rel=CLOSE)
    assert delay_margin(loop, along) * TICK == pytest.approx(known.delay, abs=TICK)


def test_place_is_told_apart() -> None:
    """Who is ahead on the path stays ahead: that multiplier is 1, and no fault of the loop's."""
    loop, along = constant(*integrator())
    found = multipliers(loop.closed, along)
    assert found.place == pytest.approx(1.0)
    assert found.largest < exp(-CROSSOVER * TICKS * TICK)


def test_wrong_sign_is_noticed() -> None:
    """A loop that drives errors up has a multiplier above 1, and no margin."""
    A, B, C = integrator()
    loop, along = constant(A, B, -C)
    assert multipliers(loop.closed, along).largest > 1.0
    assert delay_margin(loop, along) < 0
