"""A real-time loop that reads a programmed stick at every tick and ends after so many ticks."""

from kitemj.controls.stick import Stick
from kitemj.drawing.history import History
from kitemj.flight.live import LiveFlight
from kitemj.realtime.pacer import Pacer
from kitemj.recording.recorder import Recorder


class ProgrammedPacer(Pacer):
    """Flies so many `ticks` in real time, then ends.

    The `stick` is read at every tick by the flight's own time, so that a late thread changes
    nothing in what is flown.
    """

    def __init__(
        self, flight: LiveFlight, ticks: int, stick: Stick, recorder: Recorder | None = None
    ) -> None:
        super().__init__(flight, History(flight.parameters), recorder)
        self.stick, self.ticks = stick, ticks

    def _tick(self, due: float) -> float:
        self.command = self.stick.command(self.result.motion)
        lateness = super()._tick(due)
        if self.flight.ticks == self.ticks or self.touch:
            self._stopping.set()
        return lateness
