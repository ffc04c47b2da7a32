"""Where ``models/`` is: inside an installed package, or beside it in a checkout."""

from pathlib import Path


def model_file(name: str) -> Path:
    """The path of ``models/<name>``; raises FileNotFoundError where neither place has it."""
    package = Path(__file__).parent
    for folder in (package / "models", package.parent / "models"):
        if (folder / name).is_file():
            return folder / name
    raise FileNotFoundError(f"models/{name} is missing from this installation of kitemj")
