"""Parameter sets from TOML: the named sets that ship, and overrides of any field."""

import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any, get_type_hints

import numpy as np

from kitemj.data_files import read_text
from kitemj.errors import InputError
from kitemj.physics.aerodynamics import aero_law
from kitemj.physics.checked import checked, in_radians, unknown_key
from kitemj.physics.kite import Lines
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import RIGS
from kitemj.physics.wind import Wind, wind_law
from kitemj.registry import Registry

ROUNDING = 1e-12

SETS = Path(__file__).parent / "sets"
AERO_LAWS: Registry[type[Any]] = Registry(
    "aerodynamic law",
    "kitemj.aero_laws",
    {
        "linear": "kitemj.physics.aerodynamics:LinearAero",
        "table": "kitemj.physics.aerodynamics:TableAero",
    },
)
WINDS: Registry[type[Any]] = Registry("wind", "kitemj.winds", {"power": "kitemj.physics.wind:Wind"})
LINES: Registry[type[Any]] = Registry(
    "kind of lines", "kitemj.lines", {"straight": "kitemj.physics.kite:Lines"}
)
LAWS = {"aero": AERO_LAWS, "wind": WINDS, "lines": LINES}
"""Sections that hold one of several types of numbers; the first is meant where none is named."""
NAMED_BY = {"aero": "law", "wind": "law", "lines": "kind"}
"""Under which key the type is named."""
KNOWN: dict[str, Any] = {"aero": aero_law.formulas, "wind": wind_law.formulas, "lines": RIGS}
"""What each type must be known to: the formulas of its law, the rigs."""
NEEDED = {"aero": (), "wind": ("speed", "azimuth"), "lines": ("length", "rigid")}
"""Fields that each type of the section must have."""
SECTIONS = {name: kind for name, kind in get_type_hints(Parameters).items() if name != "aero"}


def set_names() -> list[str]:
    """Names of the parameter sets that ship."""
    return sorted(file.stem for file in SETS.glob("*.toml"))


def read_toml(path: Path) -> dict[str, Any]:
    """The tables of a file; raises InputError where there is none or it is not TOML."""
    try:
        return tomllib.loads(read_text(path))
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{path} is not valid TOML: {error}") from None
    except RecursionError:
        raise InputError(f"{path} nests its tables too deeply to be a file of ours") from None


@cache
def _named_set(name: str) -> Mapping[str, Mapping[str, Any]]:
    if name not in set_names():
        raise InputError(f"there is no parameter set {name!r}; there are: {', '.join(set_names())}")
    tables = read_toml(SETS / f"{name}.toml")
    return {key: in_radians(table, key, name) for key, table in tables.items()}


def parameter_set(
    name: str, overrides: Mapping[str, Mapping[str, Any]] | None = None, source: str = "overrides"
) -> Parameters:
    """The named set with any field overridden: ``{"kite": {"mass": 5.0}, "aero": {...}}``.

    Units are those of `kitemj.physics.parameters`; ``name_deg`` is read as degrees. Raises
    InputError with one sentence, which names `source`, for whatever cannot be.
    """
    base = _named_set(name)
    changes = dict(overrides or {})
    for section in changes:
        if section not in Parameters._fields:
            raise unknown_key(section, ["aero", *SECTIONS], "", source)
    parts = {
        section: _part(section, base[section], changes.get(section, {}), source)
        for section in Parameters._fields
    }
    parameters = Parameters(**parts)
    _check_together(parameters, source)
    return parameters


def told_parameters(tables: Mapping[str, Mapping[str, Any]], source: str) -> Parameters:
    """The parameters of which `parameter_tables` made all of `tables`.

    Raises InputError, which names `source`, for whatever cannot be, or is missing: no number is
    taken from a named set.
    """
    for section in Parameters._fields:
        if not isinstance(tables.get(section), Mapping):
            raise InputError(f"{source} does not say what its {section} is: it is damaged")
    parameters = parameter_set("laksa", tables, source)
    for section, part in parameters._asdict().items():
        for name in part._fields:
            if name not in tables[section] and name not in part._field_defaults:
                raise InputError(f"{source} does not say {section}.{name}: it is damaged")
    return parameters


