"""Tables that people give: of sticks, flights, coefficients; cells, columns, bytes, sizes."""

import json
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from math import isfinite
from pathlib import Path
from typing import Any

from attacks.fields import not_finite
from attacks.victim import Attack, harm_of, run
from kitemj.controls.programmed import Row, read_programmed_stick
from kitemj.data_files import SCENARIOS, shipped_or_file
from kitemj.errors import InputError
from kitemj.flight.motion_table import COLUMNS
from kitemj.flight.motion_table import row as cells_of
from kitemj.flight.scenario import read_scenario
from kitemj.flight.simulate import simulate
from kitemj.physics.parameter_files import parameter_set

CELLS = (
    *("", "nan", "inf", "-inf", "1e308", "-1e308", "5e-324", "x", "²", "1,5", '"', '"a', "true"),
    *("0x10", "1_0", "\0", "é", "a" * 200_000, "9" * 5000, "-", " ", "\t", "=1+1", "1e999", "None"),
)
STICK = [["t", "steer", "reel", "law", "buttons"], ["0", "0.5", "0", "rate", ""]]
STICK += [["1", "-0.5", "", "angle", "law"], ["2", "", "0.2", "acceleration", ""]]
FLIGHT = "flight.csv"


def attacks() -> list[Attack]:
    """Every cell with every odd text, and every table with odd columns, bytes and sizes."""
    flight = _flight()
    found = [Attack(f"stick: {what}", partial(_steer, content)) for what, content in _odd(STICK)]
    for what, content in _odd(flight, 3):
        found.append(Attack(f"flight: {what}", partial(_limits, content)))
    found += [Attack(f"aero: {what}", partial(_fly, _aero(t))) for what, t in _coefficients()]
    found += [Attack(f"steering: {what}", partial(_fly, t)) for what, t in _steerings()]
    return found


