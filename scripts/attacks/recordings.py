"""Recordings with headers, columns and rows that no flight has, cut, and with a flipped bit."""

import json
import random
import tempfile
from collections.abc import Callable, Mapping
from functools import cache, partial
from itertools import cycle
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa

from attacks.victim import Attack, harm_of, run
from kitemj.flight.live import Command
from kitemj.recording import recorder
from kitemj.recording.live import LiveFlight

NAME = "attack.arrows"
READERS = (
    ["replay", NAME, "--headless", "--model", "mujoco"],
    ["limits", NAME],
    ["replay", NAME, "--export", "csv"],
    ["replay", NAME, "--headless", "--model", "lagrange"],
    ["plot", NAME, "--save", "plot.svg"],
    ["film", NAME, "--output", "film.mp4", "--size", "320x180", "--to", "0.1"],
)
"""One of them, in turn, beside `info`; the slow ones are the rare ones."""
TURNS = (0, 1, 2, 0, 3, 1, 2, 0, 4, 1, 2, 0, 3, 1, 2, 5)
VALUES: tuple[Any, ...] = (
    *(None, True, 0, -1, 2, 1e308, -1e308, 5e-324, 1e-12, float("nan"), float("inf"), 2**63),
    *("", "x", [], {}, [[]], [1.0], {"x": None}, "\ud800", "x" * 300),
)
TYPES = (pa.string(), pa.int64(), pa.null())
NUMBERS = (float("nan"), 1e308)
CUTS, FLIPS = 50, 100
MISSING = "missing"

Change = Callable[[pa.Table], pa.Table]


def attacks() -> list[Attack]:
    """Each is read by `info` and one other command."""
    turn = cycle(TURNS)
    made = {
        **{f"header: {what}": partial(_with_header, change) for what, change in _headers()},
        **{f"column {what}": partial(_with_table, change) for what, change in _columns()},
        **{f"rows: {what}": partial(_with_table, change) for what, change in _rows()},
    }
    dice = random.Random(13)
    found = [
        Attack(what, partial(_read, make, READERS[next(turn)], "")) for what, make in made.items()
    ]
    for _ in range(CUTS):
        cut = partial(_cut, part := dice.random())
        found.append(Attack(f"cut at {part:.3f}", partial(_read, cut, READERS[next(turn)], "cut")))
    for _ in range(FLIPS):
        flip = partial(_flipped, part := dice.random(), bit := dice.randrange(8))
        what = f"bit {bit} at {part:.4f} flipped"
        found.append(Attack(what, partial(_read, flip, READERS[next(turn)], "flip")))
    return found


def _read(make: Callable[[], bytes], reader: list[str], kind: str, folder: Path) -> str:
    """What `info` and another reader do with it: both take it, or both refuse it."""
    (folder / NAME).write_bytes(make())
    told, other = run(["info", NAME], folder), run(reader, folder)
    if harm := harm_of(told) or harm_of(other):
        return f"{harm} ({reader[0]})"
    if (told.status == 2) != (other.status == 2):
        return f"wrong: info {told.status}, {reader[0]} {other.status}: {other.error or told.error}"
    for each in (told, other):
        if each.status == 2 and len(each.error.strip().splitlines()) != 1:
            return f"wrong: not one sentence: {each.error}"
    if kind == "flip" and told.status == 0:
        return "wrong: read as sound"
    if kind == "cut" and told.status == 0 and "breaks off" not in told.out:
        return "wrong: not said to be cut"
    return ""


@cache
def recording() -> bytes:
    """Three short flights, the second going on from the first, in many batches."""
    with tempfile.TemporaryDirectory() as folder:
        path, usual = Path(folder) / NAME, recorder.FLUSH
        recorder.FLUSH = 0.01
        try:
            scenario = {"set": "sport", "duration": 60.0}
            with LiveFlight(scenario, reference="lagrange", record=path) as flight:
                _fly(flight, 30)
                saved = flight.save()
                _fly(flight, 10)
                flight.resume(saved)
                _fly(flight, 15)
                flight.restart()
                _fly(flight, 20)
        finally:
            recorder.FLUSH = usual
        return path.read_bytes()


def _fly(flight: LiveFlight, ticks: int) -> None:
    for tick in range(ticks):
        flight.tick(Command(0.3 if tick % 7 < 4 else -0.2, 0.1))


@cache
def _table() -> pa.Table:
    return pa.ipc.open_stream(recording()).read_all()


def _header() -> dict[str, Any]:
    header: dict[str, Any] = json.loads(_table().schema.metadata[b"kitemj"])
    return header


def _written(table: pa.Table) -> bytes:
    sink = pa.BufferOutputStream()
    with pa.ipc.new_stream(sink, table.schema) as stream:
        stream.write_table(table)
    return bytes(sink.getvalue())


def _with_table(change: Change) -> bytes:
    return _written(change(_table()))


def _with_header(change: Callable[[dict[str, Any]], object]) -> bytes:
    header = _header()
    text = change(header)
    about = text if isinstance(text, bytes) else json.dumps(header).encode()
    return _written(_table().replace_schema_metadata({b"kitemj": about}))


