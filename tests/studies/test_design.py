"""Which flights a study holds."""

import numpy as np
import pytest

from kitemj.errors import InputError
from kitemj.studies.design import design_of

HYPERCUBE = {"count": 8, "seed": 3, "kite.mass": [3.0, 5.0], "wind": {"speed": [5.0, 9.0]}}


def test_factors_multiply_and_the_last_one_changes_the_quickest():
    grid = {"model": ["mujoco", "lagrange"], "wind": {"speed": {"from": 5, "to": 7, "count": 3}}}
    design = design_of({"list": [{"kite.mass": 4.0}, {"set": "thesis"}], "grid": grid}, "s")
    points = [design.point(i) for i in range(design.count)]
    assert len(points) == 2 * 2 * 3
    assert points[0] == {"kite.mass": 4.0, "model": "mujoco", "wind.speed": 5.0}
    assert points[1] == {"kite.mass": 4.0, "model": "mujoco", "wind.speed": 6.0}
    assert points[-1] == {"set": "thesis", "model": "lagrange", "wind.speed": 7.0}
    assert len({tuple(point.items()) for point in points}) == 12


def test_a_latin_hypercube_uses_each_slice_of_each_range_once():
    design = design_of({"hypercube": HYPERCUBE}, "s")
    points = [design.point(i) for i in range(design.count)]
    for name, low, high in (("kite.mass", 3.0, 5.0), ("wind.speed", 5.0, 9.0)):
        slices = [int((point[name] - low) / (high - low) * 8) for point in points]
        assert sorted(slices) == list(range(8))
    again = design_of({"hypercube": HYPERCUBE}, "s")
    other = design_of({"hypercube": {**HYPERCUBE, "seed": 4}}, "s")
    assert again.point(5) == points[5]
    assert other.point(5) != points[5]


def test_a_million_flights_are_not_made_before_they_are_meant():
    axis = {"from": 0, "to": 1, "count": 10}
    many = {**HYPERCUBE, "count": 10**6}
    design = design_of({"grid": {"kite.span": axis}, "hypercube": many}, "s")
    assert design.count == 10**7
    with pytest.raises(InputError, match="11000000 flights"):
        design_of({"grid": {"kite.span": {**axis, "count": 11}}, "hypercube": many}, "s")


def test_a_list_of_tables_replaces_a_whole_section():
    sine = {"programme": "sine", "delta_amplitude": 0.1}
    design = design_of({"grid": {"steering": [{"programme": "rest"}, sine]}}, "s")
    assert design.point(1) == {"steering": sine}


@pytest.mark.parametrize(
    ("tables", "says"),
    [
        ({}, "nothing is varied"),
        ({"grid": {}}, r"\[grid\] is empty"),
        ({"grid": {"wind.speed": []}}, "grid.wind.speed is empty"),
        ({"grid": {"wind.speed": 5.0}}, "must be a list of values"),
        ({"grid": {"wind.speed": {"from": 5.0, "to": 6.0}}}, "from, to and count"),
        ({"grid": {"wind.speed": {"from": 6, "to": 5, "count": 2}}}, "the lower one first"),
        ({"grid": {"wind.speed": {"from": 5, "to": 6, "count": 0}}}, "whole number >= 1, got 0"),
        ({"list": []}, "list is empty"),
        ({"list": {"wind.speed": 5.0}}, r"\[\[list\]\]"),
        ({"hypercube": {"count": 5}}, "varies nothing"),
        ({"hypercube": {"kite.mass": [3.0, 5.0]}}, "hypercube.count must be"),
        ({"hypercube": {"count": 5, "kite.mass": [np.inf, 5.0]}}, "two numbers"),
        ({"hypercube": {"count": 5, "seed": -1, "kite.mass": [3.0, 5.0]}}, "seed"),
        ({"grid": {"kite.mass": [4.0]}, "list": [{"kite": {"mass": 3.0}}]}, "varied twice"),
    ],
)
def test_bad_designs_are_a_sentence_each(tables, says):
    with pytest.raises(InputError, match=says) as error:
        design_of(tables, "study.toml")
    assert "\n" not in str(error.value)
    assert "study.toml" in str(error.value)
