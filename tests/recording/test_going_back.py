"""A recording of somebody who went back in time is flown again to the same bits."""

import numpy as np
import pytest

from kitemj.drawing.history import History
from kitemj.errors import InputError
from kitemj.flight.live import TICK, LiveFlight
from kitemj.flight.scenario import scenario_of
from kitemj.realtime.pacer import Pacer
from kitemj.realtime.rewind import BACK, EVERY
from kitemj.recording.file import read_recording
from kitemj.recording.replay import replay
from kitemj.recording.resume import resume_point
from tests.recording.flights import live_flight, recorder_of, restless

SPORT = {"set": "sport", "duration": 60.0}


def flown(path, doings, tables=SPORT):
    """Ticks by hand, not by the clock; `doings` are numbers of ticks to fly, and deeds."""
    flight, stick = live_flight(tables), restless(3)
    recorder = recorder_of(flight, path)
    pacer = Pacer(flight, History(flight.parameters), recorder)
    for doing in doings:
        if isinstance(doing, str):
            pacer.ask(doing)
            pacer._obey()
        else:
            for _ in range(doing):
                pacer.command = next(stick)
                pacer._tick(0.0)
    recorder.close("done")
    return read_recording(path), pacer


def episodes_of(recording):
    """(number, parent, first tick, last tick) of each episode."""
    episode, parent, tick = (recording.columns[name].tolist() for name in ("leg", "parent", "tick"))
    ends = [(each.start, each.stop - 1) for each in recording.episodes]
    return [(episode[first], parent[first], tick[first], tick[last]) for first, last in ends]


def test_back_marked_and_again_to_the_same_bits(tmp_path):
    doings = [730, "rewind", 50, "save", 120, "rewind", "rewind", 40, "load", 60, "restart", 30]
    recording, _ = flown(tmp_path / "x.arrows", doings)
    assert episodes_of(recording) == [
        (0, 0, 0, 730),
        (1, 0, 200, 370),  # at least BACK, at a second that was kept
        (2, 0, 0, 0),  # 370 - 500 is before the start: the first that is kept
        (3, 0, 0, 40),
        (4, 1, 250, 310),
        (5, 5, 0, 30),
    ]
    assert replay(recording, "mujoco").identical
    other = replay(recording, "lagrange")
    gap, _ = other.largest_gap(other.comparable)
    assert gap < 1e-5  # m; a restless stick: 3 µm in steps of 2 ms, a sixteenth in steps of 1 ms


def test_going_back_shows_in_the_recording_as_the_moment_itself(tmp_path):
    recording, _ = flown(tmp_path / "x.arrows", [730, "rewind", 10])
    first, then = recording.episodes
    before, again = first.start + 200, then.start
    for name in ("x_E_m", "y_E_m", "z_E_m", "delta_rad", "tension_plus_N", "t_s"):
        assert recording.columns[name][before] == recording.columns[name][again]


def test_nothing_marked_is_nothing_loaded(tmp_path):
    recording, pacer = flown(tmp_path / "x.arrows", [10, "load", 10])
    assert episodes_of(recording) == [(0, 0, 0, 20)]
    assert pacer.result.motion.t == pytest.approx(20 * TICK)


def test_back_from_a_marked_moment_is_back_in_its_own_flight(tmp_path):
    """Not in the one that was flown since: from 9 s of the first to 4 s of it."""
    doings = [800, "save", "restart", 450, "load", 100, "rewind", 20]
    recording, _ = flown(tmp_path / "x.arrows", doings)
    assert episodes_of(recording)[2:] == [(2, 0, 800, 900), (3, 0, 400, 420)]
    assert replay(recording, "mujoco").identical


def test_limits_left_before_a_branch_count_for_the_branch(tmp_path):
    """The thesis kite let go with its nose high is beyond stall at first, and comes back."""
    tables = {"set": "thesis", "duration": 60.0, "start": {"theta_deg": 25.0}}
    recording, _ = flown(tmp_path / "x.arrows", [700, "rewind", 20], tables)
    within = recording.before(("stall",))
    assert not within[recording.episodes[1]].any()


def test_the_kept_past_does_not_grow(tmp_path):
    flight = live_flight(SPORT)
    pacer = Pacer(flight, History(flight.parameters))
    pacer._rewind._past = type(pacer._rewind._past)(maxlen=4)
    for _ in range(1000):
        pacer._tick(0.0)
    assert len(pacer._rewind._past) == 4
    pacer.ask("rewind")
    pacer._obey()
    assert flight.ticks == 1000 - 3 * round(EVERY / TICK)  # all that is left of BACK
    assert BACK > 3 * EVERY


def test_trail_ends_where_the_flight_went_back_to(tmp_path):
    _, pacer = flown(tmp_path / "x.arrows", [730])
    long = pacer.history.traces(0.0).trail
    pacer.ask("rewind")
    pacer._obey()
    short = pacer.history.traces(0.0).trail
    assert len(short) == pytest.approx(len(long) * 200 / 730, abs=2)
    assert np.array_equal(short[:60], long[:60])


@pytest.mark.parametrize("at", [3.2, None])
def test_a_recording_is_flown_on_from_its_last_flight(tmp_path, at):
    doings = [430, "restart", 420, "save", 50, "load", 200]
    recording, _ = flown(tmp_path / "x.arrows", doings)
    past = resume_point(recording, at)
    flight, ticks = past.flight(), past.ticks
    recorder = recorder_of(flight, tmp_path / "y.arrows")
    pacer = Pacer(flight, History(flight.parameters), recorder, ticks)
    assert flight.ticks == (320 if at else 620)
    pacer._tick(0.0)
    recorder.close("done")
    longer = read_recording(tmp_path / "y.arrows")
    assert episodes_of(longer) == [(0, 0, 0, flight.ticks)]
    way = recording.way_to(recording.episodes[-1])[: flight.ticks]
    for name in ("x_E_m", "theta_rad", "delta_rad", "tension_plus_N", "stick_delta"):
        assert np.array_equal(longer.columns[name][: flight.ticks], recording.columns[name][way])
    assert replay(longer, "mujoco").identical


def test_a_moment_that_was_not_flown_is_a_sentence(tmp_path):
    recording, _ = flown(tmp_path / "x.arrows", [100])
    with pytest.raises(InputError, match=r"^at must be in 0 to 1 s.*got 2 s"):
        resume_point(recording, 2.0)


def test_a_flight_that_begins_at_another_start_is_flown_again_from_there(tmp_path):
    scenario = scenario_of(SPORT, "test")
    other = scenario.start._replace(q=scenario.start.q._replace(eta=0.3))
    flight = LiveFlight(scenario, other_starts=(other,))
    recorder = recorder_of(flight, tmp_path / "x.arrows")
    pacer = Pacer(flight, History(flight.parameters), recorder, start_at=1)
    aside = pacer.result.motion
    for start in (0, 1):
        for _ in range(120):
            pacer._tick(0.0)
        pacer.start_at = start
        pacer.ask("restart")
        pacer._obey()
    assert pacer.result.motion == aside
    recorder.close("done")
    recording = read_recording(tmp_path / "x.arrows")
    assert recording.columns["start"][
        [episode.start for episode in recording.episodes]
    ].tolist() == [1, 0, 1]
    assert replay(recording, "mujoco").identical
    assert resume_point(recording).scenario.start == other
