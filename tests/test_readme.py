"""What the README tells people to type works as printed (with shorter flights)."""

import re
import shlex
import tomllib
from pathlib import Path

import pytest

from kitemj.cli import main
from kitemj.flight.scenario import scenario_of

ROOT = Path(__file__).parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
LINES = re.findall(r"^    kitemj (.+?)(?: +#.*)?$", README, re.MULTILINE)
SECONDS = 1.0
"""s; flights are cut to this."""


@pytest.fixture(scope="module")
def desk(tmp_path_factory):
    """A folder as a newcomer has it, with scenarios of a second."""
    folder = tmp_path_factory.mktemp("desk")
    for kind in ("scenarios", "studies"):
        (folder / kind).mkdir()
        for file in (ROOT / kind).glob("*.toml"):
            text = re.sub(r"^duration = .*$", f"duration = {SECONDS}", file.read_text(), flags=re.M)
            (folder / kind / file.name).write_text(text)
    return folder


def test_the_readme_has_commands():
    assert len(LINES) >= 12
    assert "    make fly" in README
    assert "    make test" in README


@pytest.mark.parametrize("line", LINES)
def test_commands_of_the_readme_run_in_order(line, desk, monkeypatch):
    monkeypatch.chdir(desk)
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)
    words = shlex.split(line)
    if words[0] == "fly":
        words += ["--headless", "--duration", str(SECONDS), "--size", "640x360"]
    if words[0] == "film":
        words += ["--size", "640x360"]
    assert main(words) == 0


def test_the_scenario_of_the_readme_is_one():
    [block] = re.findall(r"```toml\n(.*?)```", README, re.DOTALL)
    assert scenario_of(tomllib.loads(block), "README.md").parameters.wind.exponent == 0.14


def test_pictures_of_the_readme_are_there():
    for name in re.findall(r"\]\((docs/[^)]+|[A-Z]+\.md)\)", README):
        assert (ROOT / name).is_file(), name
