"""What a user installs: the version, the pins of requirements.lock, the files in both packages."""

import os
import re
import subprocess
import sys
import tomllib
from importlib.metadata import version
from itertools import chain
from pathlib import Path
from tarfile import TarFile
from zipfile import ZipFile

import pytest
from hatchling.builders.sdist import SdistBuilder
from hatchling.builders.wheel import WheelBuilder
from packaging.requirements import Requirement

ROOT = Path(__file__).parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
LOCK = (ROOT / "requirements.lock").read_text()
PINS = [
    Requirement(line.split("#")[0])
    for line in LOCK.splitlines()
    if line.strip() and not line.lstrip().startswith("#")
]
DIRECT = list(
    chain(
        PROJECT["project"]["dependencies"],
        PROJECT["dependency-groups"]["dev"],
        PROJECT["build-system"]["requires"],
    )
)


def pins(requirement: Requirement, python: str) -> list[Requirement]:
    """The lines of the lock that hold for `requirement` on that Python."""
    here = {"python_version": python, "python_full_version": f"{python}.0"}
    return [
        pin
        for pin in PINS
        if pin.name == requirement.name and (pin.marker is None or pin.marker.evaluate(here))
    ]


def test_installed_version_is_that_of_pyproject() -> None:
    assert version("kitemj") == PROJECT["project"]["version"]


@pytest.mark.parametrize("python", ["3.11", "3.12", "3.13", "3.14"])
def test_direct_dependencies_have_one_pin_that_they_allow(python: str) -> None:
    for requirement in map(Requirement, DIRECT):
        wanted = requirement.marker is None or requirement.marker.evaluate(
            {"python_version": python}
        )
        found = pins(requirement, python)
        assert len(found) == wanted, f"{requirement} on Python {python}: `make lock`?"
        for pin in found:
            [pinned] = pin.specifier
            assert pinned.version in requirement.specifier, f"{pin} is not {requirement}"


def test_lock_pins_every_line_and_names_no_host() -> None:
    assert all(re.fullmatch(r"==[\w.+!]+", str(pin.specifier)) for pin in PINS)
    assert not re.search(r"://|^\s*-|@", LOCK, re.MULTILINE)


SHIPPED = [
    file.relative_to(ROOT).as_posix()
    for folder in ("models", "scenarios", "studies")
    for file in (ROOT / folder).glob("**/*.*")
]
"""Of the checkout; in the wheel they are in ``kitemj/data``."""
READ_THEM = """
from kitemj.controls.programmed import read_programmed_stick
from kitemj.dynamics.engine import build
from kitemj.flight.scenario import read_scenario
from kitemj.studies.study import read_study

parameters = read_scenario("steer_200m").parameters
build(parameters, 0.002)
read_programmed_stick("loop_right", parameters)
print(read_study("studies/wind_and_steering.toml").base.source)
"""


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> ZipFile:
    folder = tmp_path_factory.mktemp("wheel")
    return ZipFile(
        next(WheelBuilder(str(ROOT)).build(directory=str(folder), versions=["standard"]))
    )


def test_wheel_carries_data_parameter_sets_and_types(wheel: ZipFile) -> None:
    sets = [str(file.relative_to(ROOT)) for file in ROOT.glob("kitemj/physics/sets/*.toml")]
    data = [f"kitemj/data/{name}" for name in SHIPPED]
    assert len(sets) > 2
    assert len(data) > 9
    assert {*sets, *data, "kitemj/py.typed"} <= set(wheel.namelist())
    roots = {name.split("/")[0] for name in wheel.namelist()}
    assert roots == {"kitemj", f"kitemj-{version('kitemj')}.dist-info"}


def test_sdist_carries_what_the_wheel_is_built_from(tmp_path: Path, wheel: ZipFile) -> None:
    [sdist] = SdistBuilder(str(ROOT)).build(directory=str(tmp_path), versions=["standard"])
    with TarFile.open(sdist) as file:
        carried = {name.partition("/")[2] for name in file.getnames()}
    packaged = [name for name in wheel.namelist() if ".dist-info/" not in name]
    assert {"pyproject.toml", "LICENSE", "README.md", *SHIPPED} <= carried
    assert {name.replace("kitemj/data/", "") for name in packaged} <= carried


def test_an_installed_wheel_finds_its_data_from_anywhere(wheel: ZipFile, tmp_path: Path) -> None:
    wheel.extractall(tmp_path / "site")
    (tmp_path / "empty").mkdir()
    for words, status, said in (
        (["-c", READ_THEM], 0, "wind_and_steering.toml"),
        (["-m", "kitemj", "thesis", "--output", "report"], 2, "the report is made in the repo"),
    ):
        done = subprocess.run(
            [sys.executable, *words],
            cwd=tmp_path / "empty",
            env=os.environ | {"PYTHONPATH": str(tmp_path / "site")},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == status, done.stderr
        assert said in done.stdout + done.stderr
