"""Machine code is never older than what it is made of, and a cache never ends a flight."""

import atexit
import ctypes
import errno
import importlib
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from shutil import copytree, ignore_patterns

import pytest

from kitemj.physics import code_folder, machine_code
from kitemj.physics.code_folder import INHERITED
from kitemj.physics.compiled import compiled
from kitemj.physics.parameter_files import WINDS
from kitemj.physics.vectors import Vector
from kitemj.physics.wind import Wind, wind_law, wind_velocity
from kitemj.studies.study import study_of

PACKAGE = Path(code_folder.__file__).parent.parent
BREEZE = """
import helper, numbers_of_mine as mine
from fields import Breeze
from kitemj.physics.compiled import compiled
from kitemj.physics.vectors import Vector
from kitemj.physics.wind import wind_law

def told(factor):
    @compiled
    def formula(wind, p_E, t):
        return Vector(factor * wind.speed * helper.helped(t) + mine.GUST[0], mine.CALM, mine.AGAIN)
    return formula

wind_law.of(Breeze)(told(mine.FACTOR))
"""
FILES = {
    "breeze": BREEZE,
    "helper": "from numba import njit\n@njit\ndef helped(t):\n    return t + 1.0\n",
    "fields": "from typing import NamedTuple\nclass Breeze(NamedTuple):\n"
    "    speed: float\n    azimuth: float\n",
    "numbers_of_mine": "from pathlib import Path\nimport numpy\n"
    "FACTOR, CALM = 1.0, 0.0\nAGAIN = CALM\n"
    "GUST = numpy.array([float(Path(__file__).with_name('gust.txt').read_text())])\n",
}
"""A wind in four files; at t = 4 s it is 2 * (4 + 1) + 0.5 = 10.5 m/s."""
CHANGES = [
    ("helper.py", "t + 1.0", "t + 2.0", (12.5, 0.0)),
    ("numbers_of_mine.py", "1.0, 0.0", "1.0, 7.0", (10.5, 14.0)),
    ("numbers_of_mine.py", "1.0, 0.0", "3.0, 0.0", (30.5, 0.0)),
    ("numbers_of_mine.py", "AGAIN = CALM", "AGAIN = FACTOR", (10.5, 1.0)),
    ("gust.txt", "0.5", "1.5", (11.5, 0.0)),
    ("fields.py", "speed: float\n    azimuth", "azimuth: float\n    speed", (10.5, 0.0)),
]
STUDY = {"scenario": {"set": "sport", "wind": {"law": "breeze"}}, "grid": {"aero.Cm_0": [0.1]}}


@compiled
def felt(wind, t):
    v_E = wind_velocity(wind, Vector(0.0, 0.0, 0.0), t)
    return v_E.x, v_E.y + v_E.z


@compiled
def doubled(x):
    return 2.0 * x


@pytest.fixture
def folder(monkeypatch, tmp_path):
    """Where formulas that are compiled from now on are kept."""
    (tmp_path / "code").mkdir()
    monkeypatch.setattr(machine_code, "code_folder", lambda: tmp_path / "code")
    return tmp_path / "code"


@pytest.fixture
def mine(monkeypatch, tmp_path):
    """A folder of somebody's modules; what they register goes again."""
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(wind_law, "formulas", dict(wind_law.formulas))
    for name, text in FILES.items():
        (tmp_path / f"{name}.py").write_text(text)
    (tmp_path / "gust.txt").write_text("0.5")
    yield tmp_path
    for name in FILES:
        sys.modules.pop(name, None)


def anew():
    """What a process that starts now would find: (v_x, v_y) [m/s], and whether it was compiled."""
    for name in FILES:
        sys.modules.pop(name, None)
    importlib.invalidate_caches()
    importlib.import_module("breeze")
    formula = compiled(felt.py_func)
    wind = sys.modules["fields"].Breeze(speed=2.0, azimuth=3.0)
    return formula(wind, 4.0), not sum(formula.stats.cache_hits.values())


def test_a_change_in_any_file_of_somebodys_formula_compiles_it_anew(folder, mine):
    assert anew() == ((10.5, 0.0), True)
    assert anew() == ((10.5, 0.0), False)
    for name, before, after, wind in CHANGES:
        text = (mine / name).read_text()
        assert before in text
        (mine / name).write_text(text.replace(before, after))
        assert anew() == (wind, True), name
        (mine / name).write_text(text)
        assert anew() == ((10.5, 0.0), False), name


def test_a_study_does_not_go_on_where_a_file_of_its_formula_changed(folder, mine, monkeypatch):
    def digest():
        anew()
        monkeypatch.setitem(WINDS._loaded, "breeze", sys.modules["fields"].Breeze)
        return study_of(STUDY, "test", mine).digest

    before = digest()
    assert digest() == before
    helper = mine / "helper.py"
    helper.write_text(helper.read_text().replace("1.0", "2.0"))
    assert digest() != before


def test_an_own_law_leaves_the_machine_code_without_it_alone(folder, mine):
    assert compiled(felt.py_func)(Wind(3.0), 0.0) == (-3.0, 0.0)
    anew()
    again = compiled(felt.py_func)
    assert again(Wind(3.0), 0.0) == (-3.0, 0.0)
    assert sum(again.stats.cache_hits.values()) == 1


