"""How many simulated pupils at the keys fly a minute without a crash, with and without assist.

.venv/bin/python scripts/pupil.py trainer sport --markdown docs/tables/pupil.md --overwrite
"""

import argparse
import sys
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import product
from pathlib import Path
from statistics import median
from typing import NamedTuple

from kitemj.controls.held_keys import USUAL, Ramp
from kitemj.errors import InputError
from kitemj.files import new_file
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.pilots.assist import Assist
from kitemj.pilots.crash import FirstTouch
from kitemj.pilots.pupil import Pupil
from kitemj.progress_bar import with_progress
from kitemj.tables import Cell, Table, markdown, print_table

MINUTE = 60.0
"""s."""
GOLDEN = 0.618034
STEP = 0.005
"""s; the loops of a kite are the same to 0.1 mm at half of it."""


class Class(NamedTuple):
    """Pupils of one kind: what they fly, what they look at, how."""

    kite: str
    place: bool
    assist: bool


def main() -> int:
    """Flies, prints, and writes the table where asked for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("kite", nargs="*", default=["trainer"], help="sets")
    parser.add_argument("--flights", type=int, default=100, help="of each kind of pupil")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the table there")
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")
    args = parser.parse_args()
    try:
        kinds = list(product(args.kite, (False, True), (True, False)))
        with ProcessPoolExecutor() as pool:
            rows = [
                row(Class(*kind), list(pool.map(partial(crash, Class(*kind)), range(args.flights))))
                for kind in with_progress("flying", kinds, len(kinds))
            ]
        heads = "kite", "pupils look at", "assist", "a minute without a crash", "crash"
        table = Table("Pupils at the keys", heads, rows)
        print_table(table)
        if args.markdown:
            with new_file(args.markdown, args.overwrite) as path:
                path.write_text(markdown(table), encoding="utf-8")
    except InputError as error:
        print(f"pupil: {error}", file=sys.stderr)
        return 2
    return 0


def wind(seed: int) -> float:
    """That of a flight [m/s]: all of 5 to 8, evenly."""
    return 5.0 + 3.0 * (GOLDEN * seed % 1.0)


def crash(kind: Class, seed: int) -> float | None:
    """When the pupil of this `seed` crashed [s]; None: it flew for a minute, or landed softly."""
    tables = {"set": kind.kite, "duration": MINUTE, "wind": {"speed": wind(seed)}}
    flight = SteeredFlight(scenario_of(tables, f"the kite {kind.kite}"), step=STEP)
    pupil, ramp, pilot = Pupil(seed, kind.place), Ramp(), Assist()
    ground = FirstTouch(flight.parameters)
    while (motion := flight.result.motion).t < MINUTE - TICK / 2:
        if touch := ground.watch(motion):
            return None if touch.gentle else motion.t
        pilot.hand = ramp.move(USUAL * pupil.key(motion), TICK)
        flight.tick(pilot.command(motion) if kind.assist else Command(pilot.hand))
    return None


def row(kind: Class, crashes: list[float | None]) -> tuple[Cell, ...]:
    """A row of the table."""
    down = [t for t in crashes if t is not None]
    told = f"median after {median(down):.0f} s" if down else ""
    whole = f"{len(crashes) - len(down)} of {len(crashes)}"
    looks = "the kite's place" if kind.place else "its nose"
    return kind.kite, looks, "on" if kind.assist else "off", whole, told


if __name__ == "__main__":
    sys.exit(main())
