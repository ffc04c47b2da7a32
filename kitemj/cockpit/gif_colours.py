"""The few colours of a GIF, chosen anew for every few seconds of it."""

from typing import Any

import av
import numpy as np
from av.error import BlockingIOError as NotYet
from av.error import EOFError as Ended
from av.filter import Graph
from numpy.typing import NDArray

Frame = NDArray[np.uint8]
RUN = 64
"""Frames that share their colours: what does not change from one to the next then costs nothing."""
COLOURS = 128
"""Of 256 that a GIF may have: a third less to store, and skies are smooth with them."""
CHARTS = 8
"""Frames of a run whose rare colours are chosen from, too."""
RARE, SEEN = 0.01, 6
"""Of the frame's pixels, at most, that a rare colour has; pixels, at least, that it must have."""


class GifColours:
    """Takes frames one by one, and returns them as pictures in runs of the same colours."""

    def __init__(self, width: int, height: int, rate: int) -> None:
        """`width`, `height` in px; `rate` in frames/s."""
        self._source = f"width={width}:height={height}:pix_fmt=rgb24:time_base=1/{rate}"
        self._held: list[Frame] = []

    def add(self, frame: Frame) -> list[Any]:
        """The pictures that are done: those of a run, when this frame ends it."""
        self._held.append(frame.copy())
        return self.rest() if len(self._held) == RUN else []

    def rest(self) -> list[Any]:
        """The pictures that are still held."""
        if not self._held:
            return []
        charts = [rare_colours(frame) for frame in self._held[:: -(-len(self._held) // CHARTS)]]
        graph = _graph(self._source)
        for number, frame in enumerate(charts + self._held):
            picture: Any = av.VideoFrame.from_ndarray(frame, format="rgb24")
            picture.pts = number
            graph.push(picture)
        graph.push(None)
        self._held, done = [], []
        while True:
            try:
                done.append(graph.pull())
            except (NotYet, Ended):
                return done[len(charts) :]


def rare_colours(frame: Frame) -> Frame:
    """A frame in which the rare colours of `frame` are all as frequent.

    A red line in a wide sky would else be none of the colours that suit most pixels.
    """
    keys = (frame >> 4).astype(np.intp) @ [256, 16, 1]
    counts = np.bincount(keys.ravel(), minlength=4096)
    rare = np.flatnonzero((counts >= SEEN) & (counts <= RARE * keys.size))
    if not len(rare):
        return frame
    sums = [
        np.bincount(keys.ravel(), part.ravel(), 4096)[rare] for part in np.moveaxis(frame, 2, 0)
    ]
    colours = (np.array(sums) / counts[rare]).T.astype(np.uint8)
    return colours[np.arange(keys.size) * len(colours) // keys.size].reshape(frame.shape)


def _graph(source: str) -> Graph:
    """Holds all pictures, and at the end lets them out in the colours that were chosen."""
    graph = Graph()
    begin, split, sink = graph.add("buffer", source), graph.add("split"), graph.add("buffersink")
    chosen = graph.add("palettegen", f"stats_mode=full:max_colors={COLOURS}")
    used = graph.add("paletteuse", "dither=none")  # whose grain would cost a fifth more
    begin.link_to(split)
    split.link_to(used, 0, 0)
    split.link_to(chosen, 1, 0)
    chosen.link_to(used, 0, 1)
    used.link_to(sink)
    graph.configure()
    return graph
