"""The rooms import in one direction only, and the formulations know nothing of one another."""

import ast
import re
from itertools import chain
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parent.parent / "kitemj"

ROOMS = (
    ("physics", ()),
    ("dynamics", ("physics",)),
    ("flight", ("dynamics",)),
    ("pilots", ("flight",)),
    ("equilibria", ("flight",)),
    ("turning", ("pilots", "equilibria")),
    ("paths", ("turning",)),
    ("autopilot", ("paths",)),
    ("robustness", ("autopilot",)),
    ("studies", ("autopilot",)),
    ("recording", ("autopilot",)),
    ("plots", ("recording",)),
    ("controls", ("pilots",)),
    ("realtime", ("recording",)),
    ("scene", ("flight",)),
    ("sound", ("flight",)),
    ("drawing", ("pilots", "recording", "controls", "scene")),
    ("cockpit", ("drawing", "realtime", "plots", "sound")),
    ("commands", ("cockpit", "plots", "robustness", "studies")),
)
"""Each room with those right below it; it may import these and all that they may."""

GROUND = (
    "child",
    "closing",
    "console",
    "data_files",
    "errors",
    "files",
    "locks",
    "metadata",
    "mujoco_import",
    "progress_bar",
    "registry",
    "signals",
    "tables",
    "temporary",
)
"""Root files below all rooms; they import one another only."""
TOP = ("__init__", "__main__", "api", "cli", "last_resort")
"""Root files above all rooms, which no room imports; but the commands call the api."""

FORMULATIONS = {
    "lagrange": {"lagrange", "lagrange_kite", "solve4"},
    "newton-euler": {"newton_euler", "newton_euler_kite"},
    "mujoco": {"mujoco_kite", "engine", "taut", "slack"},
}
SHARED = {"motion", "formulation", "ground", "straight", "adaptive", "batch", "__init__"}
"""Files of dynamics that any formulation may import."""

LARGEST_ROOM = 3000
"""Lines of code; what a person can get to know in a day."""


def below(room: str) -> set[str]:
    """The rooms that `room` may import, itself among them."""
    return {room}.union(*(below(name) for name in dict(ROOMS)[room]))


def imported(file: Path) -> set[tuple[str, ...]]:
    """Dotted paths below kitemj that a file imports, anywhere in it."""
    names: list[str] = []
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module and node.level == 0:
            names += [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
        elif isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
    return {tuple(name.split(".")[1:]) for name in names if name.startswith("kitemj.")}


def module(path: tuple[str, ...]) -> tuple[str, ...]:
    """The module that an imported path is, or is a name of."""
    return path if PACKAGE.joinpath(*path).with_suffix(".py").is_file() else path[:-1]


@pytest.mark.parametrize("room", dict(ROOMS))
def test_rooms_import_in_one_direction(room):
    allowed = below(room) | set(GROUND) | ({"api"} if room == "commands" else set())
    for file in sorted((PACKAGE / room).glob("**/*.py")):
        rooms = {path[0] for path in imported(file)}
        assert rooms <= allowed, f"{file.name} imports {rooms - allowed}"


def test_root_files_are_ground_or_top():
    assert {file.stem for file in PACKAGE.glob("*.py")} == {*GROUND, *TOP}
    for name in GROUND:
        rooms = {path[0] for path in imported(PACKAGE / f"{name}.py")}
        assert rooms <= set(GROUND), f"{name}.py imports {rooms - set(GROUND)}"


def test_every_folder_is_a_room():
    folders = {file.parent.relative_to(PACKAGE).parts[0] for file in PACKAGE.glob("*/**/*.py")}
    assert folders == set(dict(ROOMS))


def test_no_file_imports_itself_by_way_of_others():
    files = sorted(PACKAGE.glob("**/*.py"))
    paths = {file.relative_to(PACKAGE).with_suffix("").parts: file for file in files}
    arrows = {path: {module(each) for each in imported(file)} for path, file in paths.items()}
    reached = {path: set(arrows[path]) & set(paths) for path in paths}
    for _ in paths:  # the longest way has no more files than there are
        further = {
            path: met.union(*(reached[each] for each in met)) for path, met in reached.items()
        }
        if further == reached:
            break
        reached = further
    assert not [path for path, met in reached.items() if path in met]


@pytest.mark.parametrize("room", dict(ROOMS))
def test_no_room_is_too_large_to_know(room):
    lines = sum(len(file.read_text().splitlines()) for file in (PACKAGE / room).glob("**/*.py"))
    assert lines <= LARGEST_ROOM


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_formulations_do_not_import_one_another(formulation):
    others = set(chain(*(files for name, files in FORMULATIONS.items() if name != formulation)))
    for name in FORMULATIONS[formulation]:
        paths = imported(PACKAGE / "dynamics" / f"{name}.py")
        met = {path[1] for path in paths if path[0] == "dynamics"}
        assert not met & others, f"{name}.py imports {met & others}"


def test_every_file_of_dynamics_is_accounted_for():
    known = set(chain(SHARED, *FORMULATIONS.values()))
    assert {file.stem for file in (PACKAGE / "dynamics").glob("*.py")} == known


def texts(file: Path) -> list[str]:
    """The text constants of a file, parts of f-strings too, without docstrings."""
    nodes = [*ast.walk(ast.parse(file.read_text(encoding="utf-8")))]
    told = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}
    constants = [node for node in nodes if isinstance(node, ast.Constant) and id(node) not in told]
    return [node.value for node in constants if isinstance(node.value, str)]


@pytest.mark.parametrize("room", [*(room for room, _ in ROOMS if room != "commands"), "."])
def test_only_commands_speak_of_the_command_line(room):
    """Elsewhere an argument has its name in backquotes, see `InputError`."""
    for file in sorted((PACKAGE / room).glob("*.py")):
        if file.stem not in TOP:
            options = [text for text in texts(file) if re.search("--[a-z]", text)]
            assert not options, f"{file.name} says {options}"
