"""Keys as sticks: a held key deflects as a hand would move a stick, out slowly and back fast."""

import time
from collections.abc import Callable

import pygame

from kitemj.controls.stick_mapping import Deflections

RISE = 0.3
"""s from the centre to where a held key goes: a tap of less is a small correction."""
BACK = 0.1
"""s from there to the centre once it is let go, or the other key is held."""
USUAL = 0.4
"""Of the full way: keys; with Shift they ask for all of it, which few kites forgive for long."""
LONGEST = 0.1
"""s that a ramp moves at once: what was held while a window did not answer is not known."""


class Ramp:
    """One way of a stick that keys move; `at` is where it is, in -1..1."""

    def __init__(self) -> None:
        self.at = 0.0

    def move(self, wish: float, seconds: float) -> float:
        """Moves for some `seconds` towards where the keys point; returns where it is then."""
        if wish * self.at < 0.0 or abs(wish) < abs(self.at):  # back, no further than need be
            stop = wish if wish * self.at > 0.0 else 0.0
            before, fast = self.at, USUAL / BACK
            self.at = _stepped(before, stop, fast * seconds)
            seconds -= abs(before - self.at) / fast
        self.at = _stepped(self.at, wish, abs(wish) / RISE * max(seconds, 0.0))
        return self.at


def _stepped(at: float, goal: float, most: float) -> float:
    return max(at - most, min(at + most, goal))


class HeldKeys:
    """The deflections of the keys that are held, moved on by the wall time between two looks.

    `clock` returns s. Needs pygame's display module.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock, self._looked = clock, clock()
        self._ramps = [Ramp() for _ in Deflections._fields]

    @property
    def any_held(self) -> bool:
        """Whether one is held that steers."""
        return any(held_keys())

    def hands(self) -> Deflections:
        """Where they are now."""
        now = self._clock()
        seconds, self._looked = min(now - self._looked, LONGEST), now
        ways = zip(self._ramps, held_keys(), strict=True)
        return Deflections(*(ramp.move(held, seconds) for ramp, held in ways))


def held_keys() -> Deflections:
    """Where keys point: arrows or A D W S for one stick; W S left line, ↑ ↓ right line."""
    held = pygame.key.get_pressed()
    full = 1.0 if pygame.key.get_mods() & pygame.KMOD_SHIFT else USUAL

    def between(less: tuple[int, ...], more: tuple[int, ...]) -> float:
        return full * (any(held[key] for key in more) - any(held[key] for key in less))

    return Deflections(
        steer=between((pygame.K_LEFT, pygame.K_a), (pygame.K_RIGHT, pygame.K_d)),
        reel=between((pygame.K_DOWN, pygame.K_s), (pygame.K_UP, pygame.K_w)),
        left=between((pygame.K_w,), (pygame.K_s,)),
        right=between((pygame.K_UP,), (pygame.K_DOWN,)),
    )
