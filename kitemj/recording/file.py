"""A recording read back: every whole batch of the file, whatever happened to its end."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from kitemj.errors import InputError
from kitemj.flight.limits import RECORDED, Departure, departure_in
from kitemj.flight.pilot_settings import PilotSettings
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import rig_of
from kitemj.recording.checksum import sound_part
from kitemj.recording.header import Header, from_json
from kitemj.recording.pilot import pilot_from_json
from kitemj.recording.recorder import ENDING_KEY, SUFFIX
from kitemj.recording.schema import HEADER_KEY, PILOT_KEY, checked_columns
from kitemj.recording.table import Columns, limit_numbers
from kitemj.tables import Cell, Table, Tabled

Batch = tuple[pa.RecordBatch, dict[bytes, bytes] | None]


@dataclass(frozen=True, repr=False, eq=False)
class Recording(Tabled):
    """Header, parameters and columns (each of shape (rows,)) of the file `path`.

    `ending` is how the flight ended, "" where the file breaks off before it says so. `pilot`: the
    settings of the autopilot of its scenario, if it had one.
    """

    path: Path
    header: Header
    parameters: Parameters
    columns: Columns
    ending: str
    pilot: PilotSettings | None = None

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
    data = _bytes(path)
    sound = sound_part(data)
    about, said_pilot, batches = _batches(path, pa.py_buffer(data).slice(0, sound.size))
    if sound.damaged:
        raise _damaged(path, sound.size, batches)
    header = from_json(about, path.name)
    if not any(batch.num_rows for batch, _ in batches):
        raise InputError(f"{path} holds no tick: it was cut, or stopped in its first half second")
    parameters = header.checked_parameters(path.name)
    whole = pa.Table.from_batches([batch for batch, _ in batches])
    columns = checked_columns(whole, header, rig_of(parameters), path.name)
    endings = [said[ENDING_KEY] for _, said in batches if said and ENDING_KEY in said]
    ending = endings[-1].decode("utf-8", "replace") if endings else ""
    pilot = pilot_from_json(said_pilot, path.name) if said_pilot else None
    return Recording(path, header, parameters, columns, ending, pilot)


def _damaged(path: Path, size: int, batches: list[Batch]) -> InputError:
    """What to tell of a file of which the first `size` bytes, the `batches`, are sound."""
    times = [batch["t_s"] for batch, _ in batches if batch.num_rows]
    if not times:
        return InputError(f"{path} is damaged from its beginning on: nothing of it can be trusted")
    rows = sum(len(column) for column in times)
    return InputError(
        f"{path} is damaged after {times[-1][-1].as_py():.2f} s, row {rows}: a checksum is wrong; "
        f"its first {size} bytes are sound, and a recording, if you copy these to a file of their "
        f"own (head -c {size})"
    )


def _bytes(path: Path) -> bytes:
    """All bytes; a copy, since the file may grow, or be emptied by whoever writes it."""
    if not path.is_file():
        what = (
            "is a folder" if path.is_dir() else "is no file" if path.exists() else "does not exist"
        )
        raise InputError(f"{path} {what}: give the name of a recording (*{SUFFIX})")
    try:
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"cannot read {path}: {error.strerror}") from None
    if not data:
        raise InputError(f"{path} is empty: the program was stopped before it wrote anything")
    return data


def _batches(path: Path, data: pa.Buffer) -> tuple[bytes, bytes, list[Batch]]:
    """Header, autopilot ("" if none), and all whole batches with what each says of itself."""
    batches: list[Batch] = []
    try:
        stream = pa.ipc.open_stream(data)
        metadata = stream.schema.metadata or {}
        about: bytes = metadata[HEADER_KEY]
    except (pa.ArrowException, OSError, KeyError):
        raise InputError(
            f"{path} is not a recording of kitemj, or was cut off or damaged within its header"
        ) from None
    while True:
        try:
            batch, said = stream.read_next_batch_with_custom_metadata()
            batch.validate(full=True)
        except (StopIteration, pa.ArrowException, OSError):
            return about, metadata.get(PILOT_KEY, b""), batches
        batches.append((batch, said))