def _odd(table: list[list[str]], share: int = 1) -> Iterator[tuple[str, bytes]]:
    """What is odd, and the bytes of the file; of the odd cells one of `share` in each column."""
    for row in (0, 1, len(table) - 1):
        for column in range(len(table[0])):
            for cell in CELLS[column % share :: share]:
                changed = [list(each) for each in table]
                changed[row][column] = cell
                yield f"row {row}, column {column}: {cell[:9]!a}", _csv(changed)
    plain, head = _csv(table), table[0]
    yield "nothing", b""
    yield "one line", _csv(table[:1])
    yield "no head", _csv(table[1:])
    yield "a byte-order mark", b"\xef\xbb\xbf" + plain
    yield "UTF-16", plain.decode().encode("utf-16")
    yield "Latin-1", plain + "# é".encode("latin-1")
    yield "NUL bytes", b"\0" * 4096
    yield "noise", bytes(range(256)) * 16
    yield "Windows' ends of lines", plain.replace(b"\n", b"\r\n")
    yield "old ends of lines", plain.replace(b"\n", b"\r")
    yield "empty lines", plain.replace(b"\n", b"\n\n")
    yield "semicolons", plain.replace(b",", b";")
    yield "tabs", plain.replace(b",", b"\t")
    yield "no last end of line", plain.rstrip()
    yield "cut in the middle", plain[: len(plain) // 2]
    yield "a column twice", _csv([[*row, row[1]] for row in table])
    yield "a column without a name", _csv([["", *row[1:]] for row in table[:1]] + table[1:])
    yield "a column more", _csv([[*row, "1"] for row in table])
    yield "a cell more", _csv([table[0], [*table[1], "1"], *table[2:]])
    yield "a cell fewer", _csv([table[0], table[1][:-1], *table[2:]])
    yield "rows backwards", _csv([table[0], *table[:0:-1]])
    yield "a row twice", _csv([*table, table[-1]])
    yield "columns in capitals", _csv([[name.upper() for name in head], *table[1:]])
    yield "100,000 rows the same", _csv([*table, *[table[-1]] * 100_000])
    yield "10,000 columns", _csv([[*row, *[f"{i}x" for i in range(10_000)]] for row in table])
    for i, name in enumerate(head):
        yield f"without {name}", _csv([[*row[:i], *row[i + 1 :]] for row in table])
        yield f"only {name}", _csv([[row[i]] for row in table])


def _csv(table: list[list[str]]) -> bytes:
    return "".join(f"{','.join(row)}\n" for row in table).encode()


def _flight() -> list[list[str]]:
    scenario = read_scenario(shipped_or_file("steer_80m", SCENARIOS))
    times = scenario.times._replace(duration=1.0)
    motions = simulate(replace(scenario, times=times), "lagrange").motions
    return [list(COLUMNS), *([repr(float(cell)) for cell in cells_of(each)] for each in motions)]


def _steer(content: bytes, folder: Path) -> str:
    """In this process: a flight of a person's stick needs a window."""
    (folder / "stick.csv").write_bytes(content)
    try:
        stick = read_programmed_stick(folder / "stick.csv", parameter_set("sport"))
    except InputError as error:
        return "wrong: several lines" if "\n" in str(error).strip() else ""
    except Exception as error:
        return f"traceback: {error!r:.200}"
    rows = stick._rows
    numbers = [getattr(row, name) for row in rows for name in Row._fields[:5]]
    return "" if all(map(isfinite, numbers)) else f"not finite: {numbers[:20]}"


def _limits(content: bytes, folder: Path) -> str:
    (folder / FLIGHT).write_bytes(content)
    done = run(["limits", FLIGHT], folder)
    if done.status == 2 and len(done.error.splitlines()) != 1:
        return f"wrong: {len(done.error.splitlines())} lines of error"
    return harm_of(done)


def _coefficients() -> Iterator[tuple[str, Any]]:
    good = [[[0.0] * 3 for _ in range(8)] for _ in range(6)]
    good[0][0][0], good[2][0] = -0.07, [0.1, -3.0, 0.0]
    yield "good", good
    odd: Any
    values: tuple[Any, ...] = (1e308, -1e308, 1e12, True, "x", None, [], [1.0], {}, 1, 2**70)
    for value in values:
        for place in ((0, 0), (5, 7), (3, 4)):
            odd = json.loads(json.dumps(good))
            odd[place[0]][place[1]][1] = value
            yield f"{value!r} at {place}", odd
    for what, odd in (
        *(("5 rows", good[:5]), ("7 rows", [*good, good[0]]), ("none", []), ("flat", [0.0] * 144)),
        *(("7 terms", [row[:7] for row in good]), ("9 terms", [[*row, [0.0] * 3] for row in good])),
        *(("2 powers", [[each[:2] for each in row] for row in good]), ("a number", 1.0)),
        *(("a text", "x"), ("ragged", [good[0][:3], *good[1:]]), ("empty rows", [[]] * 6)),
        ("deep", [[[[0.0] * 3] * 8] * 6]),
    ):
        yield what, odd


def _aero(table: Any) -> str:
    aero = f'aero = {{law = "table", table = {_toml(table)}}}'
    return f'set = "sport"\nstart = {{at = "state"}}\n{aero}\n'


def _steerings() -> Iterator[tuple[str, str]]:
    def table(t: Any, delta: Any, ell: Any = None) -> str:
        rows = {"t": t, "delta": delta} | ({} if ell is None else {"ell": ell})
        inner = ", ".join(f"{name} = {_toml(each)}" for name, each in rows.items())
        return f'set = "sport"\nsteering = {{programme = "table", {inner}}}\n'

    good = [0.0, 0.1, 0.2]
    for what, odd in (
        *(("empty", []), ("one", [0.0]), ("nested", [[0.0]]), ("text", ["a", "b", "c"])),
        *(("huge", [0.0, 1e308, 0.2]), ("tiny", [0.0, 5e-324, 0.2]), ("twice", [0.0, 0.0, 0.2])),
        *(("falling", [0.2, 0.1, 0.0]), ("true", [True] * 3), ("a number", 1.0)),
        *(("close", [0.0, 1e-300, 0.2]), ("long", [i / 1e5 for i in range(100_000)])),
        *(("whole", [0, 1, 2]), ("mixed", [0, 0.1, "x"]), ("ends late", [0.0, 1.0, 1e9])),
    ):
        yield f"t {what}", table(odd, good)
        yield f"delta {what}", table(good, odd)
        yield f"ell {what}", table(good, [0.0] * 3, odd)
        yield f"all {what}", table(odd, odd, odd)


def _toml(value: Any) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(_toml, value))}]"
    return "{}" if value is None or isinstance(value, dict) else json.dumps(value)


def _fly(text: str, folder: Path) -> str:
    scenario = folder / "scenario.toml"
    scenario.write_text(f"duration = 0.2\n{text}", encoding="utf-8")
    done = run(["simulate", scenario.name, "--model", "lagrange", "--output", FLIGHT], folder)
    if done.status == 2 and "Input should" in done.error:
        return f"wrong: a library's words, {done.error[:200]}"
    return harm_of(done) or (not_finite(folder / FLIGHT) if (folder / FLIGHT).exists() else "")
