"""The flight in a process of its own: what it tells, what it does when either side is gone."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from kitemj.errors import FlightError, InputError
from kitemj.flight.live import TICK, Command
from kitemj.flight.scenario import scenario_of
from kitemj.realtime.autopilots import FIGURES
from kitemj.realtime.messages import Assisted, Deed, Piloted, Rate
from kitemj.realtime.process import FlightProcess
from kitemj.recording.file import read_recording
from kitemj.recording.live import FlightSetup
from kitemj.recording.replay import replay
from kitemj.recording.resume import resume_point

pytestmark = pytest.mark.alone
SCENARIO = scenario_of({"set": "sport", "duration": 60.0}, "test")
PATIENCE = 30.0
"""s; for what takes milliseconds on a machine that has nothing else to do."""


def setup(record=None):
    return FlightSetup(SCENARIO, reference="lagrange", record=record)


def until(condition, physics):
    """Listens until `condition` of all news so far holds."""
    heard, begun = [], time.monotonic()
    while not condition(heard):
        assert time.monotonic() < begun + PATIENCE, "nothing came of it"
        heard += physics.update()
        time.sleep(0.005)
    return heard


@pytest.fixture
def flying():
    physics = FlightProcess(setup())
    physics.wait()
    physics.start()
    yield physics
    physics.stop("over")


def test_each_tick_is_told_once_and_flies_what_was_asked_for(flying):
    flying.ask(Command(0.5))
    asked = time.perf_counter()
    heard = until(lambda news: len(news) > 50, flying)
    ticks = [round(100 * news.result.motion.t) for news in heard]
    assert ticks == list(range(len(ticks)))
    later = [news for news in heard if news.begun > asked + 0.01]
    assert later
    assert all(news.command == Command(0.5) for news in later)
    assert flying.result == heard[-1].result
    assert flying.times.ticks == len(heard) - 1


def test_pause_step_save_rewind_and_restart(flying):
    until(lambda news: len(news) > 30, flying)
    flying.ask(Rate(0.0))
    flying.ask(Deed.SAVE)
    time.sleep(0.1)
    flying.update()
    paused = flying.result.motion.t
    flying.ask(Deed.STEP)
    stepped = until(lambda news: news, flying)
    assert [round(100 * (news.result.motion.t - paused)) for news in stepped] == [1]
    flying.ask(Deed.LOAD)
    until(lambda news: news and news[-1].result.motion.t == paused, flying)
    flying.ask(Deed.RESTART)
    until(lambda news: news and news[-1].result.motion.t == 0.0, flying)


def test_recording_is_that_of_the_flight(tmp_path):
    physics = FlightProcess(setup(tmp_path / "x.arrows"))
    physics.wait()
    physics.start()
    physics.ask(Command(0.3, 0.1))
    heard = until(lambda news: len(news) > 60, physics)
    said = physics.stop("left by the pilot")
    recording = read_recording(tmp_path / "x.arrows")
    assert f"{len(recording)} ticks" in said
    assert recording.ending == "left by the pilot"
    assert recording.columns["x_E_m"][20] == heard[20].result.motion.body.p_G_E.x
    assert replay(recording, "mujoco").identical


def test_the_assist_flies_each_tick_and_the_recording_says_so(tmp_path):
    physics = FlightProcess(setup(tmp_path / "x.arrows"))
    physics.wait()
    physics.start()
    physics.ask(Command(0.4))
    until(lambda news: len(news) > 20, physics)
    physics.ask(Assisted(True))
    until(lambda news: len(news) > 60, physics)
    physics.ask(Assisted(False))
    until(lambda news: len(news) > 20, physics)
    physics.stop("left by the pilot")
    recording = read_recording(tmp_path / "x.arrows")
    stick, hand = recording.columns["stick_delta"][5:], recording.columns["assist_hand"][5:]
    on = np.isfinite(hand)
    assert on.any()
    assert np.diff(on.astype(int)).tolist().count(1) == 1, "on once"
    assert set(hand[on]) == {0.4}
    assert set(stick[~on]) == {0.4}
    assert len(set(stick[on])) > 20, "moved by the assist at each tick"
    assert replay(recording, "mujoco").identical
    past = [tick.hand for tick in resume_point(recording).past]
    assert np.array_equal(past, recording.columns["assist_hand"][1:], equal_nan=True)


def test_a_flight_that_ends_from_outside_is_a_sentence(flying):
    until(lambda news: len(news) > 5, flying)
    flying._child.kill()
    with pytest.raises(FlightError, match="its process was ended from outside"):
        until(lambda news: False, flying)


@pytest.mark.skipif(os.name == "nt", reason="Windows stops no process")
def test_a_flight_that_was_stopped_is_a_sentence_and_its_recording_is_whole(tmp_path, monkeypatch):
    monkeypatch.setattr("kitemj.realtime.process.SILENCE", 1.5)
    physics = FlightProcess(setup(tmp_path / "x.arrows"))
    physics.wait()
    physics.start()
    until(lambda news: len(news) > 20, physics)
    os.kill(physics._child.pid, signal.SIGSTOP)
    with pytest.raises(FlightError, match="its process does not answer"):
        until(lambda news: False, physics)
    assert f"{tmp_path / 'x.arrows'}, " in physics.stop("it did not answer")
    assert read_recording(tmp_path / "x.arrows").ending == "it did not answer"


def test_a_pause_is_not_silence(flying, monkeypatch):
    monkeypatch.setattr("kitemj.realtime.process.SILENCE", 1.5)
    flying.ask(Rate(0.0))
    begun = time.monotonic()
    until(lambda news: time.monotonic() > begun + 3.0, flying)


def test_what_cannot_be_flown_is_the_same_sentence_as_in_one_process():
    physics = FlightProcess(setup()._replace(model="paper"))
    with pytest.raises(InputError, match="there is no model 'paper'"):
        physics.wait()


PAINTER = """
import sys, time
from pathlib import Path
from tests.realtime.test_process import FlightProcess, setup, until
if __name__ == "__main__":
    physics = FlightProcess(setup(Path(sys.argv[1])))
    physics.wait()
    physics.start()
    until(lambda news: len(news) > 100, physics)
    print(physics._child.pid, flush=True)
    time.sleep(60)
