"""What cannot be carried out, in one sentence."""

import re
from collections.abc import Mapping
from typing import Any

NOT_WRITTEN = 74
"""The exit status where the system does not take what is written; EX_IOERR of sysexits.h."""


class InputError(ValueError):
    """Bad input: what, the value with its unit, what is allowed, what to do.

    An argument of the caller's is written in backquotes, "`step` must be > 0 s"; `str` leaves
    them out.
    """

    def worded(self, words: Mapping[str, str]) -> str:
        """The sentence, with another word for each argument in `words`."""
        return re.sub(r"`(\w+)`", lambda found: words.get(found[1], found[1]), super().__str__())

    def __str__(self) -> str:
        """The sentence, with each argument by its name."""
        return self.worded({})


class NothingFound(InputError):  # noqa: N818  an answer
    """What was looked for is not there: the answer is no, which is exit status 1."""


class FlightError(RuntimeError):
    """A flight that cannot go on: which model, when [s], why, and what was flown until then."""

    def __init__(self, model: str, t: float, reason: str, motions: list[Any]) -> None:
        super().__init__(f"{model} cannot fly on after t = {t:.3f} s: {reason}")
        self.reason, self.motions = reason, motions


class NoGraphics(RuntimeError):  # noqa: N818  says what is the matter
    """There is no OpenGL to draw with; the message says how to mend that."""


def lacks_memory(error: BaseException) -> bool:
    """Whether the system had no memory for it; MuJoCo and the loader say so in words."""
    said = ("allocate memory", "failed to map segment")
    return isinstance(error, MemoryError) or any(each in str(error) for each in said)
