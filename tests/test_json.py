"""`--json`: one document on stdout, with the numbers that the program itself has."""

import json
from math import inf, nan

import numpy as np
import pytest
from pyarrow import parquet

from kitemj.cli import main
from kitemj.data_files import SCENARIOS, shipped_or_file
from kitemj.equilibria.modes import stability
from kitemj.equilibria.tables import trim_table
from kitemj.equilibria.trim import equilibria, lines_held
from kitemj.errors import InputError
from kitemj.flight.compare import compare_models
from kitemj.flight.reach import reach_of
from kitemj.flight.scenario import read_scenario
from kitemj.metadata import about_columns, about_csv
from kitemj.physics.parameter_files import parameter_set
from kitemj.recording.file import read_recording
from kitemj.tables import Table, json_text, write
from tests.recording.flights import recorded

PAIR = ["mujoco", "lagrange"]


@pytest.fixture
def short(tmp_path):
    path = tmp_path / "short.toml"
    path.write_text(shipped_or_file("steer_200m", SCENARIOS).read_text().replace("60.0", "5.0"))
    return path


@pytest.fixture
def printed(capsys):
    """What a command with ``--json`` prints, and its exit status."""

    def run(*words):
        status = main([*map(str, words), "--json"])
        out, err = capsys.readouterr()
        assert err == ""
        return json.loads(out, parse_constant=pytest.fail), status

    return run


@pytest.mark.parametrize(("step", "status"), [(0.002, 0), (0.05, 1)])
def test_compare(short, printed, step, status):
    found, left = printed("compare", short, "--models", "mujoco,lagrange", "--step", step)
    [told], [row] = found["comparisons"], compare_models(read_scenario(short), PAIR, step)
    assert left == status
    assert told["agree"] == row.agrees == (status == 0)
    assert (told["position_m"], told["position_at_s"]) == row.position
    assert (told["attitude_rad"], told["attitude_at_s"]) == row.attitude
    assert (told["tension_N"], told["tension_at_s"]) == row.tension
    assert [told[name] for name in ("model", "reference", "until_s", "valid_s")] == [*row[1:5]]
    assert found["tolerances"]["position_m"] == 1e-6


def test_ladder(printed):
    found, status = printed("compare", "rest_200m", "--ladder")
    assert status == 0
    assert {rung["model"] for rung in found["rungs"]} == {"newton-euler", "mujoco"}
    unmeasured = [rung["rung"] for rung in found["rungs"] if rung["measured"] is None]
    assert unmeasured == ["order", "order"], "a kite at rest has none"
    assert all(rung["holds"] for rung in found["rungs"])


def test_trim_and_stability(printed):
    scenario = read_scenario("rest_200m")
    held = lines_held(scenario.parameters, scenario.programme)
    trims = equilibria(scenario.parameters, *held, "lagrange", scenario.source)
    found, status = printed("trim", "rest_200m", "--models", "lagrange")
    modes = stability(scenario.parameters, *held, "lagrange", scenario.source)
    notes = [f"{trims[0].in_words}: {modes.in_words}"]
    assert (found, status) == ({"equilibria": trim_table(trims).records(), "notes": notes}, 0)
    found, status = printed("stability", "rest_200m")
    assert found["modes"] == modes.tables()[0].records()
    assert found["linear system"]["A"] == modes.linear.A.tolist()
    assert (found["stable"], status) == (True, 0)


def test_questions_of_stability(printed):
    vary = ("stability", "rest_200m", "--vary", "aero.Cl_beta", "--range", "-0.6", "0")
    [crossing] = printed(*vary)[0]["changes of stability"]
    assert crossing["parameter"] == "aero.Cl_beta"
    assert crossing["stable"] == "above"
    map_ = ("stability", "rest_200m", "--map", "aero.Cl_beta", "-0.6", "0", "kite.mass", "3", "5")
    points = printed(*map_, "--points", "3")[0]["stability map"]
    assert len(points) == 9
    growing = {point["aero.Cl_beta"]: point["real_per_s"] > 0 for point in points}
    assert growing[-0.6]
    assert not growing[0.0]


def test_reach(printed):
    found, status = printed("reach", "thesis", "--arm", "0.2")
    parameters = parameter_set("thesis")
    reach = reach_of(0.2, parameters.lines.length, 2 * parameters.kite.y_A)
    assert ([*found.values()], status) == ([*reach], 0)
    assert (found["arm_m"], found["delta_rad"]) == (reach.arm, reach.delta)


def test_info(printed, tmp_path):
    path = recorded(tmp_path / "x.arrows", 20, {"set": "sport", "duration": 9.0})
    recording = read_recording(path)
    found, status = printed("info", path)
    assert (found["ticks"], len(found["flights"]), status) == (20, 1, 0)
    [flight], columns = found["flights"], recording.columns
    assert flight["duration_s"] == columns["t_s"][-1]
    assert flight["gap_m"] == columns["gap_m"].max()
    assert flight["alpha_max_deg"] == columns["alpha_deg"].max()
    pulls = np.stack([columns["tension_plus_N"], columns["tension_minus_N"]])
    assert (flight["tension_min_N"], flight["tension_max_N"]) == (pulls.min(), pulls.max())
    assert found["header"]["parameters"]["kite"]["mass"] == recording.parameters.kite.mass


def test_a_number_that_json_lacks_is_null():
    text = json_text([Table("t", ("a", "b"), [(nan, 1.0)])], {"c": [[inf, 2]], "d": "x"})
    assert json.loads(text) == {"t": [{"a": None, "b": 1.0}], "c": [[None, 2]], "d": "x"}


def test_tables_that_are_written_say_what_they_are(tmp_path):
    table = Table("standing", ("wind_m_s", "stable"), [(6.0, True), (7.0, False)])
    about = {"scenario": "mine.toml"}
    for name in ("a.csv", "a.parquet", "a.json"):
        write(tmp_path / name, [table], {}, False, about)
    told = about_columns(parquet.read_schema(tmp_path / "a.parquet").metadata)
    assert told["scenario"] == "mine.toml"
    assert told["holds"] == "standing"
    assert told["written_by"].startswith("kitemj ")
    assert about_csv(tmp_path / "a.csv") == told
    assert (tmp_path / "a.csv").read_text() == "wind_m_s,stable\n6.0,True\n7.0,False\n"
    names = {"a.csv", "a.csv-metadata.json", "a.parquet", "a.json"}
    assert {file.name for file in tmp_path.iterdir()} == names
    (tmp_path / "a.csv").unlink()
    with pytest.raises(InputError, match=r"a\.csv-metadata\.json exists"):
        write(tmp_path / "a.csv", [table], {}, False)
