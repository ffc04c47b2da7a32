"""A recording as a table of text, for programs that do not read Arrow."""

from pathlib import Path

import pyarrow as pa
from pyarrow import csv

from kitemj.files import new_file
from kitemj.recording.file import Recording
from kitemj.recording.table import ALL


def write_table(path: Path, recording: Recording, overwrite: bool = False) -> None:
    """Every column and row as CSV, all digits kept; the columns of `simulate` come first.

    What is not a number (a reference that is lost) is an empty cell. Raises InputError where
    `path` exists or cannot be written.
    """
    options = csv.WriteOptions(include_header=False)
    columns = [pa.array(recording.columns[name], from_pandas=True) for name in ALL]
    with new_file(path, overwrite) as part, part.open("wb") as file:
        file.write(f"{','.join(ALL)}\n".encode())
        csv.write_csv(pa.table(columns, names=list(ALL)), file, options)
