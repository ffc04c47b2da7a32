"""Files that ship: in ``data/`` of an installed package, in folders beside it in a checkout."""

from pathlib import Path

from kitemj.errors import InputError

PACKAGE = Path(__file__).parent
DATA = PACKAGE / "data" if (PACKAGE / "data").is_dir() else PACKAGE.parent
SCENARIOS, STICKS, STUDIES = "scenarios", "scenarios/sticks", "studies"


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
    if (beside / path).exists():
        return beside / path
    ships = sorted((DATA / folder).glob("*.*"))
    for file in ships:
        if path.name in (file.name, file.stem) and path.parent in (Path(), Path(folder)):
            return file
    names = ", ".join(file.stem for file in ships)
    raise InputError(f"cannot read {name}: there is no such file; {folder} that ship: {names}")
