"""Who has the stick: a person, or the autopilot that they handed over to."""

from collections.abc import Mapping

from kitemj.controls.notices import Notices
from kitemj.flight.live import Command

BAND = 0.1
"""Of the stick's way; less does not take back: a worn stick that is let go may be so far off."""
SAID = {
    "scenario": "what its scenario says",
    "eight": "an eight",
    "circle": "a circle",
    "hold": "to the top, and holds",
    "land": "to the edge, and lands",
}
"""What an autopilot flies, in words."""


class HandOver:
    """`flown` names what the autopilot flies; empty: the person has the stick.

    It is told what there is to fly by `offer`, and by `watch` where the person's stick is: who
    pushes it takes back at once. A stick that was already pushed when the kite was handed over must
    be let go or moved first.
    """

    def __init__(self, notices: Notices) -> None:
        self.flown, self._say = "", notices.say
        self._offers: Mapping[str, str] = {}
        self._marked, self._held = "", Command()

    def offer(self, offers: Mapping[str, str], at_once: bool = False) -> None:
        """What an autopilot could fly, by name, and for each why it cannot, empty if it can.

        `at_once`: it has the stick from now on, and flies the first.
        """
        self._offers, self._marked = offers, next(iter(offers), "")
        if at_once:
            self._begin(Command())

    def change(self, stick: Command) -> None:
        """Hands over, or takes back; `stick` is where the person's is now."""
        if self.flown:
            self.take_back()
        else:
            self._begin(stick)

    def next_figure(self) -> None:
        """The next of what can be flown, now or when it is handed over."""
        names = list(self._offers)
        at = names.index(self._marked) if names else 0
        for name in [*names[at + 1 :], *names[:at]]:
            if not self._offers[name]:
                self._marked = name
                self._say(f"the autopilot {'flies' if self.flown else 'will fly'} {SAID[name]}")
                self.flown = name if self.flown else ""
                return
        self._say(self._offers.get(self._marked) or "there is nothing else that it could fly")

    def take_back(self, why: str = "you have the stick: the autopilot is off") -> None:
        """The person flies from now on."""
        if self.flown:
            self.flown = ""
            self._say(why)

    def watch(self, stick: Command) -> None:
        """Takes back where the person's stick was pushed."""
        if not self.flown:
            return
        ways = [(stick.delta, self._held.delta), (stick.ell, self._held.ell)]
        if any(abs(now) > BAND and _further(now, held) > BAND for now, held in ways):
            self.take_back()
        delta, ell = (min(both, key=abs) for both in ways)
        self._held = Command(delta, ell)

    def _begin(self, stick: Command) -> None:
        if fault := self._offers.get(self._marked, "there is no autopilot here"):
            self._say(fault)
            return
        self.flown, self._held = self._marked, stick
        self._say(f"the autopilot flies {SAID[self.flown]}; push the stick to take back")


def _further(now: float, held: float) -> float:
    """How much further out a way of the stick is, or on the other side; 0: it is coming back."""
    return abs(now) if now * held < 0.0 else max(abs(now) - abs(held), 0.0)
