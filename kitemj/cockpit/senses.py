"""What a person hears and feels of a flight: wind and flutter, the thud, the pad that rumbles."""

from collections.abc import Callable

from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.pilots.crash import Touch
from kitemj.sound.hearing import SILENCE, Heard, heard
from kitemj.sound.speaker import Speaker

FAINT = 0.06
"""Of a pull: a smaller difference between the hands is not felt."""
STEPS = 16
"""Strengths of a rumble: each new one is a message to the pad."""
KNOCK = 12
"""Frames for which a pad tells that the kite met the ground."""


class Senses:
    """`rumble(low, high)` shakes a pad's left and right motor for a moment, by 0..1."""

    def __init__(self, rumble: Callable[[float, float], None]) -> None:
        self._speaker, self._rumble = Speaker(), rumble
        self._touch: Touch | None = None
        self._knock, self._shaking = 0, False

    def feel(self, parameters: Parameters, motion: Motion, touch: Touch | None, on: bool) -> None:
        """Tells of a frame's motion; `touch`: how the kite met the ground where it lies now.

        With `on` off, or while time stands, all is silent and still.
        """
        now = heard(parameters, motion, touch is not None)
        if touch and touch != self._touch and on:
            self._speaker.thud(touch.speed)
            self._knock = KNOCK
        self._touch = touch
        self._speaker.hear(now if on else SILENCE)
        knocking, self._knock = on and self._knock > 0, max(self._knock - 1, 0)
        low, high = (1.0, 1.0) if knocking else strengths(now) if on else (0.0, 0.0)
        if (low, high) != (0.0, 0.0) or self._shaking:
            self._rumble(low, high)
        self._shaking = (low, high) != (0.0, 0.0)

    def close(self) -> None:
        """Silent and still."""
        self._speaker.close()
        if self._shaking:
            self._rumble(0.0, 0.0)


def strengths(now: Heard) -> tuple[float, float]:
    """How strongly the left and the right motor shake: that of the hand with the larger pull."""
    difference = now.right - now.left
    strong = round(max(abs(difference) - FAINT, 0.0) / (1.0 - FAINT) * STEPS) / STEPS
    return (0.0, strong) if difference > 0 else (strong, 0.0)
