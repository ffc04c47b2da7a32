"""Arms to δ: against triangles of known sides, not against the formulas that made it."""

import tomllib
from math import asin, cos, degrees, pi, sin, sqrt

import pytest

from kitemj.cli import main
from kitemj.errors import InputError
from kitemj.flight.reach import STEEPEST, longest_arm, reach, reach_of
from kitemj.flight.scenario import scenario_of
from kitemj.physics.parameter_files import parameter_set

EXACT = 1e-12
"""rad, m: rounding."""


@pytest.mark.parametrize("arms", [(0.25, 200.0, 5.8), (0.25, 25.0, 0.8), (3.0, 10.0, 8.0)])
def test_the_triangle_has_the_sides_that_were_asked_for(arms):
    """O_E at the origin, O_2 at ℓ; the attachments tilted by δ about it."""
    arm, length, attachments = arms
    found = reach_of(*arms)
    for side in (1.0, -1.0):
        across = side * attachments / 2 * cos(found.delta)
        along = found.ell + side * attachments / 2 * sin(found.delta)
        assert sqrt(across**2 + along**2) == pytest.approx(length + side * arm, abs=EXACT)
    assert found.ell_rest == pytest.approx(sqrt(length**2 - attachments**2 / 4), abs=EXACT)


def test_a_right_angle_by_hand():
    """Lines of 3 and 5 with attachments 4 apart: ℓ² = 13, sin δ = 2/√13."""
    found = reach_of(1.0, 4.0, 4.0)
    assert found.ell == pytest.approx(sqrt(13.0), abs=EXACT)
    assert found.delta == pytest.approx(asin(2 / sqrt(13.0)), abs=EXACT)


def test_the_number_of_the_thesis(capsys):
    """It prints 0.1: the same to one decimal."""
    assert main(["reach", "thesis", "--length", "200"]) == 0
    out = capsys.readouterr().out
    assert round(reach_of(0.25, 200.0, 5.8).delta, 1) == 0.1
    assert "0.0863231 rad" in out
    assert "prints 0.1 rad" in out
    assert main(["reach", "thesis"]) == 0
    assert "prints 0.1 rad" not in capsys.readouterr().out


def test_the_printed_lines_are_a_stick(capsys):

    assert main(["reach", "sport", "--arm", "0.2"]) == 0
    tables = tomllib.loads(capsys.readouterr().out.split("\n\n")[1])
    stick = scenario_of({"set": "sport", "duration": 1.0, **tables}, "test").parameters.stick
    assert stick.arm == 0.2
    assert stick.delta == pytest.approx(reach(parameter_set("sport"), 0.2), abs=1e-6)


def test_a_scenario_has_its_own_kite(tmp_path, capsys):
    path = tmp_path / "wide.toml"
    path.write_text('set = "sport"\nduration = 1.0\n[kite]\ny_A = 0.5\n[stick]\narm = 0.3\n')
    assert main(["reach", str(path)]) == 0
    assert "±0.3 m on each line of 25 m, attachments 1 m apart" in capsys.readouterr().out


def test_the_longest_arm_turns_the_kite_as_far_as_a_set_allows():
    longest = longest_arm(25.0, 0.8)
    assert reach_of(longest * (1 - 1e-9), 25.0, 0.8).delta == pytest.approx(STEEPEST, abs=1e-6)
    assert pi / 2 > STEEPEST
    assert degrees(STEEPEST) == pytest.approx(85.9, abs=0.1)
    with pytest.raises(InputError, match=r"arm must be < 0\.399 m .* got 0\.4 m"):
        reach_of(0.4, 25.0, 0.8)


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--arm", "0.4"], "arm must be < 0.3491 m for attachments 0.7 m apart, got 0.4 m"),
        (["--arm", "0"], "arm must be > 0 m, got 0.0 m"),
        (["--length", "1e308"], "length must be 0.001 to 100000 m, got 1e+308 m"),
        (["--length", "0.3"], "lines of 0.3 m do not reach attachments 0.7 m apart"),
        (["--attachments", "-1"], "attachments must be > 0 m, got -1.0 m"),
    ],
)
def test_arms_that_cannot_be(words, says, capsys):
    assert main(["reach", *words]) == 2
    assert says in capsys.readouterr().err


def test_a_kite_that_is_not_there(capsys):
    assert main(["reach", "none.toml"]) == 2
    assert "cannot read none.toml: " in (said := capsys.readouterr().err)
    assert "; sets: laksa, sport, thesis, trainer" in said
