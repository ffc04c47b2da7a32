"""What passes between the flight's process and those who paint: wishes there, news back."""

from enum import Enum
from typing import NamedTuple

from kitemj.flight.live import Command, TickResult
from kitemj.flight.pilot_settings import Guided
from kitemj.physics.compiled import Array
from kitemj.pilots.crash import Touch

FRAME = 1 / 30
"""s; what a person sees at once."""


class Begin(NamedTuple):
    """Time is to begin."""


class Rate(NamedTuple):
    """Simulated over wall time from now on: 1 is real time, 0 a pause."""

    rate: float


class Assisted(NamedTuple):
    """Whether the assist flies what commands ask for: their δ is the hand it is told of."""

    on: bool


class Piloted(NamedTuple):
    """What the autopilot flies, by the name of an `Offer`; empty: it does not."""

    flown: str


class Deed(Enum):
    """What is done once, before the next tick; `STEP` is a tick while paused."""

    RESTART = "restart"
    STEP = "step"
    REWIND = "rewind"
    SAVE = "save"
    LOAD = "load"


class Stop(NamedTuple):
    """The last wish; `ending` is how the recording says the flight ended."""

    ending: str


Wish = Begin | Rate | Assisted | Piloted | Deed | Command | Stop


class Timekeeping(NamedTuple):
    """How well real time was kept.

    Tick k is to be done within `TICK` of the moment at which it is due; `missed` counts
    those that were not, `late` those that were later than a frame. `lateness` and `worst`
    [s]: from due to done. `largest_gap` [m] to the reference. `lost` [s]: wall time that was
    let go (a machine asleep), not flown.
    """

    ticks: int = 0
    missed: int = 0
    late: int = 0
    lateness: float = 0.0
    worst: float = 0.0
    largest_gap: float = 0.0
    lost: float = 0.0

    def noted(self, lateness: float, allowed: float, gap: float, lost: float) -> "Timekeeping":
        """With one more tick, done `lateness` [s] after it was due, `gap` [m], `lost` [s]."""
        missed, late = self.missed + (lateness > allowed), self.late + (lateness > FRAME)
        largest = max(self.worst, lateness), max(self.largest_gap, gap)
        return Timekeeping(self.ticks + 1, missed, late, lateness, *largest, self.lost + lost)


class Offer(NamedTuple):
    """What the autopilot could fly: the `path` (n, 3) in the axes of `kitemj.paths.sphere`.

    None: it leads along no path. `fault`: why it cannot be flown; empty: it can.
    """

    path: Array | None = None
    fault: str = ""


class Ready(NamedTuple):
    """The flight stands at its start; `offers`: what the autopilot could fly, by name."""

    result: TickResult
    offers: dict[str, Offer]


class TickNews(NamedTuple):
    """Of one tick: `begun` and `done` [s] on the clock that all processes share.

    `touch`: how the kite met the ground, where it waits now; `problem`: what the person should
    know of the disk; `memory` [MB]: the most that the process has had so far; `guided`: what the
    autopilot tells of itself where it flew the tick.
    """

    begun: float
    done: float
    command: Command
    result: TickResult
    lateness: float
    times: Timekeeping
    touch: Touch | None
    problem: str
    memory: float
    guided: Guided | None = None


class Alive(NamedTuple):
    """Nothing happened for a while."""


class End(NamedTuple):
    """The last news: what became of the recording; `error` is what ended the flight.

    `cut`: the disk did not take all that was to be recorded.
    """

    recording: str
    error: str = ""
    bad_input: bool = False
    cut: bool = False


News = Ready | TickNews | Alive | End
