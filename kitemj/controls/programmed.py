"""A programmed stick: a table of deflections over time in a person's place."""

import csv
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import isfinite
from pathlib import Path
from typing import Any, NamedTuple

from kitemj.controls.actions import NAMES
from kitemj.controls.settings import law_of
from kitemj.controls.stick_mapping import Deflections, command_of
from kitemj.data_files import STICKS, read_text, shipped_or_file
from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.flight.live import Command
from kitemj.physics.checked import check_keys
from kitemj.physics.parameters import Parameters
from kitemj.physics.shaping import StickLaw


class Row(NamedTuple):
    """From time `t` [s] on: `Deflections`, the law; `buttons` are actions."""

    t: float
    steer: float = 0.0
    reel: float = 0.0
    left: float = 0.0
    right: float = 0.0
    law: StickLaw = StickLaw.ANGLE
    buttons: tuple[str, ...] = ()


class ProgrammedStick:
    """Holds each row until the next, the last one for ever or for `period` [s], then begins anew.

    Before the first row the stick rests. It flies like a person with `parameters`: a mirrored
    kite goes where the stick points, and `two_sticks` pull by its arms.
    """

    name = "programme"

    def __init__(
        self,
        rows: Sequence[Row],
        parameters: Parameters,
        period: float | None = None,
        two_sticks: bool = False,
    ) -> None:
        self._rows, self._times = rows, [row.t for row in rows]
        self._parameters, self._period, self._two_sticks = parameters, period, two_sticks
        self._asked = 0

    def command(self, motion: Motion) -> Command:
        """The command of the row that holds at the motion's time."""
        t = motion.t % self._period if self._period else motion.t
        i = bisect_right(self._times, t) - 1
        row = self._rows[i] if i >= 0 else Row(0.0)
        return command_of(Deflections(*row[1:5]), self._parameters, row.law, self._two_sticks)

    def actions(self, t: float) -> tuple[str, ...]:
        """The actions whose time has come since the last call; each is asked for once, ever.

        `t` may be any clock that does not stand still when the flight does.
        """
        begun, self._asked = self._asked, max(self._asked, bisect_right(self._times, t))
        return tuple(name for row in self._rows[begun : self._asked] for name in row.buttons)


def show(parameters: Parameters) -> ProgrammedStick:
    """A stick that goes right, left, a little right, centre: for a kite that only drifts."""
    ways = ((0.0, 0.0), (2.0, 1.0), (12.0, -1.0), (28.0, 0.4), (36.0, 0.0))
    return ProgrammedStick([Row(t, steer) for t, steer in ways], parameters, period=40.0)


def read_programmed_stick(path: Path, parameters: Parameters) -> ProgrammedStick:
    """The stick of a table (CSV, or the name of one that ships); its first line names columns.

    ``t`` [s]; ``steer`` and ``reel``, or ``left`` and ``right`` for a stick for each line, in
    -1..1; ``law`` angle, rate or acceleration; ``buttons``, names of actions with ; between
    them. All but t may be left out; an empty cell is as the one above. Lines that begin with
    # are skipped. Raises InputError with one sentence for whatever is wrong.
    """
    rows: list[Row] = []
    path = shipped_or_file(path, STICKS)
    cells = list(_cells(path))
    columns = list(cells[0][1]) if cells else []
    check_keys(columns, Row._fields, "", f"{path}, first line")
    if "t" not in columns:
        raise InputError(f"{path} must have a first line of columns, t among them, and rows below")
    apart, two = {"steer", "reel"} & {*columns}, {"left", "right"} & {*columns}
    if apart and two:
        raise InputError(f"{path} must have steer and reel, or left and right, not both")
    for where, texts in cells:
        rows.append(_row(texts, rows[-1] if rows else Row(0.0), where))
    for (where, _), (before, after) in zip(cells[1:], pairwise(rows), strict=True):
        if after.t <= before.t:
            raise InputError(f"t must ascend: {after.t:g} s after {before.t:g} s ({where})")
    return ProgrammedStick(rows, parameters, two_sticks=bool(two))


def _cells(path: Path) -> Iterator[tuple[str, dict[str, str]]]:
    """For each row its place in the file, and its cells by column."""
    lines = read_text(path).splitlines()
    columns: list[str] = []
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        where, known = f"{path}, line {number}", len(columns)
        try:
            cells = [cell.strip() for cell in next(csv.reader([line]))]
        except csv.Error as error:
            raise InputError(f"not a row of cells with commas between: {error} ({where})") from None
        if not columns:
            columns = cells
            if twice := [name for name in columns if columns.count(name) > 1]:
                raise InputError(f"the column {twice[0]} is given twice: keep one ({where})")
            continue
        if len(cells) != known:
            said = f"{len(cells)} cells where the first line names {known} columns"
            raise InputError(f"{said} ({where})")
        yield where, dict(zip(columns, cells, strict=True))


def _row(texts: dict[str, str], above: Row, where: str) -> Row:
    if texts["t"] == "":
        raise InputError(f"t is missing: give the time in s ({where})")
    cells: dict[str, Any] = {"buttons": ()}
    for column, text in texts.items():
        if text == "":
            continue
        if column == "buttons":
            cells[column] = tuple(name.strip() for name in text.split(";"))
            check_keys(cells[column], sorted(NAMES), "buttons", where)
        elif column == "law":
            cells[column] = law_of(text, where)
        else:
            cells[column] = _number(column, text, where)
    return above._replace(**cells)


def _number(column: str, text: str, where: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise InputError(f"{column} must be a number, got {text!r} ({where})") from None
    if column == "t" and not (isfinite(value) and value >= 0):
        raise InputError(f"t must be >= 0 s, got {text} s ({where})")
    if column != "t" and not abs(value) <= 1:
        raise InputError(f"{column} must be in -1..1, got {text} ({where})")
    return value
