"""A package of somebody else's brings a law of the air and a wind, and is found by their names.

This walks "How to add" of CONTRIBUTING: nothing of kitemj is touched.
"""

import csv
import json
import os
import subprocess
import sys
from math import exp
from typing import NamedTuple

import pytest
from pyarrow.parquet import read_table

from kitemj.equilibria.vary import parameter_names, unit_of, value_of, with_value
from kitemj.errors import InputError
from kitemj.physics.aerodynamics import LinearAero, aero_law
from kitemj.physics.parameter_files import AERO_LAWS, parameter_set, parameter_tables
from kitemj.registry import Registry, use

LAWS = """
from math import cos, exp, sin, tanh
from typing import Annotated, NamedTuple

from kitemj.dynamics.lagrange_kite import LagrangeKite
from kitemj.physics.aerodynamics import Coefficients, LinearAero, aero_law, linear_coefficients
from kitemj.physics.compiled import compiled
from kitemj.physics.quantity import Quantity
from kitemj.physics.vectors import Vector
from kitemj.physics.wind import wind_law


class SoftStall(NamedTuple):
    linear: LinearAero
    alpha_soft: Annotated[float, Quantity("rad", "where the lift levels off", gt=0)]


@aero_law.of(SoftStall)
@compiled
def soft_stall(aero, kite, alpha, beta, omega_B, airspeed):
    C = linear_coefficients(aero.linear, kite, alpha, beta, omega_B, airspeed)
    bent = aero.alpha_soft * tanh(alpha / aero.alpha_soft)
    return Coefficients(
        C.x, C.y, aero.linear.Cz_0 + aero.linear.Cz_alpha * bent, C.l, C.m, C.n
    )


class Jet(NamedTuple):
    speed: Annotated[float, Quantity("m/s", "far from the jet", ge=0)]
    strength: Annotated[float, Quantity("", "of the jet, part of the speed")] = 0.5
    height: Annotated[float, Quantity("m", "of the jet", gt=0)] = 30.0
    growth: Annotated[float, Quantity("1/m", "of the wind over the way downwind")] = 0.0
    veer: Annotated[float, Quantity("rad/m", "the wind turns with height")] = 0.0
    pulse: Annotated[float, Quantity("rad/s", "the jet swells and ebbs")] = 0.0
    azimuth: Annotated[float, Quantity("rad", "turns the wind about z_E")] = 0.0


@wind_law.of(Jet)
@compiled
def jet(wind, p_E, t):
    far = (-p_E.z - wind.height) / wind.height
    downwind = -p_E.x * cos(wind.azimuth) - p_E.y * sin(wind.azimuth)
    V = wind.speed * (1 + wind.strength * cos(wind.pulse * t) * exp(-far * far))
    V *= 1 + wind.growth * downwind
    towards = wind.azimuth - wind.veer * p_E.z
    return Vector(-V * cos(towards), -V * sin(towards), 0.0)


class SameAgain(LagrangeKite):
    name = "same-again"
"""
SCENARIO = """
set = "sport"
duration = 0.5

[wind]
law = "jet"
azimuth_deg = 20.0

[aero]
law = "soft-stall"
alpha_soft = 0.35
linear.Cm_0 = 0.12

[start]
phi_deg = 3.0
"""
RECORD = """
from pathlib import Path
from kitemj.flight.live import Command
from kitemj.flight.scenario import read_scenario, scenario_of
from kitemj.recording.live import LiveFlight

def record(scenario, model, path):
    with LiveFlight(scenario, model, "lagrange", record=Path(path)) as flight:
        for _ in range(40):
            flight.tick(Command(0.5))

record(read_scenario(Path("theirs.toml")), "mujoco", "theirs.arrows")
record(scenario_of({"set": "sport", "duration": 1.0}, "test"), "same-again", "model.arrows")
"""
STUDY = """
scenario = "theirs.toml"
model = "lagrange"
[grid]
"wind.strength" = [0.2, 0.6]
"aero.linear.Cm_0" = [0.12, 0.13, 0.14]
"""
TRIM = """
import json
from math import exp, tan
from kitemj.errors import InputError
from kitemj.physics.parameter_files import parameter_set
from kitemj.equilibria.trim import equilibria, trimmed

WIND = {"law": "jet", "speed": 5.0, "azimuth_deg": 20.0, "growth": 0.01}

def refused(**more):
    try:
        trimmed(parameter_set("sport", {"wind": WIND | more}), source="test")
    except InputError as error:
        return str(error)

def equilibrium(wind):
    return equilibria(parameter_set("sport", {"wind": wind}), model="mujoco")[0]

found = equilibrium(WIND)
far = (found.height - 30.0) / 30.0
downwind = found.height / tan(found.elevation)
speed = 5.0 * (1 + 0.5 * exp(-far * far)) * (1 + 0.01 * downwind)
level = equilibrium({"speed": speed, "azimuth_deg": 20.0})
scalar = trimmed(parameter_set("sport", {"wind": WIND}))[0][:4].tolist()
print(json.dumps([found.q, scalar, level.q, refused(veer=0.01), refused(pulse=1.0)]))
"""
POINTS = """
[kitemj.aero_laws]
soft-stall = my_kites:SoftStall
[kitemj.winds]
jet = my_kites:Jet
[kitemj.models]
same-again = my_kites:SameAgain
"""
SAME = 1e-7
"""rad; Newton's method leaves 1e-10 of the weight, and angles answer with less than a thousand."""
STILL = 1e-9
"""m/s; the kite stands, and columns hold 17 digits."""


