"""The folder of the formulas' machine code: whether it can be used is tried, and what if not."""

import atexit
import hashlib
import os
import sys
import tempfile
from functools import cache
from multiprocessing import parent_process
from pathlib import Path
from shutil import rmtree

from platformdirs import user_cache_path

PACKAGE = Path(__file__).parent.parent
INHERITED = "KITEMJ_PRIVATE_CACHE"
"""Environment variable that tells a process the private folder of the one that started it."""


@cache
def formula_hash() -> str:
    """A hash of the source of every formula of the package."""
    digest = hashlib.sha256()
    for source in sorted(PACKAGE.glob("*/*.py")):
        if b"@compiled" in (text := source.read_bytes()) or source.parent.name == "physics":
            digest.update(text)
    return digest.hexdigest()[:16]


@cache
def code_folder() -> Path | None:
    """Where machine code is kept, one folder for each state of the formulas; None: nowhere.

    Where the usual one cannot be used, this says so once, and makes a private one, which the
    processes that are started from here share, and which goes when this one ends.
    """
    name = f"compiled-{formula_hash()}"
    inherited = Path(os.environ.get(INHERITED) or "nowhere")
    if inherited.is_absolute() and inherited.is_dir() and not _trouble(inherited / name):
        return inherited / name
    usual = user_cache_path("kitemj") / name
    if not (why := _trouble(usual)):
        return usual
    complain(usual, why)
    try:
        private = Path(tempfile.mkdtemp(prefix="kitemj-"))
        (private / name).mkdir()
    except OSError:
        return None
    atexit.register(_remove, private, os.getpid())
    os.environ[INHERITED] = str(private)
    return private / name


def complain(folder: Path, why: str) -> None:
    """Tells a person, once and not from every process, that nothing can be kept in `folder`."""
    if not parent_process():
        print(
            f"kitemj: the folder {folder} cannot be used ({why}), so formulas are compiled "
            f"at every start, some 15 s; mend it, or name another in XDG_CACHE_HOME",
            file=sys.stderr,
        )


def owner() -> int:
    """Whose files are trusted: machine code of anybody else could do anything in our name."""
    return os.geteuid() if hasattr(os, "geteuid") else 0  # where there is none, st_uid is 0


def _trouble(folder: Path) -> str:
    """Why `folder` cannot be used; empty where a file could be written."""
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        if folder.stat().st_uid != owner():
            return "it belongs to another user"
        tempfile.TemporaryFile(dir=folder).close()
    except OSError as error:
        return error.strerror or str(error)
    return ""


def _remove(folder: Path, maker: int) -> None:
    if os.getpid() == maker:  # and not a process that was forked from it
        rmtree(folder, ignore_errors=True)
