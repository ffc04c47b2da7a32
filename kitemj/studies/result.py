"""The table of a study, in memory."""

from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from kitemj.physics.checked import unknown_key
from kitemj.tables import Table, Tabled

if TYPE_CHECKING:
    import pyarrow as pa

SHOWN = 10
"""Rows that a notebook shows."""


class StudyResult(Tabled):
    """A row for each flight of the study called `name`: what was varied, and what came of it."""

    def __init__(self, name: str, rows: "pa.Table") -> None:
        self.name, self._rows = name, rows

    def __getitem__(self, column: str) -> NDArray[Any]:
        """The column of that name; InputError, with the names there are, for another."""
        if column not in self._rows.column_names:
            raise unknown_key(column, self._rows.column_names, "", self.name)
        return self._rows[column].to_numpy()  # type: ignore[no-any-return]

    def __len__(self) -> int:
        """Number of flights."""
        return len(self._rows)

    def table(self) -> "pa.Table":
        """The same as `kitemj sweep` writes."""
        return self._rows

    def tables(self) -> list[Table]:
        """The first rows."""
        first = self._rows.slice(0, SHOWN).to_pylist()
        rows = [tuple("" if cell is None else cell for cell in row.values()) for row in first]
        title = f"{self.name}: {min(SHOWN, len(self))} of {len(self)} flights"
        return [Table(title, tuple(self._rows.column_names), rows)]
