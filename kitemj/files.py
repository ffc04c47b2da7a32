"""Files that appear whole or not at all, and never in place of another unasked."""

import errno
import os
import re
import shutil
import stat
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from secrets import token_hex

from kitemj.console import flush
from kitemj.errors import InputError

OPEN = {"/dev/stdout": 1, "/dev/stderr": 2}
"""What this process has open is not replaced either, though it be a file: /dev/fd/N, and these."""


PATIENCE = 2.0
"""s; for the reader of a pipe to come."""


def check_new(path: Path, overwrite: bool) -> None:
    """Raises InputError where `path` exists (and `overwrite` is off) or cannot be written.

    A stream, such as /dev/null, is never replaced, so it needs no `overwrite`.
    """
    try:
        _check_new(path, overwrite)
    except OSError as error:  # such as a name that is too long
        raise InputError(f"cannot write {path}: {error.strerror}; choose another") from None


def _check_new(path: Path, overwrite: bool) -> None:
    if path.is_dir():
        raise InputError(f"{path} is a folder; give the name of a file")
    if is_stream(path):
        return
    if os.path.lexists(path) and not overwrite:
        raise InputError(f"{path} exists; give another name, or `overwrite`")
    target = _target(path)
    if target.is_symlink():
        raise InputError(f"{path} is a link that leads back to itself; give another name")
    if target.exists() and not (target.is_file() and os.access(target, os.W_OK)):
        why = "is write-protected" if target.is_file() else "is not a file"
        raise InputError(f"{path} {why}; give another name")
    if not target.parent.is_dir():
        raise InputError(f"there is no folder {target.parent}; make it first")
    if not os.access(target.parent, os.W_OK):
        raise InputError(f"the folder {target.parent} is not writable; choose another")


def is_stream(path: Path) -> bool:
    """Whether what is written to `path` goes on from there: a pipe, a terminal, /dev/null."""
    try:
        mode = path.stat().st_mode
    except OSError:
        return False
    return _open_number(path) is not None or stat.S_ISFIFO(mode) or stat.S_ISCHR(mode)


def _opened(path: Path) -> int:
    """A stream, opened to be written into; raises InputError for a pipe that nobody reads."""
    until = time.monotonic() + PATIENCE
    while True:
        try:
            stream = os.open(path, os.O_WRONLY | os.O_APPEND | getattr(os, "O_NONBLOCK", 0))
        except OSError as error:
            if error.errno != errno.ENXIO:
                raise
            if time.monotonic() > until:
                says = "is a pipe that nobody reads; start its reader first"
                raise InputError(f"{path} {says}") from None
            time.sleep(0.05)
        else:
            os.set_blocking(stream, True)
            return stream


def _open_number(path: Path) -> int | None:
    """Which of what this process has open `path` stands for; None: it is an ordinary name."""
    name = str(path.absolute())
    found = re.fullmatch(r"(?:/dev|/proc/self)/fd/(\d+)", name)
    return int(found[1]) if found else OPEN.get(name)


class NewFile:
    """A file that is to appear at `path`: written at `part`, then kept or discarded.

    `part` is a new file beside it that no other has the name of; where the system can (Linux), it
    has no name in the folder until it is kept, so that nothing is left of a program that is
    killed. A link at `path` stays, and the file it leads to is replaced, whose permissions stay;
    a stream is written into.
    """

    _nameless: int | None = None

    def __init__(self, path: Path, overwrite: bool = False) -> None:
        """Raises InputError as `check_new`, and OSError, which names `path`."""
        check_new(path, overwrite)
        self.path, self.overwrite = path, overwrite
        self._stream = is_stream(path)
        folder = Path(tempfile.gettempdir()) if self._stream else _target(path).parent
        self._name = self.part = folder / f".kitemj-{token_hex(8)}.part"
        if hasattr(os, "O_TMPFILE") and Path("/proc/self/fd").is_dir():
            with suppress(OSError):  # not every kind of disk can
                self._nameless = os.open(folder, os.O_RDWR | os.O_TMPFILE, 0o666)
                self.part = Path(f"/proc/self/fd/{self._nameless}")
                return
        try:
            with self.naming():
                # exclusive: neither a file nor a link there is used; the umask counts
                os.close(os.open(self.part, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666))
        except PermissionError:
            why = os.strerror(errno.EACCES)
            raise InputError(f"cannot write {path}: {why}; choose another") from None

    def keep(self) -> None:
        """Gives the file its name, once it is on the disk; raises what `__init__` does."""
        with self.naming():
            if self._stream:
                self._pour()
                return
            with self.part.open("r+b") as file:
                os.fsync(file.fileno())
            check_new(self.path, self.overwrite)  # much may have happened meanwhile
            target = _target(self.path)
            with suppress(FileNotFoundError):
                self.part.chmod(stat.S_IMODE(target.stat().st_mode))
            if self._nameless is not None:  # given, the descriptor has the link followed
                os.link(self.part, self._name, src_dir_fd=self._nameless)
            self._name.replace(target)

    def _pour(self) -> None:
        """Writes all into the stream, after what was printed before."""
        flush()
        number = _open_number(self.path)
        stream = _opened(self.path) if number is None else os.dup(number)
        with os.fdopen(stream, "wb") as taking, self.part.open("rb") as file:
            shutil.copyfileobj(file, taking)

    def discard(self) -> None:
        """Removes what was not kept; may be called twice."""
        if self._nameless is not None:
            os.close(self._nameless)
            self._nameless = None
        self._name.unlink(missing_ok=True)

    @contextmanager
    def naming(self) -> Iterator[None]:
        """What the system refuses in the block is told of `path`, as OSError."""
        try:
            yield
        except OSError as error:
            if error.filename not in (None, str(self.part), str(self._name)):
                raise
            known = error.errno or errno.EIO
            reason = f"{os.strerror(known)}; nothing of it is kept"
            raise OSError(known, reason, str(self.path)) from error


@contextmanager
def new_file(path: Path, overwrite: bool = False) -> Iterator[Path]:
    """A name beside `path` to write to; it becomes `path` when the block ends without error."""
    new = NewFile(path, overwrite)
    try:
        with new.naming():
            yield new.part
        new.keep()
    finally:
        new.discard()


def _target(path: Path) -> Path:
    """The file that a link leads to; `path` itself where it is none."""
    return Path(os.path.realpath(path)) if path.is_symlink() else path
