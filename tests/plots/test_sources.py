"""The same flight out of every kind of file; what holds none is refused in a sentence."""

import errno
import json
from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet

from kitemj.errors import InputError
from kitemj.files import NewFile
from kitemj.flight.motion_table import COLUMNS, write_csv
from kitemj.flight.scenario import scenario_of
from kitemj.flight.simulate import simulate
from kitemj.metadata import about_csv, metadata_file
from kitemj.physics.parameter_files import parameter_set
from kitemj.plots.sources import ROWS, read_flight
from kitemj.recording.export import write_table
from kitemj.recording.file import read_recording
from tests.plots.flights import TOML, simulation
from tests.recording.flights import recorded

SPORT = {"set": "sport", "duration": 60.0}


@pytest.fixture
def scenario(tmp_path):
    path = tmp_path / "eight.toml"
    path.write_text(TOML)
    return path


@pytest.fixture
def recording(tmp_path):
    return recorded(tmp_path / "x.arrows", 40, SPORT)


def test_a_scenario_is_flown_finer_than_its_rows(scenario):
    flight = read_flight(scenario)
    own = [motion.t for motion in simulation().motions]
    assert len(flight.t) > ROWS
    assert np.allclose([flight.t[np.argmin(np.abs(flight.t - t))] for t in own], own, atol=1e-12)
    assert not flight.notes
    assert flight.name == "eight.toml, lagrange"
    assert read_flight(Path("rest_200m")).name == "rest_200m.toml, lagrange"
    assert read_flight(scenario, "newton-euler").name.endswith("newton-euler")


def test_a_recording_and_its_table_are_the_same_flight(recording, tmp_path):
    flight = read_flight(recording)
    kept = read_recording(recording)
    table = tmp_path / "x.csv"
    write_table(table, kept)
    again = read_flight(table)
    for name in ("t_s", "theta_rad", "omega_x_B_rad_s", "tension_minus_N", "ground"):
        assert np.array_equal(flight.columns[name], kept.columns[name])
        assert np.array_equal(again.columns[name], kept.columns[name])
    assert again.parameters == flight.parameters == kept.parameters == parameter_set("sport")
    assert not flight.notes
    assert not again.notes
    assert again.parameters.limits == flight.parameters.limits


def test_the_longest_flight_unless_one_is_asked_for(tmp_path):
    path = recorded(tmp_path / "two.arrows", 10, episodes=2)
    flight = read_flight(path)
    assert len(flight.t) == 11
    assert flight.notes == ("two.arrows holds 2 flights; drawn is the longest, flight 1",)
    assert read_flight(path, episode=2).name.endswith("flight 2 of 2")
    table = tmp_path / "two.csv"
    write_table(table, read_recording(path))
    second = read_flight(table, episode=2)
    assert np.array_equal(second.columns["leg"], np.full(11, 1))
    for file in (path, table):
        with pytest.raises(InputError, match=r"episode must be 1 to 2 for two\..*, got 3"):
            read_flight(file, episode=3)


def test_a_table_says_itself_which_kite_flew_it(tmp_path):
    """Also one of no set, whose lines would fit some other."""
    tables = {"set": "sport", "duration": 0.5, "kite": {"mass": 0.3}, "wind": {"speed": 6.0}}
    flight = simulate(scenario_of(tables, "mine.toml"), "lagrange")
    path = tmp_path / "flight.csv"
    write_csv(path, flight)
    again = read_flight(path)
    assert again.parameters == flight.scenario.parameters
    assert again.name == "flight.csv, lagrange"
    assert not again.notes
    assert about_csv(path)["scenario"] == "mine.toml"
    header, *rows = path.read_text().splitlines()
    assert header.split(",") == list(COLUMNS)  # every program reads it as it is
    assert len(rows) == len(flight.motions)
    path.write_text("\n".join([header, *rows[:-1]]))  # it is another table now
    assert "which kite flew it, or was changed since" in read_flight(path).notes[0]


@pytest.mark.parametrize(
    "content", [b"", b"[]", b"{}", b'{"notes": []}', b'{"notes": [[]]}', b"\xff"]
)
def test_a_table_of_which_nothing_is_told_is_a_guess_and_says_so(tmp_path, content):
    path = tmp_path / "flight.csv"
    write_csv(path, simulation())
    metadata_file(path).write_bytes(content)
    flight = read_flight(path)
    assert flight.parameters == parameter_set("sport")
    [note] = flight.notes
    assert "sport is a guess, which fits its lines; the option kite says it: a set, or" in note
    assert not read_flight(path, kite="sport").notes
    with pytest.raises(InputError, match=r"was not flown by laksa: its lines end .* m from where"):
        read_flight(path, kite="laksa")


