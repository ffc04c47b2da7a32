"""The 256 colours of a GIF, chosen anew for every few seconds of it."""

from typing import Any

from av.error import BlockingIOError as NotYet
from av.error import EOFError as Ended
from av.filter import Graph

RUN = 64
"""Frames that share their colours: what does not change from one to the next then costs nothing."""


class GifColours:
    """Takes pictures one by one, returns them in runs, each in the colours that suit it best."""

    def __init__(self, width: int, height: int, rate: int) -> None:
        """`width`, `height` in px; `rate` in frames/s."""
        self._source = f"width={width}:height={height}:pix_fmt=rgb24:time_base=1/{rate}"
        self._graph, self._held = Graph(), 0

    def add(self, picture: Any) -> list[Any]:
        """The pictures that are done: those of a run, when this one ends it."""
        if not self._held:
            self._graph = _graph(self._source)
        self._graph.push(picture)
        self._held += 1
        return self.rest() if self._held == RUN else []

    def rest(self) -> list[Any]:
        """The pictures that are still held."""
        if not self._held:
            return []
        self._graph.push(None)
        done, self._held = [], 0
        while True:
            try:
                done.append(self._graph.pull())
            except (NotYet, Ended):
                return done


def _graph(source: str) -> Graph:
    """Holds all pictures, and at the end lets them out in the colours that were chosen."""
    graph = Graph()
    begin, split, sink = graph.add("buffer", source), graph.add("split"), graph.add("buffersink")
    chosen, used = graph.add("palettegen", "stats_mode=full"), graph.add("paletteuse", DITHER)
    begin.link_to(split)
    split.link_to(used, 0, 0)
    split.link_to(chosen, 1, 0)
    chosen.link_to(used, 0, 1)
    used.link_to(sink)
    graph.configure()
    return graph


DITHER = "dither=bayer:bayer_scale=5"
"""Faint and always in the same places, so that a sky has no steps and stays as it is."""
