"""The front door: `import kitemj` is quick, and its names are all that a stranger needs."""

import ast
import os
import subprocess
import sys
from importlib.metadata import version
from itertools import pairwise
from pathlib import Path

import av
import numpy as np
import pyarrow as pa
import pytest

import kitemj
from kitemj.cli import main
from kitemj.flight.motion_table import COLUMNS
from kitemj.recording.table import ALL
from kitemj.tables import unit_of_column

ROOT = Path(__file__).parent.parent
HEAVY = ("numba", "numpy", "mujoco", "pygame", "pyarrow", "matplotlib", "scipy", "rich", "typing")
SHORT = {"set": "sport", "duration": 1.0, "output_interval": 0.1}
WEAVE = """
import kitemj

class Weave:
    def command(self, motion):
        return kitemj.Command(delta=0.2 - 0.3 * kitemj.sight(motion).azimuth)
"""


class Weave:
    """Leans to one side and back to the middle."""

    def command(self, motion):
        return kitemj.Command(delta=0.2 - 0.3 * kitemj.sight(motion).azimuth)


@pytest.fixture(scope="module")
def flight():
    return kitemj.simulate(SHORT, "lagrange")


@pytest.fixture(scope="module")
def steered():
    return kitemj.simulate(SHORT, "lagrange", pilot=Weave())


