"""A table of a TOML file made into a checked ``NamedTuple``, or one sentence for people."""

from collections.abc import Hashable, Iterable, Mapping, Sequence
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
        made: T = _adapter(kind).validate_python(values)  # type: ignore[arg-type]
    except ValidationError as error:
        raise InputError(_sentence(kind, values, error.errors()[0], section, source)) from None
    _check_sensible(made, section, source)
    return made


def _check_sensible(made: Any, section: str, source: str) -> None:
    """Raises InputError for the first number that is absurd, in tables within too."""
    for name, quantity in _quantities(made.__class__).items():
        value, field = getattr(made, name), _dotted(section, name)
        if hasattr(value, "_fields"):
            _check_sensible(value, field, source)
        elif quantity:
            (least, most), unit = quantity.sensible, f" {quantity.unit}".rstrip()
            for number in _numbers_in(value):
                if not least <= abs(number) <= most:
                    known = f"{least if quantity.gt == 0 else -most:g} to {most:g}{unit}"
                    raise InputError(f"{field} must be {known}, got {number!r}{unit} ({source})")


def _numbers_in(value: Any) -> list[float]:
    """The value if it is a number, or those in it."""
    if isinstance(value, tuple):
        return [number for each in value for number in _numbers_in(each)]
    return [value] if _is_number(value) else []


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


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
    return radians(value) if _is_number(value) else value


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
    return _quantities(kind).get(name)


@cache
def _quantities(kind: Hashable) -> Mapping[str, Quantity | None]:
    """By the names of the fields what their annotations say."""
    extras = {
        name: get_args(hint)[1:] if get_origin(hint) is Annotated else ()
        for name, hint in get_type_hints(kind, include_extras=True).items()
    }
    return {
        name: next((each for each in several if isinstance(each, Quantity)), None)
        for name, several in extras.items()
    }


def _shape(hint: Any) -> tuple[int | None, ...]:
    """How many numbers a type of nested tuples holds at each depth; None: any number of them."""
    if get_origin(hint) is not tuple:
        return next(filter(None, map(_shape, get_args(hint))), ())  # of an optional one
    inner = get_args(hint)
    return (None if Ellipsis in inner else len(inner), *_shape(inner[0]))


def _shape_of(value: Any) -> str:
    """The shape of a list of lists of equal lengths, in words."""
    lengths = []
    while isinstance(value, (list, tuple)):
        lengths.append(len(value))
        if len({len(each) if isinstance(each, (list, tuple)) else -1 for each in value}) > 1:
            return f"{' x '.join(map(str, lengths))} of unequal parts"
        value = value[0] if value else None
    return " x ".join(map(str, lengths))


def _sentence(kind: type, values: Mapping[str, Any], error: Any, section: str, source: str) -> str:
    name = str(error["loc"][0]) if error["loc"] else ""
    part: Any = get_type_hints(kind).get(name)
    if len(error["loc"]) > 1 and hasattr(part, "_fields"):
        within = {**error, "loc": error["loc"][1:]}
        return _sentence(part, values[name], within, _dotted(section, name), source)
    where = f"({source}, [{section}])" if section else f"({source})"
    field = _dotted(section, name)
    quantity = quantity_of(kind, name)
    unit = f" {quantity.unit}" if quantity and quantity.unit else ""
    meaning = f": {quantity.meaning}" if quantity else ""
    got, problem = error["input"], error["type"]
    if problem == "extra_forbidden":
        return str(unknown_key(name, list(kind._fields), section, source))  # type: ignore[attr-defined]
    if name in values and (shape := _shape(part)):
        numbers = "a list of numbers" if None in shape else f"{' x '.join(map(str, shape))} numbers"
        told = _shape_of(values[name])
        if told != " x ".join(map(str, shape)) and (None not in shape or not told):
            return f"{field} must be {numbers}, got {told or repr(got)}{meaning} {where}"
        place = "".join(f"[{index}]" for index in error["loc"][1:])
        return f"{field}{place} must be a number, got {got!r}{meaning} {where}"
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
