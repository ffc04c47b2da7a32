"""Other work: this process's own time is taken off; what cannot be known is not a number."""

import os
from math import isnan

import pytest

from kitemj.thesis.other_work import Work, others, work

needs_clock = pytest.mark.skipif(not hasattr(os, "sysconf"), reason="no ticks of the clock")


def test_own_work_is_taken_off():
    assert others(Work(10.0, 1.0, 100.0), Work(14.0, 3.0, 108.0)) == 1.5


@needs_clock
def test_idle_and_waiting_time_are_no_work(tmp_path):
    stat, hertz = tmp_path / "stat", os.sysconf("SC_CLK_TCK")
    stat.write_text("cpu  1 2 4 1000 2000 8 16 32 64 128\ncpu0 9 9 9 9 9 9 9 9 9 9\n")
    assert work(stat).everyone == (1 + 2 + 4 + 8 + 16 + 32) / hertz


def test_where_nothing_is_told_it_is_not_a_number(tmp_path):
    unknown = work(tmp_path / "none")
    assert isnan(unknown.everyone)
    assert isnan(others(unknown, work(tmp_path / "none")))
