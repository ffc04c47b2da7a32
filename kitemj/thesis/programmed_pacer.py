"""The real-time loop with the stick in it: what is flown does not depend on the machine's speed."""

from typing import TYPE_CHECKING

from kitemj.cockpit.history import History
from kitemj.cockpit.pacing import Pacer
from kitemj.flight.live import LiveFlight
from kitemj.recording.recorder import Recorder

if TYPE_CHECKING:
    from kitemj.cockpit.stick import Stick


class ProgrammedPacer(Pacer):
    """Flies so many `ticks` in real time, then ends; keeps how late each was done [s].

    The `stick`, if there is one, is read at every tick by the flight's own time, so that a
    late thread or a slow picture changes nothing in what is flown. Without it `command` is
    whatever others write to it.
    """

    def __init__(
        self,
        flight: LiveFlight,
        ticks: int,
        stick: "Stick | None" = None,
        recorder: Recorder | None = None,
    ) -> None:
        super().__init__(flight, History(flight.parameters), recorder)
        self.stick, self.ticks = stick, ticks
        self.lateness: list[float] = []

    def _tick(self, due: float) -> float:
        if self.stick:
            self.command = self.stick.command(self.moment.motion)
        lateness = super()._tick(due)
        self.lateness.append(lateness)
        if len(self.lateness) == self.ticks or self.touch:
            self._stopping.set()
        return lateness
