"""The figure of guidance draws what was told, and what was flown."""

import numpy as np
import pytest

from kitemj.errors import InputError
from kitemj.flight.guided_table import NOBODY, PHASE
from kitemj.flight.pilot_settings import PHASES
from kitemj.plots.guidance import guidance_figure
from tests.plots.flights import by_hand

CLIMB, PATH, HOLD = (PHASES.index(name) for name in ("climb", "path", "hold"))
AZIMUTH, ELEVATION = 30.0, 40.0
"""deg; where the kite is that `laksa` is given, in a wind along -x."""


def guided(**changes):
    """Six rows: by hand, climb, twice along a path, twice held."""
    a, e = np.radians([AZIMUTH, ELEVATION])
    ahead, right, down = -np.cos(e) * np.cos(a), -np.cos(e) * np.sin(a), -np.sin(e)
    nan, rows = np.nan, 6
    given = {
        "x_E_m": rows * [100 * ahead],
        "y_E_m": rows * [100 * right],
        "z_E_m": rows * [100 * down],
        PHASE: [NOBODY, CLIMB, PATH, PATH, HOLD, HOLD],
        "path_error_deg": [nan, 5.0, -3.0, 1.0, nan, nan],
        "attractor_azimuth_deg": [nan, 1.0, 20.0, 21.0, 3.0, 4.0],
        "attractor_elevation_deg": [nan, 1.0, 30.0, 31.0, 60.0, 61.0],
    }
    return by_hand(rows, **given | changes)


def test_the_path_is_where_the_attractor_was_while_it_was_flown():
    sky, below = guidance_figure(guided()).axes
    wished, otherwise, along = (np.array(line.get_xydata()) for line in sky.get_lines())
    nowhere = [[np.nan, np.nan]]
    assert np.array_equal(
        wished, [*nowhere, *nowhere, [20.0, 30.0], [21.0, 31.0], *nowhere, *nowhere], equal_nan=True
    )
    there = np.isfinite(along[:, 0])
    assert there.tolist() == [False, False, True, True, False, False]
    assert np.allclose(along[there], (AZIMUTH, ELEVATION))
    assert np.array_equal(np.isfinite(otherwise[:, 0]), ~there)
    assert sky.get_aspect() == 1.0
    error = below.get_lines()[0].get_ydata()
    assert np.array_equal(error, [np.nan, np.nan, -3.0, 1.0, np.nan, np.nan], equal_nan=True)
    assert "2.24° rms, 3.00° at most" in below.get_title(loc="left")


def test_phases_are_bands_with_their_names():
    _, below = guidance_figure(guided()).axes
    named = {text.get_text(): text.xy[0] for text in below.texts}
    assert named == {"by hand": 0.0, "climb": 1.0, "path": 2.0, "hold": 4.0}


@pytest.mark.parametrize("changes", [{}, {PHASE: [NOBODY] * 6}])
def test_a_flight_by_hand_has_no_such_figure(changes):
    flight = guided(**changes) if changes else by_hand()
    with pytest.raises(InputError, match="no autopilot flew"):
        guidance_figure(flight)
