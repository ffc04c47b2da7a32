"""A recording of format 2 that an earlier version wrote still opens, replays and exports."""

import csv
from pathlib import Path

import numpy as np
import pytest

from kitemj.recording.export import write_table
from kitemj.recording.file import read_recording
from kitemj.recording.replay import replay
from kitemj.recording.table import ALL

FILE = Path(__file__).with_name("format_2.arrows")
SAME = 1e-9
"""m; the same bits where the processor and mujoco are those that wrote it, rounding elsewhere."""


@pytest.fixture(scope="module")
def recording():
    return read_recording(FILE)


def test_it_opens_with_all_its_ticks(recording):
    assert len(recording) == 203
    assert tuple(recording.columns) == ALL
    assert [recording.columns["leg"][each.start] for each in recording.episodes] == list(
        range(len(recording.episodes))
    )


def test_nobody_was_helped_before_there_was_an_assist(recording):
    assert np.isnan(recording.columns["assist_hand"]).all()


def test_it_replays(recording):
    again = replay(recording, recording.header.model)
    assert again.note == ""
    assert np.isfinite(again.gaps).all()
    assert again.gaps.max() <= SAME


def test_it_exports(recording, tmp_path):
    write_table(tmp_path / "old.csv", recording)
    with (tmp_path / "old.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(recording)
    assert [float(row["z_E_m"]) for row in rows] == recording.columns["z_E_m"].tolist()
