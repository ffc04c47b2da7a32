"""What the manual, README and CONTRIBUTING tell people to type works as printed, if shorter.

Each page's blocks are steps, done in order at one desk: a folder with scenarios of a second.
"""

import ast
import importlib.util
import re
import runpy
import shlex
import shutil
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import matplotlib as mpl
import pytest
import yaml
from markdown_it import MarkdownIt
from uv import find_uv_bin

from kitemj.cli import _parser, main
from kitemj.controls.settings import settings_of
from kitemj.dynamics.formulation import MODELS
from kitemj.errors import InputError
from kitemj.flight.scenario import scenario_of
from kitemj.physics.parameter_files import LAWS
from kitemj.recording.table import ALL
from kitemj.studies.study import read_study

ROOT = Path(__file__).parent.parent
DOCS = ROOT / "docs"
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(DOCS.glob("*.md"))]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())

SECONDS = 0.5
"""s; flights are cut to this."""
ASKED_FOR = {  # commands that are only parsed
    "pad": "a person with a gamepad",
    "realtime": "a machine with nothing else to do",
    "thesis": "minutes",
}
SHORTER = {
    "fly": ["--headless", "--duration", str(SECONDS), "--size", "320x180"],
    "film": ["--size", "320x180"],
    "replay": ["--headless"],
}
OWN_FORMULAS = ("jet.py", "soft_stall.py")
"""Run, and used, in processes of their own, and so is what these compile."""
OWN_LAWS = ("jet", "soft-stall")
"""What they add."""
GROUPS = {registry.group for registry in (*LAWS.values(), MODELS)} | {"kitemj.pilots"}
INSTALLERS: dict[str, list[str]] = {
    "pip": [sys.executable, "-m", "pip"],
    "python3": [sys.executable],
    "uv": [find_uv_bin()],
    "uvx": [find_uv_bin(), "tool", "run"],
    "conda": [],
}
"""Their commands are only parsed: by themselves, where they are here."""
NOT_OURS = ("polars", "pandas")
"""Programs that read recordings, tried where they are."""
KINDS = {"console", "python", "toml", "text"}
NOTEBOOK = "notebook.md"
"""Its blocks are run in one namespace, and what they end with is shown."""


class Step(NamedTuple):
    """A block of a page, or one command of it."""

    page: str
    line: int
    kind: str
    text: str

    @property
    def name(self) -> str:
        """The file that a comment in the first line names."""
        found = re.match(r"# ([\w.]+\.\w+)\n", self.text)
        return found[1] if found else ""


def blocks(page: Path) -> Iterator[Step]:
    for token in MarkdownIt().parse(page.read_text(encoding="utf-8")):
        if token.type == "code_block":
            yield Step(page.name, token.map[0] + 1, "indented", token.content)
        elif token.type == "fence" and not token.info.startswith("{"):
            yield Step(page.name, token.map[0] + 1, token.info, token.content)


def commands(block: Step) -> list[str]:
    """Lines to type: behind a prompt, or indented and of our own."""
    ours = r"^\$ (.+)$" if block.kind == "console" else r"^((?:kitemj|make|pip) .+?)(?: {2,}#.*)?$"
    return re.findall(ours, block.text, re.MULTILINE)


BLOCKS = [block for page in PAGES for block in blocks(page)]
COMMANDS = [
    block._replace(kind="command", text=text)
    for block in BLOCKS
    if block.kind in ("console", "indented")
    for text in commands(block)
]
FIRST: dict[str, Step] = {}
"""Where a command stands first; it is run there."""
for command in COMMANDS:
    FIRST.setdefault(command.text, command)
STEPS = [
    step
    for block in BLOCKS
    for step in (
        [c for c in FIRST.values() if c[:2] == block[:2]]
        if block.kind in ("console", "indented")
        else [block]
    )
]


def called(step: Step) -> str:
    return f"{step.page}:{step.line} {step.name or step.text.splitlines()[0]}"


@pytest.fixture(scope="module")
def desk(tmp_path_factory):
    folder = tmp_path_factory.mktemp("desk")
    (folder / "docs" / "tables").mkdir(parents=True)
    for kind in ("scenarios", "studies"):
        (folder / kind).mkdir()
        for file in (ROOT / kind).glob("*.toml"):
            (folder / kind / file.name).write_text(cut(file.read_text()))
    shutil.copytree(ROOT / "scenarios" / "sticks", folder / "scenarios" / "sticks")
    return folder


@pytest.fixture(scope="module")
def notebook():
    return {"__name__": "notebook"}


def cut(text: str) -> str:
    return re.sub(r'^duration = [\d.]+|(?<="duration": )[\d.]+', shorter, text, flags=re.MULTILINE)


