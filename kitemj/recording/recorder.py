"""A flight written to disk while it is flown, so that it never waits for the disk.

The flight leaves its ticks in a queue; a thread makes a record batch of them every half a
second and appends it to an Arrow IPC stream, whole or not at all. Whatever ends the program,
all batches before are readable. A disk that is full or gone makes the batches wait in
memory, to be written once there is room again.
"""

import io
import os
import threading
import time
from collections import deque
from contextlib import suppress
from pathlib import Path

import pyarrow as pa

from kitemj.errors import InputError
from kitemj.files import check_new
from kitemj.flight.pilot_settings import PilotSettings
from kitemj.locks import locked
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import rig_of
from kitemj.recording.checksum import ABOUT, sealed
from kitemj.recording.header import Header
from kitemj.recording.schema import schema
from kitemj.recording.table import Tick, table

SUFFIX = ".arrows"
FLUSH = 0.5
"""s between batches: what a crash may cost."""

MAX_WAITING = 60_000
"""Ticks, ten minutes of flight in 25 MB, that wait for a disk before the recording is given up."""

PATIENCE = 10.0
"""s; longer than this the end of a flight does not wait for the disk."""

ENDING_KEY = b"ending"


class Recorder:
    """Writes ticks to a new file `path`; `add` costs a microsecond and never waits.

    Raises InputError where `path` exists, cannot be written, or another program records into it.
    `problem` is what the person should know of the disk at present, `written` counts the ticks in
    the file.
    """

    def __init__(
        self,
        path: Path,
        header: Header,
        parameters: Parameters,
        overwrite: bool = False,
        pilot: PilotSettings | None = None,
    ) -> None:
        check_new(path, overwrite)
        self.path, self.problem, self.written = path, "", 0
        self._parameters, self._schema = parameters, schema(header, rig_of(parameters), pilot)
        self._queue: deque[Tick] = deque()
        self._waiting: deque[tuple[int, bytes]] = deque()
        self._size, self._seal, self._given_up = 0, 0, False
        self._sink = io.BytesIO()
        self._stream = pa.ipc.new_stream(self._sink, self._schema)
        self._file = _opened(path, overwrite)
        # the header at once; and the first batch loads much of pyarrow, which is to happen now
        self._batch({}, always=True)
        self._write()
        self._ending = ""
        self._stopping = threading.Event()
        self._thread = threading.Thread(target=self._run, name="recorder", daemon=True)
        self._thread.start()

    def add(self, tick: Tick) -> None:
        """Takes a tick."""
        self._queue.append(tick)

    def close(self, ending: str) -> str:
        """Writes what is left and how it ended; returns a sentence on what the file holds."""
        self._ending = ending
        self._stopping.set()
        self._thread.join(PATIENCE)
        if self._thread.is_alive():
            self.problem = f"{self.path} lacks its end: the disk did not answer for {PATIENCE:g} s"
        return self.problem or f"{self.path}, {self.written} ticks"

    def _run(self) -> None:
        try:
            while not self._stopping.wait(FLUSH):
                self._batch({})
                self._write()
            self._batch({ENDING_KEY: self._ending.encode()}, always=True)
            self._stream.close()
            self._waiting.append((0, self._taken()))
            self._write()
        except Exception as error:  # a thread's own end is silent, and the flight goes on
            self.problem = f"not recording ({error}): {self.path} ends after {self.written} ticks"
        finally:
            self._file.close()

    def _batch(self, about: dict[bytes, bytes], always: bool = False) -> None:
        """Makes a record batch of what is in the queue, `always` even of nothing."""
        ticks = [self._queue.popleft() for _ in range(len(self._queue))]
        if self._given_up or not (ticks or always):
            return
        columns = table(self._parameters, ticks)
        batch = pa.record_batch(list(columns.values()), schema=self._schema)
        self._stream.write_batch(batch, custom_metadata=ABOUT | about)
        message, self._seal = sealed(self._taken(), self._seal)
        self._waiting.append((len(ticks), message))

    def _taken(self) -> bytes:
        """The bytes that the stream made since."""
        made = self._sink.getvalue()
        self._sink.seek(0)
        self._sink.truncate()
        return made

    def _write(self) -> None:
        """Appends the waiting batches; where the disk refuses, cuts back to the last whole one."""
        while self._waiting:
            count, message = self._waiting[0]
            try:
                os.lseek(self._file.fileno(), self._size, os.SEEK_SET)
                _append(self._file.fileno(), message)
            except OSError as error:
                self._refused(error)
                return
            self._waiting.popleft()
            self._size += len(message)
            self.written += count
        if not self._given_up:
            self.problem = ""

    def _refused(self, error: OSError) -> None:
        with suppress(OSError):  # else half a batch stays until the next try is written over it
            os.ftruncate(self._file.fileno(), self._size)
        waiting = sum(count for count, _ in self._waiting)
        if waiting > MAX_WAITING:
            self._given_up = True
            self._waiting.clear()
        self.problem = (
            f"not recording ({error.strerror}): {self.path} ends after {self.written} ticks"
        )


def _opened(path: Path, overwrite: bool) -> io.FileIO:
    """The empty file, ours until it is closed; what another program records stays untouched."""
    new = os.O_CREAT if overwrite else os.O_CREAT | os.O_EXCL
    file = None
    try:  # opened so that it is not emptied yet
        file = io.FileIO(path, "r+", opener=lambda name, flags: os.open(name, flags | new, 0o666))
        if locked(file):
            file.truncate(0)
            return file
        error = f"another program is recording into {path}: choose another name, or end it"
    except OSError as refused:
        error = f"cannot write {path}: {refused.strerror}; choose another"
    if file:
        file.close()
    raise InputError(error)


def _append(file: int, message: bytes) -> None:
    left = memoryview(message)
    while left:
        left = left[os.write(file, left) :]


def timestamped_name(folder: Path = Path()) -> Path:
    """A name of the present moment that is free in `folder`."""
    stem = f"kitemj-{time.strftime('%Y%m%d-%H%M%S')}"
    names = (f"{stem}{f'-{n}' if n else ''}{SUFFIX}" for n in range(1000))
    return next(folder / name for name in names if not (folder / name).exists())


def latest(folder: Path = Path()) -> Path | None:
    """The recording in `folder`, named as `timestamped_name` does, last written to; None: none."""
    found = [path for path in folder.glob(f"kitemj-*{SUFFIX}") if path.is_file()]
    return max(found, key=lambda path: (path.stat().st_mtime_ns, path.name), default=None)
