"""A recording of somebody who went back in time is flown again to the same bits."""

import numpy as np
import pytest

from kitemj.drawing.history import History
from kitemj.errors import InputError
from kitemj.flight.live import TICK
from kitemj.flight.scenario import scenario_of
from kitemj.realtime import rewind
from kitemj.realtime.autopilots import autopilots
from kitemj.realtime.messages import Deed, Piloted, Rate, Stop
from kitemj.realtime.pacer import Pacer
from kitemj.realtime.rewind import BACK, EVERY
from kitemj.recording.file import read_recording
from kitemj.recording.replay import replay
from kitemj.recording.resume import resume_point
from tests.recording.flights import live_flight, restless

SPORT = {"set": "sport", "duration": 60.0}


def paced(flight, doings, past=(), autopilots=None):
    """The news of ticks one by one, not by the clock; `doings`: numbers of ticks, and wishes."""
    stick = (command._replace(delta=0.3 * command.delta) for command in restless(3))
    news = []

    def wishes():
        yield Rate(0.0)
        for doing in doings:
            if isinstance(doing, int):
                for _ in range(doing):
                    yield from (next(stick), Deed.STEP)
            else:
                yield Deed(doing) if isinstance(doing, str) else doing
        yield Stop("done")

    flight.close(Pacer(flight, wishes, news.append, autopilots).run(past))
    return news


def flown(path, doings, tables=SPORT):
    """The recording of that, and its news."""
    news = paced(live_flight(tables, record=path), doings)
    return read_recording(path), news


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
    recording, news = flown(tmp_path / "x.arrows", [10, "load", 10])
    assert episodes_of(recording) == [(0, 0, 0, 20)]
    assert news[-1].result.motion.t == pytest.approx(20 * TICK)


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


def test_the_kept_past_does_not_grow(monkeypatch):
    monkeypatch.setattr(rewind, "MINUTES", 4 * EVERY / 60)
    flight = live_flight(SPORT)
    paced(flight, [1000, "rewind"])
    assert flight.ticks == 1000 - 3 * round(EVERY / TICK)  # all that is left of BACK
    assert BACK > 3 * EVERY


def test_trail_ends_where_the_flight_went_back_to():
    flight = live_flight(SPORT)
    history, trails = History(flight.parameters), []
    for news in paced(flight, [730, "rewind"]):
        history.add(news.done, news.result.motion, news.lateness)
        trails.append(history.traces(0.0).trail)
    long, short = trails[-2:]
    assert len(short) == pytest.approx(len(long) * 200 / 730, abs=2)
    assert np.array_equal(short[:60], long[:60])


@pytest.mark.parametrize("at", [3.2, None])
def test_a_recording_is_flown_on_from_its_last_flight(tmp_path, at):
    doings = [430, "restart", 420, "save", 50, "load", 200]
    recording, _ = flown(tmp_path / "x.arrows", doings)
    setup = resume_point(recording, at)._replace(record=tmp_path / "y.arrows")
    flight = setup.flight()
    paced(flight, [1], setup.past)
    assert flight.ticks == (321 if at else 621)
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
    flight = live_flight(SPORT, other_starts=(other,), start=1, record=tmp_path / "x.arrows")
    news = paced(flight, [120, "restart", 120])
    assert news[121].result.motion == news[0].result.motion
    recording = read_recording(tmp_path / "x.arrows")
    assert recording.columns["start"][
        [episode.start for episode in recording.episodes]
    ].tolist() == [1, 1]
    assert replay(recording, "mujoco").identical
    assert resume_point(recording).scenario.start == other


def test_an_autopilot_that_went_back_flies_the_same_again(tmp_path):
    """Open loop and closed loop, to the same bits: it goes on from what it knew then."""
    flight = live_flight({**SPORT, "pilot": {}}, record=tmp_path / "x.arrows")
    made, _ = autopilots(live_flight({**SPORT, "pilot": {}}))
    doings = [400, Piloted("scenario"), 700, "rewind", 150, "save", 120, "load", 60, "restart", 40]
    paced(flight, doings, autopilots=made)
    recording = read_recording(tmp_path / "x.arrows")
    assert len(recording.episodes) == 4
    assert replay(recording, "mujoco").identical
    assert replay(recording, "mujoco", closed_loop=True).identical


HELD = {"set": "laksa", "duration": 60.0, "start": {"phi_deg": 5.0}}
NOISY = {"noise_deg": 1.0}


@pytest.mark.parametrize(
    ("tables", "doings"),
    [
        (
            {**SPORT, "pilot": {}},
            [50, Piloted("scenario"), 150, Piloted(""), Piloted("scenario"), 80],
        ),
        ({**SPORT, "pilot": {}}, [50, Piloted("scenario"), 150, Piloted("circle"), 80]),
        (
            {**HELD, "pilot": {"phases": ["hold"], "sensors": NOISY}},
            [100, Piloted("scenario"), 700, "rewind", 100],
        ),
    ],
    ids=[
        "handed over anew between two ticks",
        "another autopilot goes on",
        "a held kite went back",
    ],
)
def test_the_loop_is_closed_as_it_was(tmp_path, tables, doings):
    """The scenario's autopilot begins anew where it did, and flies only what it flew."""
    made, _ = autopilots(live_flight(tables))
    paced(live_flight(tables, record=tmp_path / "x.arrows"), doings, autopilots=made)
    recording = read_recording(tmp_path / "x.arrows")
    assert np.isfinite(recording.columns["pilot_since_s"]).any()
    assert replay(recording, "mujoco", closed_loop=True).identical


def test_no_loop_is_closed_around_another_autopilot(tmp_path):
    tables = {**SPORT, "pilot": {}}
    made, _ = autopilots(live_flight(tables))
    flight = live_flight(tables, record=tmp_path / "x.arrows")
    paced(flight, [20, Piloted("circle"), 20], autopilots=made)
    recording = read_recording(tmp_path / "x.arrows")
    assert (recording.columns["pilot_phase"] >= 0).any()
    with pytest.raises(InputError, match="no autopilot of a scenario flew"):
        replay(recording, "mujoco", closed_loop=True)
