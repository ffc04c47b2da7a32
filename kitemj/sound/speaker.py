"""The loudspeaker: plays what is heard, and is never in the way where there is none."""

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Event, Thread

import pygame

from kitemj.sound.hearing import SILENCE, Heard
from kitemj.sound.synthesis import CHUNK, RATE, Place, samples, thud

BUFFER = CHUNK // 2
"""Samples that the system takes at a time; a chunk is whole buffers, so none ends within one."""
LOOK = CHUNK / RATE / 6
"""s between looks at whether another chunk is wanted."""


PATIENCE = 1.0
"""s that a device may take for the last chunks; one that has gone takes none."""


class Speaker:
    """Plays what was last told by `hear`; each chunk leads from the one before to that.

    A thread makes a chunk while the one before is played, so a painted frame may take 0.1 s.
    Without a device all of it does nothing.
    """

    def __init__(self) -> None:
        self._heard, self._stopping = SILENCE, Event()
        self._thread: Thread | None = None
        if _opened():
            pygame.mixer.set_reserved(2)
            self._wind, self._ground = pygame.mixer.Channel(0), pygame.mixer.Channel(1)
            self._thread = Thread(target=self._run, name="speaker", daemon=True)
            self._thread.start()

    def hear(self, now: Heard) -> None:
        """Sounds like `now` from the next chunk on."""
        self._heard = now

    def thud(self, speed: float) -> None:
        """A kite that meets the ground at `speed` [m/s], at once."""
        if self._thread:
            self._ground.play(pygame.mixer.Sound(buffer=thud(speed)))

    def close(self) -> None:
        """Fades out; the device stays open for another speaker of this program."""
        self._heard = SILENCE
        self._stopping.set()
        if self._thread:
            self._thread.join(PATIENCE)
            self._thread = None

    def _run(self) -> None:
        """Keeps a chunk waiting behind the one that is played; nothing while all is silent."""
        before, place = SILENCE, Place()
        while before != SILENCE or not self._stopping.is_set():
            now = self._heard
            silent = before == SILENCE == now
            if not silent and not self._wind.get_busy():
                # it ran dry; or pygame lost a chunk that was put behind one that ended just then
                chunk, place = samples(SILENCE, now, place)
                self._wind.play(pygame.mixer.Sound(buffer=chunk))
                before = now
            elif not silent and self._wind.get_queue() is None:
                chunk, place = samples(before, now, place)
                self._wind.queue(pygame.mixer.Sound(buffer=chunk))
                before = now
            else:
                time.sleep(LOOK)


def _opened() -> bool:
    """Whether there is something to play on, of pygame's mixer, which is opened if need be."""
    if not pygame.mixer.get_init():
        with _hushed():
            try:
                pygame.mixer.init(RATE, -16, 2, BUFFER, allowedchanges=0)
            except (pygame.error, NotImplementedError):  # pygame may be built without
                return False
    return pygame.mixer.get_init() == (RATE, -16, 2)


@contextmanager
def _hushed() -> Iterator[None]:
    """Without what libraries of the system write to stderr where there is no device."""
    try:
        kept = os.dup(2)
    except OSError:  # there is none
        yield
        return
    nothing = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nothing, 2)
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nothing)
