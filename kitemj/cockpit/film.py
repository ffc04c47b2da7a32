"""A film file, written beside its name and given its name when it is complete."""

from pathlib import Path
from typing import Any

import av
import numpy as np
from av.filter import Graph
from numpy.typing import NDArray

from kitemj.closing import Closing
from kitemj.errors import InputError
from kitemj.files import NewFile
from kitemj.signals import held

OPTIONS = {"preset": "veryfast", "crf": "20"}
CONTAINER = {"movflags": "+faststart"}  # the index in front: plays while it loads
SUFFIXES = (".mp4", ".gif")
GIF_RATE = 50
"""Frames/s, the most that a GIF can have (its clock ticks 100 times a second)."""
FILM_RATE = 1000
"""Frames/s; the ticks of a flight are ten times as long."""


class Film(Closing):
    """H.264 in mp4 (or a GIF, by the name) from frames of `width` x `height` px at `rate` a second.

    A context manager. However it is left, by an exception and Ctrl-C too, the frames added
    until then make a complete film; without any frame there is none.
    """

    def __init__(
        self, path: Path, width: int, height: int, rate: int = 30, overwrite: bool = False
    ) -> None:
        """Opens a file beside `path`; nothing is at `path` before `close`.

        Raises InputError where there is a file and `overwrite` is False, for a place that
        cannot be written, and for a kind, a size or a rate that no film can have.
        """
        self.path, self.width, self.height, self.frames = Path(path), width, height, 0
        check_film(self.path, width, height, rate)
        self._graph: Graph | None = None
        self._file = NewFile(self.path, overwrite)
        try:
            self._begin(str(self._file.part), rate)
        except BaseException:
            self._file.discard()
            raise
        self._stream.width, self._stream.height = width, height
        self._open = True

    def _begin(self, part: str, rate: int) -> None:
        if self.path.suffix.lower() == ".gif":
            self._container = av.open(part, "w", format="gif")
            self._stream: Any = self._container.add_stream("gif", rate=rate)
            self._stream.pix_fmt = "pal8"
            self._graph = _palettes(self.width, self.height, rate)
        else:
            options = dict(CONTAINER)
            self._container = av.open(part, "w", format="mp4", container_options=options)
            self._stream = self._container.add_stream("libx264", rate=rate, options=dict(OPTIONS))
            self._stream.pix_fmt = "yuv420p"
            self._stream.thread_type = "AUTO"

    def add(self, frame: NDArray[np.uint8]) -> None:
        """Appends one frame (height, width, 3), RGB, row 0 on top."""
        if not self._open:
            raise RuntimeError(f"the film {self.path} is closed: no frame can be added")
        if frame.shape != (self.height, self.width, 3) or frame.dtype != np.uint8:
            raise InputError(
                f"a frame of shape {frame.shape}, {frame.dtype}, does not fit the film "
                f"{self.path}: ({self.height}, {self.width}, 3), uint8, is needed"
            )
        picture: Any = av.VideoFrame.from_ndarray(frame, format="rgb24")
        with held():  # a part of it that is lost would spoil the frames after it
            if self._graph:
                picture.pts = self.frames
                self._graph.push(picture)
                picture = self._graph.pull()
            self._write(picture)
            self.frames += 1

    def close(self) -> None:
        """Completes the file and gives it its name; may be called twice."""
        if not self._open:
            return
        try:
            with held():
                if self.frames:
                    self._write(None)
                with self._file.naming():
                    self._container.close()
                if self.frames:
                    self._file.keep()
        finally:
            self._open = False
            self._file.discard()

    def _write(self, picture: Any) -> None:
        """Encodes a picture; None: the film's end. After an error there is no film."""
        try:
            with self._file.naming():
                self._container.mux(self._stream.encode(picture))
        except OSError:
            self._open = False  # libav ends the program if it is asked to go on
            self._file.discard()
            raise


def check_film(path: Path, width: int, height: int, rate: int) -> None:
    """Raises InputError for a name, a size [px] or a rate [1/s] that no film can have."""
    kind = path.suffix.lower()
    if kind not in SUFFIXES:
        raise InputError(f"a film's name ends with {' or '.join(SUFFIXES)}, got {path.name}")
    if width < 2 or height < 2 or width % 2 or height % 2:
        raise InputError(f"a film of {width} x {height} pixels: both numbers must be even, > 0")
    most = GIF_RATE if kind == ".gif" else FILM_RATE
    if not 1 <= rate <= most:
        raise InputError(f"`rate` must be 1 to {most} frames/s, got {rate}")


def _palettes(width: int, height: int, rate: int) -> Graph:
    """Gives every frame the 256 colours that suit it best."""
    graph = Graph()
    source = graph.add("buffer", f"width={width}:height={height}:pix_fmt=rgb24:time_base=1/{rate}")
    split, chosen = graph.add("split"), graph.add("palettegen", "stats_mode=single")
    used, sink = graph.add("paletteuse", "new=1:dither=bayer"), graph.add("buffersink")
    source.link_to(split)
    split.link_to(used, 0, 0)
    split.link_to(chosen, 1, 0)
    chosen.link_to(used, 0, 1)
    used.link_to(sink)
    graph.configure()
    return graph
