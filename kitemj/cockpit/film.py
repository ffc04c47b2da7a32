"""A film file, written beside its name and given its name when it is complete."""

import os
from pathlib import Path
from types import TracebackType
from typing import Self

import av
import numpy as np
from numpy.typing import NDArray

from kitemj.errors import InputError

OPTIONS = {"preset": "veryfast", "crf": "20"}
CONTAINER = {"movflags": "+faststart"}  # the index in front: plays while it loads


class Film:
    """H.264 in mp4 from frames of `width` x `height` pixels at `rate` frames/s.

    A context manager. However it is left, by an exception and Ctrl-C too, the frames added
    until then make a complete film; without any frame there is none.
    """

    def __init__(
        self, path: Path, width: int, height: int, rate: int = 30, overwrite: bool = False
    ) -> None:
        """Opens ``<path>.part``; nothing is at `path` before `close`.

        Raises FileExistsError where there is a file and `overwrite` is False, InputError for
        a size that H.264 cannot have, FileNotFoundError, IsADirectoryError or PermissionError
        for a place that cannot be written: each with one sentence.
        """
        self.path, self.width, self.height, self.frames = Path(path), width, height, 0
        if width < 2 or height < 2 or width % 2 or height % 2:
            raise InputError(f"a film of {width} x {height} pixels: both numbers must be even, > 0")
        if rate < 1:
            raise InputError(f"a film of {rate} frames/s: at least 1 is needed")
        self._part = self.path.with_name(self.path.name + ".part")
        _check_place(self.path, self._part, overwrite)
        self._container = av.open(
            str(self._part), "w", format="mp4", container_options=dict(CONTAINER)
        )
        self._stream = self._container.add_stream("libx264", rate=rate, options=dict(OPTIONS))
        self._stream.width, self._stream.height = width, height
        self._stream.pix_fmt = "yuv420p"
        self._stream.thread_type = "AUTO"
        self._open = True

    def add(self, frame: NDArray[np.uint8]) -> None:
        """Appends one frame (height, width, 3), RGB, row 0 on top."""
        if not self._open:
            raise RuntimeError(f"the film {self.path} is closed: no frame can be added")
        if frame.shape != (self.height, self.width, 3) or frame.dtype != np.uint8:
            raise InputError(
                f"a frame of shape {frame.shape}, {frame.dtype}, does not fit the film "
                f"{self.path}: ({self.height}, {self.width}, 3), uint8, is needed"
            )
        picture = av.VideoFrame.from_ndarray(frame, format="rgb24")
        self._container.mux(self._stream.encode(picture))
        self.frames += 1

    def close(self) -> None:
        """Completes the file and gives it its name; may be called twice."""
        if not self._open:
            return
        self._open = False
        if self.frames == 0:
            self._container.close()
            self._part.unlink(missing_ok=True)
            return
        self._container.mux(self._stream.encode(None))
        self._container.close()
        os.replace(self._part, self.path)  # noqa: PTH105  the one call that is atomic everywhere

    def __enter__(self) -> Self:
        """The film itself."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Closes it, so that what was filmed is kept."""
        self.close()


def _check_place(path: Path, part: Path, overwrite: bool) -> None:
    """Raises the error that writing there would end with, before any work is done."""
    folder = path.parent
    if not folder.is_dir():
        raise FileNotFoundError(f"cannot write the film {path}: there is no folder {folder}")
    if path.is_dir():
        raise IsADirectoryError(f"cannot write the film {path}: it is a folder, name a file in it")
    if path.exists() and not overwrite:
        raise FileExistsError(
            f"the film {path} exists already: choose another name or ask to overwrite it"
        )
    try:
        part.touch()
    except OSError as error:
        reason = error.strerror or str(error)
        raise PermissionError(
            f"cannot write the film {path}: {reason} in {folder}, choose another folder"
        ) from None
