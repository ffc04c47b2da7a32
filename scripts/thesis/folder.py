"""A folder written whole or not at all, and never over another unasked."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from kitemj.errors import InputError
from kitemj.temporary import temporary_folder


def check_folder(path: Path, overwrite: bool) -> None:
    """Raises InputError where `path` has content (and `overwrite` is off) or cannot be made."""
    if os.path.lexists(path) and not path.is_dir():  # a link may lead nowhere
        raise InputError(f"{path} is no folder; give the name of one")
    if path.is_dir() and any(path.iterdir()) and not overwrite:
        raise InputError(
            f"the folder {path} exists and is not empty; give another name, or --overwrite"
        )
    parent = path.absolute().parent
    if not parent.is_dir():
        raise InputError(f"there is no folder {path.parent}; make it first")
    for folder in filter(Path.is_dir, (parent, path)):
        if not os.access(folder, os.W_OK):
            raise InputError(f"the folder {folder} is not writable; choose another")


@contextmanager
def new_folder(path: Path, overwrite: bool = False) -> Iterator[Path]:
    """A folder beside `path` to fill; its content is in `path` when the block ends without error.

    In a folder that has content, files of the same names are replaced and all others kept.
    """
    check_folder(path, overwrite)
    with temporary_folder(f".{path.name}-", path.absolute().parent) as part:
        yield part
        check_folder(path, overwrite)  # much may have happened meanwhile
        if path.is_dir() and any(path.iterdir()):
            _replace(part, path)
        else:
            part.chmod(0o777 & ~_umask())
            if path.is_dir():
                path.rmdir()
            part.replace(path)


def _replace(part: Path, path: Path) -> None:
    """Every file of `part` into `path`, those in folders first: the page comes last."""
    files = sorted((file for file in part.rglob("*") if file.is_file()), key=_deepest_first)
    for file in files:
        target = path / file.relative_to(part)
        target.parent.mkdir(exist_ok=True)
        file.replace(target)


def _deepest_first(file: Path) -> tuple[int, str]:
    return -len(file.parts), file.name


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
