"""What the pages take from the program itself, so that it is never typed and never stale.

Tables are Markdown text; the functions at the end are asked by autodoc.
"""

import argparse
import re
import sys
from collections import Counter
from importlib.metadata import version as installed
from pathlib import Path
from typing import Annotated, Any, get_args, get_origin, get_type_hints

import pygame

from kitemj.cli import _parser
from kitemj.controls.actions import HELP, REPLAY_HELP
from kitemj.controls.keys import TOGGLES
from kitemj.physics.aerodynamics import LinearAero
from kitemj.physics.parameter_files import SECTIONS, parameter_set, set_names
from kitemj.physics.quantity import Quantity

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT))

from tests.agreement.faults import FAULTS  # noqa: E402
from tests.authorities.faults import FAULTS as SHARED  # noqa: E402


def version() -> str:
    """Of the installed package."""
    return installed("kitemj")


def table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    """A Markdown table."""
    lines = [head, ("---",) * len(head), *rows]
    return "\n".join(f"| {' | '.join(_cell(cell) for cell in line)} |" for line in lines)


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def keys() -> str:
    """What each key and control does: the page that F1 shows."""
    return _page(HELP, "keys (pad)")


def replay_keys() -> str:
    """The same while a recording is shown."""
    return _page(REPLAY_HELP, "keys")


def _page(lines: tuple[str, ...], head: str) -> str:
    rows = [tuple(line.split("\t")) for line in lines if "\t" in line]
    return table((head, "what they do"), rows)


def toggles() -> str:
    """Which key shows which part of the picture."""
    rows = [(pygame.key.name(key), name.removeprefix("toggle ")) for key, name in TOGGLES.items()]
    return table(("key", "shows or hides"), rows)


def parser() -> argparse.ArgumentParser:
    """All commands; their texts are no markup, so stars are made to stay stars."""
    whole = _parser()
    for action in whole._actions:
        if isinstance(action, argparse._SubParsersAction):
            for each in {**action.choices}.values():
                for option in each._actions:
                    option.help = option.help and option.help.replace("*", r"\*")
    return whole


def quantities(kind: type) -> dict[str, Quantity]:
    """Unit, meaning and bounds of each field of a ``NamedTuple`` that has them."""
    found = {}
    for name, hint in get_type_hints(kind, include_extras=True).items():
        if get_origin(hint) is Annotated:
            found[name] = next(extra for extra in get_args(hint) if isinstance(extra, Quantity))
    return found


def bounds(quantity: Quantity) -> str:
    """What a number may be: "> 0", "" where there is no bound."""
    signs = {"gt": ">", "ge": "≥", "lt": "<", "le": "≤"}
    given = {sign: getattr(quantity, name) for name, sign in signs.items()}
    return ", ".join(f"{sign} {limit:g}" for sign, limit in given.items() if limit is not None)


def parameters() -> str:
    """Every field of a parameter set: unit, meaning, what is allowed."""
    rows = []
    for section, kind in {**SECTIONS, "aero": LinearAero}.items():
        for name, quantity in quantities(kind).items():
            field = f"`{section}.{name}`"
            rows.append((field, quantity.unit, quantity.meaning, bounds(quantity)))
    return table(("field", "unit", "meaning", "allowed"), rows)


def kites() -> str:
    """The numbers of the named sets, side by side."""
    sets = {name: parameter_set(name) for name in set_names()}
    rows = []
    for section, kind in {**SECTIONS, "aero": LinearAero}.items():
        for name, quantity in quantities(kind).items():
            values = [getattr(getattr(each, section), name) for each in sets.values()]
            told = [f"{v:.4g}" if isinstance(v, float) else str(v).lower() for v in values]
            rows.append((f"`{section}.{name}`", quantity.unit, *told))
    return table(("field", "unit", *sets), rows)


def faults() -> str:
    """Every fault that the tests plant, and the rung of the ladder that must break."""
    rows = [(fault.model, fault.what, fault.rung) for fault in FAULTS]
    return table(("in", "fault", "first noticed by"), rows)


def counted_faults() -> str:
    """How many faults there are, by rung."""
    count = Counter(fault.rung for fault in FAULTS)
    told = ", ".join(f"{count[rung]} by {rung}" for rung in dict.fromkeys(f.rung for f in FAULTS))
    return f"{len(FAULTS)} faults: {told}"


def shared_faults() -> str:
    """Every fault planted in what the models share, and the authority that must notice it."""
    rows = []
    for fault in SHARED:
        test = fault.test.partition(":")[2].removeprefix("test_")
        rows.append((fault.module, fault.what, test.replace("_", " ")))
    return table(("in", "fault", "noticed, because"), rows)


def short_signature(
    app: Any, what: str, name: str, thing: Any, options: Any, signature: str | None, returns: Any
) -> tuple[str, str | None] | None:
    """The names of a ``NamedTuple``'s fields; units and meanings follow below."""
    if what == "class" and quantities_or_none(thing):
        return f"({', '.join(thing._fields)})", None
    return None


def with_units(app: Any, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """A docstring as text, in which |δ| is an amount; with the fields of a ``NamedTuple``."""
    lines[:] = [line if line.startswith(" ") else as_markup(line) for line in lines]
    if what == "class":
        for field, quantity in (quantities_or_none(thing) or {}).items():
            unit = f" [{quantity.unit}]" if quantity.unit else ""
            lines += ["", f":param {field}: {as_markup(quantity.meaning)}{unit}"]


def as_markup(line: str) -> str:
    """Bars are bars, and a plural s may stand at a ``name``."""
    return re.sub(r"(?<=\w)(`+)(?=\w)", r"\1\\ ", re.sub(r"(?<!`)\|(?!`)", r"\\|", line))


def quantities_or_none(thing: Any) -> dict[str, Quantity] | None:
    """As `quantities`; None for what is no ``NamedTuple``."""
    is_tuple = isinstance(thing, type) and hasattr(thing, "_fields")
    return quantities(thing) if is_tuple else None


def skipped(app: Any, what: str, name: str, thing: Any, skip: bool, options: Any) -> bool | None:
    """Fields of a ``NamedTuple`` say nothing ("Alias for field number 0")."""
    return True if type(thing).__name__ == "_tuplegetter" else None
