"""A folder for a while, which goes when the program does, however that ends."""

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from shutil import rmtree
from tempfile import mkdtemp

SWEEPER = """
import os, shutil, sys, time
sys.stdin.read()
for again in range(100):  # who writes there may live for a moment longer
    shutil.rmtree(sys.argv[1], ignore_errors=True)
    if not os.path.exists(sys.argv[1]):
        break
    time.sleep(0.1)
"""
"""Waits until nobody holds the other end of its input: a killed program cannot sweep."""


@contextmanager
def temporary_folder(prefix: str = "kitemj-", parent: Path | None = None) -> Iterator[Path]:
    """A new folder in `parent` (None: where such things belong), gone when the block ends."""
    folder = Path(mkdtemp(prefix=prefix, dir=parent)).absolute()
    words = [sys.executable, "-I", "-S", "-c", SWEEPER, str(folder)]
    sweeper = None
    with suppress(OSError):
        sweeper = subprocess.Popen(words, stdin=subprocess.PIPE, start_new_session=True)
    try:
        yield folder
    finally:
        rmtree(folder, ignore_errors=True)
        if sweeper and sweeper.stdin:
            sweeper.stdin.close()
            sweeper.wait()
