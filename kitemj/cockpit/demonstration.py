"""A flight that is shown for its own sake: a pilot flies figures, and nobody records it."""

from kitemj.controls.stick import show_of
from kitemj.dynamics.motion import Motion
from kitemj.errors import FlightError
from kitemj.flight.limits import touches_ground
from kitemj.flight.live import TICK, SteeredFlight
from kitemj.flight.scenario import Scenario

ROUNDING = 1e-9  # s
MOST = 0.1
"""s; after a longer frame the flight does not catch up."""


class Demonstration:
    """`motion` is now; it goes on as `advance` lets it, and begins anew where it ends."""

    def __init__(self, scenario: Scenario) -> None:
        self._flight, self._left = SteeredFlight(scenario), 0.0
        self._stick = show_of(scenario.parameters)

    @property
    def motion(self) -> Motion:
        """The kite now."""
        return self._flight.result.motion

    def advance(self, wall: float) -> None:
        """Lets `wall` [s] pass."""
        self._left = min(self._left + wall, MOST)
        while self._left > TICK - ROUNDING:
            self._left -= TICK
            try:
                self._flight.tick(self._stick.command(self.motion))
            except FlightError:
                self._begin()
            if touches_ground(self._flight.parameters, self.motion):
                self._begin()

    def _begin(self) -> None:
        self._flight.restart()
        self._stick = show_of(self._flight.parameters)
