"""The design of a study: a list, a grid and a Latin hypercube, multiplied together."""

from collections.abc import Mapping, Sequence
from functools import cached_property
from math import prod
from typing import Any

import numpy as np

from kitemj.errors import InputError

Point = dict[str, Any]
"""Dotted names (``wind.speed``, ``model``) and the values that one flight gives them."""
MOST = 10_000_000
"""Flights in a study; a week of a desktop's cores."""
LARGEST = float(np.finfo(float).max)


class Choices:
    """Points given one by one."""

    def __init__(self, points: Sequence[Point]) -> None:
        self.points, self.count = points, len(points)
        self.names = list(dict.fromkeys(name for point in points for name in point))
        others = {name for point in points for name in point if not _number(point[name])}
        self.numbers = {*self.names} - others

    def point(self, i: int) -> Point:
        """The point `i`, from 0 on."""
        return self.points[i]


class Axis:
    """Points at equal distances of one number, made when they are asked for."""

    def __init__(self, name: str, low: float, high: float, count: int) -> None:
        self.names, self.numbers, self.count = [name], {name}, count
        self._low, self._high = low, high

    @cached_property
    def _values(self) -> Any:
        return np.linspace(self._low, self._high, self.count)

    def point(self, i: int) -> Point:
        """The point `i`, from 0 on."""
        return {self.names[0]: float(self._values[i])}


class Hypercube:
    """`count` points in the box of `ranges`, each range cut into `count` slices used once."""

    def __init__(self, count: int, seed: int, ranges: Mapping[str, tuple[float, float]]) -> None:
        self.count, self.seed, self.ranges = count, seed, dict(ranges)
        self.names, self.numbers = list(ranges), set(ranges)

    @cached_property
    def _samples(self) -> Any:
        from scipy.stats import qmc

        unit = qmc.LatinHypercube(d=len(self.ranges), rng=self.seed).random(self.count)
        low, high = np.array(list(self.ranges.values())).T
        return low + (high - low) * unit

    def point(self, i: int) -> Point:
        """The point `i`, from 0 on."""
        return dict(zip(self.names, self._samples[i].tolist(), strict=True))


Factor = Choices | Axis | Hypercube


class Design:
    """Every combination of the `factors`; the last one changes the quickest.

    `names` of what is varied; `numbers`: those of them that are given numbers only.
    """

    def __init__(self, factors: Sequence[Factor]) -> None:
        self.factors = factors
        self.count = prod(factor.count for factor in factors)
        self.names = [name for factor in factors for name in factor.names]
        self.numbers = {name for factor in factors for name in factor.numbers}

    def point(self, flight: int) -> Point:
        """The values given to flight `flight`, from 0 on."""
        point: Point = {}
        for factor in reversed(self.factors):
            flight, i = divmod(flight, factor.count)
            point = {**factor.point(i), **point}
        return point


def design_of(tables: Mapping[str, Any], source: str) -> Design:
    """The design of the tables ``list``, ``grid`` and ``hypercube`` of a study file.

    Raises InputError for what is empty, given twice, or not a range.
    """
    factors: list[Factor] = []
    if "list" in tables:
        factors.append(Choices(_list(tables["list"], source)))
    for name, values in _flat(_table(tables, "grid", source)).items():
        factors.append(_axis(name, values, source))
    if "hypercube" in tables:
        factors.append(_hypercube(_table(tables, "hypercube", source), source))
    if not factors:
        raise InputError(f"nothing is varied: give [[list]], [grid] or [hypercube] ({source})")
    design = Design(factors)
    for name in design.names:
        if design.names.count(name) > 1:
            raise InputError(f"{name} is varied twice: keep one ({source})")
    if design.count > MOST:
        raise InputError(f"{design.count} flights are too many: at most {MOST} ({source})")
    return design


def _table(tables: Mapping[str, Any], name: str, source: str) -> Mapping[str, Any]:
    table = tables.get(name, {})
    if not isinstance(table, Mapping):
        raise InputError(f"{name} must be a table of named values, got {table!r} ({source})")
    if name in tables and not table:
        raise InputError(f"[{name}] is empty: name what it varies, or leave it out ({source})")
    return table


def _flat(table: Mapping[str, Any]) -> Point:
    """``{"wind": {"speed": v}}`` as ``{"wind.speed": v}``; a range stays what it is."""
    flat: Point = {}
    for name, value in table.items():
        if isinstance(value, Mapping) and not {"from", "to"} & set(value):
            flat.update({f"{name}.{key}": v for key, v in _flat(value).items()})
        else:
            flat[name] = value
    return flat


def _list(entries: Any, source: str) -> list[Point]:
    if not isinstance(entries, list) or not all(isinstance(each, Mapping) for each in entries):
        raise InputError(f"list must be [[list]] tables, one for each flight ({source})")
    if not entries:
        raise InputError(f"list is empty: give one [[list]] table for each flight ({source})")
    return [_flat(each) for each in entries]


def _axis(name: str, values: Any, source: str) -> Choices | Axis:
    if isinstance(values, Mapping):
        if set(values) != {"from", "to", "count"}:
            got = ", ".join(values)
            raise InputError(f"grid.{name} must have from, to and count, got {got} ({source})")
        low, high = _ends((values["from"], values["to"]), f"grid.{name}", source)
        count = _count(values["count"], f"grid.{name}.count", source)
        return Axis(name, low, high, count)
    if not isinstance(values, list):
        known = "a list of values or { from, to, count }"
        raise InputError(f"grid.{name} must be {known}, got {values!r} ({source})")
    if not values:
        raise InputError(f"grid.{name} is empty: give it one value or more ({source})")
    return Choices([{name: value} for value in values])


def _hypercube(table: Mapping[str, Any], source: str) -> Hypercube:
    given = dict(table)
    count = _count(given.pop("count", None), "hypercube.count", source)
    seed = given.pop("seed", 0)
    if not isinstance(seed, int) or isinstance(seed, bool) or seed < 0:
        raise InputError(f"hypercube.seed must be a whole number >= 0, got {seed!r} ({source})")
    if not given:
        raise InputError(f'[hypercube] varies nothing: add "kite.mass" = [3.0, 5.0] ({source})')
    ranges = {name: _ends(ends, f"hypercube.{name}", source) for name, ends in _flat(given).items()}
    return Hypercube(count, seed, ranges)


def _count(value: Any, name: str, source: str) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or value < 1:
        raise InputError(f"{name} must be a whole number >= 1, got {value!r} ({source})")
    if value > MOST:
        raise InputError(f"{name} must be <= {MOST}, got {value} ({source})")
    return value


def _ends(value: Any, name: str, source: str) -> tuple[float, float]:
    pair = isinstance(value, (list, tuple)) and len(value) == 2
    if not pair or not all(_number(end) for end in value) or not value[0] < value[1]:
        known = "two numbers, the lower one first"
        raise InputError(f"{name} must be {known}, got {value!r} ({source})")
    return float(value[0]), float(value[1])


def _number(value: Any) -> bool:
    known = isinstance(value, (int, float)) and not isinstance(value, bool)
    return known and abs(value) <= LARGEST
