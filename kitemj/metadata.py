"""What a table says of itself: in the metadata of Parquet, in a file beside a CSV.

The file beside has the name and the form of W3C's "CSV on the Web" (flight.csv-metadata.json), so
that the table itself stays one that every program reads: a comment in it would break most.
"""

import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from importlib.metadata import version
from pathlib import Path
from typing import Any
from zlib import crc32

from kitemj.files import check_new, is_stream, new_file

KEY = "kitemj"
"""Under which it stands, in Parquet, Arrow and beside a CSV."""


def metadata_file(table: Path) -> Path:
    """The file that says what a CSV is."""
    return table.with_name(f"{table.name}-metadata.json")


def check_new_table(path: Path, overwrite: bool) -> None:
    """Raises InputError as `check_new`, for a CSV also where what says so of it cannot be new."""
    check_new(path, overwrite)
    if _told_beside(path):
        check_new(metadata_file(path), overwrite)


def told(about: Mapping[str, Any]) -> str:
    """What is said of a table, as it stands in its metadata."""
    return json.dumps({"written_by": f"kitemj {version('kitemj')}", **about})


@contextmanager
def new_csv(path: Path, about: Mapping[str, Any], overwrite: bool = False) -> Iterator[Path]:
    """A name to write a CSV to, as `new_file`; beside it appears what the table is `about`.

    Both or none; where `path` is a stream, nothing is beside it.
    """
    if not _told_beside(path):
        with new_file(path, overwrite) as part:
            yield part
        return
    new = not os.path.lexists(path)
    alone = False
    try:  # the table appears first: nothing is told of one that does not
        with new_file(metadata_file(path), overwrite) as beside:
            with new_file(path, overwrite) as part:
                yield part
                _tell(beside, path.name, about, part.read_bytes())
            alone = new
    except BaseException:
        if alone:
            path.unlink(missing_ok=True)
        raise


def _tell(beside: Path, name: str, about: Mapping[str, Any], content: bytes) -> None:
    note = {KEY: json.loads(told(about)), "crc32": f"{crc32(content):08x}"}
    document = {"@context": "http://www.w3.org/ns/csvw", "url": name, "notes": [note]}
    beside.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")


def about_csv(path: Path) -> dict[str, Any]:
    """What is told of the CSV `path`; {} where nothing is, or of another content."""
    try:
        [note] = json.loads(metadata_file(path).read_text(encoding="utf-8"))["notes"]
        told_of, about = note["crc32"], note[KEY]
        same = told_of == f"{crc32(path.read_bytes()):08x}"
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return {}
    return dict(about) if same and isinstance(about, dict) else {}


def about_columns(metadata: Mapping[bytes, bytes] | None) -> dict[str, Any]:
    """What the metadata of an Arrow schema tell; {} where that is nothing."""
    try:
        about = json.loads((metadata or {})[KEY.encode()])
    except (ValueError, KeyError, RecursionError):
        return {}
    return about if isinstance(about, dict) else {}


def _told_beside(path: Path) -> bool:
    return path.suffix.lower() == ".csv" and not is_stream(path)
