"""How much painting a frame may cost, and the choice of it by measuring the first second."""

from statistics import median
from typing import NamedTuple

from kitemj.errors import InputError


class Quality(NamedTuple):
    """What a frame is painted with.

    `texels` across a face of the sky; `samples` of a pixel; `scale` of what is rendered to what
    is shown, whose instruments stay sharp; `details`: whether there is what moves on the ground.
    """

    texels: int
    samples: int
    scale: float
    details: bool


QUALITIES = {
    "low": Quality(512, 0, 0.5, False),
    "medium": Quality(1024, 0, 0.7, False),
    "high": Quality(1024, 0, 1.0, True),
}
HIGH = QUALITIES["high"]
FILM = HIGH._replace(samples=4)
"""For frames that nobody waits for; "film"."""


def quality_of(name: str) -> Quality:
    """The quality of this name; InputError where there is none."""
    known = QUALITIES | {"film": FILM}
    if name not in known:
        raise InputError(f"there is no quality {name!r}; there are: {', '.join(known)}, auto")
    return known[name]


PERIOD = 1.0  # s of frames that are measured
BATCH = 6  # frames from which a step is decided
SETTLING = 2  # frames after a start or a step that do not count: they fill caches
MOST, LEAST = 0.80, 0.30  # parts of the time of a frame that painting may take, and is worth a step


class QualityChooser:
    """Chooses among QUALITIES while a flight begins: down where painting is slow, up where quick.

    A quality that was too slow is not tried again.
    """

    def __init__(self, rate: float, begin: str = "high") -> None:
        """`rate`: frames/s that are wanted; `begin`: the name of the first quality."""
        self._names, self._rate = [*QUALITIES], rate
        self._level, self._highest = self._names.index(begin), len(self._names) - 1
        self._measured = 0.0
        self._times: list[float] = []
        self._left_out = SETTLING

    @property
    def quality(self) -> Quality:
        """The quality of the next frame."""
        return QUALITIES[self.name]

    @property
    def name(self) -> str:
        """Its name."""
        return self._names[self._level]

    def painted(self, seconds: float) -> None:
        """Takes in how long a frame took to paint [s]."""
        if self._measured >= PERIOD:
            return
        self._measured += max(seconds, 1.0 / self._rate)
        if self._left_out:
            self._left_out -= 1
            return
        self._times.append(seconds)
        if len(self._times) == BATCH:
            self._decide(median(self._times) * self._rate)
            self._times.clear()

    def _decide(self, share: float) -> None:
        if share > MOST and self._level > 0:
            self._level -= 1
            self._highest, self._left_out = self._level, SETTLING
        elif share < LEAST and self._level < self._highest:
            self._level += 1
            self._left_out = SETTLING
