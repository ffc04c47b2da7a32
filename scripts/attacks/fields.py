"""Every field of scenario and study files, from the types, with values that no kite has."""

import csv
from collections.abc import Iterator
from functools import partial
from pathlib import Path

from attacks.victim import Attack, harm_of, left_over, run
from kitemj.dynamics.formulation import MODELS
from kitemj.flight.scenario import Offsets, SteeringTable, Times
from kitemj.physics.parameter_files import LAWS, NAMED_BY, SECTIONS, field_names
from kitemj.physics.steering import Sines
from kitemj.studies.study import VARIED, Settings

VALUES = (
    *("0", "-1", "1e308", "-1e308", "5e-324", "1e-12", "1e12", "inf", "nan"),
    *('""', '"x"', "[]", "{}", "true", "9223372036854775807", "1979-05-27"),
)
"""As TOML spells them."""
ZEROS = str([[[0.0] * 3] * 8] * 6)
TABLES = {
    "aero table": {"aero.law": '"table"', "aero.table": ZEROS, "start.at": '"state"'},
    "sine": {"steering.programme": '"sine"', "steering.delta_amplitude": "0.1"},
    "table": {
        **{"steering.programme": '"table"', "steering.t": "[0.0, 0.1, 0.2]"},
        "steering.delta": "[0.0, 0.1, 0.0]",
    },
    "state": {"start.at": '"state"', "start.gamma": "0.4"},
    "": {},
}
"""Scenarios, by what is in them beside the set and the duration."""
STUDY = {"scenario": '"base.toml"', "model": '"lagrange"', "list": '[{"wind.speed" = 6.0}]'}


def attacks() -> list[Attack]:
    """A flight of 0.2 s, by each model in turn, for every field and value; then studies."""
    models, found = list(MODELS.shipped), []
    for kind, field in _fields():
        for i, value in enumerate(VALUES):
            act = partial(_fly, kind, field, value, models[i % len(models)])
            found.append(Attack(f"{f'{kind}: ' if kind else ''}{field} = {value}", act))
    for field in _study_fields():
        found += [Attack(f"study: {field} = {v}", partial(_sweep, field, v)) for v in VALUES]
    return found


def _fields() -> Iterator[tuple[str, str]]:
    """A key of `TABLES` and a dotted name."""
    yield from (("", name) for name in ("set", *Times._fields))
    for section in ("aero", *SECTIONS, "steering", "start"):
        yield "", section
        yield "", f"{section}.unknown"
    for section, kind in SECTIONS.items():
        yield from (("", f"{section}.{name}") for name in field_names(kind))
    for section, registry in LAWS.items():
        yield "", f"{section}.{NAMED_BY[section]}"
        if section == "aero":
            yield from (("", f"aero.{name}") for name in field_names(registry["linear"]))
            yield from (("aero table", f"aero.{name}") for name in field_names(registry["table"]))
    yield from (("sine", f"steering.{name}") for name in ("programme", *Sines._fields))
    yield from (("table", f"steering.{name}") for name in SteeringTable._fields)
    yield from (("", f"start.{name}") for name in ("at", *Offsets._fields))
    yield from (("state", f"start.{name}") for name in Offsets._fields)


def _study_fields() -> list[str]:
    ranges = ("from", "to", "count")
    return [
        *("scenario", "scenario.kite", "scenario.kite.mass", *Settings._fields, *VARIED),
        *("grid.model", "grid.start", '"grid.kite.mass"', "grid.wind.speed", "grid.unknown"),
        *(f"grid.wind.speed.{end}" for end in ranges),
        *("hypercube.count", "hypercube.seed", "hypercube.wind.speed"),
    ]


def _text(tables: dict[str, str]) -> str:
    """TOML: a line for each name, whole tables inline."""
    return "".join(f"{name} = {value}\n" for name, value in tables.items())


def _fly(kind: str, field: str, value: str, model: str, folder: Path) -> str:
    given = {"set": '"sport"', "duration": "0.2", **TABLES[kind]}
    under = [name for name in given if name.startswith(f"{field}.")]
    tables = {name: each for name, each in given.items() if name not in under} | {field: value}
    (folder / "attack.toml").write_text(_text(tables), encoding="utf-8")
    words = ["simulate", "attack.toml", "--output", "flight.csv", "--model", model]
    done = run(words, folder)
    written = done.status in (0, 1) and (folder / "flight.csv").exists()
    return (
        harm_of(done)
        or (written and not_finite(folder / "flight.csv"))
        or left_over(
            folder,
            ["attack.toml", *(["flight.csv", "flight.csv-metadata.json"] if written else [])],
        )
    )


def _sweep(field: str, value: str, folder: Path) -> str:
    base = {"set": '"sport"', "duration": "0.2"}
    (folder / "base.toml").write_text(_text(base), encoding="utf-8")
    given = {**STUDY, "grid.wind.azimuth": "[0.0]"}
    part = field.partition(".")[0]
    if part == "scenario":
        del given["scenario"]
    if part == "grid":
        del given["grid.wind.azimuth"]
    if field.startswith("grid.wind.speed"):
        del given["list"]
    if field.startswith("grid.wind.speed."):
        given |= {f"grid.wind.speed.{name}": n for name, n in (("from", "5"), ("to", "6"))}
        given |= {"grid.wind.speed.count": "2"}
    if part == "hypercube":
        given |= {"hypercube.count": "2", "hypercube.kite.mass": "[0.2, 0.3]"}
        given.pop("list")
    if field == part:
        given = {name: each for name, each in given.items() if not name.startswith(part)}
    (folder / "study.toml").write_text(_text(given | {field: value}), encoding="utf-8")
    done = run(["sweep", "study.toml", "--output", "study.parquet", "--processes", "1"], folder)
    expected = ["base.toml", "study.toml", *(["study.parquet"] if done.status == 0 else [])]
    return harm_of(done) or left_over(folder, expected)


def not_finite(path: Path) -> str:
    """A harm where a number in the table, below its first line, is not finite."""
    with path.open(encoding="utf-8-sig", newline="") as file:
        rows = csv.reader(line for line in file if not line.startswith("#"))
        columns = next(rows)
        for number, row in enumerate(rows):
            for name, cell in zip(columns, row, strict=True):
                if cell.lower() in ("nan", "inf", "-inf"):
                    return f"not finite: {name} = {cell} in row {number}"
    return ""
