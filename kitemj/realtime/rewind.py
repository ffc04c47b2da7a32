"""The last minutes of a flight, to go back to, and one moment that somebody marked."""

from collections import deque
from typing import NamedTuple

from kitemj.autopilot.autopilot import Autopilot, SavedAutopilot
from kitemj.autopilot.drift_hold import DriftPilot
from kitemj.flight.live import TICK, Saved, SteeredFlight

EVERY = 1.0
"""s of flight between the moments that are kept."""
MINUTES = 5.0
"""How far back they go: 300 moments of 4 kB."""
BACK = 5.0
"""s; how far one step back goes, at least."""


class Moment(NamedTuple):
    """A moment of a flight, and of the autopilot that flew it; None: nobody did."""

    flight: Saved
    autopilot: Autopilot | DriftPilot | None
    knows: SavedAutopilot | None


class RewindHistory:
    """Sees every tick of a flight; belongs to who flies it."""

    def __init__(self) -> None:
        self._past: deque[Moment] = deque(maxlen=round(60 * MINUTES / EVERY))
        self._marked: tuple[Moment, deque[Moment]] | None = None

    def see(self, flight: SteeredFlight, autopilot: Autopilot | DriftPilot | None = None) -> None:
        """Keeps the moment if it is time to."""
        if flight.ticks % round(EVERY / TICK) == 0:
            self._past.append(_moment(flight, autopilot))

    def mark(self, flight: SteeredFlight, autopilot: Autopilot | DriftPilot | None = None) -> None:
        """Keeps the present moment, with the past that led there, until another is marked."""
        self._marked = _moment(flight, autopilot), self._past.copy()

    def recall(self) -> Moment | None:
        """The marked moment; its past is the past again."""
        if self._marked is None:
            return None
        kept, past = self._marked
        self._past = past.copy()
        return kept

    def back(self, flight: SteeredFlight) -> Moment | None:
        """The kept moment `BACK` or a little more ago, else the first; forgets what came after."""
        wanted = flight.ticks - round(BACK / TICK)
        while len(self._past) > 1 and self._past[-1].flight.ticks > wanted:
            self._past.pop()
        return self._past[-1] if self._past else None

    def forget(self) -> None:
        """The flight begins anew; a marked moment stays."""
        self._past.clear()


def _moment(flight: SteeredFlight, autopilot: Autopilot | DriftPilot | None) -> Moment:
    knows = autopilot.save() if isinstance(autopilot, Autopilot) else None
    return Moment(flight.save(), autopilot, knows)
