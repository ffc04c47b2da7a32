"""Files that ship: in ``data/`` of an installed package, in folders beside it in a checkout."""

import os
from io import FileIO
from pathlib import Path

from kitemj.errors import InputError

PACKAGE = Path(__file__).parent
DATA = PACKAGE / "data" if (PACKAGE / "data").is_dir() else PACKAGE.parent
SCENARIOS, STICKS, STUDIES = "scenarios", "scenarios/sticks", "studies"

MOST_BYTES = 16 << 20
"""Of a text file that a person gives us: a million lines; /dev/zero has no end."""


def model_file(name: str) -> Path:
    """The path of ``models/<name>``; raises FileNotFoundError where it is not installed."""
    path = DATA / "models" / name
    if not path.is_file():
        raise FileNotFoundError(f"models/{name} is missing from this installation of kitemj")
    return path


def shipped_or_file(name: str | Path, folder: str, beside: Path = Path()) -> Path:
    """The file `name` (relative to `beside`) where there is one, else the shipped one so called.

    `folder` is one of SCENARIOS, STICKS and STUDIES; a shipped file may be called by its name
    with or without folder and suffix. Raises InputError with those that ship for no file.
    """
    path = Path(name)
    if not path.name:
        raise InputError(f"a file needs a name, got {str(name)!r}")
    try:
        if (beside / path).exists():
            return beside / path
    except OSError as error:
        raise InputError(f"cannot read {name}: {error.strerror}") from None
    ships = sorted((DATA / folder).glob("*.*"))
    for file in ships:
        if path.name in (file.name, file.stem) and path.parent in (Path(), Path(folder)):
            return file
    names = ", ".join(file.stem for file in ships)
    raise InputError(f"cannot read {name}: there is no such file; {folder} that ship: {names}")


def read_text(path: Path) -> str:
    """The text of a UTF-8 file, a byte-order mark left out; InputError where it cannot be read."""
    try:
        with FileIO(path, opener=_open) as file:
            content = file.read(MOST_BYTES + 1)
            while len(content) <= MOST_BYTES and (more := file.read(MOST_BYTES)):  # of a pipe
                content += more
        text = content.decode("utf-8-sig")
    except OSError as error:
        raise InputError(f"cannot read {path}: {error.strerror or error}") from None
    except UnicodeDecodeError as error:
        raise InputError(
            f"cannot read {path}: not UTF-8, {error.reason} at {error.start}"
        ) from None
    if len(content) > MOST_BYTES:
        raise InputError(f"cannot read {path}: it has more than {MOST_BYTES >> 20} MB")
    return text.replace("\r\n", "\n")


def _open(path: str, flags: int) -> int:
    """As usual, but a pipe that nobody fills is an empty file, and not waited for."""
    if os.name != "posix":
        return os.open(path, flags)
    handle = os.open(path, flags | os.O_NONBLOCK)
    os.set_blocking(handle, True)
    return handle
