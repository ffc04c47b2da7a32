"""How well the autopilot follows its path: kites, winds, sensors, delays, models.

.venv/bin/python scripts/guidance.py
.venv/bin/python scripts/guidance.py --markdown docs/tables/guidance.md --overwrite
"""

import argparse
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from guidance_flights import IDEAL, KITES, REAL, Result, Trial, fly
from kitemj.errors import InputError
from kitemj.files import new_file
from kitemj.progress_bar import with_progress
from kitemj.tables import Table, print_table, titled_markdown

WINDS = (5.0, 6.5, 8.0)
"""m/s."""
PATHS = ("lemniscate", "circle")
SPORT = "sport, 25 m"
HEADS = (
    *("kite, line", "wind [m/s]", "path", "sensors", "law c₁, delay", "laps"),
    *("rms [deg]", "largest [deg]", "|δ| [deg]", "|β| [deg]", "least pull [N]", "ending"),
)


def main() -> int:
    """Flies, prints, and writes the tables where asked for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the tables there")
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")
    args = parser.parse_args()
    try:
        titles = {
            "sport on 25 m": [
                Trial(SPORT, wind, path, sensors)
                for sensors in (IDEAL, REAL)
                for path in PATHS
                for wind in WINDS
            ],
            "other kites and lines, a path for each by the same rule": [
                Trial(kite, wind, path, IDEAL)
                for kite in KITES
                if kite != SPORT
                for path in PATHS
                for wind in WINDS
            ],
            "a law that is not the kite's, and twice its delay": [
                Trial(SPORT, wind, "lemniscate", IDEAL, c1=factor, later=later)
                for factor, later in ((0.7, 0.0), (1.3, 0.0), (1.0, 1.0))
                for wind in WINDS
            ],
        }
        tables = []
        with ProcessPoolExecutor() as pool:
            for title, trials in titles.items():
                rows = list(with_progress("flying", pool.map(fly, trials), len(trials)))
                tables.append(Table(title, HEADS, [told(row) for row in rows]))
                print_table(tables[-1])
        if args.markdown:
            with new_file(args.markdown, args.overwrite) as path:
                path.write_text(titled_markdown(tables), encoding="utf-8")
    except InputError as error:
        print(f"guidance: {error}", file=sys.stderr)
        return 2
    return 0


def told(result: Result) -> tuple[str | float, ...]:
    """A row of the table."""
    trial, *numbers, ending = result
    sensors = "ideal" if trial.sensors == IDEAL else "real" if trial.sensors == REAL else "other"
    law = f"{trial.c1:g}, {1.0 + trial.later:g}"
    laps, rms, largest, stick, beta, pull = numbers
    return (
        *(trial.kite, f"{trial.wind:g}", trial.path, sensors, law, f"{laps:.0f}"),
        *(f"{rms:.2f}", f"{largest:.2f}", f"{stick:.0f}", f"{beta:.1f}", f"{pull:.1f}", ending),
    )


if __name__ == "__main__":
    sys.exit(main())
