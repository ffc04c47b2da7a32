"""Every flipped bit of a recording is noticed; one that was cut is not called damaged."""

import re
from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest

from kitemj.errors import InputError
from kitemj.flight.live import Command
from kitemj.plots.sources import read_flight
from kitemj.recording import recorder
from kitemj.recording.checksum import END, MARK, ZEROS, sealed, sound_part
from kitemj.recording.file import read_recording
from kitemj.recording.replay import replay
from kitemj.recording.summary import comparison
from tests.recording.flights import SPORT, live_flight, recorded, restless

OLD = Path(__file__).with_name("format_2.arrows")


@pytest.fixture(scope="module")
def data(tmp_path_factory):
    """A flight in several batches."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(recorder, "FLUSH", 0.01)
        path = tmp_path_factory.mktemp("checksum") / "kite.arrows"
        return recorded(path, 150, SPORT, restless(1)).read_bytes()


def test_every_flipped_bit_is_noticed(data):
    """A third of the bytes of header and schema, some of the numbers, all at the end.

    What says that a stream was closed is not looked at: all was read before it.
    """
    assert sound_part(data) == (len(data) - len(END), False)
    dice = np.random.default_rng(1)
    size = len(data) - len(END)
    for place in (*range(0, 16_000, 3), *dice.integers(size, size=1000), *range(size - 50, size)):
        flipped = bytearray(data)
        flipped[place] ^= 1 << int(dice.integers(8))
        sound = sound_part(bytes(flipped))
        assert sound.damaged or sound.size == 0  # without a batch it is no recording at all
        assert sound.size <= place


def test_damage_before_the_last_batch_of_a_killed_writer_is_no_cut(data):
    killed = data[: -len(END)]
    last = killed.rfind(b"\xff\xff\xff\xff", 0, killed.rfind(MARK))
    marks = [found.start() for found in re.finditer(re.escape(MARK), killed[:last])]
    places = [place for mark in marks for place in range(mark - 8, mark + 20)]
    places += range(max(0, last - 30_000), last, 7)  # how ticks fall into batches varies
    for place in places:
        flipped = bytearray(killed)
        flipped[place] ^= 0x40
        sound = sound_part(bytes(flipped))
        assert sound.damaged or sound.size == 0


def test_damage_says_from_when_on_and_what_can_be_kept(data, tmp_path):
    path, kept = tmp_path / "kite.arrows", tmp_path / "kept.arrows"
    flipped = bytearray(data)
    flipped[len(data) * 3 // 4] ^= 1
    path.write_bytes(flipped)
    with pytest.raises(InputError, match=r"is damaged after \d\.\d\d s, row \d+: a chec") as told:
        read_recording(path)
    kept.write_bytes(flipped[: sound_part(bytes(flipped)).size])
    part = read_recording(kept)
    assert f"after {part.columns['t_s'][-1]:.2f} s, row {len(part)}: " in str(told.value)
    assert f"(head -c {kept.stat().st_size})" in str(told.value)
    assert part.ending == ""
    again = replay(part, "mujoco")
    assert again.identical
    assert "recorded end unknown: the file breaks off" in comparison(again)
    assert read_flight(kept).notes[0].startswith("kept.arrows breaks off")
    path.write_bytes(bytes([data[0] ^ 1]) + data[1:])
    with pytest.raises(InputError, match="is not a recording of kitemj, or was cut off or damaged"):
        read_recording(path)


def test_what_was_cut_is_not_damaged(data):
    for size in np.linspace(0, len(data), 200).astype(int):
        sound = sound_part(data[:size])
        assert not sound.damaged
        assert sound.size <= size


def test_an_ending_that_looks_like_a_checksum_is_none(tmp_path):
    path = tmp_path / "crc32=00000000.arrows"
    for ending in ("crc32=00000000", "\x0e\0\0\0crc32=12345678"):
        flight = live_flight(SPORT, record=path, overwrite=True)
        flight.tick(Command())
        flight.close(ending)
        assert read_recording(path).ending == ending


def test_other_programs_read_it_as_before(data):
    with pa.ipc.open_stream(data) as stream:
        assert stream.read_all().num_rows == 151


def test_what_has_no_checksum_is_taken_at_its_word():
    old = OLD.read_bytes()
    assert sound_part(old) == (len(old) - len(END), False)
    message, seal = sealed(b"head\x0e\x00\x00\x00crc32=" + ZEROS + b"tail", 5)
    assert message == b"head\x0e\x00\x00\x00crc32=%08xtail" % seal
