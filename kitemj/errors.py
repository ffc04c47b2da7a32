"""What cannot be carried out, in one sentence."""

from typing import Any


class InputError(ValueError):
    """Bad input: what, the value with its unit, what is allowed, what to do."""


class FlightError(RuntimeError):
    """A flight that cannot go on: which model, when [s], why, and what was flown until then."""

    def __init__(self, model: str, t: float, reason: str, motions: list[Any]) -> None:
        super().__init__(f"{model} cannot fly on after t = {t:.3f} s: {reason}")
        self.reason, self.motions = reason, motions


class NoGraphics(RuntimeError):  # noqa: N818  says what is the matter
    """There is no OpenGL to draw with; the message says how to mend that."""
