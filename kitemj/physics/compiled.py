"""Formulas as plain Python that numba compiles: one source, two ways to run it.

``@compiled`` turns a function of floats and ``NamedTuple``s into machine code;
``f.py_func`` is still the Python one. ``@law`` makes a function whose formula is chosen
by the type of its first argument, in both worlds: that is how another aerodynamic model
or another steering programme takes its place without touching the dynamics.
"""

import hashlib
import multiprocessing
import sys
import tempfile
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import numba
import numpy as np
from numba import njit
from numba.core import event
from numba.extending import overload
from numpy.typing import NDArray
from platformdirs import user_cache_path

Array = NDArray[np.float64]
F = TypeVar("F", bound=Callable[..., Any])

OPTIONS: Any = {
    "nogil": True,
    "error_model": "numpy",
    "no_cfunc_wrapper": True,  # nothing calls through a C pointer; a tenth of the compiling
}
PACKAGE = Path(__file__).parent.parent


@cache
def cache_folder() -> Path:
    """Where machine code is kept: one folder for each state of the formulas.

    numba notices a change in a function's own file only, never in the files of the
    functions that it calls, so the name carries a hash of every formula.
    """
    digest = hashlib.sha256()
    for source in sorted(PACKAGE.glob("*/*.py")):
        if b"@compiled" in (text := source.read_bytes()) or source.parent.name == "physics":
            digest.update(text)
    home = user_cache_path("kitemj")
    try:
        home.mkdir(parents=True, exist_ok=True)
    except OSError:  # a home that cannot be written: compile in every process
        home = Path(tempfile.mkdtemp(prefix="kitemj-"))
    return home / f"compiled-{digest.hexdigest()[:16]}"


class _FirstCompilation(event.Listener):
    """Says once why nothing happens for a while, where nothing is compiled yet."""

    said = False

    def on_start(self, event: event.Event) -> None:
        """A formula is about to be compiled: it was not found on the disk."""
        kept = any(cache_folder().glob("**/*.nbi"))
        if not (self.said or multiprocessing.parent_process() or kept):
            print("compiling the formulas for this machine, once: some 15 s", file=sys.stderr)
        self.said = True

    def on_end(self, event: event.Event) -> None:
        """Nothing to be said."""


event.register("numba:compile", _FirstCompilation())  # type: ignore[no-untyped-call]

_formulas: list[Any] = []
_strangers: dict[str, bytes] = {}
"""Files outside the package that hold formulas, those of a user, or cells of a notebook."""


def compiled(function: F) -> F:
    """Machine code for `function`, kept on disk, free of the interpreter's lock."""
    machine_code: Any = njit(**OPTIONS)(function)
    if machine_code is not function:  # numba can be told to leave everything Python
        _formulas.append(machine_code)
        code = function.__code__
        source = Path(code.co_filename)
        if PACKAGE in source.parents or code.co_filename in _strangers:
            _keep([machine_code])
        else:  # from now on nothing is kept where processes without this file would find it
            cell = code.co_code + repr(code.co_consts).encode()
            name = code.co_filename if source.is_file() else f"{code.co_filename} {code.co_name}"
            _strangers[name] = source.read_bytes() if source.is_file() else cell
            _keep(_formulas)
    return machine_code  # type: ignore[no-any-return]


def _keep(formulas: list[Any]) -> None:
    folder = cache_folder()
    if _strangers:
        digest = hashlib.sha256(b"".join(_strangers[name] for name in sorted(_strangers)))
        folder = folder.with_name(f"{folder.name}-{digest.hexdigest()[:16]}")
    settings: Any = numba.config
    elsewhere, settings.CACHE_DIR = settings.CACHE_DIR, str(folder)
    try:
        for formula in formulas:
            with suppress(RuntimeError):  # typed in, not read from a file: never kept
                formula.enable_caching()
    finally:
        settings.CACHE_DIR = elsewhere


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


def law(contract: F) -> tuple[F, Law]:
    """The function to call and the `Law` to register formulas with.

    `contract` has the signature and the docstring; its body is never run.
    """
    register = Law()

    def by_type(*arguments: Any) -> Any:
        return register.formulas[type(arguments[0])](*arguments)

    by_type.__doc__, by_type.__name__ = contract.__doc__, contract.__name__

    @overload(by_type, strict=False)
    def choose(*arguments: Any) -> Any:
        formula = register.formulas[arguments[0].instance_class]
        return lambda *arguments: formula(*arguments)

    return by_type, register  # type: ignore[return-value]
