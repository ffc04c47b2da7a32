"""What the machine code of a formula is made of: all code and all numbers within its reach."""

import hashlib
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

import numpy as np
from numba import types

PLAIN = (bool, int, float, complex, str, bytes, np.generic, type(None), type(...))
"""Values that their text tells."""


def fingerprint(formula: Any, signature: Any) -> str:
    """A hash that changes with whatever changes the machine code of `formula` for `signature`.

    That is the code of each compiled function that it can call, in whichever file; the values of
    globals and closures, which numba freezes; the fields of each ``NamedTuple``; and of a `law`
    the formulas for the types that can occur, so that laws of others leave this one alone.
    """
    reach = _Reach()
    reach.follow([formula, *classes_of(signature)])
    digest = hashlib.sha256(str(signature).encode())
    for told in reach.told:
        digest.update(repr(told).encode())
    return digest.hexdigest()


def classes_of(kind: Any) -> Iterator[type]:
    """The ``NamedTuple``s among numba's types, at whatever depth."""
    if isinstance(kind, types.NamedTuple | types.NamedUniTuple):
        yield kind.instance_class
    if isinstance(kind, tuple | types.BaseTuple):
        parts: Any = kind
        for part in dict.fromkeys(parts):
            yield from classes_of(part)


class _Reach:
    """What is told of everything that was met, in the order in which it was met."""

    def __init__(self) -> None:
        self.told: list[Any] = []
        self._met: dict[int, tuple[int, Any]] = {}  # by identity; held, so that it stays one
        self._laws: list[Any] = []
        self._chosen: set[tuple[int, int]] = set()

    def follow(self, values: list[Any]) -> None:
        """Tells of `values` and of all that they lead to."""
        waiting = values[::-1]
        while waiting:
            value = waiting.pop()
            if isinstance(value, PLAIN):
                self.told.append((type(value).__name__, value))
            elif id(value) in self._met:
                self.told.append(self._met[id(value)][0])
            else:
                self._met[id(value)] = len(self._met), value
                waiting += self._tell(value)
            waiting = waiting or self._formulas()

    def _formulas(self) -> list[Any]:
        """Those of the laws that were met for the types that were met, each once."""
        found = []
        for law in self._laws:
            for kind in sorted((each for each in law.formulas if id(each) in self._met), key=_name):
                if (id(law), id(kind)) not in self._chosen:
                    self._chosen.add((id(law), id(kind)))
                    self.told.append(_name(kind))
                    found.append(law.formulas[kind])
        return found

    def _tell(self, value: Any) -> list[Any]:
        """Tells of one value; what it leads to."""
        if isinstance(value, tuple):
            self.told.append((_name(type(value)), len(value)))
            return [type(value), *value]
        if isinstance(value, np.ndarray):
            self.told.append((str(value.dtype), value.shape, value.tobytes()))
        elif hasattr(value, "py_func"):
            self.told.append((_name(value), sorted(value.targetoptions.items())))
            return self._function(value.py_func)
        elif hasattr(value, "_fields"):
            self.told.append((_name(value), value._fields, [*value._field_defaults]))
            return [*value._field_defaults.values()]
        elif hasattr(value, "law"):
            self.told.append(_name(value))
            self._laws.append(value.law)
        else:  # nothing that can be looked into: the file that it comes from
            named = str(value) if isinstance(value, types.Type) else _name(value)
            self.told.append((named, _source(getattr(value, "__module__", None))))
        return []

    def _function(self, function: Any) -> list[Any]:
        code: CodeType = function.__code__
        self.told.append(list(_told_of(code)))
        cells = [cell.cell_contents for cell in function.__closure__ or ()]
        return [*_globals(function), *cells, *(function.__defaults__ or ())]


def _told_of(code: CodeType) -> Iterator[Any]:
    """What the code does, and that of the functions within it."""
    yield code.co_code, code.co_names, code.co_varnames, code.co_freevars
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _told_of(constant)
        else:
            yield sorted(map(repr, constant)) if isinstance(constant, frozenset) else constant


def _globals(function: Any) -> list[Any]:
    """The values of the global names of a function, and of names of the modules among them."""
    names = list(dict.fromkeys(_names(function.__code__)))
    found, modules = [], [function.__globals__]
    for module in modules:  # more are added on the way
        for name in names:
            value = module.get(name)
            if isinstance(value, ModuleType):
                if not any(value.__dict__ is known for known in modules):
                    modules.append(value.__dict__)
            elif name in module:
                found.append(value)
    return found


def _names(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


def _name(value: Any) -> str:
    named = value if hasattr(value, "__name__") else type(value)
    return f"{getattr(value, '__module__', '')}.{getattr(named, '__qualname__', named.__name__)}"


@cache
def _source(module: str | None) -> str:
    """A hash of the file of `module`; empty where there is none."""
    file = Path(getattr(sys.modules.get(module or ""), "__file__", None) or "")
    return hashlib.sha256(file.read_bytes()).hexdigest() if file.is_file() else ""
