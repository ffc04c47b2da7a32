"""Parameter sets from TOML: the named sets that ship, and overrides of any field."""

import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from kitemj.errors import InputError
from kitemj.physics.aerodynamics import LinearAero, TableAero
from kitemj.physics.checked import checked, in_radians, unknown_key
from kitemj.physics.kite import Kite, Lines
from kitemj.physics.parameters import Environment, Limits, Parameters, StickLimits
from kitemj.physics.wind import Wind

ROUNDING = 1e-12

SETS = Path(__file__).parent / "sets"
AERO_LAWS: dict[str, type[LinearAero] | type[TableAero]] = {
    "linear": LinearAero,
    "table": TableAero,
}
SECTIONS = {
    "kite": Kite,
    "lines": Lines,
    "environment": Environment,
    "wind": Wind,
    "limits": Limits,
    "stick": StickLimits,
}


def set_names() -> list[str]:
    """Names of the parameter sets that ship."""
    return sorted(file.stem for file in SETS.glob("*.toml"))


def read_toml(path: Path) -> dict[str, Any]:
    """The tables of a file; raises InputError where there is none or it is not TOML."""
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"cannot read {path}: {error.strerror or error}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise InputError(f"{path} is not valid TOML: {error}") from None


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
        if section != "aero" and section not in SECTIONS:
            raise unknown_key(section, ["aero", *SECTIONS], "", source)
    tables = {
        section: {**base[section], **_table(changes.get(section, {}), section, source)}
        for section in SECTIONS
    }
    parts: dict[str, Any] = {
        section: checked(kind, tables[section], section, source)
        for section, kind in SECTIONS.items()
    }
    parameters = Parameters(aero=_aero(base["aero"], changes.get("aero", {}), source), **parts)
    _check_together(parameters, source)
    return parameters


def _table(value: Any, section: str, source: str) -> dict[str, Any]:
    if not isinstance(value, Mapping):
        raise InputError(f"{section} must be a table of named values, got {value!r} ({source})")
    return in_radians(value, section, source)


def _aero(base: Mapping[str, Any], changes: Any, source: str) -> LinearAero | TableAero:
    changes = _table(changes, "aero", source)
    law = changes.get("law", base["law"])
    if law not in AERO_LAWS:
        raise InputError(
            f"aero.law must be one of {', '.join(AERO_LAWS)}, got {law!r} ({source}, [aero])"
        )
    merged = {**base, **changes} if law == base["law"] else changes
    numbers = {key: value for key, value in merged.items() if key != "law"}
    return checked(AERO_LAWS[law], numbers, "aero", source)


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
