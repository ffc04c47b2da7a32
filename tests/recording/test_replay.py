"""The recorded input flown again: the same bits in the same model, micrometres in another."""

import subprocess
import sys

import numpy as np
import pytest

from kitemj.cli import main
from kitemj.errors import InputError
from kitemj.flight.motion_table import COLUMNS
from kitemj.recording.export import write_table
from kitemj.recording.file import read_recording
from kitemj.recording.replay import replay
from kitemj.recording.track import Track
from tests.recording.flights import LOOPS, recorded, restless

GAP = 5e-6
"""m, over five minutes of calm flight; measured: 0.02 µm."""


@pytest.fixture(scope="module")
def calm(tmp_path_factory):
    """Five minutes of the thesis' kite, never at rest, within its limits."""
    path = tmp_path_factory.mktemp("recordings") / "calm.arrows"
    return read_recording(recorded(path, 30_000))


def test_same_model_same_bits_lagrange_micrometres(calm):
    assert calm.departure(calm.episodes[0]) is None
    assert np.ptp(calm.columns["delta_rad"]) > 0.02
    assert replay(calm, "mujoco").identical
    again = replay(calm, "lagrange")
    assert not again.identical
    gap, _ = again.largest_gap(again.comparable)
    assert 0 < gap <= GAP


def test_wild_flights_and_restarts_have_the_same_bits_in_a_fresh_process(tmp_path):
    """Slack lines, stalls, the ground: 8 s at full stick, twice, and on from there."""
    stick = restless(2, ell=1.0, hold=90)
    path = recorded(tmp_path / "wild.arrows", 800, LOOPS, stick, episodes=2)
    recording = read_recording(path)
    assert recording.columns["slack"].any()
    assert len(recording.episodes) == 2
    assert replay(recording, "mujoco").identical
    command = [sys.executable, "-m", "kitemj", "replay", str(path), "--model", "mujoco"]
    said = subprocess.run([*command, "--headless"], capture_output=True, text=True, check=True)
    assert "identical to the last bit" in said.stdout


def test_one_bit_of_steering_is_noticed(calm):
    columns = {name: values[:200].copy() for name, values in calm.columns.items()}
    columns["ell_m"][100] = np.nextafter(columns["ell_m"][100], np.inf)
    changed = type(calm)(calm.path, calm.header, calm.parameters, columns, "")
    assert not replay(changed, "mujoco").identical


def test_another_step_and_unknown_models(calm):
    with pytest.raises(InputError, match="there is no model 'laksa'"):
        replay(calm, "laksa")
    with pytest.raises(InputError, match="step must be"):
        replay(calm, "lagrange", 3.0)


def test_motions_between_ticks(calm):
    """Every second tick against the middle of its neighbours, flown tick by tick."""
    track = Track(calm)
    coarse = {name: values[::2] for name, values in calm.columns.items()}
    header = type(calm.header)(**(vars(calm.header) | {"tick": 0.02}))
    half = Track(type(calm)(calm.path, header, calm.parameters, coarse, ""))
    for place in (3, 1001, 14_567):
        true, found = track.motion(place), half.motion(place / 2)
        assert found.t == pytest.approx(true.t)
        np.testing.assert_allclose(found.body.p_G_E, true.body.p_G_E, atol=1e-6)
        np.testing.assert_allclose(found.body.R_BE, true.body.R_BE, atol=5e-5)
        np.testing.assert_allclose(found.lengths, true.lengths, atol=1e-4)
        np.testing.assert_allclose(np.linalg.det(found.body.R_BE), 1.0, atol=1e-12)
    deltas = [track.motion(place).control.delta for place in (7.0, 7.0001)]
    assert deltas[0] == pytest.approx(deltas[1], abs=1e-7)
    beside = track.motion(500.3)
    apart = np.subtract(track.reference(500.3, beside).body.p_G_E, beside.body.p_G_E)
    assert np.linalg.norm(apart) == pytest.approx(calm.columns["gap_m"][500], abs=1e-9)


def test_export_has_every_row_and_all_digits(tmp_path):
    recording = read_recording(recorded(tmp_path / "kite.arrows", 120))
    write_table(tmp_path / "kite.csv", recording)
    lines = (tmp_path / "kite.csv").read_text().splitlines()
    names = lines[0].split(",")
    assert names[: len(COLUMNS)] == list(COLUMNS)
    assert len(lines) == 122
    for i in (1, 121):
        cells = dict(zip(names, lines[i].split(","), strict=True))
        for name in COLUMNS:
            assert float(cells[name]) == recording.columns[name][i - 1]
    with pytest.raises(InputError, match="exists"):
        write_table(tmp_path / "kite.csv", recording)


def test_commands_answer_bad_words_with_a_sentence(tmp_path, capsys):
    assert main(["info", str(tmp_path / "none.arrows")]) == 2
    assert "does not exist" in capsys.readouterr().err
    path = recorded(tmp_path / "kite.arrows", 60)
    assert main(["info", str(path)]) == 0
    told = capsys.readouterr().out
    for word in (
        "thesis",
        "mujoco beside lagrange",
        "0 of 60 ticks missed",
        "as long as was asked",
    ):
        assert word in told
    assert main(["replay", str(path), "--export", "csv"]) == 0
    assert main(["replay", str(path), "--export", "csv"]) == 2
    assert "exists" in capsys.readouterr().err
