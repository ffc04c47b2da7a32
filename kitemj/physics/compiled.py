"""Formulas as plain Python that numba compiles: one source, two ways to run it.

``@compiled`` turns a function of floats and ``NamedTuple``s into machine code;
``f.py_func`` is still the Python one. ``@law`` makes a function whose formula is chosen
by the type of its first argument, in both worlds: that is how another aerodynamic model
or another steering programme takes its place without touching the dynamics.
"""

import os
import sys
from collections.abc import Callable
from multiprocessing import parent_process
from typing import Any, TypeVar

import numpy as np
from numba import njit
from numba.core import event
from numba.extending import overload
from numpy.typing import NDArray

from kitemj.physics.code_folder import INHERITED, code_folder
from kitemj.physics.fingerprint import fingerprint
from kitemj.physics.machine_code import MachineCode

Array = NDArray[np.float64]
F = TypeVar("F", bound=Callable[..., Any])

OPTIONS: Any = {
    "nogil": True,
    "error_model": "numpy",
    "no_cfunc_wrapper": True,  # nothing calls through a C pointer; a tenth of the compiling
}


class _FirstCompilation(event.Listener):
    """Says once why nothing happens for a while, where nothing is compiled yet."""

    said = False

    def on_start(self, event: event.Event) -> None:
        """A formula is about to be compiled: it was not found on the disk."""
        folder = code_folder()
        known = os.environ.get(INHERITED) or folder is None or any(folder.iterdir())
        if not (self.said or parent_process() or known):
            print("compiling the formulas for this machine, once: some 15 s", file=sys.stderr)
        self.said = True

    def on_end(self, event: event.Event) -> None:
        """Nothing to be said."""


event.register("numba:compile", _FirstCompilation())  # type: ignore[no-untyped-call]


def compiled(function: F) -> F:
    """Machine code for `function`, kept on disk, free of the interpreter's lock."""
    formula: Any = njit(**OPTIONS)(function)
    if formula is not function:  # numba can be told to leave everything Python
        formula._cache = MachineCode(formula)
    return formula  # type: ignore[no-any-return]


class Law:
    """A formula for each type of first argument; see `law`."""

    def __init__(self) -> None:
        self.formulas: dict[type, Callable[..., Any]] = {}

    def of(self, kind: type) -> Callable[[F], F]:
        """Registers the decorated function as the formula for `kind` (a ``NamedTuple``).

        Its name must be its own: numba tells types apart by their names and their fields.
        """

        def register(function: F) -> F:
            self.formulas[kind] = function
            return function

        return register


_laws: list[Law] = []


def code_of(kind: type) -> str:
    """A hash of the formulas that laws have for `kind`, and of all that they are made of."""
    return fingerprint(tuple(law.formulas[kind] for law in _laws if kind in law.formulas), ())


def law(contract: F) -> tuple[F, Law]:
    """The function to call and the `Law` to register formulas with.

    `contract` has the signature and the docstring; its body is never run.
    """
    register = Law()
    _laws.append(register)

    def by_type(*arguments: Any) -> Any:
        return register.formulas[type(arguments[0])](*arguments)

    by_type.__doc__, by_type.__name__ = contract.__doc__, contract.__name__
    by_type.law = register  # type: ignore[attr-defined]

    @overload(by_type, strict=False)
    def choose(*arguments: Any) -> Any:
        formula = register.formulas[arguments[0].instance_class]
        return lambda *arguments: formula(*arguments)

    return by_type, register  # type: ignore[return-value]
