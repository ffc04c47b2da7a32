"""The journal of a study: rows written as they come, and the Parquet table in the end.

A line of JSON for each flight, after one that names the study. What a crash or a full disk
cut short is at most the last line, which is taken off before the next one is written.
"""

import json
import os
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import IO, Any

from kitemj.errors import InputError
from kitemj.files import new_file
from kitemj.metadata import KEY, told
from kitemj.studies.flights import FAILED, Row, result_columns
from kitemj.studies.study import Study

try:
    import fcntl
except ImportError:  # Windows: there nobody is kept from starting the same study twice
    fcntl = None  # type: ignore[assignment]

AT_ONCE = 20_000
"""Rows turned into columns together."""


class Journal:
    """The flights that are done; `path` stands beside the table until that is complete."""

    def __init__(self, table: Path, study: Study) -> None:
        self.path = table.with_name(f"{table.name}.journal")
        self.study, self.done, self.count = study, bytearray(study.design.count), 0
        self._file: IO[bytes]

    def __enter__(self) -> "Journal":
        """Opens it, whether begun before or not.

        Raises InputError where it is of another study, or where another command writes to it.
        """
        self._file = os.fdopen(os.open(self.path, os.O_RDWR | os.O_CREAT, 0o666), "r+b")
        try:
            self._lock()
            end = self._read()
        except InputError:
            self._file.close()
            raise
        self._file.truncate(end)
        self._file.seek(end)
        if end == 0:
            self._file.write(self._header)
            self._file.flush()
        return self

    @property
    def _header(self) -> bytes:
        return json.dumps({"study": self.study.digest}).encode() + b"\n"

    def _lock(self) -> None:
        if fcntl is not None:
            try:
                fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                reason = "wait for it, or write another table"
                raise InputError(f"another command is writing to {self.path}; {reason}") from None

    def _read(self) -> int:
        """Marks what is done; returns where the last whole line ends."""
        first = self._file.readline()
        if not first.endswith(b"\n"):
            return 0
        if first != self._header:
            raise InputError(
                f"{self.path} was begun by another study, or by other formulas; "
                f"write another table, or `overwrite` to start anew"
            )
        end = len(first)
        for line in self._file:
            if not line.endswith(b"\n"):
                break
            end += len(line)
            self._mark(json.loads(line)["flight"])
        return end

    def __exit__(self, kind: type[BaseException] | None, *error: object) -> None:
        """Closes it; what a full disk refused is gone, what was written before is not."""
        try:
            self._file.close()
        except OSError:
            if kind is None:
                raise

    def _mark(self, flight: int) -> bool:
        """Marks a flight as done; returns whether it was new."""
        if self.done[flight]:
            return False
        self.done[flight] = 1
        self.count += 1
        return True

    def remaining(self) -> Iterator[int]:
        """Flights that are not done, ascending."""
        return (i for i in range(len(self.done)) if not self.done[i])

    def add(self, rows: Iterable[Row]) -> None:
        """Writes the rows through to the disk."""
        new = [row for row in rows if self._mark(row["flight"])]
        self._file.write(b"".join(json.dumps(row).encode() + b"\n" for row in new))
        self._file.flush()
        os.fsync(self._file.fileno())

    def write_table(self, table: Path, overwrite: bool) -> int:
        """Writes all rows by flight as one Parquet table, whose metadata name the study.

        Returns how many flights failed.
        """
        import pyarrow as pa
        import pyarrow.parquet as pq

        schema = self._schema()
        parts = [schema.empty_table()]
        with self.path.open("rb") as file:
            next(file)
            while lines := list(islice(file, AT_ONCE)):
                rows = [json.loads(line) for line in lines]
                columns = {
                    field.name: [_cell(row.get(field.name), field.type) for row in rows]
                    for field in schema
                }
                parts.append(pa.table(columns, schema=schema))
        whole = pa.concat_tables(parts).sort_by("flight")
        with new_file(table, overwrite) as part:
            pq.write_table(whole, part, compression="zstd")
        return sum(ending == FAILED for ending in whole["ending"].to_pylist())

    def _schema(self) -> Any:
        import pyarrow as pa

        kinds: dict[type, Any] = {float: pa.float64(), str: pa.string()}
        design, results = self.study.design, result_columns(self.study.rig)
        given = {name: float if name in design.numbers else str for name in design.names}
        given = {name: kind for name, kind in given.items() if name not in results}
        fields = [(name, kinds[kind]) for name, kind in (given | results).items()]
        about = told({"holds": "flights of a study", **self.study.base._asdict()})
        metadata = {"study": self.study.digest, KEY: about}
        return pa.schema([("flight", pa.int64()), *fields], metadata)


def _cell(value: Any, kind: Any) -> Any:
    text = str(kind) == "string" and not isinstance(value, str | None)
    return json.dumps(value) if text else value


def completed_by(table: Path, study: Study) -> bool:
    """Whether `table` is already what this study makes."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        metadata = pq.read_schema(table).metadata or {}
    except (OSError, pa.ArrowInvalid):
        return False
    return bool(metadata.get(b"study") == study.digest.encode())
