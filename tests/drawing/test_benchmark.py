"""The benchmark tells the parts of a frame, whatever a frame is made of."""

import re

import pytest

import benchmark


def test_the_parts_of_a_frame_are_all_measured():
    lines = "\n".join(benchmark.frame(1))
    if lines.startswith("No frames"):
        pytest.skip(lines)
    parts = dict(re.findall(r"^\| (.*?) \| ([0-9.]+)", lines, re.MULTILINE))
    assert len(parts) == 8
    whole = float(parts.pop("**the frame**"))
    assert max(map(float, parts.values())) < whole
    assert float(parts["instruments and labels"]) > 0
