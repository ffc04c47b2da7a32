"""The film of a flight, painted from its recording when it is over: smooth on any machine."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from kitemj.cockpit.film_sources import RecordingSource
from kitemj.cockpit.filming import FilmStyle, film
from kitemj.recording.file import read_recording
from kitemj.recording.live import FlightSetup
from kitemj.temporary import temporary_folder


@contextmanager
def recorded(setup: FlightSetup) -> Iterator[FlightSetup]:
    """`setup` with a recording: its own, or one that is gone when the block ends."""
    if setup.record:
        yield setup
        return
    with temporary_folder() as folder:
        yield setup._replace(record=folder / "flight.arrows")


def film_of_flight(
    recording: Path, path: Path, style: FilmStyle, overwrite: bool = False, kept: bool = True
) -> str:
    """Films all that was flown; returns a sentence on what became of that.

    recording: of the flight, which may break off
    path: the film
    style: how it looks
    overwrite: whether a file at `path` is replaced
    kept: whether the recording stays, so that it can be filmed again

    An interrupt leaves a complete film of what was painted. Raises InputError or NoGraphics.
    """
    source = RecordingSource(read_recording(recording))
    if not source.duration:
        return "none: nothing was flown"
    try:
        return film([source], path, style, overwrite=overwrite)
    except KeyboardInterrupt:
        again = f"; {recording} can still be filmed" if kept else ""
        return f"none: interrupted before its first frame{again}"
