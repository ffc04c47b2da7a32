"""Scenario files: what they mean, and the one sentence for each thing that is wrong."""

from math import radians
from pathlib import Path

import numpy as np
import pytest

from kitemj.errors import InputError
from kitemj.flight.scenario import parameters_named, read_scenario, scenario_of
from kitemj.physics.aerodynamics import TableAero
from kitemj.physics.parameter_files import parameter_set, set_names
from kitemj.physics.steering import control, rest_ell

SHIPPED = sorted((Path(__file__).parents[2] / "scenarios").glob("*.toml"))
MINUTE = {"set": "laksa", "duration": 60.0}


def test_both_named_sets_ship():
    assert {"laksa", "thesis"} <= set(set_names())
    assert parameter_set("laksa").lines.length == 200.0
    assert parameter_set("thesis").lines.length == 80.0
    assert parameter_set("thesis").aero.Cm_alpha == -0.7633


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_shipped_scenarios_are_readable(path):
    scenario = read_scenario(path)
    assert scenario.output_times[0] == 0.0
    assert scenario.output_times[-1] == pytest.approx(scenario.times.duration)


def test_any_field_can_be_overridden_and_angles_given_in_degrees():
    tables = {
        **MINUTE,
        "kite": {"mass": 5.0},
        "lines": {"length": 120.0},
        "limits": {"beta_max_deg": 12.0},
        "steering": {"programme": "sine", "delta_amplitude_deg": 8.0, "delta_frequency": 0.1},
    }
    scenario = scenario_of(tables, "test")
    assert scenario.parameters.kite.mass == 5.0
    assert scenario.parameters.limits.beta_max == radians(12.0)
    assert scenario.programme.ell == rest_ell(120.0, 2.9)
    assert scenario.programme.delta_amplitude == radians(8.0)


def test_table_programme_goes_through_its_rows():
    rows = {"t": [0.0, 20.0, 40.0, 60.0], "delta": [0.0, 0.05, -0.05, 0.0], "ell": [199.0] * 4}
    programme = scenario_of({**MINUTE, "steering": {"programme": "table", **rows}}, "t").programme
    for t, delta in zip(rows["t"], rows["delta"], strict=True):
        c = control(programme, t)
        assert (c.ell, c.delta) == pytest.approx((199.0, delta), abs=1e-12)
    ahead, behind = control(programme, 20.0 + 1e-6), control(programme, 20.0 - 1e-6)
    assert ahead.delta_ddot == pytest.approx(behind.delta_ddot, abs=1e-8)


def test_general_coefficient_table_takes_the_place_of_the_linear_law():
    """Filled with the linear law's terms it gives the linear law's equilibrium."""
    linear = parameter_set("laksa")
    table = np.zeros((6, 8, 3))
    aero = linear.aero
    table[0, 0, :2], table[1, 1, 0] = (aero.Cx_0, aero.Cx_alpha), aero.Cy_beta
    table[2, 0, :2], table[4, 0, :2] = (aero.Cz_0, aero.Cz_alpha), (aero.Cm_0, aero.Cm_alpha)
    scenario = scenario_of({**MINUTE, "aero": {"law": "table", "table": table.tolist()}}, "test")
    assert isinstance(scenario.parameters.aero, TableAero)
    same = scenario_of(MINUTE, "test").start.q
    assert scenario.start.q == pytest.approx(tuple(same), abs=1e-14)


def test_start_is_offset_from_equilibrium_or_given_outright():
    rest = scenario_of(MINUTE, "test").start.q
    moved = scenario_of({**MINUTE, "start": {"phi_deg": 2.0, "eta_dot": 0.1}}, "test").start
    assert moved.q.phi == radians(2.0)
    assert moved.q.gamma == rest.gamma
    assert moved.q_dot.eta == 0.1
    outright = scenario_of({**MINUTE, "start": {"at": "state", "gamma": 0.3}}, "test").start
    assert tuple(outright.q) == (0.0, 0.3, 0.0, 0.0)


