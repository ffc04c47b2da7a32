"""Things by name: those that ship, those of installed packages, those of a module of one's own."""

from collections.abc import Iterator, Mapping
from importlib import import_module
from importlib.metadata import EntryPoint, entry_points
from typing import Any, Generic, TypeVar

from kitemj.errors import InputError

T = TypeVar("T")


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

    def __getitem__(self, name: str) -> T:
        """The thing called `name`; raises InputError as `check` does."""
        self.check(name)
        if name not in self._loaded:
            if name in self.shipped:
                module, _, attribute = self.shipped[name].partition(":")
                thing: Any = getattr(import_module(module), attribute)
            else:
                thing = self._installed()[name].load()
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
        return len(list(self))

    def name_of(self, thing: T) -> str:
        """The name under which `thing` can be asked for; raises InputError where it has none."""
        for name in self:
            if self[name] is thing:
                return name
        raise InputError(f"{thing!r} has no name among the {self.kind}s: add it first")

    def origin(self, name: str) -> dict[str, str]:
        """Who brought `name`, with its version; empty for ours."""
        if name in self.shipped:
            return {}
        if name in (installed := self._installed()):
            package = installed[name].dist
            return {package.name: package.version} if package else {}
        module = import_module(getattr(self[name], "__module__", "__main__"))
        return {module.__name__: str(getattr(module, "__version__", "without a version"))}

    def _installed(self) -> dict[str, EntryPoint]:
        return {each.name: each for each in entry_points(group=self.group)}
