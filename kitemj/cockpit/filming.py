"""Films and still pictures of flights, made without a screen as fast as it goes."""

import time
from collections.abc import Sequence
from contextlib import closing
from io import BytesIO
from math import radians
from pathlib import Path
from typing import NamedTuple

import pygame

from kitemj.cockpit.film import Film, check_film
from kitemj.cockpit.film_sources import FilmSource
from kitemj.cockpit.film_title import titled, with_title
from kitemj.cockpit.parallel_painting import Painter, Shot, Stage, painted, workers_for
from kitemj.cockpit.screens import FRAME_RATE
from kitemj.controls.actions import DEPTHS
from kitemj.errors import InputError, NoGraphics
from kitemj.files import check_new, new_file
from kitemj.progress_bar import with_progress
from kitemj.scene.eye import Eye

MOST_FRAMES = 1_000_000
"""Of a film: nine hours of it, and a day of painting."""


class FilmStyle(NamedTuple):
    """How a film looks: `instruments` in depth; `rate` in frames/s, `speed` of the flight on it.

    `turn` [deg/s, of the film]: how fast the eye of the view "orbit" goes round the kite, to the
    right; `title` is over the first seconds.
    """

    size: tuple[int, int] = (1280, 720)
    view: str = "pilot"
    instruments: str = DEPTHS[0]
    rate: int = FRAME_RATE
    speed: float = 1.0
    turn: float = 0.0
    title: str = ""


def usual_for(path: Path) -> FilmStyle:
    """The style of a film of that name for which nothing is asked."""
    return USUAL.get(path.suffix.lower(), FilmStyle())


USUAL = {
    ".webp": FilmStyle(size=(640, 360), rate=20),
    ".gif": FilmStyle(size=(480, 270), rate=12),
}
"""These are for pages, which are to load soon: six seconds are some 3 MB."""
FASTEST = 360.0
"""deg/s of an eye that goes round."""


def check_output(path: Path, style: FilmStyle, still: bool, overwrite: bool) -> None:
    """Raises InputError for what could not be written, before any work is done."""
    check_new(path, overwrite)
    if still and path.suffix.lower() != ".png":
        raise InputError(f"the name of a still picture ends with .png, got {path.name}")
    if not still:
        check_film(path, *style.size, style.rate)
    if not 0.0 < style.speed <= 1000.0:
        raise InputError(f"`speed` must be > 0 and <= 1000, got {style.speed:g}")
    if style.instruments not in DEPTHS:
        told = f"{style.instruments!r}; there are: {', '.join(DEPTHS)}"
        raise InputError(f"there are no `instruments` {told}")
    if style.turn and style.view != "orbit":
        raise InputError(f"`turn` is for the `view` orbit, which goes round, not for {style.view}")
    if not abs(style.turn) <= FASTEST:
        raise InputError(
            f"`turn` must be within {FASTEST:g} degrees/s to either side, got {style.turn:g}"
        )


def film(
    sources: Sequence[FilmSource],
    path: Path,
    style: FilmStyle,
    start: float = 0.0,
    end: float | None = None,
    overwrite: bool = False,
) -> str:
    """Films flights side by side, and returns a sentence on what became of that.

    sources: the flights, from left to right
    path: the film; its ending says which kind
    style: size, rate, speed and view
    start: s of the flight, where the film begins
    end: s of the flight, where it ends; None: with the longest flight
    overwrite: whether a file at `path` is replaced

    An interrupt leaves a complete film of what was painted. Raises InputError or NoGraphics.
    """
    longest = max(source.duration for source in sources)
    end = longest if end is None else min(end, longest)
    if not 0.0 <= start < end:
        raise InputError(f"`start` must be >= 0 s and before the end at {end:g} s, got {start:g} s")
    if (end - start) / style.speed * style.rate > MOST_FRAMES:
        slowest = (end - start) * style.rate / MOST_FRAMES
        raise InputError(
            f"{end - start:g} s at `speed` {style.speed:g} are more than {MOST_FRAMES} frames: "
            f"film less of it, or at a speed >= {slowest:.2g}"
        )
    begun = time.perf_counter()
    count = int((end - start) / style.speed * style.rate + 1e-6) + 1
    times = [start + i * style.speed / style.rate for i in range(count)]
    # painters see single frames; where a view stands follows from all before
    eyed = [(source, Eye(source.parameters)) for source in sources]
    shots = (
        [_seen(flight.shot(t, style.speed), eye, style) for flight, eye in eyed] for t in times
    )
    bare = painted(_stage(sources, style), shots, workers_for(count))
    frames = titled(bare, style.title, style.rate)
    written = Film(path, *style.size, style.rate, overwrite)
    try:
        with written, closing(bare):
            for frame in with_progress(f"filming {path}", frames, count):
                written.add(frame)
    except (KeyboardInterrupt, NoGraphics) as reason:
        if not written.frames:
            raise
        kept = f"{path} has the first {written.frames} of {count} frames"
        if isinstance(reason, NoGraphics):
            raise NoGraphics(f"{reason}; {kept}") from None
        return f"interrupted: {kept}"
    endings = "; ".join(source.ending for source in sources)
    taken = time.perf_counter() - begun
    return f"{path}: {written.frames} frames, painted in {taken:.1f} s; {endings}"


def still(
    sources: Sequence[FilmSource], path: Path, style: FilmStyle, t: float, overwrite: bool = False
) -> str:
    """Writes the picture at `t` [s] as a PNG file, and returns a sentence that says so."""
    longest = max(source.duration for source in sources)
    if not 0.0 <= t <= longest + 1e-9:
        raise InputError(f"`still` must be >= 0 s and <= {longest:g} s (the end), got {t:g} s")
    with Painter(_stage(sources, style)) as painter, new_file(path, overwrite) as part:
        frame = painter.paint([source.shot(t, style.speed) for source in sources])
        frame = with_title(frame, style.title) if style.title else frame
        picture, png = pygame.image.frombuffer(frame.data, frame.shape[1::-1], "RGB"), BytesIO()
        pygame.image.save(picture, png, "PNG")  # in memory, since SDL does not say why a disk fails
        part.write_bytes(png.getvalue())
    return f"{path}: {t:g} s"


def _seen(shot: Shot, eye: Eye, style: FilmStyle) -> Shot:
    """The shot as `eye` sees it, which has seen those before; then it goes on its way."""
    seen = shot._replace(camera=eye.look(shot.motion, style.view))
    if style.turn:
        eye.turn(radians(style.turn) / style.rate, 0.0)
    return seen


def _stage(sources: Sequence[FilmSource], style: FilmStyle) -> Stage:
    parameters = tuple(source.parameters for source in sources)
    captions = tuple(source.caption for source in sources)
    return Stage(parameters, captions, style.size, style.view, style.instruments)