def shorter(duration: re.Match[str]) -> str:
    return f"duration = {SECONDS}" if "=" in duration[0] else str(SECONDS)


@pytest.mark.parametrize("step", STEPS, ids=called)
def test_every_block_works_in_order(step, desk, notebook, monkeypatch):
    monkeypatch.chdir(desk)
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)
    if step.kind == "command":
        type_in(shlex.split(step.text))
        return
    assert step.kind in KINDS, "of a kind that is tried"
    if step.name:
        (desk / step.name).write_text(cut(step.text), encoding="utf-8")
    if step.kind == "toml":
        check_toml(step, desk)
    if step.kind == "python":
        if step.page == NOTEBOOK:
            run_cell(step, notebook)
        else:
            run_python(step, desk, monkeypatch)


def type_in(words: list[str]) -> None:
    program, *rest = words
    if program == "kitemj":
        words = [name for word in rest for name in (expanded(word) or [word])]
        _parser().parse_args(words)
        if "--use" in words:
            run_apart("-m", "kitemj", *words)
        elif words[0] not in ASKED_FOR:
            assert main([*words, *SHORTER.get(words[0], [])]) == 0
    elif program == "make":
        assert re.search(rf"^{rest[0]}:", (ROOT / "Makefile").read_text(), re.MULTILINE)
    elif program in INSTALLERS:
        parse_only(program, rest)
    elif program == ".":
        assert re.fullmatch(r"(\.venv|kite)/bin/activate", rest[0])
    elif program == ".venv/bin/python":
        assert (ROOT / rest[0]).is_file()
    else:
        assert program.removeprefix(".venv/bin/") in PROJECT["dependency-groups"]["dev"]


def parse_only(program: str, words: list[str]) -> None:
    """The installers' own parsers see nothing wrong, and what is to be installed is there."""
    if parser := INSTALLERS[program]:
        words = words[: words.index("kitemj")] if "kitemj" in words else words
        done = subprocess.run([*parser, *words, "--help"], capture_output=True, check=False)
        assert done.returncode == 0, done.stderr.decode()
    assert words[0] in ("create", "activate") or {".", "kite"} & set(words)


def expanded(word: str) -> list[str]:
    """As a shell does it."""
    return sorted(map(str, Path().glob(word))) if "*" in word else []


def check_toml(step: Step, desk: Path) -> None:
    tables = tomllib.loads(step.text)
    if step.name == "settings.toml":
        settings_of(tables, called(step))
    elif step.name == "pyproject.toml":
        assert set(tables["project"]["entry-points"]) <= GROUPS
    elif any(tables.get(section, {}).get("law", "") in OWN_LAWS for section in LAWS):
        assert step.name, "the commands after it read it"
    elif "scenario" in tables:
        assert read_study(desk / step.name).design.count > 1
    else:
        scenario_of({"duration": 60.0} | tables, called(step))


def run_python(step: Step, desk: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for package in NOT_OURS:
        if re.search(rf"^import {package}$", step.text, re.MULTILINE):
            pytest.importorskip(package)
    file = desk / (step.name or "snippet.py")
    file.write_text(cut(step.text), encoding="utf-8")
    if step.name in OWN_FORMULAS:
        run_apart(file)
        return
    monkeypatch.syspath_prepend(desk)
    known = set(sys.modules)
    runpy.run_path(str(file), run_name="__main__")
    for name in set(sys.modules) - known:
        if (desk / f"{name}.py").is_file():
            del sys.modules[name]


def run_apart(*words: str | Path) -> None:
    done = subprocess.run([sys.executable, *words], capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()


def run_cell(step: Step, namespace: dict[str, object]) -> None:
    """Runs a block, and shows its last expression as a notebook does."""
    tree = ast.parse(cut(step.text))
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, called(step), "exec"), namespace)
    if last:
        result = eval(compile(ast.Expression(last.value), called(step), "eval"), namespace)
        html = getattr(result, "_repr_html_", result.__repr__)()
        assert html, "something is shown"
        if type(result).__module__.startswith("kitemj"):
            assert html.startswith(("<table>", "<img", "PerLine"))


def test_there_is_much_to_try():
    assert len(COMMANDS) > 40
    assert sum(step.kind == "python" for step in STEPS) > 7
    assert {"make fly", "make test"} <= set(FIRST)
    assert len([c for c in FIRST if c.startswith("kitemj")]) > 30


def test_commands_within_sentences_are_ones():
    found = [
        child.content
        for page in (*PAGES, ROOT / "ARCHITECTURE.md", ROOT / "CHANGELOG.md")
        for token in MarkdownIt().parse(page.read_text(encoding="utf-8"))
        for child in token.children or []
        if child.type == "code_inline" and re.match(r"kitemj \w", child.content)
    ]
    assert len(found) > 10
    for text in found:
        words = shlex.split(text)[1:]
        if len(words) > 1:
            _parser().parse_args(words)
        else:
            assert words[0] in _parser().format_help()


