"""How well the observer knows the kite: laps of the usual paths, ideal and real sensors, gusts.

.venv/bin/python scripts/sensors.py
.venv/bin/python scripts/sensors.py --markdown docs/tables/sensors.md --overwrite
"""

import argparse
import sys
from math import cos, degrees, hypot
from pathlib import Path
from typing import Literal

import numpy as np

from guidance_flights import IDEAL, KITES, REAL, of
from kitemj.autopilot.autopilot import Autopilot
from kitemj.autopilot.observer import Observer
from kitemj.autopilot.rehearse import on_path
from kitemj.autopilot.truth import true_estimate
from kitemj.errors import InputError
from kitemj.files import new_file
from kitemj.flight.pilot_settings import PilotSettings
from kitemj.paths.check_path import usual_path
from kitemj.pilots.sight import turned
from kitemj.tables import Table, print_table, titled_markdown
from kitemj.turning.identify import identified_law

WINDS, GUSTS, TICKS, SETTLED = (5.0, 6.5, 8.0), (0.0, 0.3), 2500, 100
"""m/s, parts of it at 1 rad/s, ticks of a flight, and those that are not counted."""
HEADS = (
    *("path", "wind [m/s]", "gusts", "sensors", "place [deg]", "course [deg]"),
    *("turning [rad/s]", "airspeed [%]"),
)


def main() -> int:
    """Flies, prints, and writes the table where asked for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the table there")
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")
    args = parser.parse_args()
    try:
        rows: list[tuple[str | float, ...]] = []
        for kind in ("lemniscate", "circle"):
            for wind in WINDS:
                for gust in GUSTS:
                    rows += flown(kind, wind, gust)
        table = Table("rms errors of the estimate, sport on 25 m", HEADS, rows)
        print_table(table)
        if args.markdown:
            with new_file(args.markdown, args.overwrite) as path:
                path.write_text(titled_markdown([table]), encoding="utf-8")
    except InputError as error:
        print(f"sensors: {error}", file=sys.stderr)
        return 2
    return 0


def flown(
    kind: Literal["lemniscate", "circle"], wind: float, gust: float
) -> list[tuple[str | float, ...]]:
    """Rows of a flight by ideal sensors, at which real ones look too."""
    steady = of(KITES["sport, 25 m"], wind)
    law = identified_law(steady)
    pilot = Autopilot(steady, PilotSettings(path=usual_path(steady, law, kind)), law)
    blown = steady.wind._replace(gust_amplitude=gust, gust_frequency=1.0)
    flight = on_path(steady._replace(wind=blown), pilot.path)
    motions = []
    for _ in range(TICKS):
        motions.append(flight.result.motion)
        flight.tick(pilot.command(motions[-1]))
    found = []
    for name, sensors in (("ideal", IDEAL), ("real", REAL)):
        observer, errors = Observer(steady, law, sensors, 1), []
        for motion in motions:
            seen, true = observer.look(motion), true_estimate(motion)
            aside = cos(true.elevation) * turned(seen.azimuth - true.azimuth)
            place = hypot(aside, seen.elevation - true.elevation)
            way, turn = turned(seen.course - true.course), seen.turning - true.turning
            air = 100 * (seen.airspeed / true.airspeed - 1)
            errors.append((degrees(place), degrees(way), turn, air))
        rms = np.sqrt(np.mean(np.square(errors[SETTLED:]), axis=0))
        numbers = f"{rms[0]:.3f}", f"{rms[1]:.2f}", f"{rms[2]:.3f}", f"{rms[3]:.1f}"
        found.append((kind, f"{wind:g}", f"{gust:g}", name, *numbers))
    return found


if __name__ == "__main__":
    sys.exit(main())
