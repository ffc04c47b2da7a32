"""Study files: a scenario, how it is flown, and what is varied."""

import hashlib
import json
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Annotated, Any, NamedTuple

from kitemj.data_files import SCENARIOS, STUDIES, shipped_or_file
from kitemj.dynamics.formulation import DEFAULT_STEP, MAX_STEP, MIN_STEP, MODELS
from kitemj.errors import InputError
from kitemj.flight.pilot_settings import (
    PathSettings,
    PilotSettings,
    SensorSettings,
    TurnRateLaw,
)
from kitemj.flight.scenario import Offsets, SteeringTable, Times
from kitemj.physics.checked import checked, unknown_key
from kitemj.physics.code_folder import formula_hash
from kitemj.physics.compiled import code_of
from kitemj.physics.parameter_files import LAWS, LINES, NAMED_BY, SECTIONS, field_names, read_toml
from kitemj.physics.quantity import Quantity
from kitemj.physics.rig import RIGS, Rig
from kitemj.physics.steering import Sines
from kitemj.registry import own_modules
from kitemj.studies.design import Design, Point, design_of

VARIED = ("list", "grid", "hypercube")
LONGEST_STEP = Quantity("s", "longest step of mujoco", ge=MIN_STEP, le=MAX_STEP)
STEP_ERROR = Quantity("", "error of a step of lagrange and newton-euler", ge=1e-14, le=1e-3)


class Settings(NamedTuple):
    """How a flight is flown; each of these can be varied, too."""

    model: Annotated[str, Quantity("", "the model that flies")] = "mujoco"
    step: Annotated[float, LONGEST_STEP] = DEFAULT_STEP
    tolerance: Annotated[float, STEP_ERROR] = 1e-8
    reference: Annotated[str, Quantity("", 'the model to keep beside it; "": none')] = ""


class Base(NamedTuple):
    """What the flights of a study have in common; goes to every worker. Tables as in TOML.

    `modules` are those of a person's own that bring the laws and models of the study.
    """

    source: str
    scenario: dict[str, Any]
    settings: dict[str, Any]
    modules: tuple[str, ...] = ()

    def at(self, point: Point) -> tuple[dict[str, Any], Settings]:
        """The scenario's tables and the settings of one flight; InputError for bad settings."""
        tables, settings = deepcopy(self.scenario), dict(self.settings)
        for name, value in point.items():
            *sections, field = name.split(".")
            table = settings if name in Settings._fields else tables
            for section in sections:
                table = table.setdefault(section, {})
            table.pop(_twin(field), None)
            table[field] = value
        return tables, _settings(settings, self.source)


@dataclass(frozen=True)
class Study:
    """What all flights share, and what each of them is given."""

    base: Base
    design: Design
    digest: str

    @property
    def rig(self) -> Rig:
        """By which lines all its flights are flown."""
        lines = self.base.scenario.get("lines", {})
        return RIGS[LINES[lines.get(NAMED_BY["lines"], next(iter(LINES.shipped)))]]


def as_study(given: Study | str | Path | Mapping[str, Any]) -> Study:
    """A study: `given` itself, that of a file, or that of tables as a file has them."""
    if isinstance(given, Study):
        return given
    return study_of(given, "study", Path()) if isinstance(given, Mapping) else read_study(given)


def read_study(path: str | Path) -> Study:
    """The study in a TOML file, or of those that ship the one of this name.

    Raises InputError with one sentence for what is wrong.
    """
    found = shipped_or_file(path, STUDIES)
    return study_of(read_toml(found), found.name, found.parent)


def study_of(tables: Mapping[str, Any], source: str, folder: Path) -> Study:
    """The study of tables as a TOML file in `folder` has them; `source` names them in messages.

    Its scenario stands in `folder`, or ships. Its digest changes with whatever changes a result:
    the tables, the scenario, the formulas.
    """
    known = ["scenario", *Settings._fields, *VARIED]
    for name in tables:
        if name not in known:
            raise unknown_key(name, known, "", source)
    scenario = tables.get("scenario", {})
    if isinstance(scenario, str):
        scenario = read_toml(shipped_or_file(scenario, SCENARIOS, folder))
    if not isinstance(scenario, dict):
        raise InputError(f"scenario must be the name of a file or a table ({source})")
    for name in ("aero", *SECTIONS, "steering", "start"):
        if not isinstance(table := scenario.get(name, {}), Mapping):
            raise InputError(f"{name} must be a table of named values, got {table!r} ({source})")
    settings = {name: tables[name] for name in Settings._fields if name in tables}
    study = Study(
        Base(source, scenario, settings, own_modules()),
        design_of({name: tables[name] for name in VARIED if name in tables}, source),
        _digest(scenario, tables),
    )
    for name in study.design.names:
        _check_name(name, source)
    _settings(settings, source)
    return study


def _digest(*parts: Any) -> str:
    text = json.dumps([*parts, formula_hash()], sort_keys=True, default=str)
    for registry in (*LAWS.values(), MODELS):  # whose a formula is that the study names
        for name in (name for name in registry if f'"{name}"' in text):
            if whose := registry.origin(name):
                text += whose + code_of(registry[name])
    return hashlib.sha256(text.encode()).hexdigest()


def _settings(given: Mapping[str, Any], source: str) -> Settings:
    numbers = {k: float(v) if isinstance(v, int) else v for k, v in given.items()}
    settings = checked(Settings, numbers, "", source)
    for key in ("model", "reference"):
        model = getattr(settings, key)
        if (key, model) != ("reference", ""):
            MODELS.check(model)
    return settings


def _twin(field: str) -> str:
    """The other name of an angle: in rad for degrees, in degrees for rad."""
    return field.removesuffix("_deg") if field.endswith("_deg") else f"{field}_deg"


def _nested() -> list[str]:
    """Names, with dots, of what is in the tables within [pilot]."""
    kinds = {"path": PathSettings, "sensors": SensorSettings, "law": TurnRateLaw}
    return [f"{table}.{field}" for table, kind in kinds.items() for field in field_names(kind)]


def _check_name(name: str, source: str) -> None:
    """Raises InputError for what no scenario and no setting is called."""
    section, dot, field = name.partition(".")
    sections: dict[str, list[str]] = {
        "steering": ["programme", *Sines._fields, *SteeringTable._fields],
        "start": ["at", *Offsets._fields],
        **{key: field_names(kind) for key, kind in SECTIONS.items()},
    }
    sections["pilot"] = [*field_names(PilotSettings), *_nested()]
    for key, registry in LAWS.items():
        sections[key] = [NAMED_BY[key], *chain(*(field_names(registry[law]) for law in registry))]
    whole = ["set", *Times._fields, *Settings._fields]
    if not dot and section not in (*whole, *sections):
        raise unknown_key(name, [*whole, *sections], "", source)
    if dot and section not in sections:
        raise unknown_key(section, list(sections), "", source)
    if dot and field.removesuffix("_deg") not in sections[section]:
        raise unknown_key(field, list(sections[section]), section, source)
