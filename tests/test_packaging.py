"""What a user installs: the version, the pins of requirements.lock, the files in the wheel."""

import re
import tomllib
from importlib.metadata import version
from itertools import chain
from pathlib import Path
from zipfile import ZipFile

import pytest
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


def test_wheel_carries_models_parameter_sets_and_types(tmp_path: Path) -> None:
    [wheel] = WheelBuilder(str(ROOT)).build(directory=str(tmp_path), versions=["standard"])
    names = ZipFile(wheel).namelist()
    assert {name.split("/")[0] for name in names} == {
        "kitemj",
        f"kitemj-{version('kitemj')}.dist-info",
    }
    carried = {name for name in names if name.startswith("kitemj/")}
    data = [*ROOT.glob("models/*"), *ROOT.glob("kitemj/physics/sets/*.toml")]
    assert data
    for file in data:
        assert str(file.relative_to(ROOT)).replace("models/", "kitemj/models/") in carried
    assert "kitemj/py.typed" in carried
