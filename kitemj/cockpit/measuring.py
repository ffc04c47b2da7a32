"""`kitemj realtime`: measures ticks, frames, memory, and the delay from stick to picture.

The loop that is measured is `fly`'s own. The way of the stick is measured at both its ends:
the tick that first flies a new command, and the first frame in which the knob's pointer is
seen, by its pixels, on the other side.
"""

import random
import statistics
import time
from dataclasses import dataclass

import numpy as np

from kitemj.cockpit.fly import fly
from kitemj.cockpit.screens import Frame, Screen
from kitemj.controls.stick import Stick
from kitemj.drawing.colours import CALL
from kitemj.drawing.instruments import Instruments
from kitemj.drawing.knob import HUB, OUTER
from kitemj.drawing.picture import Picture
from kitemj.dynamics.motion import Motion
from kitemj.flight.live import Command
from kitemj.physics.parameters import Parameters
from kitemj.pilots.crash import Touch
from kitemj.realtime.memory import peak_memory
from kitemj.realtime.messages import TickNews
from kitemj.realtime.process import FlightProcess
from kitemj.recording.live import FlightSetup

SETTLED = 10.0
"""s; what memory grows by in this time is the program's own beginning."""

DEFLECTION = 0.2
"""Of the stick to each side: enough to see the pointer move, too little to fly away."""


class TimedScreen(Screen):
    """A screen whose frames are timed: when shown, `times` [s], and how long it took, `took` [s].

    Also peak `memory` [MB] at some of them, that of both processes.
    """

    def __init__(self, screen: Screen, stick: Stick, physics: FlightProcess) -> None:
        super().__init__(stick)
        self._screen, self._physics, self.wishes = screen, physics, screen.wishes
        self.times: list[float] = []
        self.took: list[float] = []
        self._begun = 0.0
        self.memory: list[tuple[float, float]] = []

    @property
    def message(self) -> str:
        """The message of the screen within."""
        return self._screen.message

    def poll(self) -> None:
        """Takes in what the person did since; a frame begins with that."""
        self._begun = time.perf_counter()
        self._screen.poll()

    def sense(
        self, parameters: Parameters, motion: Motion, touch: Touch | None, moving: bool
    ) -> None:
        """Lets the person hear and feel, which costs time too."""
        self._screen.sense(parameters, motion, touch, moving)

    def show(self, frame: Frame, wall: float) -> None:
        """Shows the frame."""
        self._screen.show(frame, wall)
        self.times.append(time.perf_counter())
        self.took.append(self.times[-1] - self._begun)
        if not self.memory or wall > self.memory[-1][0] + 1.0:
            self.memory.append((wall, peak_memory() + self._physics.memory))

    def close(self) -> None:
        """Closes the screen."""
        self._screen.close()

    @property
    def median_rate(self) -> float:
        """Frames a second, by the median time between two."""
        return 1.0 / statistics.median(np.diff(self.times).tolist() or [float("nan")])

    @property
    def slowest_rate(self) -> float:
        """Frames in the second that had fewest, of all but the first and the last; NaN without."""
        seconds = np.floor(np.array(self.times) - self.times[0]).astype(int)
        counts = np.bincount(seconds)[:-1]  # the last is not whole
        return float(counts[1:].min()) if len(counts) > 1 else float("nan")

    @property
    def growth(self) -> float:
        """MB of memory gained since `SETTLED`; not a number in a shorter flight."""
        settled = [memory for wall, memory in self.memory if wall >= SETTLED]
        return settled[-1] - settled[0] if settled else float("nan")


@dataclass
class Step:
    """A move of the stick: `polled` when [s], how many ticks and frames until it was there.

    1 is the first tick that began, the first frame that was shown after it was polled.
    """

    polled: float
    side: float
    ticks: int = 0
    frames: int = 0
    flown: bool = False
    seen: bool = False
    seen_after: float = float("nan")


class SteppingStick:
    """Jumps from side to side at random moments, 0.3 to 0.8 s apart."""

    name = "measuring"

    def __init__(self) -> None:
        self._random, self._next, self._side = random.Random(1), 0.0, 1.0
        self.steps: list[Step] = []

    def command(self, motion: Motion) -> Command:
        """The command now."""
        now = time.perf_counter()
        if now >= self._next:
            self._next = now + self._random.uniform(0.3, 0.8)
            self._side = -self._side
            self.steps.append(Step(now, self._side))
        return Command(self._side * DEFLECTION)


class StickTimingProcess(FlightProcess):
    """A flight that tells `stick` which of its moves each tick flew."""

    def __init__(self, setup: FlightSetup, stick: SteppingStick) -> None:
        super().__init__(setup)
        self._stick = stick

    def update(self) -> list[TickNews]:
        """Takes in the ticks flown since, and tells the stick of its moves among them."""
        heard = super().update()
        for step in self._stick.steps[-1:]:
            for news in heard:
                if not step.flown and news.begun >= step.polled:
                    step.ticks += 1
                    step.flown = news.command.delta * step.side > 0
        return heard


class PointerScreen(TimedScreen):
    """Looks at the knob in each frame."""

    def __init__(
        self, screen: Screen, stick: SteppingStick, physics: FlightProcess, instruments: Instruments
    ) -> None:
        super().__init__(screen, stick, physics)
        self._steps, self._box, self._u = stick.steps, instruments.box("knob"), instruments.u

    def show(self, frame: Frame, wall: float) -> None:
        """Shows the frame, then looks at it."""
        super().show(frame, wall)
        for step in self._steps[-1:]:
            if not step.seen:
                step.frames += 1
                step.seen = self._pointer(frame) * step.side > 0
                step.seen_after = self.times[-1] - step.polled

    def _pointer(self, frame: Frame) -> float:
        """By how many pixels the knob's pointer is right of its hub; 0 where none is seen."""
        wide = round((HUB[0] + OUTER + 12) * self._u)
        dial = frame[self._box.top : self._box.bottom, self._box.left : self._box.left + wide]
        columns = np.nonzero((dial == CALL).all(axis=2))[1]
        return float(columns.mean()) - HUB[0] * self._u if len(columns) else 0.0


def stick_steps(
    setup: FlightSetup, picture: Picture, screen: Screen, duration: float
) -> list[Step]:
    """The moves of the stick in a flight of `duration` [s], but the last, which may be cut."""
    stick = SteppingStick()
    physics = StickTimingProcess(setup, stick)
    physics.wait()
    instruments = Instruments(physics.parameters, picture.width, picture.height)
    screen.wishes.depth = "engineer"  # which has a knob
    fly(physics, picture, PointerScreen(screen, stick, physics, instruments), duration)
    return stick.steps[:-1]
