"""The rooms import in one direction only, and the formulations know nothing of one another."""

import ast
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parent.parent / "kitemj"
MAY_IMPORT = {
    "physics": {"physics"},
    "dynamics": {"physics", "dynamics"},
    "flight": {"physics", "dynamics", "flight"},
    "studies": {"physics", "dynamics", "flight", "studies"},
    "stability": {"physics", "dynamics", "flight", "stability"},
    "recording": {"physics", "dynamics", "flight", "recording"},
    "plots": {"physics", "dynamics", "flight", "recording", "plots"},
    "cockpit": {"physics", "dynamics", "flight", "recording", "cockpit"},
    "thesis": {
        "physics",
        "dynamics",
        "flight",
        "studies",
        "stability",
        "recording",
        "plots",
        "cockpit",
        "thesis",
    },
    "commands": {
        "physics",
        "dynamics",
        "flight",
        "studies",
        "stability",
        "recording",
        "plots",
        "cockpit",
        "thesis",
        "commands",
    },
}
SHARED = {"closing", "tables", "errors", "model_files", "mujoco_import"}
FORMULATIONS = {
    "lagrange": {"lagrange", "lagrange_kite", "linear"},
    "newton-euler": {"newton_euler", "newton_euler_kite"},
    "mujoco": {"mujoco_kite", "engine", "taut", "slack", "straight"},
}


def imported(file):
    """Names below kitemj that a file imports, anywhere in it."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module and node.level == 0:
            names = [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        else:
            names = []
        yield from (name.split(".")[1:] for name in names if name.startswith("kitemj."))


@pytest.mark.parametrize("room", MAY_IMPORT)
def test_rooms_import_in_one_direction(room):
    for file in sorted((PACKAGE / room).glob("**/*.py")):
        rooms = {path[0] for path in imported(file)} - SHARED
        assert rooms <= MAY_IMPORT[room], f"{file.name} imports {rooms - MAY_IMPORT[room]}"


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_formulations_do_not_import_one_another(formulation):
    others = set().union(*(files for name, files in FORMULATIONS.items() if name != formulation))
    for name in FORMULATIONS[formulation]:
        paths = imported(PACKAGE / "dynamics" / f"{name}.py")
        met = {path[1] for path in paths if path[0] == "dynamics"}
        assert not met & others, f"{name}.py imports {met & others}"


def test_every_file_of_dynamics_is_accounted_for():
    known = set().union(*FORMULATIONS.values()) | {"motion", "adaptive", "survey", "__init__"}
    assert {file.stem for file in (PACKAGE / "dynamics").glob("*.py")} == known
