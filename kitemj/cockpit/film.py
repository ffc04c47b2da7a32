"""A film file, written beside its name and given its name when it is complete."""

from pathlib import Path
from typing import Any

import av
import numpy as np
from numpy.typing import NDArray

from kitemj.closing import Closing
from kitemj.cockpit.gif_colours import GifColours
from kitemj.errors import InputError
from kitemj.files import NewFile
from kitemj.signals import held

CODECS: dict[str, tuple[str, str, dict[str, str]]] = {
    "mp4": ("libx264", "yuv420p", {"preset": "veryfast", "crf": "20"}),
    "webp": ("libwebp_anim", "yuv420p", {"quality": "85", "compression_level": "4"}),
    "gif": ("gif", "pal8", {}),
}
"""By the ending of a film's name: its encoder, what that takes, and how it is asked for.

Below a quality of 85 WebP keeps blocks of the frame before where the eye sees that they moved.
"""
SUFFIXES = tuple(f".{kind}" for kind in CODECS)
CONTAINER = {"movflags": "+faststart"}  # the index in front: plays while it loads
FOR_EVER = {"loop": "0"}
GIF_RATE = 50
"""Frames/s, the most that a GIF can have (its clock ticks 100 times a second)."""
FILM_RATE = 1000
"""Frames/s; the ticks of a flight are ten times as long."""


class Film(Closing):
    """A film of frames of `width` x `height` px at `rate` a second.

    H.264 in mp4; by its name a WebP or a GIF, which begins anew for ever.

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
        self._colours: GifColours | None = None
        self._encoded = 0  # frames, of which some may still be held
        self._file = NewFile(self.path, overwrite)
        try:
            self._begin(str(self._file.part), rate)
        except BaseException:
            self._file.discard()
            raise
        self._stream.width, self._stream.height = width, height
        self._open = True

    def _begin(self, part: str, rate: int) -> None:
        kind = self.path.suffix.lower().removeprefix(".")
        codec, pixels, options = CODECS[kind]
        container = CONTAINER if kind == "mp4" else FOR_EVER
        self._container = av.open(part, "w", format=kind, container_options=dict(container))
        stream: Any = self._container.add_stream(codec, rate=rate, options=dict(options))
        self._stream = stream
        self._stream.pix_fmt = pixels
        if kind == "mp4":
            self._stream.thread_type = "AUTO"
        if kind == "gif":
            self._colours = GifColours(self.width, self.height, rate)

    def add(self, frame: NDArray[np.uint8]) -> None:
        """Appends one frame (height, width, 3), RGB, row 0 on top."""
        if not self._open:
            raise RuntimeError(f"the film {self.path} is closed: no frame can be added")
        if frame.shape != (self.height, self.width, 3) or frame.dtype != np.uint8:
            raise InputError(
                f"a frame of shape {frame.shape}, {frame.dtype}, does not fit the film "
                f"{self.path}: ({self.height}, {self.width}, 3), uint8, is needed"
            )
        with held():  # a part of it that is lost would spoil the frames after it
            if self._colours:
                ready = self._colours.add(frame)
            else:
                ready = [av.VideoFrame.from_ndarray(frame, format="rgb24")]
            self._encode(ready)
            self.frames += 1

    def close(self) -> None:
        """Completes the file and gives it its name; may be called twice."""
        if not self._open:
            return
        try:
            with held():
                if self.frames:
                    self._encode(self._colours.rest() if self._colours else [])
                    self._write(None)
                with self._file.naming():
                    self._container.close()
                if self.frames:
                    self._file.keep()
        finally:
            self._open = False
            self._file.discard()

    def _encode(self, pictures: list[Any]) -> None:
        for picture in pictures:
            picture.pts, self._encoded = self._encoded, self._encoded + 1
            self._write(picture)

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
        known = f"{', '.join(SUFFIXES[:-1])} or {SUFFIXES[-1]}"
        raise InputError(f"a film's name ends with {known}, got {path.name}")
    if width < 2 or height < 2 or width % 2 or height % 2:
        raise InputError(f"a film of {width} x {height} pixels: both numbers must be even, > 0")
    most = GIF_RATE if kind == ".gif" else FILM_RATE
    if not 1 <= rate <= most:
        raise InputError(f"`rate` must be 1 to {most} frames/s, got {rate}")