def _cut(part: float) -> bytes:
    data = recording()
    return data[: int(part * (len(data) - 8))]


def _flipped(part: float, bit: int) -> bytes:
    data = bytearray(recording())
    data[int(part * (len(data) - 8))] ^= 1 << bit  # the last 8 only say that it was closed
    return bytes(data)


def _headers() -> list[tuple[str, Callable[[dict[str, Any]], object]]]:
    """What, and a change of the header; one that returns bytes has them in its place."""
    header = _header()
    paths: list[tuple[str | int, ...]] = [(name,) for name in header]
    paths += [("parameters", section) for section in header["parameters"]]
    paths += [("parameters", "kite", "mass"), ("parameters", "aero", "law"), ("starts", 0)]
    paths += [("starts", 0, 0), ("starts", 0, 1, 2), ("versions", "kitemj")]
    found: list[tuple[str, Callable[[dict[str, Any]], object]]] = []
    for path in paths:
        for value in VALUES:
            told = ".".join(map(str, path))
            found.append((f"{told} = {value!r:.20}", partial(_set, path, value)))
        found.append((f"{told} {MISSING}", partial(_delete, path)))
    texts = (b"", b"\xff\xfe", b"null", b"[]", b"3", b"[" * 100_000, b'{"format": 2}')
    found += [(f"{text!r:.20}", partial(_instead, text)) for text in texts]
    return found


def _set(path: tuple[Any, ...], value: object, header: Any) -> None:
    *inner, last = path
    for key in inner:
        header = header[key]
    header[last] = value


def _delete(path: tuple[Any, ...], header: Any) -> None:
    *inner, last = path
    for key in inner:
        header = header[key]
    del header[last]


def _instead(text: bytes, header: Mapping[str, Any]) -> bytes:
    return text


def _columns() -> list[tuple[str, Change]]:
    """Each column of a wrong type, with a wrong number, with nothing in a row, twice, missing."""
    found: list[tuple[str, Change]] = []
    for name in _table().column_names:
        found += [(f"{name} of {kind}", partial(_typed, name, kind)) for kind in TYPES]
        found += [(f"{name} with {number:g}", partial(_valued, name, number)) for number in NUMBERS]
        found.append((f"{name} with a gap", partial(_valued, name, None)))
        found.append((f"{name} {MISSING}", partial(_without, name)))
        found.append((f"{name} twice", partial(_twice, name)))
    return found


def _typed(name: str, kind: pa.DataType, table: pa.Table) -> pa.Table:
    values: list[Any] = table[name].to_pylist()
    if kind == pa.null():
        values = [None] * len(values)
    elif kind == pa.string():
        values = [str(value) for value in values]
    else:
        values = [int(value) if value == value else 0 for value in values]
    return _put(table, name, pa.array(values, kind))


def _valued(name: str, number: float | None, table: pa.Table) -> pa.Table:
    """Another value in the seventh row, of the column's own type where it has that value."""
    values, kind = table[name].to_pylist(), table.schema.field(name).type
    if number is not None and kind == pa.int32():
        number = int(number) if abs(number) < 1e10 else 2**31 - 1
    values[6] = bool(number) if number is not None and kind == pa.bool_() else number
    return _put(table, name, pa.array(values, kind))


def _put(table: pa.Table, name: str, column: pa.Array) -> pa.Table:
    field = pa.field(name, column.type)
    return table.set_column(table.column_names.index(name), field, column)


def _without(name: str, table: pa.Table) -> pa.Table:
    return table.drop_columns([name])


def _twice(name: str, table: pa.Table) -> pa.Table:
    return table.append_column(table.schema.field(name), table[name])


def _rows() -> list[tuple[str, Change]]:
    """Rows that are missing, in another order, or of another flight."""
    n = len(_table())
    rows = np.arange(n)
    orders = {
        **{f"the first {count} missing": rows[count:] for count in (1, 2, 5, 31, 41, 57, n - 1)},
        **{f"row {row} missing": np.delete(rows, row) for row in (3, 30, 40, 41, 42, 57, 60)},
        **{f"row {row} twice": np.insert(rows, row, row) for row in (0, 3, 41, 57)},
        "reversed": rows[::-1],
        "shuffled": np.random.default_rng(13).permutation(rows),
        "flights swapped": np.concatenate([rows[57:], rows[:57]]),
        "none": rows[:0],
        "one": rows[:1],
        "all twice": np.concatenate([rows, rows]),
    }
    found: list[tuple[str, Change]] = [
        (what, partial(_ordered, order)) for what, order in orders.items()
    ]
    for name in ("leg", "tick", "parent", "start"):
        for value in (-1, 0, 1, 2, 3, 2**31 - 1, -(2**31)):
            found.append((f"{name} = {value} everywhere", partial(_filled, name, value, 0)))
            found.append((f"{name} = {value} from 41 on", partial(_filled, name, value, 41)))
    return found


def _ordered(order: Any, table: pa.Table) -> pa.Table:
    return table.take(pa.array(order))


def _filled(name: str, value: int, first: int, table: pa.Table) -> pa.Table:
    values = table[name].to_pylist()
    values[first:] = [value] * (len(values) - first)
    return _put(table, name, pa.array(values, pa.int32()))
