"""Compiled and interpreted, the formulas give the same numbers, bit by bit."""

import os
import subprocess
import sys
from pathlib import Path

from tests.bits import CASES, numbers, results


def test_interpreted_formulas_give_the_bits_of_the_compiled_ones():
    said = subprocess.run(
        [sys.executable, "-m", "tests.bits"],
        env={**os.environ, "NUMBA_DISABLE_JIT": "1"},
        cwd=Path(__file__).parent.parent,
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    interpreted = {name: texts for name, *texts in (line.split("\t") for line in said.splitlines())}
    assert interpreted.pop("compiled") == [(0.0).hex()]
    compiled = results()
    assert set(compiled) == set(interpreted)
    for name, values in compiled.items():
        assert len(values) == CASES
        assert [number.hex() for number in numbers(tuple(values))] == interpreted[name], name
