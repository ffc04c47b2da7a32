"""The margins that are known before the flight."""

from math import pi

import numpy as np
import pytest

from kitemj.autopilot.design_margins import (
    LEAST_GAIN,
    check_gain,
    design_margins,
    largest_crossover,
)
from kitemj.errors import InputError
from kitemj.flight.pilot_settings import PilotSettings, TurnRateLaw
from kitemj.robustness.frozen import margins_of
from kitemj.turning.gains import Gains

LAW = TurnRateLaw(0.34, -1.6, 0.4, 15.0, 2.5)
SAMPLED = 0.02
"""Relative; ticks of 5 % of the delay, whose errors go with the square, and the grid."""
FAR = 1e9
"""An outlook so far that the place does not count: what is left is an integrator with delay."""


def test_integrator_with_delay() -> None:
    """Gain margin π/(2 ω_c T) and phase margin 90° - ω_c T, where the place does not count."""
    found = design_margins(Gains(crossover=0.5, outlook=FAR))
    assert found.gain == pytest.approx(20 * np.log10(pi / 2 / 0.5))
    assert found.phase == pytest.approx(90 - np.degrees(0.5))


def test_place_and_course_together() -> None:
    """Against python-control, sampled: the delay T is 20 ticks and the half one of the hold."""
    gains, ticks, x = Gains(crossover=0.4, outlook=2.0), 20, 0.4
    h = 1 / (ticks + 0.5)
    A, B, C = np.zeros((ticks + 2, ticks + 2)), np.zeros(ticks + 2), np.zeros(ticks + 2)
    A[0, 0], A[0, 2], A[1, 1], A[1, 0], A[1, 2] = 1.0, h, 1.0, h, h * h / 2
    for j in range(2, ticks + 1):
        A[j, j + 1] = 1.0
    B[ticks + 1], C[0], C[1] = 1.0, x, x * x / gains.outlook
    known, found = margins_of(A, B, C, h), design_margins(gains)
    assert found.gain == pytest.approx(known.gain_up, rel=SAMPLED)
    assert found.phase == pytest.approx(known.phase, rel=SAMPLED)


def test_quick_loop_is_refused() -> None:
    """With a sentence that says what is allowed; and what it says is allowed is."""
    gains = Gains()
    most = largest_crossover(gains)
    assert design_margins(gains._replace(crossover=most)).gain == pytest.approx(LEAST_GAIN)
    with pytest.raises(InputError, match=r"pilot.crossover must be <= .*, got 1.9.*is unstable"):
        check_gain(PilotSettings(crossover=1.9), gains, LAW)
    assert check_gain(PilotSettings(crossover=most - 0.01), gains, LAW).gain > LEAST_GAIN
