"""Pilots by name, and out of a file of one's own."""

from collections.abc import Callable
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

from kitemj.errors import InputError
from kitemj.pilots.manoeuvres import Pilot
from kitemj.registry import Registry

PILOTS: Registry[Callable[[], Pilot]] = Registry(
    "pilot",
    "kitemj.pilots",
    {
        "hold": "kitemj.pilots.manoeuvres:Hold",
        "loop": "kitemj.pilots.manoeuvres:Loop",
        "eight": "kitemj.pilots.manoeuvres:Eight",
        "assist": "kitemj.pilots.assist:Assist",
        "land": "kitemj.pilots.manoeuvres:Land",
        "show": "kitemj.pilots.show:Show",
    },
)
"""Each makes a pilot when called without arguments."""


def as_pilot(given: Pilot | Callable[[], Pilot] | str) -> Pilot:
    """A pilot: `given`, or what it makes; as a text, a name of `PILOTS` or FILE.py:NAME.

    Raises InputError for a name that there is not, a file that cannot be loaded, and for
    what has no method `command`.
    """
    found: Any = given
    if isinstance(given, str):
        found = _loaded(*given.rsplit(":", 1)) if ":" in given else PILOTS[given]
    if isinstance(found, type) or not hasattr(found, "command"):
        try:
            found = found()
        except TypeError as error:
            raise InputError(
                f"the pilot {given!r} is not made without arguments: {error}"
            ) from None
    if not hasattr(found, "command"):
        raise InputError(f"the pilot {given!r} has no method command(motion)")
    return found  # type: ignore[no-any-return]


def _loaded(file: str, name: str) -> Any:
    """What is called `name` in a Python file, which is run for it."""
    path = Path(file)
    spec = spec_from_file_location(path.stem, path)
    if path.suffix != ".py" or not path.is_file() or spec is None or spec.loader is None:
        raise InputError(f"{file} is no Python file: give a pilot as FILE.py:NAME, or by its name")
    module = module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except Exception as error:  # whatever is wrong in a file of somebody else
        raise InputError(f"{file} cannot be loaded: {type(error).__name__}: {error}") from None
    if not hasattr(module, name):
        raise InputError(f"there is no {name} in {file}")
    return getattr(module, name)
