"""Launches from the edge of the window and landings there by the autopilot; each seed a flight.

.venv/bin/python scripts/launch_and_land.py --flights 100
.venv/bin/python scripts/launch_and_land.py --markdown docs/tables/launch_and_land.md --overwrite
.venv/bin/python scripts/launch_and_land.py trainer --seed 17
"""

import argparse
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from math import degrees
from pathlib import Path

import numpy as np

from guidance_flights import IDEAL, REAL
from kitemj.dynamics.formulation import MODELS
from kitemj.errors import InputError
from kitemj.files import new_file
from kitemj.pilots.crash import SOFT
from kitemj.progress_bar import with_progress
from kitemj.tables import Cell, Table, print_table, titled_markdown
from launch_and_land_flights import PHASES, Hop, Hopped, hop

SENSORS = {"ideal": IDEAL, "real": REAL}


def main() -> int:
    """Flies, prints, and writes the tables where asked for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("kite", nargs="*", default=["sport", "trainer"], help="sets")
    parser.add_argument("--flights", type=int, default=100, help="seeds 0 and on (100)")
    parser.add_argument("--seed", type=int, help="this flight alone")
    parser.add_argument("--sensors", choices=SENSORS, default="ideal")
    parser.add_argument("--model", choices=list(MODELS), default="lagrange")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the tables there")
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")
    args = parser.parse_args()
    seeds = range(args.flights) if args.seed is None else [args.seed]
    try:
        tables = []
        for kite in args.kite:
            hops = [Hop(seed, kite, SENSORS[args.sensors], args.model) for seed in seeds]
            with ProcessPoolExecutor() as pool:
                found = pool.map(hop, hops, chunksize=2)
                hopped = list(with_progress(kite, found, len(hops)))
            tables += [summed(kite, hopped), failures(kite, hopped)]
        for table in tables:
            print_table(table)
        if args.markdown:
            with new_file(args.markdown, args.overwrite) as path:
                path.write_text(titled_markdown(tables), encoding="utf-8")
    except InputError as error:
        print(f"launch_and_land: {error}", file=sys.stderr)
        return 2
    return 0


def summed(kite: str, hopped: list[Hopped]) -> Table:
    """How many were launched and landed, how hard, and in which phase a limit was left."""
    count, touched = len(hopped), [each for each in hopped if each.landed]
    speeds = np.array([each.speed for each in touched] or [np.nan])
    left = Counter(pair for each in hopped for pair in each.left)
    rows: list[tuple[Cell, ...]] = [
        ("flights", f"{count}"),
        ("launched", f"{sum(each.launched for each in hopped)} of {count}"),
        ("landed", f"{len(touched)} of {count}"),
        (f"of these under {SOFT:g} m/s", f"{sum(each.speed < SOFT for each in touched)}"),
        ("touch-down, middle", f"{np.median(speeds):.2f} m/s"),
        ("touch-down, 95th of 100", f"{np.quantile(speeds, 0.95):.2f} m/s"),
        ("touch-down, fastest", f"{speeds.max():.2f} m/s"),
        ("twist at the end, most", f"{max(abs(each.twist) for each in hopped):.2f} turns"),
        ("least pull of a line", f"{min(each.pull for each in hopped):.2f} N"),
    ]
    for phase in ("start", *PHASES):
        of = [f"{name} {number}" for (at, name), number in sorted(left.items()) if at == phase]
        rows.append((f"left limits in {phase}", ", ".join(of) or "none"))
    return Table(f"{kite}, launched and landed in 5 to 8 m/s", ("what", "how many"), rows)


def failures(kite: str, hopped: list[Hopped]) -> Table:
    """A row for each flight that was not launched, or not landed softly."""
    rows = [
        (
            *(f"{each.hop.seed}", f"{each.wind:.1f}"),
            f"{degrees(each.azimuth):.0f}",
            *(each.side, each.ending),
        )
        for each in hopped
        if not (each.landed and each.speed < SOFT)
    ]
    heads = ("seed", "wind [m/s]", "start at azimuth [deg]", "landing", "what")
    return Table(f"{kite}, flights that failed", heads, rows)


if __name__ == "__main__":
    sys.exit(main())
