"""Files that appear whole or not at all, and never in place of another unasked."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from kitemj.errors import InputError


def check_new(path: Path, overwrite: bool) -> None:
    """Raises InputError where `path` exists (and `overwrite` is off) or cannot be written."""
    if path.is_dir():
        raise InputError(f"{path} is a folder; give the name of a file")
    if path.exists() and not overwrite:
        raise InputError(f"{path} exists; give another name, or `overwrite`")
    if not path.parent.is_dir():
        raise InputError(f"there is no folder {path.parent}; make it first")
    if not os.access(path.parent, os.W_OK):
        raise InputError(f"the folder {path.parent} is not writable; choose another")


@contextmanager
def new_file(path: Path, overwrite: bool = False) -> Iterator[Path]:
    """A name beside `path` to write to; it becomes `path` when the block ends without error."""
    check_new(path, overwrite)
    part = path.with_name(f"{path.name}.part")
    try:
        yield part
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)
