"""Tables as `kitemj simulate` and `kitemj replay --export` write them, read back."""

from pathlib import Path

import numpy as np
import pyarrow as pa

from kitemj.errors import InputError
from kitemj.recording.table import Columns

TABLES = (".csv", ".parquet")


def read_columns(path: Path) -> Columns:
    """Every column by its name, shape (rows,); InputError where the file holds no table."""
    from pyarrow import csv, parquet

    read = csv.read_csv if path.suffix.lower() == ".csv" else parquet.read_table
    try:
        table = read(path)
    except (pa.ArrowException, OSError) as error:
        reason = str(error).splitlines()[0]
        raise InputError(f"{path} is not a table that can be read: {reason}") from None
    if not table.num_rows:
        raise InputError(f"{path} holds no row")
    return {name: table[name].to_numpy() for name in table.column_names}


def episodes_of(columns: Columns) -> list[slice]:
    """The rows of each flight: one, unless a column `leg` tells several apart."""
    rows = len(next(iter(columns.values())))
    if "leg" not in columns:
        return [slice(0, rows)]
    cuts = (np.flatnonzero(np.diff(columns["leg"])) + 1).tolist()
    return [slice(a, b) for a, b in zip([0, *cuts], [*cuts, rows], strict=True)]
