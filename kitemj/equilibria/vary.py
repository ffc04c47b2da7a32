"""Parameters by dotted names (``aero.Cl_beta``): which there are, and a set with one changed."""

from functools import reduce
from typing import Any

from kitemj.errors import InputError
from kitemj.physics.checked import quantity_of, unknown_key
from kitemj.physics.parameter_files import field_names, parameter_set, parameter_tables
from kitemj.physics.parameters import Parameters

VARIED = ("aero", "kite", "lines", "environment", "wind")
"""Sections that an equilibrium depends on."""
NOT_VARIED = ("wind.gust_amplitude", "wind.gust_frequency")


def parameter_names(parameters: Parameters) -> list[str]:
    """Every number of the set that an equilibrium in a steady wind can depend on."""
    names = [
        f"{section}.{field}"
        for section in VARIED
        for field in field_names(type(getattr(parameters, section)))
    ]
    numbers = [name for name in names if type(_value(parameters, name)) in (int, float)]
    return [name for name in numbers if name not in NOT_VARIED]


def value_of(parameters: Parameters, name: str) -> float:
    """The value of the parameter `name`; raises InputError, with those there are."""
    if name not in parameter_names(parameters):
        raise unknown_key(name, parameter_names(parameters), "", "parameters that can be varied")
    return float(_value(parameters, name))


def unit_of(parameters: Parameters, name: str) -> str:
    """The unit of the parameter `name`; empty where it has none."""
    part, _, field = name.rpartition(".")
    quantity = quantity_of(type(_value(parameters, part)), field)
    return quantity.unit if quantity else ""


def with_value(parameters: Parameters, name: str, value: float) -> Parameters:
    """The set with one number changed; unchecked, for numbers within a checked range."""
    changed: Any = value
    while name:
        name, _, field = name.rpartition(".")
        changed = _value(parameters, name)._replace(**{field: changed})
    return changed  # type: ignore[no-any-return]


def check_range(parameters: Parameters, name: str, low: float, high: float) -> None:
    """Raises InputError for an unknown `name`, an empty range, or an end no set may have."""
    value_of(parameters, name)
    if not low < high:
        raise InputError(f"the range of {name} must ascend, got {low:g} to {high:g}")
    for end in (low, high):
        tables = parameter_tables(with_value(parameters, name, end))
        parameter_set("laksa", tables, f"the range of {name}")


def _value(parameters: Parameters, name: str) -> Any:
    """The number or the section called `name`; the whole set for an empty one."""
    return reduce(getattr, filter(None, name.split(".")), parameters)
