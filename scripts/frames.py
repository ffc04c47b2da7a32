"""How long a frame takes to paint, by size, quality and view; all in one run.

.venv/bin/python scripts/frames.py --markdown docs/tables/frames.md --overwrite

A frame is that of `kitemj fly` with the pilot's instruments. Qualities and views take turns, so
that what else the machine does disturbs all of them.
"""

import argparse
import sys
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from statistics import median

from kitemj.controls.actions import VIEWS
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.dynamics.formulation import make_model
from kitemj.dynamics.motion import Motion
from kitemj.files import new_file
from kitemj.flight.scenario import read_scenario
from kitemj.scene.quality import QUALITIES
from kitemj.tables import Table, markdown, print_table
from timing import interleaved, machine, processor_seconds, seconds

SIZES = ((640, 360), (1280, 720), (1920, 1080))
SHOWN = (*QUALITIES, "film")
SCENARIO = read_scenario("sport_loops")


def main() -> int:
    """Prints the table, and writes it where that is asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=15, help="frames of each kind")
    parser.add_argument("--markdown", type=Path, help="a file for the table")
    parser.add_argument("--overwrite", action="store_true", help="replace that file")
    words = parser.parse_args()
    rows = [row for size in SIZES for row in rows_of(size, words.rounds)]
    columns = ("size", "quality", *VIEWS, f"{VIEWS[0]}, all cores")
    table = Table("milliseconds a frame, medians", columns, rows)
    print_table(table)
    if words.markdown:
        with new_file(words.markdown, words.overwrite) as part:
            about = f"Milliseconds a frame, medians of {words.rounds}; {machine()}"
            part.write_text(f"{markdown(table)}\n{about}\n", encoding="utf-8")
    return 0


def rows_of(size: tuple[int, int], rounds: int) -> list[tuple[str | float, ...]]:
    """A row for each quality: wall time in each view; processor time in the first."""
    works = []
    with ExitStack() as stack:
        for quality in SHOWN:
            picture = stack.enter_context(Picture(SCENARIO.parameters, *size, quality))
            works += [painting(picture, view) for view in VIEWS]
        walls = interleaved(works, rounds, seconds)
        processor = interleaved(works[:: len(VIEWS)], rounds, processor_seconds)
    middles = [f"{1e3 * median(times):.1f}" for times in walls]
    spent = [f"{1e3 * median(times):.1f}" for times in processor]
    return [
        (f"{size[0]}x{size[1]}", quality, *middles[k * len(VIEWS) :][: len(VIEWS)], spent[k])
        for k, quality in enumerate(SHOWN)
    ]


def painting(picture: Picture, view: str):
    """A function that paints the next frame of a flight."""
    motions = flown()
    return lambda: picture.paint(next(motions), None, Readings(), view)


def flown() -> Iterator[Motion]:
    """Motions of a flight, 30 a second."""
    kite = make_model("mujoco", SCENARIO.parameters)
    kite.start(SCENARIO.start, SCENARIO.programme)
    while True:
        yield kite.motion(SCENARIO.programme)
        kite.advance(SCENARIO.programme, 1 / 30)


if __name__ == "__main__":
    sys.exit(main())
