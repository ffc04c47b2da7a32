"""The loop of a kite on its path: what the multipliers say is what is flown."""

import numpy as np
import pytest

from kitemj.flight.live import TICK
from kitemj.flight.pilot_settings import PilotSettings
from kitemj.flight.scenario import as_scenario
from kitemj.physics.compiled import Array
from kitemj.robustness.floquet import changed, gain_margins, multipliers
from kitemj.robustness.linear import Opened, opened
from kitemj.robustness.loop import Lap, Loop, flown_loop, steady_lap
from kitemj.robustness.verify import growth_flown

Known = tuple[Loop, Lap, Opened, Array]


@pytest.fixture(scope="module")
def known() -> Known:
    """`sport` on 25 m lines, its usual eight."""
    tables = {"set": "sport", "duration": 60.0, "wind": {"speed": 6.5}, "lines": {"length": 25.0}}
    loop, x = flown_loop(as_scenario(tables), PilotSettings())
    lap = steady_lap(loop, x, 1)
    return loop, lap, opened(loop, lap), np.asarray((lap.x[1] - lap.x[0]) / TICK)


def test_deviations_die_out_unless_the_sign_is_wrong(known: Known) -> None:
    """The planted fault, errors answered the other way, is noticed."""
    _, _, linear, along = known
    assert multipliers(linear.closed, along).largest < 1.0
    assert multipliers(changed(linear, -1.0), along).largest > 1.0


def test_gain_margin_is_flown(known: Known) -> None:
    """A tenth below it a small deviation dies out, a tenth above it grows."""
    loop, lap, linear, along = known
    most = gain_margins(linear, along)[1]
    assert growth_flown(loop, lap, 0.9 * most) < 1.0
    assert growth_flown(loop, lap, 1.1 * most) > 1.0
