"""A few seconds of the hostile flight of `scripts/hostile_flight.py`."""

import pytest

from hostile_flight import WINDS, hostile
from kitemj.dynamics.formulation import DEFAULT_STEP

OFF = 1e-4
"""m; of a taut line, aloft or on the ground, in winds a set is made for: 20 µm were measured."""


@pytest.mark.parametrize("name", WINDS)
def test_nothing_is_thrown_and_lines_keep_their_length(name):
    met = hostile(name, strong=False, seed=4, step=DEFAULT_STEP, seconds=4.0)
    assert met["ticks"] + met["restarts"] == 400
    assert met["thrown"] == met["diverged"] == 0
    assert max(met["off"], met["off, ground"]) < OFF


def test_a_divergence_has_a_known_cause():
    """Sport in twice its wind, in steps five times the default: they follow no more than 278/s."""
    met = hostile("sport", strong=True, seed=15, step=5 * DEFAULT_STEP, seconds=2.0)
    assert met["diverged"] > 0
    assert met["unexplained"] == met["thrown"] == 0
