"""Parameters by dotted names (``aero.Cl_beta``): which there are, and a set with one changed."""

from typing import Annotated, Any, get_args, get_origin, get_type_hints

from kitemj.errors import InputError
from kitemj.physics.checked import unknown_key
from kitemj.physics.parameter_files import AERO_LAWS, SECTIONS, parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.quantity import Quantity

VARIED = ("aero", "kite", "lines", "environment", "wind")
"""Sections that an equilibrium depends on."""
NOT_VARIED = ("wind.gust_amplitude", "wind.gust_frequency")


def parameter_names(parameters: Parameters) -> list[str]:
    """Every number of the set that an equilibrium in a steady wind can depend on."""
    names = [
        f"{section}.{field}"
        for section in VARIED
        for field, value in getattr(parameters, section)._asdict().items()
        if isinstance(value, (int, float)) and not isinstance(value, bool)
    ]
    return [name for name in names if name not in NOT_VARIED]


def value_of(parameters: Parameters, name: str) -> float:
    """The value of the parameter `name`; raises InputError, with those there are."""
    if name not in parameter_names(parameters):
        raise unknown_key(name, parameter_names(parameters), "", "parameters that can be varied")
    section, field = name.split(".")
    return float(getattr(getattr(parameters, section), field))


def unit_of(parameters: Parameters, name: str) -> str:
    """The unit of the parameter `name`; empty where it has none."""
    section, field = name.split(".")
    hint = get_type_hints(type(getattr(parameters, section)), include_extras=True)[field]
    extras = get_args(hint)[1:] if get_origin(hint) is Annotated else ()
    return next((extra.unit for extra in extras if isinstance(extra, Quantity)), "")


def with_value(parameters: Parameters, name: str, value: float) -> Parameters:
    """The set with one number changed; unchecked, for numbers within a checked range."""
    section, field = name.split(".")
    changed = getattr(parameters, section)._replace(**{field: value})
    return parameters._replace(**{section: changed})


def check_range(parameters: Parameters, name: str, low: float, high: float) -> None:
    """Raises InputError for an unknown `name`, an empty range, or an end no set may have."""
    value_of(parameters, name)
    if not low < high:
        raise InputError(f"the range of {name} must ascend, got {low:g} to {high:g}")
    for end in (low, high):
        _checked(with_value(parameters, name, end), f"the range of {name}")


def _checked(parameters: Parameters, source: str) -> None:
    """The checks of `parameter_set` on every number of the set."""
    tables: dict[str, dict[str, Any]] = {
        section: getattr(parameters, section)._asdict() for section in SECTIONS
    }
    law = next(name for name, kind in AERO_LAWS.items() if isinstance(parameters.aero, kind))
    tables["aero"] = {"law": law, **parameters.aero._asdict()}
    parameter_set("laksa", tables, source)