@pytest.mark.parametrize(
    "damage",
    [
        lambda kept: b"",
        lambda kept: kept[: len(kept) // 2],
        lambda kept: b"no machine code" * 100,
        lambda kept: kept[:-9] + bytes([kept[-9] ^ 1]) + kept[-8:],
    ],
    ids=["emptied", "cut", "overwritten", "a bit flipped"],
)
def test_a_damaged_file_is_compiled_anew_and_mended(folder, damage):
    assert compiled(doubled.py_func)(2.0) == 4.0
    [file] = folder.iterdir()
    sound = file.read_bytes()
    file.write_bytes(damage(sound))
    with pytest.raises(ValueError, match="damaged"):
        machine_code._read(file)
    assert compiled(doubled.py_func)(2.0) == 4.0
    assert [*folder.iterdir()] == [file]
    after = compiled(doubled.py_func)
    assert after(2.0) == 4.0
    assert sum(after.stats.cache_hits.values()) == 1


def test_another_users_file_is_not_run(folder, monkeypatch):
    assert compiled(doubled.py_func)(2.0) == 4.0
    monkeypatch.setattr(machine_code, "owner", lambda: folder.stat().st_uid + 1)
    again = compiled(doubled.py_func)
    assert again(2.0) == 4.0
    assert not again.stats.cache_hits


def test_a_disk_that_fills_ends_nothing(folder, monkeypatch, capsys):
    def full(*arguments, **named):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(tempfile, "mkstemp", full)
    assert compiled(doubled.py_func)(2.0) == 4.0
    assert "cannot be used (No space left on device)" in capsys.readouterr().err


@pytest.fixture
def fresh(monkeypatch, tmp_path):
    """`code_folder` as in a process that starts now, with a cache in a folder of its own."""
    monkeypatch.setattr(code_folder, "user_cache_path", lambda name: tmp_path / name)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    monkeypatch.setattr(atexit, "register", lambda *arguments: None)
    monkeypatch.setenv(INHERITED, "")  # and not what is set on the way
    (tmp_path / "temporary").mkdir()
    return code_folder.code_folder.__wrapped__


def test_another_users_folder_is_not_used(fresh, tmp_path, monkeypatch, capsys):
    usual = fresh()
    assert usual.parent == tmp_path / "kitemj"
    monkeypatch.setattr(code_folder, "owner", lambda: usual.stat().st_uid + 1)
    private = fresh()
    assert private.parent.parent == tmp_path / "temporary"
    assert private.name == usual.name
    assert f"{usual} cannot be used (it belongs to another user)" in capsys.readouterr().err


def test_a_private_folder_that_is_gone_stays_gone(fresh, tmp_path, monkeypatch):
    monkeypatch.setenv(INHERITED, str(tmp_path / "gone"))
    assert fresh().parent == tmp_path / "kitemj"
    assert not (tmp_path / "gone").exists()


def test_without_any_folder_formulas_still_compile(fresh, tmp_path, monkeypatch):
    (tmp_path / "kitemj").write_text("in its place")
    (tmp_path / "temporary").rmdir()
    monkeypatch.setattr(machine_code, "code_folder", fresh)
    assert fresh() is None
    assert compiled(doubled.py_func)(2.0) == 4.0


SPEED = """
import os, subprocess, sys
from kitemj.physics.loads import air
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Rotation, Vector
from kitemj.physics.wind import Wind

none, x = Vector(0.0, 0.0, 0.0), Vector(1.0, 0.0, 0.0)
sets = Parameters(*[Wind(5.0) for _ in Parameters._fields])
print(air(sets, none, Rotation(x, Vector(0.0, 1.0, 0.0), Vector(0.0, 0.0, 1.0)), none, 0.0).speed)
print(sum(air.stats.cache_hits.values()), flush=True)  # before the child says anything
if "--again" not in sys.argv:
    subprocess.run([sys.executable, *sys.orig_argv[1:], "--again"], check=True)
"""


def bound_by_permissions():
    """Takes from root what lets it write to folders that nobody may write to."""
    ctypes.CDLL(None).prctl(24, 1, 0, 0, 0)  # PR_CAPBSET_DROP, CAP_DAC_OVERRIDE


def flown(package, **environment):
    """(what `SPEED` says in a process and in its child, what they complain of)."""
    done = subprocess.run(
        [sys.executable, "-c", SPEED],
        cwd=package,
        env=os.environ | {"PYTHONPATH": str(package), "PYTHONDONTWRITEBYTECODE": "1"} | environment,
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=bound_by_permissions,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.split(), done.stderr


@pytest.mark.skipif(sys.platform != "linux", reason="takes root's powers away as Linux does")
def test_where_the_cache_cannot_be_written_a_changed_formula_flies_at_once(tmp_path):
    copytree(PACKAGE, tmp_path / "kitemj", ignore=ignore_patterns("__pycache__"))
    cache, temporary = tmp_path / "cache" / "kitemj", tmp_path / "temporary"
    cache.mkdir(parents=True)
    temporary.mkdir()
    cache.chmod(0o555)
    where = {"XDG_CACHE_HOME": str(cache.parent), "TMPDIR": str(temporary)}
    wind = tmp_path / "kitemj" / "physics" / "wind.py"
    text = wind.read_text()
    for factor in (1, 2):
        wind.write_text(text.replace("return wind.speed", f"return {factor} * wind.speed"))
        said, complaint = flown(tmp_path, **where)
        assert said == [str(5.0 * factor), "0", str(5.0 * factor), "1"]
        assert complaint.count("\n") == 1
        assert f"{cache}/compiled-" in complaint
        assert "cannot be used (Permission denied)" in complaint
        assert not [*temporary.iterdir()]
    assert not [*tmp_path.rglob("*.nbi")]
