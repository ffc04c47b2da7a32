"""Hundreds of flights by the autopilot in gusts, from anywhere in the window; each seed a flight.

.venv/bin/python scripts/gusts.py --flights 1000
.venv/bin/python scripts/gusts.py --flights 1000 --markdown docs/tables/gusts.md --overwrite
.venv/bin/python scripts/gusts.py --seed 17
"""

import argparse
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from math import degrees
from pathlib import Path

import numpy as np

from guidance_flights import IDEAL, REAL, Gusty, Outcome, gusts
from kitemj.dynamics.formulation import MODELS
from kitemj.errors import InputError
from kitemj.files import new_file
from kitemj.progress_bar import with_progress
from kitemj.tables import Table, print_table, titled_markdown

SENSORS = {"ideal": IDEAL, "real": REAL}
HEADS = ("seed", "wind [m/s]", "gust", "Ω [rad/s]", "start (az, el, nose) [deg]", "limit", "what")


def main() -> int:
    """Flies, prints, and writes the tables where asked for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--flights", type=int, default=100, help="seeds 0 and on (100)")
    parser.add_argument("--seed", type=int, help="this flight alone")
    parser.add_argument("--sensors", choices=SENSORS, default="ideal")
    parser.add_argument("--model", choices=list(MODELS), default="lagrange")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the tables there")
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")
    args = parser.parse_args()
    seeds = range(args.flights) if args.seed is None else [args.seed]
    flights = [Gusty(seed, sensors=SENSORS[args.sensors], model=args.model) for seed in seeds]
    try:
        with ProcessPoolExecutor() as pool:
            found = pool.map(gusts, flights, chunksize=4)
            outcomes = list(with_progress("flying", found, len(flights)))
        tables = [summed(outcomes, args.sensors), failures(outcomes)]
        for table in tables:
            print_table(table)
        if args.markdown:
            with new_file(args.markdown, args.overwrite) as path:
                path.write_text(titled_markdown(tables), encoding="utf-8")
    except InputError as error:
        print(f"gusts: {error}", file=sys.stderr)
        return 2
    return 0


def summed(outcomes: list[Outcome], sensors: str) -> Table:
    """How many flights there were, and how they went."""
    count, limits = len(outcomes), Counter(outcome.limit for outcome in outcomes)
    rms = np.array([outcome.rms for outcome in outcomes])
    rows = [
        ("flights of 60 s", f"{count}"),
        ("within all limits", f"{limits['']} ({100 * limits[''] / count:.1f} %)"),
        *((f"left: {name}", f"{number}") for name, number in limits.items() if name),
        ("time beyond a limit", f"{100 * np.mean([o.beyond for o in outcomes]):.3f} %"),
        ("off the path, rms of the middle flight", f"{np.median(rms):.2f}°"),
        ("off the path, rms of the 95th of 100", f"{np.quantile(rms, 0.95):.2f}°"),
    ]
    return Table(f"in gusts, {sensors} sensors", ("what", "how many"), rows)


def failures(outcomes: list[Outcome]) -> Table:
    """A row for each flight that left a limit."""
    rows = [
        (
            *(f"{o.gusty.seed}", f"{o.wind:.1f}", f"{o.amplitude:.2f}", f"{o.frequency:.2f}"),
            ", ".join(f"{degrees(angle):.0f}" for angle in o.place),
            *(o.limit, f"at {o.t:.2f} s: {o.reading}"),
        )
        for o in outcomes
        if o.limit
    ]
    return Table("flights that left a limit", HEADS, rows)


if __name__ == "__main__":
    sys.exit(main())
