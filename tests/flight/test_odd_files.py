"""Files that people give: what is absurd or damaged is one sentence, and never unbounded work."""

import os
from pathlib import Path

import pytest

from kitemj.controls.programmed import read_programmed_stick
from kitemj.errors import InputError
from kitemj.flight.scenario import Offsets, read_scenario, scenario_of
from kitemj.physics.aerodynamics import LinearAero
from kitemj.physics.checked import quantity_of
from kitemj.physics.parameter_files import SECTIONS, field_names, parameter_set, read_toml
from kitemj.physics.steering import Sines
from kitemj.studies.design import design_of
from kitemj.studies.study import study_of

KINDS = {**SECTIONS, "aero": LinearAero, "steering": Sines, "start": Offsets}
NUMBERS = [
    (section, name)
    for section, kind in KINDS.items()
    for name in field_names(kind)
    if name not in ("rigid", "mirrored")
]
SINE = {"steering": {"programme": "sine"}}


@pytest.mark.parametrize(("section", "name"), NUMBERS)
def test_absurd_numbers_are_refused_by_what_is_sensible(section, name):
    quantity = quantity_of(KINDS[section], name)
    least = [5e-324, 1e-12] if quantity.gt == 0 else []
    for value in (1e308, -1e308, 1e12, *least):
        table = {**SINE.get(section, {}), name: value}
        with pytest.raises(InputError, match=rf"{section}\.{name} must be") as caught:
            scenario_of({"set": "sport", "duration": 1.0, section: table}, "s.toml")
        assert quantity.unit in str(caught.value)


def test_a_table_of_coefficients_says_its_shape():
    def refusal(table):
        aero = {"law": "table", "table": table}
        with pytest.raises(InputError) as caught:
            scenario_of({"duration": 1.0, "aero": aero}, "s.toml")
        return str(caught.value)

    zeros = [[[0.0] * 3 for _ in range(8)] for _ in range(6)]
    assert "aero.table must be 6 x 8 x 3 numbers, got 5 x 8 x 3" in refusal(zeros[:5])
    assert "6 x 8 x 3 numbers, got 6 x 7 x 3" in refusal([row[:7] for row in zeros])
    assert "6 x 8 x 3 numbers, got 6 of unequal parts" in refusal([zeros[0][:3], *zeros[1:]])
    assert "6 x 8 x 3 numbers, got 1.0" in refusal(1.0)
    zeros[2][3][1] = "x"
    assert "aero.table[2][3][1] must be a number, got 'x'" in refusal(zeros)
    zeros[2][3][1] = 1e308
    assert "aero.table must be -10000 to 10000, got 1e+308" in refusal(zeros)
    steering = {"programme": "table", "t": 1.0, "delta": [0.0, 0.0]}
    with pytest.raises(InputError, match=r"steering\.t must be a list of numbers, got 1\.0"):
        scenario_of({"duration": 1.0, "steering": steering}, "s.toml")


def test_a_steering_table_moves_at_the_pace_of_hands():
    for t in ([0.0, 5e-324, 1.0], [0.0, 1e-300, 1.0], [0.0, 0.0, 1.0], [1.0, 0.5, 0.0]):
        steering = {"programme": "table", "t": t, "delta": [0.0, 0.1, 0.0]}
        with pytest.raises(InputError, match="ascending times, 1e-06 s apart or more"):
            scenario_of({"duration": 1.0, "steering": steering}, "s.toml")


def test_rows_are_bounded():
    with pytest.raises(InputError, match=r"too many rows of 1000 s .*one every 0\.002 s"):
        scenario_of({"duration": 1000.0, "output_interval": 1e-6}, "s.toml")


FILES = {
    "nested": (b"a = " + b"[" * 1000 + b"]" * 1000, "nests its tables too deeply"),
    "Latin-1": (b'set = "\xff"', "not UTF-8"),
    "NUL": (b"\0" * 100, "not valid TOML"),
    "UTF-16": ("duration = 1.0".encode("utf-16"), "not UTF-8"),
    "nothing": (b"", "duration is missing"),
}


@pytest.mark.parametrize("name", FILES)
def test_damaged_files_are_one_sentence(name, tmp_path):
    content, says = FILES[name]
    (tmp_path / "s.toml").write_bytes(content)
    with pytest.raises(InputError, match=says):
        read_scenario(tmp_path / "s.toml")


@pytest.mark.parametrize("name", ["n" * 300, "a\0b", "", "/", "\udcff"])
def test_names_that_no_file_has_are_one_sentence(name):
    with pytest.raises(InputError):
        read_scenario(name)
    tables = {"scenario": name, "grid": {"wind.speed": [5.0]}}
    with pytest.raises(InputError):
        study_of(tables, "study.toml", Path())


def test_a_byte_order_mark_is_no_fault(tmp_path):
    (tmp_path / "s.toml").write_bytes("\ufeffset = 'sport'\r\nduration = 1.0\r\n".encode())
    assert read_scenario(tmp_path / "s.toml").times.duration == 1.0


@pytest.mark.skipif(os.name != "posix", reason="pipes with names, and /dev/zero")
def test_what_has_no_end_is_not_read_for_ever(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    assert read_toml(tmp_path / "pipe") == {}
    with pytest.raises(InputError, match="more than 16 MB"):
        read_toml(Path("/dev/zero"))


STICKS = {
    "a column twice": ("t,steer,steer\n0,1,1\n", "the column steer is given twice"),
    "a long cell": (f"t,steer\n0,{'1' * 200_000}\n", "field larger than field limit"),
}


@pytest.mark.parametrize("name", STICKS)
def test_sticks_of_odd_tables(name, tmp_path):
    text, says = STICKS[name]
    (tmp_path / "stick.csv").write_text(text)
    with pytest.raises(InputError, match=says):
        read_programmed_stick(tmp_path / "stick.csv", parameter_set("sport"))


def test_a_section_that_is_no_table_is_refused_in_a_study_too():
    tables = {"scenario": {"kite": 3}, "grid": {"wind.speed": [5.0]}}
    with pytest.raises(InputError, match="kite must be a table of named values, got 3"):
        study_of(tables, "study.toml", Path())


def test_flights_are_counted_before_they_are_made():
    axis = {"from": 0.0, "to": 1.0, "count": 10_000_000}
    grid = {name: dict(axis) for name in ("kite.mass", "kite.span", "kite.area", "wind.speed")}
    with pytest.raises(InputError, match="flights are too many"):
        design_of({"grid": grid}, "study.toml")
