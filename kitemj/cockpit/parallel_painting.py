"""Frames of films: one flight or two side by side, painted in as many processes as help.

Where the processor draws, painting takes three quarters of a film's time and one process
cannot keep up with 30 frames/s of 1280 x 720; with a graphics card one process is quickest.
"""

import os
from collections import deque
from collections.abc import Generator, Iterable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from multiprocessing.connection import Connection
from queue import SimpleQueue
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.child import Child
from kitemj.closing import Closing
from kitemj.drawing.instruments import Instruments
from kitemj.drawing.picture import Picture
from kitemj.drawing.plates import paint_plate
from kitemj.drawing.readings import Readings
from kitemj.drawing.text import put, width
from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError, NoGraphics
from kitemj.physics.parameters import Parameters
from kitemj.scene.gl import open_graphics
from kitemj.scene.views import Camera

Frame = NDArray[np.uint8]
MOST_WORKERS = 8
WORTH_IT = 150
"""Frames; for fewer the start of more processes (2 s) takes longer than painting them."""
PATIENCE = 60
"""s; for a frame, and for all that a process loads before its first."""


class Shot(NamedTuple):
    """What one flight shows in one frame; `camera`: None for where the stage's view stands."""

    motion: Motion
    reference: Motion | None
    readings: Readings
    camera: Camera | None = None


class Stage(NamedTuple):
    """What all frames of a film share: parameters and caption of each flight, size [px], view.

    `instruments`: their depth, a name of `actions.DEPTHS`.
    """

    parameters: tuple[Parameters, ...]
    captions: tuple[str, ...]
    size: tuple[int, int]
    view: str
    instruments: str


class Painter(Closing):
    """Paints frames of a stage; a context manager. Raises NoGraphics and InputError."""

    def __init__(self, stage: Stage) -> None:
        self._stage = stage
        across = stage.size[0] // len(stage.parameters)
        self._pictures = [Picture(each, across, stage.size[1], "film") for each in stage.parameters]
        for picture in self._pictures:
            picture.depth = stage.instruments
        instruments = Instruments(stage.parameters[0], across, stage.size[1])
        below = instruments.box("arrows").bottom if stage.instruments == "engineer" else 0
        self._below, self._unit = below, instruments.u

    def paint(self, shots: Sequence[Shot]) -> Frame:
        """The frame (height, width, 3) of a shot of each flight, side by side."""
        view = self._stage.view
        parts = [
            picture.paint(shot.motion, shot.reference, shot.readings, shot.camera or view)
            for picture, shot in zip(self._pictures, shots, strict=True)
        ]
        if len(parts) == 1:
            return parts[0]
        for part, caption in zip(parts, self._stage.captions, strict=True):
            _write(part, caption, self._below, self._unit)
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
    """Yields the frames of `film` in their order."""
    if workers < 2:
        with Painter(stage) as painter:
            yield from (painter.paint(shots) for shots in film)
        return
    under_way: deque[Future[Frame]] = deque()
    with ThreadPoolExecutor(workers) as pool, Painters(stage, workers) as painters:
        for shots in film:
            if len(under_way) == 2 * workers + 2:
                yield under_way.popleft().result()
            under_way.append(pool.submit(painters.paint, shots))
        while under_way:
            yield under_way.popleft().result()


class Painters(Closing):
    """Processes that paint the frames of a stage; a thread of this one for each waits for it."""

    def __init__(self, stage: Stage, count: int) -> None:
        self._stage, self._closed = stage, False
        self._children = [Child(_paint, stage) for _ in range(count)]
        self._idle = SimpleQueue[int]()
        for number in range(count):
            self._idle.put(number)

    def paint(self, shots: Sequence[Shot]) -> Frame:
        """The frame of these shots. A process that is lost, or stuck, is replaced once.

        Raises what `Painter` does, and NoGraphics.
        """
        number = self._idle.get()
        try:
            return self._painted(number, shots)
        except (EOFError, OSError):
            if self._closed:
                raise
            self._children[number].kill()
            self._children[number] = Child(_paint, self._stage)
            try:
                return self._painted(number, shots)
            except (EOFError, OSError):
                raise NoGraphics("a process that paints was ended from outside, twice") from None
        finally:
            self._idle.put(number)

    def _painted(self, number: int, shots: Sequence[Shot]) -> Frame:
        link, (wide, height) = self._children[number].link, self._stage.size
        link.send(shots)
        if not any(link.poll(1.0) for _ in range(PATIENCE)):
            raise EOFError("it does not answer")
        error = link.recv()
        if error:
            raise error
        return np.frombuffer(link.recv_bytes(), np.uint8).reshape(height, wide, 3)

    def close(self) -> None:
        """Ends the processes: what they still paint nobody will see."""
        self._closed = True
        for child in self._children:
            child.kill()
            child.close()


def _paint(link: Connection, stage: Stage) -> None:
    """Paints what comes through `link` in a process of its own, in which one thread draws."""
    os.environ.setdefault("LP_NUM_THREADS", "0")
    with suppress(EOFError, OSError):  # whoever films is gone
        try:
            with Painter(stage) as painter:
                while True:
                    frame = painter.paint(link.recv())
                    link.send(None)
                    link.send_bytes(np.ascontiguousarray(frame).data.cast("B"))
        except (InputError, NoGraphics) as error:
            link.send(error)


def _write(frame: Frame, caption: str, below: int, unit: float) -> None:
    """Writes a caption at the left edge of a picture, `below` [px] its upper edge."""
    height, wide = frame.shape[:2]
    size = 18 * unit + 3
    size *= min(1.0, 0.42 * wide / width(caption, size))
    gap = round(12 * unit)
    plate = pygame.Rect(gap, below + gap, width(caption, size) + 2 * size, 2.4 * size)
    surface = pygame.image.frombuffer(frame.data, (wide, height), "RGB")
    paint_plate(surface, plate, unit)
    put(surface, caption, plate.centerx, plate.centery, size, align=0.5)
