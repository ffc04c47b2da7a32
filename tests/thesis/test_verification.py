"""Verification: the same is flown each time, and flown again; interpolation errs as it must."""

from math import pi

import numpy as np
import pytest

from kitemj.physics.steering import Control, Segment, control
from thesis import verification
from thesis.answers import dangling
from thesis.verification import section
from thesis.verification_flights import (
    POSITION,
    LinearInterpolation,
    all_replays,
    delta_series,
    distances,
    interpolation_errors,
    record_flight,
    segments_of,
)

SHORT = 1.0
NEAR = 1e-8
"""m; a hundred times what MuJoCo at 2 ms differs from the others in a second of calm steering."""


@pytest.fixture(scope="module")
def recording(tmp_path_factory):
    return record_flight(tmp_path_factory.mktemp("flight") / "flight.arrows", SHORT)


def test_the_same_is_flown_each_time(recording, tmp_path):
    again = record_flight(tmp_path / "again.arrows", SHORT)
    assert len(again) == len(recording) == round(SHORT / recording.header.tick) + 1
    for name, column in recording.columns.items():
        if name != "lateness_s":
            np.testing.assert_array_equal(again.columns[name], column, err_msg=name)
    assert abs(recording.columns["delta_rad"]).max() > 1e-3


def test_segments_go_on_from_one_another_and_are_where_the_kite_is(recording):
    segments, tick = segments_of(recording), recording.header.tick
    assert len(segments) == len(recording) - 1
    steered = [segment.control.delta for segment in segments]
    ends = [control(s, (k + 1) * tick).delta for k, s in enumerate(segments)]
    np.testing.assert_allclose(ends[:-1], steered[1:], atol=1e-15)
    # the attachments are where lines of these lengths end: MuJoCo holds them to 1 nm of 80 m
    np.testing.assert_allclose(
        delta_series(recording.parameters, recording.columns)[1:], ends, atol=1e-9
    )


def test_straight_lines_meet_the_samples_and_miss_a_parabola_by_an_eighth():
    tick, ddot = 0.01, 0.05
    first = Segment(0.0, Control(80.0, 0.0, 0.0, 0.01, 0.002, ddot))
    second = Segment(tick, control(first, tick)._replace(delta_ddot=-ddot))
    straight = LinearInterpolation([first, second], tick)
    assert straight(0.0) == pytest.approx(first.control)
    assert straight(tick) == pytest.approx(second.control)
    miss = straight(tick / 2).delta - control(first, tick / 2).delta
    assert miss == pytest.approx(ddot * tick**2 / 8)
    assert straight(tick / 2).delta_ddot == pytest.approx(0.0)


def test_all_ways_end_up_near_the_recording_and_the_thesiss_way_farthest(recording):
    again = {a.name: a for a in all_replays(recording)}
    gaps = {name: float(distances(recording, a, POSITION).max()) for name, a in again.items()}
    assert again["mujoco, exact"].note == "the same to the last bit"
    assert gaps["mujoco, exact"] == 0.0
    assert 0.0 < gaps["lagrange, exact"] < NEAR
    assert 0.0 < gaps["newton-euler, exact"] < NEAR
    assert NEAR < gaps["ode45 tight, interp1"] < 0.1
    assert NEAR < gaps["ode45, interp1"] < 0.1


def test_interpolation_errors_are_those_of_the_steering(recording):
    errors, tick = interpolation_errors(recording), recording.header.tick
    largest = max(abs(s.control.delta_ddot) for s in segments_of(recording))
    assert 0.5 < errors["delta"].max() / (largest * tick**2 / 8) <= 1.0 + 1e-6
    assert errors["ell"].max() < 1e-12


def test_the_section_says_what_the_files_hold(tmp_path, monkeypatch):
    monkeypatch.setattr(verification, "SECONDS", SHORT)
    found = section(tmp_path)
    assert found.answers == verification.ANSWERS
    assert not dangling(found)
    assert {a.item for a in found.answers} == {f"Figure {n}" for n in (23, 24, 26, 27, 28)}
    table = found.tables[0].table
    assert len(table.rows) == 6
    assert all(0 <= cell < pi for row in table.rows for cell in row[1:-1])
    worst = max(row[1] for row in table.rows if "interp1" in row[0] and "tight" not in row[0])
    assert f"{worst:.2g} m" in " ".join(found.here)
