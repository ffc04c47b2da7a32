"""A recording: all of it comes back, whatever became of the program, the disk or the file."""

import errno
import os
import subprocess
import sys
import threading
import time

import numpy as np
import pyarrow as pa
import pytest

from kitemj.errors import InputError
from kitemj.flight.limits import SLACK
from kitemj.flight.live import TICK, Command
from kitemj.flight.motion_table import COLUMNS, row
from kitemj.realtime.messages import Stop
from kitemj.realtime.pacer import Pacer
from kitemj.recording import recorder as recording_module
from kitemj.recording.file import read_recording
from kitemj.recording.header import from_json, header_of, to_json
from kitemj.recording.recorder import timestamped_name
from kitemj.recording.summary import parameters_in_words, summary
from kitemj.recording.table import ALL, LIMITS, STEERING, STICK
from tests.recording.flights import LOOPS, live_flight, recorded, restless

CRASH_COSTS = 1.0
"""s; what the end of a program may cost. Batches are half a second apart."""


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """Two flights of 3 s, one after the other, in many batches."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(recording_module, "FLUSH", 0.01)
        return recorded(tmp_path_factory.mktemp("recordings") / "kite.arrows", 300, episodes=2)


def test_every_number_comes_back_to_the_last_bit(tmp_path):
    flight, stick = live_flight(record=tmp_path / "kite.arrows"), restless(1)
    seen = [(flight.result, flight.segment, Command(), 0.0)]
    for _ in range(129):
        command = next(stick)
        result = flight.tick(command, due=time.perf_counter())
        seen.append((result, flight.segment, command, flight.lateness))
    assert "130 ticks" in flight.close("over")
    recording = read_recording(tmp_path / "kite.arrows")
    table = recording.columns
    assert recording.ending == "over"
    for i, (result, segment, command, lateness) in enumerate(seen):
        assert [table[name][i] for name in STEERING] == list(segment.control)
        assert [table[name][i] for name in COLUMNS] == row(result.motion)
        assert [table[name][i] for name in STICK] == list(command)
        assert table["gap_m"][i] == result.gap
        assert table["lateness_s"][i] == lateness
        assert table["ref_x_E_m"][i] == result.reference.body.p_G_E.x


def test_header_survives_to_the_last_bit():
    flight = live_flight({"set": "laksa", "duration": 1.0, "kite": {"mass": 4.1}, "start": {}})
    header = from_json(to_json(header_of(flight)), "test")
    assert header.checked_parameters("test") == flight.parameters
    assert header.states == [flight.scenario.start]
    assert parameters_in_words(header.parameters) == "laksa with kite.mass = 4.1"


def test_other_programs_read_it_in_a_line(file):
    table = pa.ipc.open_stream(str(file)).read_all()
    assert table.column_names == list(ALL)
    assert table.num_rows == 602
    assert table["leg"].to_pylist() == [0] * 301 + [1] * 301
    assert table["t_s"][301].as_py() == 0.0


def test_an_hour_stays_below_500_mb(file):
    """602 ticks with their header; an hour has 360,001."""
    assert file.stat().st_size / 602 * 360_001 < 500e6


def test_first_departure_has_its_moment_and_reason(tmp_path):
    """A small kite whose stick is thrown about comes by a slack line in seconds."""
    flight = live_flight(LOOPS, record=tmp_path / "kite.arrows")
    stick, slack = restless(2, ell=1.0, hold=90), None
    while slack is None and flight.ticks < 800:
        result = flight.tick(next(stick))
        if result.departure and result.departure.limit is SLACK:
            slack = flight.ticks
    flight.close("over")
    assert slack is not None
    recording = read_recording(tmp_path / "kite.arrows")
    departed = np.flatnonzero(np.any([recording.columns[name] for name in LIMITS], axis=0))
    assert departed[0] <= slack
    assert recording.departure(recording.episodes[0]).t == recording.columns["t_s"][departed[0]]
    assert recording.columns["slack"][slack]
    assert "left the limits of validity at" in summary(recording)


@pytest.mark.alone
def test_kill_9_costs_less_than_a_second_and_leaves_no_lock(tmp_path):
    file = tmp_path / "kite.arrows"
    command = [sys.executable, "-m", "tests.recording.flights", str(file)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as program:
        assert program.stdout.readline() == "flying\n"
        begun = time.perf_counter()
        with pytest.raises(InputError, match="another program is recording into"):
            live_flight(record=file, overwrite=True)
        time.sleep(1.3)
        program.kill()
        flown = time.perf_counter() - begun
    recording = read_recording(file)
    assert flown - CRASH_COSTS < recording.columns["t_s"][-1] <= flown + TICK
    assert recording.ending == ""
    assert "breaks off" in summary(recording)
    live_flight(record=file, overwrite=True).close("over")
    assert read_recording(file).ending == "over"


def test_cut_anywhere_all_whole_batches_are_read(file, tmp_path):
    whole = read_recording(file)
    data, cut = file.read_bytes(), tmp_path / "cut.arrows"
    before, readable = 0, 0
    for size in np.linspace(len(data) // 20, len(data) - 20, 25).astype(int):
        cut.write_bytes(data[:size])
        try:
            part = read_recording(cut)
        except InputError as error:
            assert "holds no tick" in str(error) or "cut off" in str(error)  # noqa: PT017
            continue
        readable += 1
        assert before <= len(part) <= len(whole)
        before = len(part)
        for name in ALL:
            np.testing.assert_array_equal(part.columns[name], whole.columns[name][:before])
    assert readable > 3


def full_disk(room):
    """An `os.write` for a disk with `room` bytes left in a list."""

    def write(file, data):
        if room[0] <= 0:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        taken = os.pwrite(file, data[: room[0]], os.lseek(file, 0, os.SEEK_CUR))
        os.lseek(file, taken, os.SEEK_CUR)
        room[0] -= taken
        return taken

    return write


class Disk:
    """The module `os` with another `write`."""

    def __init__(self, write):
        self.write = write

    def __getattr__(self, name):
        return getattr(os, name)


class Paced:
    """A flight in real time in a thread, which a test looks into; `times` counts its ticks."""

    def __init__(self, path):
        live_flight().warm_up()
        self.flight, self.wishes, self.news = live_flight(record=path), [], []
        pacer = Pacer(self.flight, lambda: self.wishes, self.news.append)
        self.thread = threading.Thread(target=pacer.run)
        self.thread.start()

    @property
    def times(self):
        return self.news[-1].times

    def stop(self):
        self.wishes.append(Stop("over"))
        self.thread.join()
        self.flight.close("over")


@pytest.mark.alone
def test_full_disk_is_said_and_nothing_before_is_lost(tmp_path, monkeypatch):
    room = [60_000]
    monkeypatch.setattr(recording_module, "os", Disk(full_disk(room)))
    paced = Paced(tmp_path / "kite.arrows")
    time.sleep(1.7)
    assert "No space left" in paced.news[-1].problem
    flown = paced.times.ticks
    kept = read_recording(tmp_path / "kite.arrows")
    assert 0 < len(kept) < flown
    time.sleep(0.2)
    assert paced.times.ticks > flown  # it flies on
    room[0] = 10**9  # somebody makes room: what waited is written
    time.sleep(0.6)
    assert paced.news[-1].problem == ""
    paced.stop()
    assert len(read_recording(tmp_path / "kite.arrows")) == paced.times.ticks + 1
    assert not paced.flight.cut


def test_a_recording_that_stays_cut_is_told_of(tmp_path, monkeypatch):
    monkeypatch.setattr(recording_module, "os", Disk(full_disk([20_000])))
    with live_flight(record=tmp_path / "kite.arrows") as flight:
        for _ in range(50):
            flight.tick(Command())
    assert flight.cut


@pytest.mark.alone
def test_slow_disk_makes_no_tick_late(tmp_path, monkeypatch):
    """Each write takes longer than a batch; the flight is as punctual as its machine lets it."""

    def slow(file, data):
        time.sleep(0.6)
        return os.write(file, data)

    paced = Paced(tmp_path / "kite.arrows")
    monkeypatch.setattr(recording_module, "os", Disk(slow))
    time.sleep(1.4)
    paced.stop()
    # a tick that waited for the disk would be 600 ms late; 200 ms: a busy machine
    assert paced.times.worst < 0.2
    assert len(read_recording(tmp_path / "kite.arrows")) == paced.times.ticks + 1


def test_what_exists_is_kept(tmp_path):
    path = tmp_path / "kite.arrows"
    path.write_bytes(b"precious")
    with pytest.raises(InputError, match="exists"):
        live_flight(record=path)
    assert path.read_bytes() == b"precious"
    with pytest.raises(InputError, match="no folder"):
        live_flight(record=tmp_path / "nowhere" / "kite.arrows")
    names = {timestamped_name(tmp_path)}
    next(iter(names)).touch()
    assert not timestamped_name(tmp_path).exists()


def rewritten(file, path, **changes):
    """The same recording with another header."""
    table = pa.ipc.open_stream(str(file)).read_all()
    header = table.schema.metadata[b"kitemj"].decode()
    for old, new in changes.items():
        assert old in header
        header = header.replace(old, new)
    table = table.replace_schema_metadata({b"kitemj": header.encode()})
    with pa.ipc.new_stream(str(path), table.schema) as stream:
        stream.write_table(table)
    return path


def refusal(path):
    with pytest.raises(InputError) as caught:
        read_recording(path)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_bad_files_are_a_sentence(file, tmp_path):
    bad = tmp_path / "bad.arrows"
    assert "does not exist" in refusal(bad)
    assert "is a folder" in refusal(tmp_path)
    bad.touch()
    assert "is empty" in refusal(bad)
    bad.write_text("t,x\n0,1\n")
    assert "not a recording" in refusal(bad)
    table = pa.table({"t": [1.0]})
    with pa.ipc.new_stream(str(bad), table.schema) as stream:
        stream.write_table(table)
    assert "not a recording" in refusal(bad)
    later = rewritten(file, bad, **{'"format": 2': '"format": 99', '"kitemj": "0': '"kitemj": "9'})
    assert "format 99" in refusal(later)
    assert "upgrade kitemj" in refusal(later)
    earlier = rewritten(file, bad, **{'"format": 2': '"format": 1'})
    assert "format 1, of an earlier kitemj" in refusal(earlier)
    assert "kite.mass must be > 0 kg" in refusal(
        rewritten(file, bad, **{'"mass": 4': '"mass": -4'})
    )
    assert "damaged" in refusal(rewritten(file, bad, **{'"scenario"': '"scenery"'}))


def test_other_versions_are_named(file, tmp_path):
    other = rewritten(file, tmp_path / "other.arrows", **{'"mujoco": "': '"mujoco": "1'})
    assert "other than here (mujoco" in summary(read_recording(other))
    assert "other than here" not in summary(read_recording(file))
