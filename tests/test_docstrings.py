"""A function with many arguments lists them in its docstring, one a line."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
ROOMS = (
    *(f"kitemj/{name}" for name in ("pilots", "equilibria", "studies", "plots")),
    *(f"kitemj/{name}" for name in ("controls", "drawing", "cockpit")),
    "scripts",
)
MANY = 6
"""Arguments, `self` not counted: more than one sentence can explain."""


def arguments(function: ast.FunctionDef) -> list[str]:
    every = (*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs)
    return [each.arg for each in every if each.arg not in ("self", "cls")]


def not_listed(function: ast.FunctionDef) -> list[str]:
    text = ast.get_docstring(function) or ""
    return [name for name in arguments(function) if not re.search(rf"^{name}: \S", text, re.M)]


@pytest.mark.parametrize("room", ROOMS)
def test_many_arguments_are_listed_one_a_line(room):
    files = sorted((ROOT / room).glob("**/*.py"))
    assert files
    for file in files:
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef) and len(arguments(node)) >= MANY:
                where = f"{file.relative_to(ROOT)}, {node.name}"
                assert not not_listed(node), f"{where}: {', '.join(not_listed(node))}"


def test_an_argument_that_is_only_mentioned_is_found():
    source = 'def f(a, b, c, d, e, g):\n """Does.\n\n a: m\n b: `c` and d: e\n e: s\n g: N\n """'
    [function] = ast.parse(source).body
    assert not_listed(function) == ["c", "d"]
