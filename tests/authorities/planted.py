"""A fault planted in a shared formula: the program and one test imported anew, in plain Python."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from types import CodeType, ModuleType
from typing import Any

import numba

ROOTS = ("kitemj", "tests")


class _Faulty(SourceFileLoader):
    """Loads a module whose text `right` is made `wrong`."""

    change = ("", "")

    def get_code(self, fullname: str) -> CodeType:
        """The code of the changed text, which is never kept."""
        text, (right, wrong) = self.get_source(fullname) or "", self.change
        if text.count(right) != 1:
            raise ValueError(f"{right!r} stands {text.count(right)} times in {fullname}")
        return compile(text.replace(right, wrong), self.path, "exec")


class _Finder(MetaPathFinder):
    def __init__(self, module: str, right: str, wrong: str) -> None:
        self._module, self._change = module, (right, wrong)

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> ModuleSpec | None:
        """The place of the one module that has the fault."""
        spec = PathFinder.find_spec(name, path) if name == self._module else None
        if spec and spec.origin:
            spec.loader = _Faulty(name, spec.origin)
            spec.loader.change = self._change
        return spec


@contextmanager
def planted(module: str = "", right: str = "", wrong: str = "") -> Iterator[None]:
    """Within, imports are of a program whose `module` has `wrong` in the place of `right`.

    Nothing of it is compiled. Raises ValueError, when the module is imported, unless `right`
    stands there exactly once: a fault must be planted, not believed to be.
    """
    settings: Any = numba.config
    finder, compiling, whole = _Finder(module, right, wrong), settings.DISABLE_JIT, _ours()
    for name in whole:
        del sys.modules[name]
    sys.meta_path.insert(0, finder)
    settings.DISABLE_JIT = True
    try:
        yield
    finally:
        settings.DISABLE_JIT = compiling
        sys.meta_path.remove(finder)
        for name in _ours():
            del sys.modules[name]
        sys.modules.update(whole)


def _ours() -> dict[str, ModuleType]:
    return {n: module for n, module in sys.modules.items() if n.partition(".")[0] in ROOTS}


def outcome(test: str) -> str:
    """ "" where `test` ("module:function" of this folder) holds, else what it said."""
    file, _, function = test.partition(":")
    try:
        getattr(import_module(f"tests.authorities.{file}"), function)()
    except AssertionError as error:
        return str(error) or "it does not hold"
    return ""