@pytest.fixture(scope="module")
def desk(tmp_path_factory):
    """A folder to work in, and the package as pip would leave it in another one."""
    folder = tmp_path_factory.mktemp("desk")
    about = folder / "packages" / "my_kites-1.2.dist-info"
    about.mkdir(parents=True)
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: my_kites\nVersion: 1.2\n")
    (about / "entry_points.txt").write_text(POINTS)
    (folder / "packages" / "my_kites.py").write_text(LAWS)
    (folder / "theirs.toml").write_text(SCENARIO)
    (folder / "study.toml").write_text(STUDY)
    run(folder, "-c", RECORD)
    return folder


def run(folder, *words, package=True, status=0):
    """What a program says."""
    paths = [*sys.path, *([str(folder / "packages")] if package else [])]
    env = {"PYTHONPATH": os.pathsep.join(paths)}
    done = subprocess.run(
        [sys.executable, *words],
        cwd=folder,
        env=os.environ | env,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == status, done.stderr
    return done.stdout if status == 0 else done.stderr


def kitemj(folder, *words, **how):
    return run(folder, "-m", "kitemj", *words, **how)


def test_the_kite_feels_the_wind_of_the_scenario(desk):
    kitemj(desk, "replay", "theirs.arrows", "--export", "csv", "--output", "theirs.csv")
    with (desk / "theirs.csv").open() as file:
        still = next(csv.DictReader(file))
    far = (-float(still["z_E_m"]) - 30.0) / 30.0
    speed = parameter_set("sport").wind.speed * (1 + 0.5 * exp(-far * far))
    assert float(still["airspeed_m_s"]) == pytest.approx(speed, abs=STILL)


def test_the_three_models_agree_with_them(desk):
    assert kitemj(desk, "compare", "theirs.toml").count("yes") == 2


def test_their_equilibrium_is_that_of_a_constant_wind_as_at_the_kite(desk):
    found, scalar, level, veering, pulsing = json.loads(run(desk, "-c", TRIM))
    assert found == pytest.approx(level, abs=SAME)
    assert scalar == pytest.approx(level, abs=SAME)
    for refused in (veering, pulsing):
        assert "needs a wind that is steady and blows along its azimuth, this Jet" in refused


def test_a_recording_names_who_brought_them_and_replays(desk):
    told = kitemj(desk, "info", "theirs.arrows")
    assert "aerodynamic law soft-stall my_kites 1.2" in told
    assert "wind jet my_kites 1.2" in told
    assert "wind.law = jet" in told
    again = kitemj(desk, "replay", "theirs.arrows", "--headless", "--model", "mujoco")
    assert "identical to the last bit" in again


def test_without_the_package_a_recording_is_refused_in_one_sentence(desk):
    refused = kitemj(desk, "info", "theirs.arrows", package=False, status=2)
    assert refused == (
        "kitemj: theirs.arrows was flown with the aerodynamic law 'soft-stall' of my_kites 1.2: "
        "install the package, or use the module, that adds it\n"
    )
    refused = kitemj(desk, "simulate", "theirs.toml", "--output", "x.csv", package=False, status=2)
    assert "aero.law must be one of linear, table, got 'soft-stall' (theirs.toml" in refused


def test_a_recording_of_a_model_that_is_not_here_is_read_and_flown_by_others(desk):
    words = ("replay", "model.arrows", "--headless", "--model")
    assert "identical to the last bit" in kitemj(desk, *words, "same-again")
    told = "model.arrows was flown with the model 'same-again' of my_kites 1.2: install"
    assert told in kitemj(desk, "info", "model.arrows", package=False)
    assert told in kitemj(desk, *words, "same-again", package=False, status=2)
    assert "largest gap  0 µm" in kitemj(desk, *words, "lagrange", package=False)


def test_a_module_that_is_used_is_known_to_the_processes_of_a_study(desk):
    """The same without an installation."""
    added = 'AERO_LAWS.add("soft-stall", SoftStall)\nWINDS.add("jet", Jet)\n'
    adds = f"{LAWS}\nfrom kitemj.physics.parameter_files import AERO_LAWS, WINDS\n{added}"
    (desk / "mine.py").write_text(adds)
    words = ("sweep", "study.toml", "--use", "mine", "--processes", "1", "--output", "rows.parquet")
    kitemj(desk, *words, package=False)
    rows = read_table(desk / "rows.parquet").to_pylist()
    assert [row["ending"] for row in rows] == ["finished"] * 6  # three here, three in a process
    assert len({row["alpha_max_deg"] for row in rows}) == 6


class Nested(NamedTuple):
    """A law whose numbers are partly those of another."""

    linear: LinearAero
    factor: float


@pytest.fixture
def nested(monkeypatch):
    monkeypatch.setitem(aero_law.formulas, Nested, lambda *arguments: None)
    monkeypatch.setitem(AERO_LAWS._loaded, "nested", Nested)


def test_a_law_within_a_law_survives_files(nested):
    linear = parameter_set("sport").aero
    law = {"law": "nested", "factor": 2.0, "linear": {"Cm_0": 0.5}}
    made = parameter_set("sport", {"aero": law})
    assert made.aero == Nested(linear._replace(Cm_0=0.5), 2.0)
    kept = json.loads(json.dumps(parameter_tables(made)))
    assert parameter_set("laksa", kept) == made


def test_numbers_of_a_law_within_a_law_can_be_varied(nested):
    made = parameter_set("sport", {"aero": {"law": "nested", "factor": 2.0}})
    assert {"aero.linear.Cm_alpha", "aero.factor"} <= set(parameter_names(made))
    assert unit_of(made, "aero.linear.Cm_alpha") == "1/rad"
    assert value_of(with_value(made, "aero.linear.Cm_alpha", -2.0), "aero.linear.Cm_alpha") == -2.0


@pytest.mark.parametrize(
    ("aero", "told"),
    [
        ({"factor": 2.0, "linear": {"V_ref": -1.0}}, "aero.linear.V_ref must be > 0 m/s, got -1.0"),
        ({"factor": 2.0, "linear": {"Cm": 1.0}}, "aero.linear.Cm is not known"),
        ({"factor": 2.0, "linear": 1.0}, "aero.linear"),
        ({}, "aero.factor is missing"),
    ],
)
def test_what_is_wrong_within_a_law_is_said_by_its_name(nested, aero, told):
    with pytest.raises(InputError, match=told):
        parameter_set("sport", {"aero": {"law": "nested", **aero}})


def test_a_law_without_a_formula_and_a_wind_without_a_speed_are_refused(monkeypatch):
    monkeypatch.setitem(AERO_LAWS._loaded, "bare", Nested)
    with pytest.raises(InputError, match="'bare' has no formula"):
        parameter_set("sport", {"aero": {"law": "bare"}})


def test_a_module_that_cannot_be_used_is_one_sentence(tmp_path, monkeypatch):
    (tmp_path / "broken_law.py").write_text("1 / 0\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    with pytest.raises(InputError, match="'broken_law': ZeroDivisionError: division by zero"):
        use("broken_law")
    with pytest.raises(InputError, match="'not_there': ModuleNotFoundError"):
        use("not_there.py")


def test_a_name_is_given_once():
    registry = Registry("thing", "kitemj.nothing", {"ours": "kitemj.registry:Registry"})
    registry.add("mine", Nested)
    registry.add("mine", Nested)
    for name in ("ours", "mine"):
        with pytest.raises(InputError, match=f"there is a thing '{name}' already"):
            registry.add(name, LinearAero)
    assert list(registry) == ["ours", "mine"]
    with pytest.raises(InputError, match="no thing 'yours'; there are: ours, mine"):
        registry["yours"]
