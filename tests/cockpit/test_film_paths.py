"""Films of guided flights show the path and what the autopilot told at that moment."""

import numpy as np
import pytest

from kitemj.cockpit.film_sources import RecordingSource, film_source
from kitemj.flight.scenario import scenario_of
from kitemj.realtime.autopilots import autopilots
from kitemj.realtime.messages import Piloted
from kitemj.recording.file import read_recording
from tests.recording.flights import live_flight
from tests.recording.test_going_back import SPORT, paced

CIRCLE = {"kind": "circle", "radius_deg": 24.0, "elevation_deg": 45.0}
GUIDED = {**SPORT, "pilot": {"path": CIRCLE}}
HANDED = 50
"""Ticks, after which the kite is handed over."""


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    path = tmp_path_factory.mktemp("guided") / "x.arrows"
    made, offers = autopilots(live_flight(GUIDED))
    flight = live_flight(GUIDED, record=path)
    news = paced(flight, [HANDED, Piloted("scenario"), 100], autopilots=made)
    return read_recording(path), news, offers


def test_a_recording_shows_who_flew_when(recorded):
    recording, news, offers = recorded
    source = RecordingSource(recording)
    assert source.shot(0.01 * (HANDED - 1), 1.0).readings.wished is None
    shown = source.shot(0.01 * (HANDED + 60), 1.0).readings.wished
    assert np.array_equal(shown.path, offers["scenario"].path)
    told = news[HANDED + 60].guided
    assert shown.guided.phase == told.phase
    assert shown.guided[1:] == pytest.approx(told[1:], nan_ok=True)


def test_a_scenario_with_a_pilot_is_filmed_with_its_path(recorded):
    _, _, offers = recorded
    source = film_source(scenario_of({**GUIDED, "duration": 1.0}, "test"))
    for t in (0.0, 0.5, 1.0):
        shown = source.shot(t, 1.0).readings
        assert np.array_equal(shown.wished.path, offers["scenario"].path)
        assert shown.wished.guided.phase in ("climb", "path")
    assert shown.stick == "autopilot"
    without = film_source(scenario_of({**SPORT, "duration": 0.1}, "test"))
    assert without.shot(0.1, 1.0).readings.wished is None