def parameter_tables(parameters: Parameters) -> dict[str, dict[str, Any]]:
    """The tables that `parameter_set` makes `parameters` of, angles in rad.

    Raises InputError for a law that has no name.
    """
    tables = {}
    for section, part in parameters._asdict().items():
        tables[section] = _table_of(part)
        if section in LAWS and not isinstance(part, Wind | Lines):  # files of old name neither
            name = LAWS[section].name_of(type(part))
            tables[section] = {NAMED_BY[section]: name, **tables[section]}
    return tables


def field_names(kind: type[Any]) -> list[str]:
    """The fields of a section, those of a ``NamedTuple`` in it as ``name.field``."""
    names = []
    for name, hint in get_type_hints(kind).items():
        inner = field_names(hint) if hasattr(hint, "_fields") else [""]
        names += [f"{name}.{each}".removesuffix(".") for each in inner]
    return names


def _table_of(part: Any) -> Any:
    if not hasattr(part, "_fields"):
        return part
    return {name: _table_of(value) for name, value in part._asdict().items()}


def _part(section: str, base: Mapping[str, Any], changes: Any, source: str) -> Any:
    """The section's numbers: those of the set, and over them those of `changes`."""
    if not isinstance(changes, Mapping):
        raise InputError(f"{section} must be a table of named values, got {changes!r} ({source})")
    changes = in_radians(changes, section, source)
    if section not in LAWS:
        return checked(SECTIONS[section], {**base, **changes}, section, source)
    key = NAMED_BY[section]
    usual = base.get(key, next(iter(LAWS[section].shipped)))
    law = changes.get(key, usual)
    kind = _kind(section, law, source)
    if law != usual:
        base = _shared(base, LAWS[section][usual], kind)
    numbers = {name: value for name, value in _over(base, changes).items() if name != key}
    return checked(kind, numbers, section, source)


def _kind(section: str, law: Any, source: str) -> type[Any]:
    """The type that the law's numbers have; InputError where it cannot be used."""
    registry = LAWS[section]
    if not isinstance(law, str) or law not in registry:
        raise InputError(
            f"{section}.{NAMED_BY[section]} must be one of {', '.join(registry)}, got {law!r} "
            f"({source}, [{section}])"
        )
    kind = registry[law]
    lacks = [name for name in NEEDED[section] if name not in getattr(kind, "_fields", ())]
    if lacks or kind not in KNOWN[section]:
        what = f"no field {lacks[0]}" if lacks else "no formula" if section != "lines" else "no rig"
        raise InputError(f"the {registry.kind} {law!r} has {what}: see its module's manual")
    return kind


def _shared(base: Mapping[str, Any], usual: type[Any], kind: type[Any]) -> dict[str, Any]:
    """Of the set's numbers for the law `usual` those that the law `kind` has too.

    By their names, or all of them as a field of the type `usual`.
    """
    numbers = {name: value for name, value in base.items() if name not in NAMED_BY.values()}
    hints = get_type_hints(kind).items()
    return {
        name: numbers if hint is usual else numbers[name]
        for name, hint in hints
        if hint is usual or name in numbers
    }


def _over(base: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """`base` with each value of `changes` in place of its own; tables within, too."""
    both = dict(base)
    for name, value in changes.items():
        under: Any = both.get(name)
        nested = isinstance(value, Mapping) and isinstance(under, Mapping)
        both[name] = _over(under, value) if nested else value
    return both


def _check_together(parameters: Parameters, source: str) -> None:
    """What no single number shows."""
    kite, length = parameters.kite, parameters.lines.length
    if length <= kite.y_A:
        raise InputError(
            f"lines.length must be > kite.y_A = {kite.y_A} m, got {length} m ({source}, [lines])"
        )
    if kite.inertia_xz**2 >= kite.inertia_x * kite.inertia_z:
        raise InputError(
            f"kite.inertia_xz² must be < inertia_x inertia_z = "
            f"{kite.inertia_x * kite.inertia_z:g} kg² m⁴, got inertia_xz = {kite.inertia_xz} "
            f"kg m² ({source}, [kite])"
        )
    tensor = [
        [kite.inertia_x, 0.0, -kite.inertia_xz],
        [0.0, kite.inertia_y, 0.0],
        [-kite.inertia_xz, 0.0, kite.inertia_z],
    ]
    moments = np.linalg.eigvalsh(tensor)
    if 2 * moments[2] > (1 + ROUNDING) * moments.sum():
        told = ", ".join(f"{moment:.6g}" for moment in moments)
        raise InputError(
            f"no rigid body has the principal moments of inertia {told} kg m²: the largest must "
            f"be <= the sum of the other two ({source}, [kite])"
        )
