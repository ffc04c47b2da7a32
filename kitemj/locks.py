"""One writer for a file: the system's lock on the file itself, however its name is spelt.

It ends with the program that holds it, whatever ended that, and keeps nobody from reading.
"""

import sys
from typing import IO, Any

if sys.platform == "win32":
    import msvcrt

    FAR = 1 << 62
    """The byte that is locked: there a locked byte cannot be read, and no file is so long."""

    def _lock(file: IO[Any]) -> None:
        file.seek(FAR)
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        file.seek(0)

else:
    import fcntl

    def _lock(file: IO[Any]) -> None:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


def locked(file: IO[Any]) -> bool:
    """Whether `file` is ours to write until it is closed; False: another program holds it.

    A file system that knows no locks keeps nobody from anything: there the answer is True.
    """
    try:
        _lock(file)
    except (BlockingIOError, PermissionError):
        return False
    except OSError:
        return True
    return True