BAD = {
    "misspelt key": ({"kite": {"mas": 4.0}}, r"kite\.mas is not known: did you mean 'mass'"),
    "misspelt section": ({"wnd": {}}, r"wnd is not known: did you mean 'wind'"),
    "negative mass": ({"kite": {"mass": -4.0}}, r"kite\.mass must be > 0 kg, got -4\.0 kg"),
    "word for wind": ({"wind": {"speed": "fast"}}, r"wind\.speed must be a number in m/s, got 'f"),
    "not a number": ({"kite": {"mass": float("nan")}}, r"kite\.mass must be a finite number"),
    "lines too short": ({"lines": {"length": 2.0}}, r"lines\.length must be > kite\.y_A = 2\.9 m"),
    "ell too short": ({"steering": {"ell": 2.0}}, r"steering\.ell must stay > kite\.y_A = 2\.9 m"),
    "unknown set": ({"set": "lakse"}, r"no parameter set 'lakse'; there are: laksa"),
    "degrees as rad": ({"steering": {"delta": 8.0}}, r"steering\.delta must stay below π/2"),
    "both units": ({"limits": {"beta_max": 0.1, "beta_max_deg": 5.0}}, r"beta_max is given twice"),
    "no duration": ({"duration": 0.0}, r"duration must be > 0 s, got 0\.0 s"),
    "interval": ({"output_interval": 90.0}, r"output_interval must be <= duration = 60\.0 s"),
    "programme": ({"steering": {"programme": "sinus"}}, r"programme must be one of rest, sine"),
    "sine at rest": ({"steering": {"delta_amplitude": 0.1}}, r"add programme = \"sine\""),
    "short table": (
        {"steering": {"programme": "table", "t": [0.0, 1.0], "delta": [0.0, 0.1]}},
        r"steering\.t must reach from 0 s to the duration 60\.0 s",
    ),
    "ragged table": (
        {"steering": {"programme": "table", "t": [0.0, 60.0], "delta": [0.0]}},
        r"steering\.delta has 1 values where steering\.t has 2",
    ),
    "no lift": ({"wind": {"speed": 0.5}}, r"no equilibrium"),
    "impossible inertia": (
        {"kite": {"inertia_x": 99.0}},
        r"no rigid body has the principal moments",
    ),
    "skewed inertia": ({"kite": {"inertia_xz": 2.0}}, r"no rigid body has the principal moments"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_input_is_one_sentence_that_names_the_field(name):
    tables, sentence = BAD[name]
    with pytest.raises(InputError, match=sentence) as caught:
        scenario_of({**MINUTE, **tables}, "scenario.toml")
    assert "\n" not in str(caught.value)


def test_files_that_are_missing_or_not_toml(tmp_path):
    with pytest.raises(InputError, match="cannot read"):
        read_scenario(tmp_path / "none.toml")
    broken = tmp_path / "broken.toml"
    broken.write_text("set = ")
    with pytest.raises(InputError, match="not valid TOML"):
        read_scenario(broken)


def test_one_that_ships_is_found_by_its_name_from_anywhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    whole = read_scenario(next(path for path in SHIPPED if path.stem == "steer_200m"))
    for name in ("steer_200m", "steer_200m.toml", "scenarios/steer_200m.toml"):
        assert read_scenario(name) == whole
    with pytest.raises(InputError, match=r"cannot read steer_20m: .*that ship: gusts_200m, loops_"):
        read_scenario("steer_20m")
    with pytest.raises(InputError, match="cannot read other/steer_200m"):
        read_scenario("other/steer_200m")
    (tmp_path / "steer_200m").write_text("duration = 3.0")
    assert read_scenario("steer_200m").times.duration == 3.0, "a file of one's own comes first"
    assert parameters_named("sport") == parameter_set("sport")
    with pytest.raises(InputError, match="sets: laksa, sport, thesis, trainer"):
        parameters_named("spork")