def test_nothing_is_loaded_before_it_is_asked_for():
    code = f"import sys, kitemj; print([m for m in {HEAVY} if m in sys.modules])"
    bare = [sys.executable, "-S", "-c", f"import sys; sys.path[:0] = {sys.path}; {code}"]
    done = subprocess.run(bare, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_every_name_is_there_for_programs_and_for_editors():
    assert dir(kitemj) == sorted(kitemj.__all__)
    for name in kitemj.__all__:
        assert getattr(kitemj, name) is not None
    tree = ast.parse((ROOT / "kitemj" / "__init__.py").read_text(encoding="utf-8"))
    found = [node.names for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    typed = {name.name for names in found for name in names} - {"import_module", "version"}
    assert typed == set(kitemj.__all__) - {"__version__"}
    assert kitemj.__version__ == version("kitemj")
    with pytest.raises(AttributeError, match="no attribute 'simulat'"):
        _ = kitemj.simulat


def test_no_name_is_hidden_by_a_room():
    rooms = {path.stem for path in (ROOT / "kitemj").iterdir()}
    assert not rooms & set(kitemj.__all__)


def test_a_scenario_is_a_path_tables_or_itself(tmp_path):
    path = tmp_path / "short.toml"
    path.write_text('set = "sport"\nduration = 1.0\noutput_interval = 0.1\n')
    flights = [
        kitemj.simulate(given, "lagrange")
        for given in (path, str(path), SHORT, kitemj.as_scenario(SHORT))
    ]
    for each in flights:
        assert np.array_equal(each["theta_rad"], flights[0]["theta_rad"])
    assert flights[0].ending is kitemj.Ending.FINISHED
    assert len(flights[0]) == 11


def test_a_flight_is_a_table_with_units(flight):
    table = flight.table()
    assert isinstance(table, pa.Table)
    assert table.column_names[: len(COLUMNS)] == list(COLUMNS)
    units = {field.name: field.metadata[b"unit"].decode() for field in table.schema}
    assert units["t_s"] == "s"
    assert units["phi_rad"] == "rad"
    assert units["alpha_deg"] == "deg"
    assert units["vx_E_m_s"] == "m/s"
    assert units["omega_x_B_rad_s"] == "rad/s"
    assert np.array_equal(table["z_E_m"].to_numpy(), flight["z_E_m"])
    with pytest.raises(kitemj.InputError, match="did you mean 'alpha_deg'"):
        flight["alpha"]


def test_every_column_of_a_recording_has_the_unit_of_its_name():
    units = {name: unit_of_column(name) for name in ALL}
    assert units["ell_ddot_m_s2"] == "m/s²"
    assert units["delta_ddot_rad_s2"] == "rad/s²"
    assert units["lateness_s"] == "s"
    assert units["tension_minus_N"] == "N"
    for name in ("R_BE_xx", "ref_R_BE_zz", "stick_delta", "leg", "slack"):
        assert units[name] == "1"


def test_a_flight_is_drawn_as_plot_draws_it(flight):
    (left, *_) = flight.plot("tensions").axes[0].get_lines()
    assert np.array_equal(left.get_ydata(), flight["tension_plus_N"])
    with pytest.raises(kitemj.InputError, match="no figure 'tension'; there are: state"):
        flight.plot("tension")


def test_a_pilot_is_an_object_a_class_a_name_or_a_file(steered, tmp_path):
    (tmp_path / "weave.py").write_text(WEAVE)
    for pilot in (Weave, lambda: Weave(), f"{tmp_path / 'weave.py'}:Weave"):
        again = kitemj.simulate(SHORT, "lagrange", pilot=pilot)
        assert np.array_equal(again["eta_rad"], steered["eta_rad"])
    assert np.allclose(steered["t_s"], np.linspace(0.0, 1.0, 11), rtol=0, atol=1e-12)
    hold = kitemj.simulate(SHORT, "lagrange", pilot="hold")
    assert not np.array_equal(hold["eta_rad"], steered["eta_rad"])


def test_a_pilot_flies_into_the_ground():
    class Full:
        def command(self, motion):
            return kitemj.Command(delta=1.0)

    dive = kitemj.simulate(SHORT | {"duration": 20.0}, "mujoco", pilot=Full)
    assert dive.ending is kitemj.Ending.GROUND
    assert dive["ground"][-1]
    assert not dive["ground"][:-1].any()


BAD_PILOTS = {
    "name": (
        "helix",
        "there is no pilot 'helix'; there are: hold, loop, eight, assist, land, show",
    ),
    "no file": ("none.py:Weave", "none.py is no Python file"),
    "broken": ("broken.py:Weave", "broken.py cannot be loaded: ZeroDivisionError"),
    "no such": ("weave.py:Wave", "there is no Wave in weave.py"),
    "no pilot": ("weave.py:kitemj", "is not made without arguments"),
}


@pytest.mark.parametrize("case", BAD_PILOTS)
def test_who_cannot_fly_is_told_in_one_line(case, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "weave.py").write_text(WEAVE)
    (tmp_path / "broken.py").write_text("1 / 0")
    (tmp_path / "s.toml").write_text("duration = 1.0")
    pilot, says = BAD_PILOTS[case]
    assert main(["simulate", "s.toml", "--pilot", pilot, "--output", "x.csv"]) == 2
    told = capsys.readouterr().err
    assert says in told
    assert told.count("\n") == 1
    assert not (tmp_path / "x.csv").exists()


def test_the_command_line_flies_a_pilot_as_the_program_does(tmp_path, monkeypatch, steered):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "weave.py").write_text(WEAVE)
    (tmp_path / "s.toml").write_text('set = "sport"\nduration = 1.0\n')
    words = ["simulate", "s.toml", "--pilot", "weave.py:Weave", "--model", "lagrange"]
    assert main([*words, "--output", "x.csv"]) == 0
    again = kitemj.read_flight("x.csv")
    assert np.array_equal(again["eta_rad"], steered["eta_rad"])
    words = ["--duration", "0.3", "--size", "320x180", "--film", "x.mp4", "--no-record"]
    assert main(["fly", "s.toml", "--headless", "--pilot", "weave.py:Weave", *words]) == 0
    assert main(["fly", "s.toml", "--pilot", "eight", "--stick", "x.csv"]) == 2


def test_results_show_themselves_in_a_notebook(flight):
    rest = {"set": "laksa", "duration": 1.0}
    study = {"scenario": rest, "model": "lagrange", "grid": {"wind.speed": [6.0, 7.0]}}
    results = (
        (flight, ("lagrange", "data:image/png;base64,")),
        (kitemj.compare(rest), ("mujoco / lagrange", "newton-euler / lagrange")),
        (kitemj.trim(rest), ("elevation_deg",)),
        (kitemj.stability(rest), ("time_constant_s", "heave")),
        (kitemj.sweep(study), ("wind.speed", "finished")),
    )
    for result, parts in results:
        html = result._repr_html_()
        assert html.startswith("<table>")
        for part in parts:
            assert part in html


def test_html_is_escaped():
    flight = kitemj.simulate({"duration": 0.1}, "lagrange")
    html = kitemj.Flight("<b>", flight.parameters, flight.columns)._repr_html_()
    assert "<b>" not in html
    assert "&lt;b&gt;" in html


def test_a_study_of_tables_is_what_simulate_flies():
    study = {"scenario": SHORT, "model": "lagrange", "grid": {"wind.speed": [6.0, 7.0]}}
    found = kitemj.sweep(study)
    assert list(found["wind.speed"]) == [6.0, 7.0]
    assert found.table().num_rows == len(found) == 2
    for speed, largest in zip(found["wind.speed"], found["tension_plus_max_N"], strict=True):
        one = kitemj.simulate(SHORT | {"wind": {"speed": float(speed)}}, "lagrange")
        assert largest == pytest.approx(one["tension_plus_N"].max(), rel=SAME_TENSION)


SAME_TENSION = 1e-5
"""Of a tension; the error of steps that a study allows itself."""


def test_a_flight_on_film_moves_between_its_rows(steered, tmp_path):
    path = tmp_path / "flight.mp4"
    assert kitemj.film(steered, path, size=(320, 180), rate=20) == path
    with av.open(str(path)) as container:
        frames = [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]
    assert len(frames) == 21
    assert all((a != b).any() for a, b in pairwise(frames))
    with pytest.raises(kitemj.InputError, match="exists"):
        kitemj.film(steered, path)


def test_nothing_is_shown_of_progress_where_nobody_looks(capfd):
    kitemj.simulate(SHORT, "lagrange", pilot="eight")
    kitemj.compare(SHORT)
    assert capfd.readouterr() == ("", "")


def test_the_first_compilation_says_that_it_compiles(tmp_path):
    code = "from kitemj.physics.frames import R_BE, Angles; R_BE(Angles(0.1, 0.2, 0.3, 0.4))"
    environment = os.environ | {"XDG_CACHE_HOME": str(tmp_path)}
    told = [
        subprocess.run(
            [sys.executable, "-c", code],
            env=environment,
            capture_output=True,
            text=True,
            check=True,
        ).stderr
        for _ in range(2)
    ]
    assert told == ["compiling the formulas for this machine, once: some 15 s\n", ""]
