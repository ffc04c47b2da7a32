"""Which lessons have been passed, from one flight to the next.

A file of JSON in the user's state folder, ``{"passed": ["top", ...]}``. It is a convenience:
where it is damaged or cannot be written, the flight goes on and a sentence says so.
"""

import json
from collections.abc import Collection
from pathlib import Path
from typing import NamedTuple

from platformdirs import user_state_path

from kitemj.errors import InputError
from kitemj.files import new_file


class Progress(NamedTuple):
    """Keys of the passed lessons; `message` says what is wrong with the file, if anything is."""

    passed: frozenset[str]
    message: str = ""


def progress_path() -> Path:
    """The file; on Linux the folder follows XDG_STATE_HOME."""
    return user_state_path("kitemj") / "lessons.json"


def read_progress(path: Path | None = None) -> Progress:
    """What the file says; nothing is passed where there is none or it is damaged."""
    path = path or progress_path()
    try:
        known = json.loads(path.read_text(encoding="utf-8"))["passed"]
    except FileNotFoundError:
        return Progress(frozenset())
    except OSError as error:
        why = error.strerror or error
        return Progress(frozenset(), f"{path} cannot be read ({why}): the lessons begin anew")
    except (ValueError, KeyError, TypeError):
        known = None
    if not isinstance(known, list) or not all(isinstance(key, str) for key in known):
        return Progress(frozenset(), f"{path} is damaged: the lessons begin anew")
    return Progress(frozenset(known))


def write_progress(passed: Collection[str], path: Path | None = None) -> str:
    """Keeps the keys of the passed lessons; a sentence where that fails, else an empty text.

    The file appears whole or not at all.
    """
    path = path or progress_path()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with new_file(path, overwrite=True) as part:
            part.write_text(json.dumps({"passed": sorted(passed)}) + "\n", encoding="utf-8")
    except (OSError, InputError) as error:
        why = getattr(error, "strerror", None) or error
        return f"{path} cannot be written ({why}): this lesson is not kept"
    return ""
