"""A recording read back: every whole batch of the file, whatever happened to its end."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from kitemj.errors import InputError
from kitemj.flight.limits import RECORDED, Departure, departure_in
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import rig_of
from kitemj.recording.header import Header, from_json
from kitemj.recording.recorder import ENDING_KEY, HEADER_KEY, SUFFIX
from kitemj.recording.table import Columns, all_columns, limit_numbers
from kitemj.tables import Cell, Table, Tabled


@dataclass(frozen=True, repr=False, eq=False)
class Recording(Tabled):
    """Header, parameters and columns (each of shape (rows,)) of the file `path`.

    `ending` is how the flight ended, "" where the file breaks off before it says so.
    """

    path: Path
    header: Header
    parameters: Parameters
    columns: Columns
    ending: str

    def __len__(self) -> int:
        """Number of rows."""
        return len(self.columns["tick"])

    def tables(self) -> list[Table]:
        """What was flown, how long, and how it ended; `kitemj info` tells more."""
        header, seconds = self.header, len(self) * self.header.tick
        rows: list[tuple[Cell, ...]] = [
            ("flown", f"{header.scenario}, {header.model}"),
            ("time", f"{seconds:.2f} s, {len(self)} ticks, flights: {len(self.episodes)}"),
            ("ended", self.ending or "it breaks off"),
        ]
        return [Table(self.path.name, ("", ""), rows)]

    __repr__ = Tabled.in_short

    @property
    def episodes(self) -> list[slice]:
        """The rows of each episode."""
        starts = np.flatnonzero(np.diff(self.columns["leg"], prepend=-1)).tolist()
        return [slice(a, b) for a, b in zip(starts, [*starts[1:], len(self)], strict=True)]

    def way_to(self, episode: slice) -> NDArray[np.intp]:
        """Rows flown from a start at tick 0 to the end of `episode`, those of its parents first."""
        tick, episodes = self.columns["tick"], self.episodes
        ways, first = [np.arange(episode.start, episode.stop)], int(tick[episode.start])
        while first > 0:
            episode = episodes[int(self.columns["parent"][episode.start])]
            rows = np.arange(episode.start, episode.stop)
            ways.insert(0, rows[tick[rows] < first])
            first = int(tick[episode.start])
        return np.concatenate(ways)

    def before(self, limits: Sequence[str]) -> NDArray[np.bool_]:
        """Rows before the first of their flight that is beyond one of `limits`, shape (rows,)."""
        rows = np.ones(len(self), np.bool_)
        for episode in self.episodes:
            way = self.way_to(episode)
            beyond = [np.zeros(len(way), np.bool_), *(self.columns[name][way] for name in limits)]
            within = ~np.logical_or.accumulate(np.any(beyond, axis=0))
            rows[episode] = within[way >= episode.start]
        return rows

    def departure(self, episode: slice) -> Departure | None:
        """The first departure of an episode; None: it stayed within limits."""
        columns = {name: column[episode] for name, column in self.columns.items()}
        return departure_in(
            self.parameters.limits, columns["t_s"].tolist(), limit_numbers(columns), RECORDED
        )


def read_recording(path: str | Path) -> Recording:
    """The recording in a file; raises InputError with one sentence where it is none."""
    path = Path(path)
    batches, about = _batches(path)
    header = from_json(about, path.name)
    if not any(batch.num_rows for batch, _ in batches):
        raise InputError(f"{path} holds no tick: it was cut, or stopped in its first half second")
    whole = pa.Table.from_batches([batch for batch, _ in batches])
    parameters = header.checked_parameters(path.name)
    names = all_columns(rig_of(parameters))
    missing = [name for name in names if name not in whole.column_names]
    if missing:
        raise InputError(f"{path} lacks the column {missing[0]}: another version wrote it")
    columns = {name: whole[name].to_numpy() for name in names}
    endings = [said[ENDING_KEY].decode() for _, said in batches if said and ENDING_KEY in said]
    recording = Recording(path, header, parameters, columns, endings[-1] if endings else "")
    _check_parents(recording)
    return recording


def _check_parents(recording: Recording) -> None:
    """Raises InputError where an episode goes on from none before it."""
    for number, episode in enumerate(recording.episodes):
        parent, tick = (int(recording.columns[key][episode.start]) for key in ("parent", "tick"))
        if tick > 0 and not 0 <= parent < number:
            raise InputError(
                f"{recording.path} is damaged: its flight {number + 1} goes on from flight "
                f"{parent + 1}, which must be an earlier one"
            )


def _batches(path: Path) -> tuple[list[tuple[pa.RecordBatch, dict[bytes, bytes] | None]], bytes]:
    """All whole batches with what each says of itself, and the header."""
    if not path.is_file():
        what = "is a folder" if path.is_dir() else "does not exist"
        raise InputError(f"{path} {what}: give the name of a recording (*{SUFFIX})")
    if path.stat().st_size == 0:
        raise InputError(f"{path} is empty: the program was stopped before it wrote anything")
    try:
        stream = pa.ipc.open_stream(pa.memory_map(str(path)))
        about = (stream.schema.metadata or {})[HEADER_KEY]
    except (pa.ArrowException, OSError, KeyError):
        raise InputError(
            f"{path} is not a recording of kitemj, or was cut off within its header"
        ) from None
    batches: list[tuple[pa.RecordBatch, dict[bytes, bytes] | None]] = []
    while True:
        try:
            batch, said = stream.read_next_batch_with_custom_metadata()
        except (StopIteration, pa.ArrowException, OSError):
            return batches, about
        batches.append((batch, said))
