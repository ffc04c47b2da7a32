"""A recording as a table of text, for programs that do not read Arrow."""

from pathlib import Path

import pyarrow as pa
from pyarrow import csv

from kitemj.metadata import new_csv
from kitemj.recording.file import Recording


def write_table(path: Path, recording: Recording, overwrite: bool = False) -> None:
    """Every column and row as CSV, all digits kept; the columns of `simulate` come first.

    The recording's header is told beside it. What is not a number (a reference that is lost) is
    an empty cell. Raises InputError where `path` exists or cannot be written.
    """
    options = csv.WriteOptions(include_header=False)
    names = list(recording.columns)
    columns = [pa.array(recording.columns[name], from_pandas=True) for name in names]
    with new_csv(path, vars(recording.header), overwrite) as part, part.open("wb") as file:
        file.write(f"{','.join(names)}\n".encode())
        csv.write_csv(pa.table(columns, names=names), file, options)
