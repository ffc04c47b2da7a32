"""A live flight that records itself, with a reference or without."""

import numpy as np
import pytest

from kitemj.errors import InputError
from kitemj.flight.live import Command
from kitemj.recording.file import read_recording
from kitemj.recording.replay import replay
from kitemj.recording.resume import resume_point
from kitemj.recording.summary import summary
from kitemj.recording.table import REFERENCE
from tests.recording.flights import live_flight, restless

SPORT = {"set": "sport", "duration": 60.0}
NEAR = 1e-5
"""m; what steps of 2 ms and a moving stick leave between MuJoCo and Lagrange in 3 s."""


def flown(path, **options):
    """Somebody goes back once, and begins anew once."""
    stick = restless(3, ell=0.3, hold=40)
    with live_flight(SPORT, record=path, **options) as flight:
        for _ in range(100):
            flight.tick(next(stick))
        saved = flight.save()
        for _ in range(50):
            flight.tick(next(stick))
        flight.resume(saved)
        for _ in range(60):
            flight.tick(next(stick))
        flight.restart()
        said = flight.close("landed by hand")
    return read_recording(path), said


@pytest.mark.parametrize("reference", ["lagrange", None])
def test_replays_to_the_same_bits_and_in_another_formulation(tmp_path, reference):
    recording, said = flown(tmp_path / "mine.arrows", reference=reference)
    assert said.endswith("mine.arrows, 213 ticks")
    assert recording.ending == "landed by hand"
    assert recording.columns["leg"].tolist() == [0] * 151 + [1] * 61 + [2]
    assert recording.columns["parent"].tolist() == [0] * 212 + [2]
    assert recording.columns["tick"][151] == 100
    assert replay(recording, "mujoco").identical
    again = replay(recording, "lagrange")
    gap, _ = again.largest_gap(again.comparable)
    assert gap < NEAR


def test_a_reference_changes_nothing_but_its_own_columns(tmp_path):
    beside, _ = flown(tmp_path / "beside.arrows", reference="lagrange")
    alone, _ = flown(tmp_path / "alone.arrows", reference=None)
    for name in set(alone.columns) - {*REFERENCE, "gap_m"}:
        assert np.array_equal(beside.columns[name], alone.columns[name], equal_nan=True)
    for name in (*REFERENCE, "gap_m"):
        assert np.isnan(alone.columns[name]).all()
        assert not np.isnan(beside.columns[name]).any()


def test_without_a_reference_it_says_so_and_is_flown_on_without(tmp_path):
    alone, _ = flown(tmp_path / "alone.arrows", reference=None)
    assert alone.header.reference == ""
    assert "mujoco alone, steps of 2 ms" in summary(alone)
    setup = resume_point(alone)
    assert setup.reference is None
    assert setup.flight().result.reference is None


def test_what_ended_the_flight_is_its_ending(tmp_path):
    path = tmp_path / "mine.arrows"

    def slip():
        with live_flight(SPORT, record=path) as flight:
            flight.tick(Command())
            raise ValueError("the pilot slipped")

    with pytest.raises(ValueError, match="slipped"):
        slip()
    assert read_recording(path).ending == "the pilot slipped"
    with pytest.raises(InputError, match="exists"):
        live_flight(SPORT, record=path)
    live_flight(SPORT, record=path, overwrite=True).close()
    assert len(read_recording(path)) == 1


def test_without_a_file_it_is_a_live_flight():
    with live_flight(SPORT) as flight:
        flight.tick(Command(0.5))
        assert flight.close() == "none"
