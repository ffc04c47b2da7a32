"""A menu: what can be chosen, what is marked now, and what a key, a button or the mouse does."""

from collections.abc import Sequence
from dataclasses import dataclass, field


@dataclass
class Entry:
    """A line of a menu: `key` for the program, `label` and what it `says` for people.

    `offers` are what can be chosen within it, to the left and to the right of `offer`. One that
    is not `open` is passed over.
    """

    key: str
    label: str
    says: str = ""
    open: bool = True
    offers: Sequence[str] = ()
    offer: int = 0

    @property
    def offered(self) -> str:
        """What is chosen within it now."""
        return self.offers[self.offer] if self.offers else ""


@dataclass
class Menu:
    """Entries of which one, that is open, is marked; `chosen` is the key of the one taken."""

    entries: Sequence[Entry]
    marked: int = 0
    chosen: str = field(default="", init=False)

    def __post_init__(self) -> None:
        """Marks an entry that is open."""
        if not self.entries[self.marked].open:
            self._move(1)

    @property
    def entry(self) -> Entry:
        """The one that is marked."""
        return self.entries[self.marked]

    def ask(self, action: str) -> None:
        """Does "up", "down", "left", "right", "choose" or "leave"; nothing for other words."""
        if action in ("up", "down"):
            self._move(1 if action == "down" else -1)
        elif action in ("left", "right"):
            self._turn(1 if action == "right" else -1)
        elif action == "choose":
            if self.entry.offers:
                self._turn(1)
            else:
                self.chosen = self.entry.key
        elif action == "leave":
            self.chosen = "leave"

    def _move(self, by: int) -> None:
        """Marks the next open entry, around and around."""
        for _ in self.entries:
            self.marked = (self.marked + by) % len(self.entries)
            if self.entry.open:
                return

    def _turn(self, by: int) -> None:
        """Offers the next within the entry, which is then chosen."""
        if self.entry.offers:
            self.entry.offer = (self.entry.offer + by) % len(self.entry.offers)
            self.chosen = self.entry.key
