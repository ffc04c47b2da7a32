"""The journal of a study: rows written as they come, and the Parquet table in the end.

A line of JSON for each flight, after one that names the study, and behind each its checksum, which
begins with that of the study. What a crash or a full disk cut short is at most the last line,
which is taken off before the next one is written. A line that is not as it was written, whatever
became of it, is passed over and its flight flown again.
"""

import json
import os
from collections.abc import Iterable, Iterator
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import IO, Any
from zlib import crc32

from kitemj.errors import InputError
from kitemj.files import check_new, new_file
from kitemj.locks import locked
from kitemj.metadata import KEY, told
from kitemj.studies.flights import FAILED, Row, result_columns
from kitemj.studies.study import Study

AT_ONCE = 20_000
"""Rows turned into columns together."""
BEGINNING = b'{"study": '
"""What every journal begins with."""


class Journal:
    """The flights that are done; `path` stands beside the table until that is complete.

    A context manager. `count` flights are done; `damaged` lines were passed over.
    """

    def __init__(self, table: Path, study: Study, anew: bool = False) -> None:
        """`anew`: what was begun before is given up."""
        self.path = table.with_name(f"{table.name}.journal")
        self.study, self.anew = study, anew
        self.done, self.count, self.damaged = bytearray(study.design.count), 0, 0
        self._file: IO[bytes]
        self._end, self._begun, self._tabled = 0, False, False
        self._header = BEGINNING + json.dumps(study.digest).encode() + b"}\n"
        self._seal = crc32(self._header)

    def __enter__(self) -> "Journal":
        """Opens it, whether begun before or not.

        Raises InputError where it is of another study, or where another command writes to it.
        """
        self._file = self._opened()
        try:
            self._read()
            self._begun = self.count > 0
            self._file.truncate(self._end)
            if self._end == 0:
                self._append(self._header)
        except InputError:
            self._file.close()
            raise
        except OSError as error:
            self.__exit__(type(error))
            raise
        return self

    def __exit__(self, kind: type[BaseException] | None, *error: object) -> None:
        """Closes it; none stays that is of no more use, or of a study that was refused."""
        refused = kind is not None and issubclass(kind, InputError) and not self._begun
        useless, windows = self._tabled or refused or not self.count, os.name == "nt"
        if useless and not windows:  # while nobody else can go on with it
            self.path.unlink(missing_ok=True)
        self._file.close()
        if useless and windows:  # which removes nothing that is open
            self.path.unlink(missing_ok=True)

    def _opened(self) -> IO[bytes]:
        """The file, locked: no link, and not one that was removed meanwhile."""
        odd = InputError(f"{self.path} is not a journal of a study; give another name")
        if os.path.lexists(self.path) and (self.path.is_symlink() or not self.path.is_file()):
            raise odd
        check_new(self.path, overwrite=True)
        flags = os.O_RDWR | os.O_CREAT | os.O_APPEND
        system = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
        file = os.fdopen(os.open(self.path, flags | system, 0o666), "r+b", buffering=0)
        if not locked(file):
            file.close()
            reason = "wait for it, or write another table"
            raise InputError(f"another command is writing to {self.path}; {reason}")
        if self.path.exists() and os.path.samestat(os.fstat(file.fileno()), self.path.stat()):
            return file
        file.close()
        return self._opened()

    def _read(self) -> None:
        """Marks what is done, and finds where the last whole line ends."""
        with open(self._file.fileno(), "rb", closefd=False) as lines:
            first = lines.readline(len(self._header))
            if self.anew and (first.startswith(BEGINNING) or not first):
                return
            if first != self._header and not self._header.startswith(first):
                raise InputError(
                    f"{self.path} was begun by another study, or by other formulas; "
                    f"write another table, or `overwrite` to start anew"
                    if first.startswith(BEGINNING)
                    else f"{self.path} is not a journal of a study; give another name"
                )
            if first != self._header:
                return
            self._end = len(first)
            for line in lines:
                if not line.endswith(b"\n"):
                    break
                self._end += len(line)
                row = self._row(line)
                if row is None:
                    self.damaged += 1
                elif not self.done[row["flight"]]:
                    self._mark(row)

    def _line(self, row: Row) -> bytes:
        data = json.dumps(row).encode()
        return b"%s %08x\n" % (data, crc32(data, self._seal))

    def _row(self, line: bytes) -> Row | None:
        """The row that a line holds; None where it is not as it was written, or of this study."""
        data, _, seal = line.strip().rpartition(b" ")
        return json.loads(data) if seal == b"%08x" % crc32(data, self._seal) else None

    def _mark(self, row: Row) -> None:
        self.done[row["flight"]] = 1
        self.count += 1

    def _append(self, data: bytes) -> None:
        """Writes through to the disk; where that refuses, nothing of it stays. Raises OSError."""
        left = memoryview(data)
        try:
            while left:
                left = left[os.write(self._file.fileno(), left) :]
            os.fsync(self._file.fileno())
        except OSError as error:
            with suppress(OSError):
                self._file.truncate(self._end)
            raise OSError(error.errno, error.strerror, str(self.path)) from error
        self._end += len(data)

    def remaining(self) -> Iterator[int]:
        """Flights that are not done, ascending."""
        return (i for i in range(len(self.done)) if not self.done[i])

    def add(self, rows: Iterable[Row]) -> None:
        """Writes the rows through to the disk; raises OSError where that refuses."""
        new = {row["flight"]: row for row in rows if not self.done[row["flight"]]}
        self._append(b"".join(self._line(row) for row in new.values()))
        for row in new.values():
            self._mark(row)

    def write_table(self, table: Path, overwrite: bool) -> int:
        """Writes all rows by flight as one Parquet table, whose metadata name the study.

        Returns how many flights failed. With the table written the journal's use is over.
        """
        import pyarrow as pa
        import pyarrow.parquet as pq

        schema = self._schema()
        parts, rows = [schema.empty_table()], self._rows()
        while some := list(islice(rows, AT_ONCE)):
            columns = {
                field.name: [_cell(row.get(field.name), field.type) for row in some]
                for field in schema
            }
            parts.append(pa.table(columns, schema=schema))
        whole = pa.concat_tables(parts).sort_by("flight")
        if len(whole) < self.count:
            changed = f"{self.path} was changed by another program while the study was flown"
            raise InputError(f"{changed}: the same command flies what is missing")
        with new_file(table, overwrite) as part:
            pq.write_table(whole, part, compression="zstd")
        self._tabled = self.count == len(self.done)
        return sum(ending == FAILED for ending in whole["ending"].to_pylist())

    def _rows(self) -> Iterator[Row]:
        """The row of each flight that is done, the first of it that the file holds."""
        told = bytearray(len(self.done))
        self._file.seek(0)
        with open(self._file.fileno(), "rb", closefd=False) as lines:
            for row in map(self._row, lines):
                if row and not told[row["flight"]]:
                    told[row["flight"]] = 1
                    yield row

    def _schema(self) -> Any:
        import pyarrow as pa

        kinds: dict[type, Any] = {float: pa.float64(), str: pa.string()}
        design, results = self.study.design, result_columns(self.study.rig)
        given = {name: float if name in design.numbers else str for name in design.names}
        given = {name: kind for name, kind in given.items() if name not in results}
        fields = [(name, kinds[kind]) for name, kind in (given | results).items()]
        base = self.study.base._asdict()
        base["scenario"] = {"set": "laksa", **base["scenario"]}
        about = told({"holds": "flights of a study", **base})
        metadata = {"study": self.study.digest, KEY: about}
        return pa.schema([("flight", pa.int64()), *fields], metadata)


def _cell(value: Any, kind: Any) -> Any:
    """The value as the column has it."""
    if value is None:
        return None
    if str(kind) != "string":
        return float(value) if str(kind) == "double" else value
    text = value if isinstance(value, str) else json.dumps(value)
    return text.encode(errors="replace").decode()  # of names of files that are not text


def completed_by(table: Path, study: Study) -> bool:
    """Whether `table` is already what this study makes."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        metadata = pq.read_schema(table).metadata or {}
    except (OSError, pa.ArrowInvalid):
        return False
    return bool(metadata.get(b"study") == study.digest.encode())
