"""Journals of studies: cut, flipped, filled with zeros, with lines that no study has written."""

import json
import random
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache, partial
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq

from attacks.victim import Attack, Outside, harm_of, run
from attacks.writers import STUDY
from kitemj.studies import executors
from kitemj.studies.flights import fly
from kitemj.studies.journal import Journal
from kitemj.studies.study import read_study

WORDS = ["sweep", "study.toml", "--output", "a.parquet"]
FLIGHTS = 3
ODD: tuple[Any, ...] = (-1, FLIGHTS, 2**70, 1.5, True, None, "0", [], {}, float("nan"))
"""What is no number of a flight."""
VALUES: tuple[Any, ...] = (None, "x", [], {}, True, 10**400, "\ud800")
CUTS, FLIPS = 25, 60
FOREIGN = (
    *(b"my notes\n", b"my notes", b"\0" * 512, b"\x89PNG\r\n\x1a\n" + bytes(100), b"[]\n", b"\n"),
    *(b'{"study": 3}\n', b'{"study": "another"}\n', b'{"study": "another"}\n{"flight": 0}\n'),
)

Damage = Callable[[list[bytes]], bytes]


def attacks() -> list[Attack]:
    """Each is gone on with: the table must be that of a study flown at once."""
    found = []
    for what, damage in {**_lines(), **_bytes()}.items():
        found.append(Attack(what, partial(_gone_on, damage)))
    for number, content in enumerate(FOREIGN):
        found.append(Attack(f"another's file, {content[:24]!r}", partial(_foreign, number)))
    return found


def _lines() -> dict[str, Damage]:
    """Lines in place of one, and beside all."""
    row = json.loads(_sound()[1].rpartition(b" ")[0])
    made: dict[str, Any] = {f"flight = {value!r:.20}": row | {"flight": value} for value in ODD}
    for key in row:
        made[f"without {key}"] = {name: each for name, each in row.items() if name != key}
    for value in VALUES:
        made[f"ending = {value!r:.20}"] = row | {"ending": value}
        made[f"tension_plus_max_N = {value!r:.20}"] = row | {"tension_plus_max_N": value}
        made[f"a line {value!r:.20}"] = value
    texts = {what: json.dumps(value).encode() + b"\n" for what, value in made.items()}
    texts |= {
        "a line of zeros": bytes(300) + b"\n",
        "a line of letters": b"what is this?\n",
        "an empty line": b"\n",
        "a deep line": b"[" * 100_000 + b"\n",
        "letters that are none": b"\xff\xfe\n",
    }
    found: dict[str, Damage] = {what: partial(_in_place, text) for what, text in texts.items()}
    found["a line twice"] = lambda lines: b"".join([*lines, lines[1]])
    found["a line of another flight"] = lambda lines: b"".join(
        [lines[0], lines[1].replace(b'"flight": 0', b'"flight": 2'), *lines[2:3]]
    )
    found["lines in another order"] = lambda lines: b"".join([lines[0], *lines[:0:-1]])
    found["zeros at the end"] = lambda lines: b"".join(lines[:2]) + bytes(4096)
    found["two lines in one"] = lambda lines: b"".join(lines[:2]).rstrip() + b"".join(lines[2:])
    return found


def _bytes() -> dict[str, Damage]:
    dice = random.Random(13)
    found: dict[str, Damage] = {}
    for _ in range(CUTS):
        part = dice.random()
        found[f"cut at {part:.3f}"] = partial(_cut, part)
    for _ in range(FLIPS):
        part, bit = dice.random(), dice.randrange(8)
        found[f"bit {bit} at {part:.4f} flipped"] = partial(_flip, part, bit)
    return found


def _in_place(text: bytes, lines: list[bytes]) -> bytes:
    return b"".join([lines[0], text, *lines[2:]])


def _cut(part: float, lines: list[bytes]) -> bytes:
    whole = b"".join(lines)
    return whole[: int(part * len(whole))]


def _flip(part: float, bit: int, lines: list[bytes]) -> bytes:
    whole = bytearray(b"".join(lines))
    whole[int(part * len(whole))] ^= 1 << bit
    return bytes(whole)


def _gone_on(damage: Damage, folder: Path) -> str:
    (folder / "study.toml").write_text(STUDY, encoding="utf-8")
    damaged = damage(_sound())
    journal = folder / "a.parquet.journal"
    journal.write_bytes(damaged)
    ended = run(WORDS, folder, outside=Outside(before=_here))
    if not damaged.startswith(_sound()[0][: len(damaged)]):
        return harm_of(ended, (2,)) or ("" if journal.read_bytes() == damaged else "file lost")
    if harm := harm_of(ended, (0,)):
        return harm
    if journal.exists():
        return "file left: the journal"
    if _rows(folder / "a.parquet") != _true_rows():
        return "wrong: other rows than flown at once"
    return ""


def _foreign(number: int, folder: Path) -> str:
    (folder / "study.toml").write_text(STUDY, encoding="utf-8")
    journal = folder / "a.parquet.journal"
    journal.write_bytes(FOREIGN[number])
    for more in ([], ["--overwrite"]):
        ended = run([*WORDS, *more], folder, outside=Outside(before=_here))
        given_up = more and FOREIGN[number].startswith(b'{"study": ')
        if harm := harm_of(ended, (0,) if given_up else (2,)):
            return harm
        if not given_up and journal.read_bytes() != FOREIGN[number]:
            return "file lost: another's"
    return ""


@cache
def _sound() -> list[bytes]:
    """The lines of a journal of all flights."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "study.toml"
        file.write_text(STUDY, encoding="utf-8")
        study = read_study(file)
        with Journal(Path(folder) / "a.parquet", study) as journal:
            journal.add([fly(study.base, i, study.design.point(i)) for i in range(FLIGHTS)])
        return journal.path.read_bytes().splitlines(keepends=True)


@cache
def _true_rows() -> list[dict[str, Any]]:
    rows = [json.loads(line.rpartition(b" ")[0]) for line in _sound()[1:]]
    return [{k: v for k, v in row.items() if k != "cost_s"} for row in rows]


def _rows(table: Path) -> list[dict[str, Any]]:
    """Those of a table, without what they cost and without empty cells."""
    rows = pq.read_table(table).to_pylist()
    return [{k: v for k, v in row.items() if k != "cost_s" and v is not None} for row in rows]


def _here() -> None:
    """Flights of this process, for which no other has to be started."""

    @contextmanager
    def here(processes: int | None = None) -> Iterator[executors.StudyExecutor]:
        yield executors.StudyExecutor(1, "this process", executors.InProcess(), ())

    executors.local_executor = here
