"""A table of a TOML file made into a checked ``NamedTuple``, or one sentence for people."""

from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches
from functools import cache
from math import radians
from typing import Annotated, Any, TypeVar, get_args, get_origin, get_type_hints

from pydantic import ConfigDict, TypeAdapter, ValidationError

from kitemj.errors import InputError
from kitemj.physics.quantity import Quantity

T = TypeVar("T")


def checked(kind: type[T], table: Mapping[str, Any], section: str, source: str) -> T:
    """`table` as a `kind` whose annotations name unit and bounds.

    `section` and `source` say where the table stands, for the sentence of the `InputError`
    that is raised for an unknown or missing key, a wrong type, a bound or a non-number.
    """
    values = {key: _tuples(value) for key, value in table.items()}
    try:
        return _adapter(kind).validate_python(values)  # type: ignore[no-any-return, arg-type]
    except ValidationError as error:
        raise InputError(_sentence(kind, error.errors()[0], section, source)) from None


@cache
def _adapter(kind: type) -> Any:
    """Made once: it takes half a millisecond, and a study reads thousands of flights."""
    return TypeAdapter(kind, config=ConfigDict(strict=True, allow_inf_nan=False))


def in_radians(table: Mapping[str, Any], section: str, source: str) -> dict[str, Any]:
    """The table with every ``name_deg`` in degrees as ``name`` in rad, and so in tables within."""
    turned: dict[str, Any] = {}
    for key, value in table.items():
        name = key.removesuffix("_deg")
        if name in turned or (name != key and name in table):
            raise InputError(
                f"{_dotted(section, name)} is given twice, with and without _deg: "
                f"keep one ({source})"
            )
        if isinstance(value, Mapping):
            turned[name] = in_radians(value, _dotted(section, name), source)
        else:
            turned[name] = _radians(value) if name != key else value
    return turned


def _tuples(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _tuples(item) for key, item in value.items()}
    return tuple(_tuples(item) for item in value) if isinstance(value, list) else value


def _radians(value: Any) -> Any:
    if isinstance(value, list):
        return [_radians(item) for item in value]
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return radians(value) if number else value


def unknown_key(name: str, known: Sequence[str], section: str, source: str) -> InputError:
    """The error for a key that is not in `known`."""
    close = get_close_matches(name, known, 1)
    hint = f"did you mean {close[0]!r}? " if close else ""
    return InputError(
        f"{_dotted(section, name)} is not known: {hint}there are: {', '.join(known)} ({source})"
    )


def check_keys(keys: Iterable[str], known: Sequence[str], section: str, source: str) -> None:
    """Raises the InputError of `unknown_key` for the first of `keys` that is not `known`."""
    for key in keys:
        if key not in known:
            raise unknown_key(key, known, section, source)


def _dotted(section: str, name: str) -> str:
    return f"{section}.{name}" if section else name


def quantity_of(kind: type, name: str) -> Quantity | None:
    """What the annotation of the field `name` says; None where it says nothing."""
    hint = get_type_hints(kind, include_extras=True).get(name)
    if get_origin(hint) is not Annotated:
        return None
    return next((extra for extra in get_args(hint)[1:] if isinstance(extra, Quantity)), None)


def _sentence(kind: type, error: Any, section: str, source: str) -> str:
    name = str(error["loc"][0]) if error["loc"] else ""
    part: Any = get_type_hints(kind).get(name)
    if len(error["loc"]) > 1 and hasattr(part, "_fields"):
        return _sentence(part, {**error, "loc": error["loc"][1:]}, _dotted(section, name), source)
    where = f"({source}, [{section}])" if section else f"({source})"
    field = _dotted(section, name)
    quantity = quantity_of(kind, name)
    unit = f" {quantity.unit}" if quantity and quantity.unit else ""
    meaning = f": {quantity.meaning}" if quantity else ""
    got, problem = error["input"], error["type"]
    if problem == "extra_forbidden":
        return str(unknown_key(name, list(kind._fields), section, source))  # type: ignore[attr-defined]
    if len(error["loc"]) > 1:
        place = "".join(f"[{index}]" for index in error["loc"][1:])
        return f"{field}{place}: {error['msg']}{meaning} {where}"
    if problem in ("missing_argument", "missing"):
        return f"{field} is missing{meaning}{f' in{unit}' if unit else ''}; add it {where}"
    for bound, sign in (("gt", ">"), ("ge", ">="), ("lt", "<"), ("le", "<=")):
        if bound in error.get("ctx", {}):
            limit = error["ctx"][bound]
            return f"{field} must be {sign} {limit:g}{unit}, got {got!r}{unit} {where}"
    if problem == "finite_number":
        return f"{field} must be a finite number{f' in{unit}' if unit else ''}, got {got} {where}"
    if problem.startswith(("float", "int", "bool", "string")):
        wanted = {"f": "a number", "i": "a whole number", "b": "true or false", "s": "a text"}
        what = wanted[problem[0]] + (f" in{unit}" if unit else "")
        return f"{field} must be {what}, got {got!r} {where}"
    return f"{field}: {error['msg']}, got {got!r} {where}"
