"""The pilot of a show: rests at the top, eights, a loop each way, and again."""

from collections.abc import Callable
from math import radians
from typing import NamedTuple

from kitemj.dynamics.motion import Motion
from kitemj.flight.live import Command
from kitemj.pilots.manoeuvres import Eight, Hold, Loop, Pilot
from kitemj.pilots.sight import LEFT, RIGHT, Sight, sight


class Act(NamedTuple):
    """A part of a show: who flies it, and whether it is over, `t` [s] after its beginning."""

    pilot: Callable[[], Pilot]
    over: Callable[[Pilot, float, Sight], bool]


def passes(count: int) -> Callable[[Pilot, float, Sight], bool]:
    """Until a pilot of eights has turned back so often."""
    return lambda pilot, t, seen: isinstance(pilot, Eight) and pilot.passes >= count


def looped(pilot: Pilot, t: float, seen: Sight) -> bool:
    """Until a loop is flown."""
    return isinstance(pilot, Loop) and pilot.looped


def high(pilot: Pilot, t: float, seen: Sight) -> bool:
    """Until the kite is high enough for a loop, near the middle, and looks up."""
    upright = abs(seen.heading) < radians(35.0) and abs(seen.azimuth) < radians(25.0)
    return seen.elevation > radians(46.0) and upright


def home(pilot: Pilot, t: float, seen: Sight) -> bool:
    """Until the kite has come to the top again, and stood there for a moment."""
    there = seen.elevation > radians(48.0) and abs(seen.azimuth) < radians(12.0)
    return there and t > 3.2


ACTS = (
    Act(Hold, lambda pilot, t, seen: t > 1.0),
    Act(Eight, passes(3)),
    Act(Hold, high),
    Act(lambda: Loop(RIGHT), looped),
    Act(Hold, high),
    Act(lambda: Loop(LEFT), looped),
    Act(Hold, home),
)
"""Some 20 s; at the end the kite is where it began, and one loop has untwisted the other."""


class Show:
    """Flies `ACTS` in turn, again and again."""

    def __init__(self) -> None:
        self._number, self._begun, self._pilot = 0, 0.0, ACTS[0].pilot()

    def command(self, motion: Motion) -> Command:
        """The stick of the act that is on."""
        over = ACTS[self._number].over(self._pilot, motion.t - self._begun, sight(motion))
        again = motion.t < self._begun  # the flight was begun anew
        if over or again:
            self._number = 0 if again else (self._number + 1) % len(ACTS)
            self._begun, self._pilot = motion.t, ACTS[self._number].pilot()
        return self._pilot.command(motion)