def test_a_guess_names_the_sets_that_fit_as_well(tmp_path):
    path = tmp_path / "flight.csv"
    write_csv(path, simulate(scenario_of({"set": "thesis", "duration": 0.1}, "test"), "lagrange"))
    assert read_flight(path).parameters == parameter_set("thesis")
    metadata_file(path).unlink()
    assert "laksa is a guess, which fits its lines (so does thesis)" in read_flight(path).notes[0]


def test_what_is_told_of_a_table_is_complete_or_refused(tmp_path):
    path = tmp_path / "flight.csv"
    write_csv(path, simulation())
    told = json.loads(metadata_file(path).read_text())
    del told["notes"][0]["kitemj"]["parameters"]["kite"]["mass"]
    metadata_file(path).write_text(json.dumps(told))
    with pytest.raises(InputError, match=r"flight.csv does not say kite.mass: it is damaged"):
        read_flight(path)


def test_nothing_told_of_a_table_is_written_over_unasked(tmp_path):
    path = tmp_path / "flight.csv"
    metadata_file(path).write_text("mine")
    with pytest.raises(InputError, match=r"flight\.csv-metadata\.json exists"):
        write_csv(path, simulation())
    assert [file.name for file in tmp_path.iterdir()] == ["flight.csv-metadata.json"]
    write_csv(path, simulation(), overwrite=True)
    assert not read_flight(path).notes


def test_a_table_and_what_is_told_of_it_are_there_both_or_none(tmp_path, monkeypatch):
    keep = NewFile.keep

    def refused(new):
        if new.path.suffix == ".json":
            raise OSError(errno.ENOSPC, "No space left on device", str(new.path))
        keep(new)

    with monkeypatch.context() as patch:
        patch.setattr(NewFile, "keep", refused)
        with pytest.raises(OSError, match="No space left"):
            write_csv(tmp_path / "flight.csv", simulation())
        assert list(tmp_path.iterdir()) == []
    write_csv(tmp_path / "flight.csv", simulation())
    assert len(list(tmp_path.iterdir())) == 2


def test_a_kite_of_no_set_must_be_named(tmp_path):
    text = TOML + "kite = { y_A = 0.45 }\n"
    scenario = tmp_path / "wide.toml"
    scenario.write_text(text)
    columns = dict(read_flight(scenario).columns)
    path = tmp_path / "wide.parquet"
    parquet.write_table(pa.table(columns), path)
    with pytest.raises(InputError, match=r"was not flown by laksa or .*; give another kite"):
        read_flight(path)
    assert read_flight(path, kite=str(scenario)).parameters.kite.y_A == 0.45


BAD = {
    "none.arrows": (None, "does not exist; give a recording"),
    "empty.arrows": (b"", "is empty"),
    "text.arrows": (b"once upon a time", "is not a recording"),
    "empty.csv": (b"", "is not a table that can be read"),
    "header.csv": (b"t_s,alpha_deg\n", "holds no row"),
    "ragged.csv": (b"t_s,alpha_deg\n0.0,1.0\n2.0\n", "is not a table that can be read"),
    "broken.parquet": (b"PAR1 nothing", "is not a table that can be read"),
    "other.csv": (b"name,age\nann,3\n", "lacks the column t_s, needed for every figure"),
    "back.csv": (b"t_s,alpha_deg\n1.0,1.0\n0.5,1.0\n", "t_s must rise"),
    "text.csv": (b"t_s,alpha_deg\nnow,1.0\n", "holds text in the column t_s"),
    "bare.csv": (
        b"t_s,alpha_deg\n0.0,1.0\n1.0,1.0\n",
        "does not say which kite flew it, and lacks",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_files_that_hold_no_flight(name, tmp_path):
    content, says = BAD[name]
    path = tmp_path / name
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(InputError, match=says) as told:
        read_flight(path)
    assert "\n" not in str(told.value)


def test_words_that_mean_nothing_with_a_file(scenario, recording, tmp_path):
    with pytest.raises(InputError, match="is a folder; give a recording"):
        read_flight(tmp_path)
    with pytest.raises(InputError, match="model is for a scenario"):
        read_flight(recording, model="lagrange")
    with pytest.raises(InputError, match="episode is for a recording"):
        read_flight(scenario, episode=1)
    with pytest.raises(InputError, match="kite is for a table"):
        read_flight(recording, kite="sport")
    with pytest.raises(InputError, match="there is no model 'x'"):
        read_flight(scenario, model="x")
