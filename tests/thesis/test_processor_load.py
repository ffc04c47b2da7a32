"""Other work: this process's own time is taken off; what cannot be known is not a number."""

import os
from math import isnan

import pytest

from thesis import processor_load
from thesis.processor_load import ProcessorTime, other_load, processor_time

needs_clock = pytest.mark.skipif(not hasattr(os, "sysconf"), reason="no ticks of the clock")


def test_own_work_is_taken_off():
    assert other_load(ProcessorTime(10.0, 1.0, 100.0), ProcessorTime(14.0, 3.0, 108.0)) == 1.5


@needs_clock
def test_idle_and_waiting_time_are_no_work(tmp_path):
    hertz = os.sysconf("SC_CLK_TCK")
    (tmp_path / "stat").write_text("cpu  1 2 4 1000 2000 8 16 32 64 128\ncpu0 9 9 9 9 9 9 9 9\n")
    assert processor_time(tmp_path).everyone == (1 + 2 + 4 + 8 + 16 + 32) / hertz


@needs_clock
def test_work_of_a_process_of_ours_is_our_own(tmp_path, monkeypatch):
    class Child:
        pid = 77

    hertz = os.sysconf("SC_CLK_TCK")
    (tmp_path / "77").mkdir()
    fields = "S 1 2 3 4 5 6 7 8 9 10 300 700 13"
    (tmp_path / "77" / "stat").write_text(f"77 (a name) with) {fields}")
    monkeypatch.setattr(processor_load, "active_children", list)
    alone = processor_time(tmp_path).own
    monkeypatch.setattr(processor_load, "active_children", lambda: [Child()])
    assert processor_time(tmp_path).own - alone == pytest.approx(1000 / hertz, abs=1.0)


def test_where_nothing_is_told_it_is_not_a_number(tmp_path):
    unknown = processor_time(tmp_path)
    assert isnan(unknown.everyone)
    assert isnan(other_load(unknown, processor_time(tmp_path)))
