"""Messages to the person, each shown for some seconds."""

import time
from collections.abc import Callable

READABLE = 8.0
"""s; a long sentence, by someone who looks at a kite."""


class Notices:
    """`newest` is shown; when its time is over, an older one that still has time comes back."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._said: list[tuple[float, str]] = []

    def say(self, text: str, seconds: float = READABLE) -> None:
        """Adds a sentence that stays for `seconds`."""
        self._said.append((self._clock() + seconds, text))

    @property
    def newest(self) -> str:
        """The sentence to be shown now, or nothing."""
        now = self._clock()
        self._said = [(until, text) for until, text in self._said if until > now]
        return self._said[-1][1] if self._said else ""