def test_pictures_and_pages_that_texts_name_are_there():
    for page in (ROOT / "README.md", ROOT / "CONTRIBUTING.md"):
        for name in re.findall(r"\]\(((?!http)[^)#]+)", page.read_text(encoding="utf-8")):
            assert (ROOT / name).is_file(), name


def test_the_scenario_of_the_readme_is_one():
    [block] = [b for b in BLOCKS if (b.page, b.kind) == ("README.md", "toml")]
    scenario = scenario_of(tomllib.loads(block.text), "README.md")
    assert scenario.parameters.wind.exponent == 0.14


def test_the_message_in_contributing_is_what_people_get():
    [told] = [b.text.strip() for b in BLOCKS if b[0] == "CONTRIBUTING.md" and b[2] == "indented"]
    with pytest.raises(InputError) as refused:
        scenario_of({"duration": 1.0, "kite": {"mass": -4.0}}, "scenario.toml")
    assert str(refused.value) == told


def test_every_column_of_a_recording_is_explained():
    named = set(re.findall(r"`(\w+)`", (DOCS / "flights.md").read_text(encoding="utf-8")))
    for name in ALL:
        corner = re.sub(r"R_BE_..$", "R_BE_xx", name)
        assert corner in named, f"flights.md does not explain the column {name}"


def rows(text: str) -> list[list[str]]:
    """Of Markdown tables, those that hold a model against the reference."""
    lines = re.findall(r"^\| (.+ / lagrange .+) \|$", text, re.MULTILINE)
    return [line.split(" | ") for line in lines]


def test_the_measured_table_is_whole_and_that_of_the_readme():
    """Else make it anew: see the end of "How to add" in CONTRIBUTING."""
    table = rows((DOCS / "tables" / "agreement.md").read_text(encoding="utf-8"))
    shipped = sorted(file.name for file in (ROOT / "scenarios").glob("*.toml"))
    assert [row[0] for row in table] == sorted(2 * shipped)
    assert all(row[-1] == ("at rest" if row[0].startswith("rest") else "yes") for row in table)
    readme = rows((ROOT / "README.md").read_text(encoding="utf-8"))
    assert readme == [[r[0].removesuffix(".toml"), r[1], r[2], r[4], r[6], r[8]] for r in table]


def test_figures_are_those_that_the_script_draws(tmp_path):
    with mpl.rc_context():
        runpy.run_path(str(ROOT / "scripts" / "manual_figures.py"))["main"](tmp_path)
    drawn = {file.name for file in tmp_path.iterdir()}
    assert drawn == {file.name for file in (DOCS / "figures").iterdir()}
    texts = "".join(page.read_text(encoding="utf-8") for page in PAGES)
    assert all(f"(figures/{name})" in texts for name in drawn)


def test_the_manual_builds_without_a_warning_and_needs_no_network(tmp_path):
    words = ["-q", "-n", "-W", "-E", "-d", str(tmp_path / "trees"), str(DOCS), str(tmp_path)]
    done = subprocess.run(
        [sys.executable, "-m", "sphinx", *words], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    pages = {page.stem: page.read_text(encoding="utf-8") for page in tmp_path.glob("*.html")}
    assert {page.stem for page in DOCS.glob("*.md")} - {"benchmark"} <= set(pages)
    for name, page in pages.items():
        assert not re.search(r"<(script|link|img)[^>]+(src|href)=\"(https?:)?//", page), name
    assert "v_1 = R_1E v_E" in pages["api"], "compiled functions show their docstrings"
    assert "mass of the kite [kg]" in pages["api"], "fields show their units"
    assert "wind.gust_amplitude" in pages["physics"]
    for name in ("fly", "simulate", "stability"):
        assert f"kitemj-{name}" in pages["commands"]


def test_citation_names_version_and_papers():
    cff = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert {"cff-version", "message", "title", "authors"} <= set(cff)
    assert cff["cff-version"] == "1.2.0"
    assert cff["version"] == PROJECT["project"]["version"]
    assert cff["license"] == PROJECT["project"]["license"]
    page = (DOCS / "citing.md").read_text(encoding="utf-8")
    dois = [reference["doi"] for reference in cff["references"]]
    assert len(set(dois)) == 3
    for reference in cff["references"]:
        assert {"type", "title", "authors", "year"} <= set(reference)
        assert f"https://doi.org/{reference['doi']}" in page


def test_the_manual_is_tried_with_what_it_is_built_with():
    for module in ("sphinx", "myst_parser", "furo", "sphinx_argparse_cli", "ziamath"):
        assert importlib.util.find_spec(module), f"{module}: `make lock`?"