"""


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGKILL")
def test_when_the_painter_is_killed_the_recording_is_closed_and_no_process_stays(tmp_path):
    script, path = tmp_path / "painter.py", tmp_path / "x.arrows"
    script.write_text(PAINTER)
    root = Path(__file__).parents[2]
    with subprocess.Popen(
        [sys.executable, script, path],
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": str(root)},
    ) as painter:
        physics = int(painter.stdout.readline())
        painter.send_signal(signal.SIGKILL)
    begun = time.monotonic()
    while Path(f"/proc/{physics}").exists() and time.monotonic() < begun + PATIENCE:
        time.sleep(0.02)
    recording = read_recording(path)
    assert recording.ending == "the program that showed it was ended"
    assert len(recording) > 100


def test_the_autopilot_takes_over_is_told_of_and_gives_back_without_a_jerk(tmp_path):
    """δ̇ is continuous within the hands' limit on δ̈, at hand-over and at taking back."""
    physics = FlightProcess(setup(tmp_path / "x.arrows"))
    physics.wait()
    assert [name for name, offer in physics.offers.items() if not offer.fault] == list(FIGURES)
    assert np.linalg.norm(physics.offers["eight"].path, axis=1) == pytest.approx(1.0)
    physics.start()
    physics.ask(Command(0.6))
    heard = until(lambda news: len(news) > 30, physics)
    physics.ask(Piloted("eight"))
    physics.ask(Command())
    heard += until(lambda news: len(news) > 150, physics)
    physics.ask(Piloted(""))
    physics.ask(Command(-0.6))
    heard += until(lambda news: len(news) > 30, physics)
    physics.stop("left by the pilot")
    guided = [news.guided is not None for news in heard]
    assert np.diff(np.array(guided, int)).tolist().count(1) == 1, "on once"
    assert np.diff(np.array(guided, int)).tolist().count(-1) == 1, "off once"
    assert {news.guided.phase for news in heard if news.guided} <= {"climb", "path"}
    rates = np.array([news.result.motion.control.delta_dot for news in heard])
    limits = SCENARIO.parameters.stick
    assert np.abs(np.diff(rates)).max() <= limits.delta_ddot * TICK * (1 + 1e-9)
    assert np.abs(rates).max() <= limits.delta_dot * (1 + 1e-9)
    assert np.abs(rates).max() > 0.1, "the hands moved at all"
    assert replay(read_recording(tmp_path / "x.arrows"), "mujoco").identical


def test_after_going_back_the_autopilot_begins_anew(flying):
    flying.ask(Piloted("circle"))
    until(lambda news: len(news) > 150, flying)
    flying.ask(Deed.RESTART)
    heard = until(lambda news: any(each.result.motion.t == 0.0 for each in news), flying)
    heard += until(lambda news: len(news) > 20, flying)
    start = next(i for i, each in enumerate(heard) if each.result.motion.t == 0.0)
    assert heard[start].guided is None, "nobody flew to the start"
    assert (heard[start + 1].guided.phase, heard[start + 1].guided.lap) == ("climb", 0.0)


def test_a_kite_that_drifts_is_offered_to_be_held_and_nothing_else():
    physics = FlightProcess(FlightSetup(scenario_of({"set": "thesis", "duration": 60.0}, "test")))
    physics.wait()
    assert list(physics.offers) == list(FIGURES)
    faults = {name: offer.fault for name, offer in physics.offers.items()}
    assert [name for name, fault in faults.items() if not fault] == ["hold"]
    assert all("it does not turn" in fault for name, fault in faults.items() if name != "hold")
    physics.start()
    physics.ask(Piloted("eight"))
    heard = until(lambda news: len(news) > 20, physics)
    assert all(news.guided is None for news in heard)
    physics.ask(Piloted("hold"))
    heard = until(lambda news: news and news[-1].guided, physics)
    assert heard[-1].guided.phase == "hold"
    physics.stop("over")
