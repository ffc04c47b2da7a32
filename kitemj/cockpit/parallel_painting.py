"""Frames of films: one flight or two side by side, painted in as many processes as help.

Where the processor draws, painting takes three quarters of a film's time and one process
cannot keep up with 30 frames/s of 1280 x 720; with a graphics card one process is quickest.
"""

import os
import signal
from collections import deque
from collections.abc import Generator, Iterable, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from multiprocessing import get_context
from multiprocessing.shared_memory import SharedMemory
from typing import Any, NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.closing import Closing
from kitemj.drawing.gl import open_graphics
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.drawing.text import put, width
from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters

Frame = NDArray[np.uint8]
MOST_WORKERS = 8
SHADE = (70, 78, 90)  # what the ground of a caption multiplies the picture with
FOOT = 124  # units above the lower edge: over the strip of instruments
WORTH_IT = 150
"""Frames; for fewer the start of more processes (2 s) takes longer than painting them."""


class Shot(NamedTuple):
    """What one flight shows in one frame."""

    motion: Motion
    reference: Motion | None
    readings: Readings


class Stage(NamedTuple):
    """What all frames of a film share: parameters and caption of each flight, size [px], view."""

    parameters: tuple[Parameters, ...]
    captions: tuple[str, ...]
    size: tuple[int, int]
    view: str
    instruments: bool


class Painter(Closing):
    """Paints frames of a stage; a context manager. Raises NoGraphics and InputError."""

    def __init__(self, stage: Stage) -> None:
        self._stage = stage
        across = stage.size[0] // len(stage.parameters)
        self._pictures = [Picture(each, across, stage.size[1]) for each in stage.parameters]
        if not stage.instruments:
            for picture in self._pictures:
                picture.shown = set()

    def paint(self, shots: Sequence[Shot]) -> Frame:
        """The frame (height, width, 3) of a shot of each flight, side by side."""
        view = self._stage.view
        parts = [
            picture.paint(shot.motion, shot.reference, shot.readings, view)
            for picture, shot in zip(self._pictures, shots, strict=True)
        ]
        if len(parts) == 1:
            return parts[0]
        for part, caption in zip(parts, self._stage.captions, strict=True):
            _write(part, caption)
            part[:, -1] = 255
        return np.concatenate(parts, axis=1)

    def close(self) -> None:
        """Gives OpenGL back."""
        for picture in self._pictures:
            picture.close()


def workers_for(frames: int) -> int:
    """The number of processes that paint so many frames soonest; raises NoGraphics."""
    graphics = open_graphics(16, 16)
    graphics.context.free()
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return min(cores or 1, MOST_WORKERS) if graphics.software and frames >= WORTH_IT else 1


def painted(
    stage: Stage, film: Iterable[Sequence[Shot]], workers: int
) -> Generator[Frame, None, None]:
    """Yields the frames of `film` in their order; each is valid until the next one is asked for."""
    if workers < 2:
        with Painter(stage) as painter:
            yield from (painter.paint(shots) for shots in film)
        return
    slots, size = 2 * workers + 2, stage.size[0] * stage.size[1] * 3
    memory = SharedMemory(create=True, size=slots * size)
    pool = ProcessPoolExecutor(workers, get_context("spawn"), _begin, (stage, memory.name))
    try:
        under_way: deque[tuple[int, Future[None]]] = deque()
        for number, shots in enumerate(film):
            if len(under_way) == slots:
                yield _taken(memory, under_way, stage.size)
            slot = number % slots
            under_way.append((slot, pool.submit(_paint, shots, slot)))
        while under_way:
            yield _taken(memory, under_way, stage.size)
    finally:
        pool.shutdown(cancel_futures=True)
        memory.close()
        memory.unlink()


def _taken(memory: SharedMemory, under_way: Any, size: tuple[int, int]) -> Frame:
    slot, future = under_way.popleft()
    future.result()
    return _frame(memory, slot, size).copy()


def _frame(memory: SharedMemory, slot: int, size: tuple[int, int]) -> Frame:
    wide, height = size
    return np.ndarray((height, wide, 3), np.uint8, memory.buf, slot * wide * height * 3)


def _begin(stage: Stage, name: str) -> None:
    """Prepares a painting process: one thread draws, Ctrl-C is left to the process that films."""
    global _painter, _memory, _size
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.environ.setdefault("LP_NUM_THREADS", "0")
    _painter, _memory, _size = Painter(stage), SharedMemory(name), stage.size


def _paint(shots: Sequence[Shot], slot: int) -> None:
    _frame(_memory, slot, _size)[:] = _painter.paint(shots)


_painter: Painter
_memory: SharedMemory
_size: tuple[int, int]


def _write(frame: Frame, caption: str) -> None:
    """Writes a caption on the right above the strip, in each of two pictures."""
    height, wide = frame.shape[:2]
    unit = min(height / 720, wide / 1280)
    size, room = height / 45, 0.48 * wide
    size *= min(1.0, 0.92 * room / width(caption, size))
    surface = pygame.image.frombuffer(frame.data, (wide, height), "RGB")
    top = height - FOOT * unit - height / 18
    band = (round(wide - room), round(top), round(room), round(height / 18))
    surface.fill(SHADE, band, special_flags=pygame.BLEND_MULT)
    put(surface, caption, wide - room / 2, top + height / 36, size, align=0.5)
