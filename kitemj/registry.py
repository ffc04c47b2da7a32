"""Things by name: those that ship, those of installed packages, those of a module of one's own."""

import hashlib
import sys
from collections.abc import Iterator, Mapping
from importlib import import_module
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Any, Generic, TypeVar

from kitemj.errors import InputError

T = TypeVar("T")

_own_modules: dict[str, None] = {}
"""Modules that were used, or define what was added, in their order."""


def use(module: str) -> None:
    """Imports a module, of the working folder or installed, which adds things to registries.

    Raises InputError where it cannot be imported.
    """
    folder, name = str(Path.cwd()), module.removesuffix(".py")
    if "" not in sys.path and folder not in sys.path:
        sys.path.append(folder)
    try:
        import_module(name)
    except Exception as error:
        raise InputError(f"cannot use the module {name!r}: {_why(error)}") from None
    _own_modules[name] = None


def own_modules() -> tuple[str, ...]:
    """What another process has to `use`, so that the same names are known there."""
    return tuple(_own_modules)


def _why(error: Exception) -> str:
    return str(error) if isinstance(error, InputError) else f"{type(error).__name__}: {error}"


class Registry(Generic[T]):
    """Things of one `kind` ("model", "pilot") by name; each is loaded when it is asked for.

    `shipped` says where ours are ("package.module:Name"). Another installed package names its
    own as entry points of `group`; a module of one's own calls `add`. Ours come first.
    """

    def __init__(self, kind: str, group: str, shipped: Mapping[str, str]) -> None:
        self.kind, self.group, self.shipped = kind, group, dict(shipped)
        self._loaded: dict[str, T] = {}

    def add(self, name: str, thing: T) -> None:
        """Gives `thing` a name; raises InputError where the name is that of another."""
        if name in self.shipped or self._loaded.get(name, thing) is not thing:
            raise InputError(f"there is a {self.kind} {name!r} already: choose another name")
        self._loaded[name] = thing
        if thing.__module__ != "__main__":
            _own_modules[thing.__module__] = None

    def __getitem__(self, name: str) -> T:
        """The thing called `name`; raises InputError as `check` does."""
        self.check(name)
        if name not in self._loaded:
            if name in self.shipped:
                module, _, attribute = self.shipped[name].partition(":")
                thing: Any = getattr(import_module(module), attribute)
            else:
                try:
                    thing = self._installed()[name].load()
                except Exception as error:
                    raise InputError(
                        f"cannot load the installed {self.kind} {name!r}: {_why(error)}"
                    ) from None
            self._loaded[name] = thing
        return self._loaded[name]

    def check(self, name: str) -> None:
        """Raises InputError, with the names there are, for a name that means nothing."""
        if name not in self:
            names = ", ".join(self)
            raise InputError(f"there is no {self.kind} {name!r}; there are: {names}")

    def __contains__(self, name: object) -> bool:
        """Whether there is something of this name."""
        return name in self.shipped or name in self._loaded or name in self._installed()

    def __iter__(self) -> Iterator[str]:
        """All names: ours in their order, then the others by the alphabet."""
        yield from self.shipped
        yield from sorted({*self._loaded, *self._installed()} - {*self.shipped})

    def __len__(self) -> int:
        """How many names there are."""
        return sum(1 for _ in self)

    def name_of(self, thing: T) -> str:
        """The name under which `thing` can be asked for; raises InputError where it has none."""
        for name in list(self._loaded) + list(self):
            if self[name] is thing:
                return name
        raise InputError(f"{thing!r} has no name among the {self.kind}s: add it first")

    def origin(self, name: str) -> str:
        """Who brought `name`, with its version ("my_kites 1.2"); empty for ours.

        A module that has no `__version__` is known by a hash of its source.
        """
        if name in self.shipped:
            return ""
        if name in (installed := self._installed()):
            package = installed[name].dist
            return f"{package.name} {package.version}" if package else "an unknown package"
        module = import_module(str(self[name].__module__))
        file = Path(getattr(module, "__file__", None) or "")
        source = hashlib.sha256(file.read_bytes()).hexdigest()[:8] if file.is_file() else "unknown"
        return f"{module.__name__} {getattr(module, '__version__', f'(source {source})')}"

    def _installed(self) -> dict[str, EntryPoint]:
        return {each.name: each for each in entry_points(group=self.group)}
