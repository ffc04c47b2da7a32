"""What kites that drift and barely turn can do: held, in gusts, brought aside, swayed, caught.

.venv/bin/python scripts/slow_kites.py
.venv/bin/python scripts/slow_kites.py --markdown docs/tables/slow_kites.md --overwrite
"""

import argparse
import sys
from collections.abc import Iterator
from math import degrees, radians
from pathlib import Path

import numpy as np

from kitemj.autopilot.drift_design import drift_design
from kitemj.dynamics.formulation import MODELS
from kitemj.equilibria.trim import equilibria
from kitemj.errors import InputError
from kitemj.files import new_file
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.tables import Cell, Table, print_table, titled_markdown
from slow_kites_flights import (
    aside,
    caught,
    flight_of,
    growing,
    held,
    largest_gap,
    margins,
    measured,
    stand,
    swing,
    swing_flown,
)

SETS = ("laksa", "thesis")
WINDS = (5.0, 6.0, 7.0, 8.0, 9.0)
"""m/s."""
PERIODS = (20.0, 40.0, 80.0, 160.0)
"""s."""
LONG = 300.0
"""s of a hold."""
NOISE = radians(1.0)
"""rad, of a real kite's angles."""
HOLDS = ((10.0, 0.0, NOISE), (0.0, 7.0, NOISE))
"""Starts and points that are held, deg of azimuth; noise [rad]."""
GUSTS = ((0.0, 0.6), (0.1, 0.1), (0.3, 0.1), (0.3, 1.0))
"""Amplitude, and rad/s."""
UNSTABLE = (-0.1, -0.2, -0.3, -0.36, -0.42, -0.49, -0.55, -0.6)
"""C_lβ of `laksa`."""


def main() -> int:
    """Flies, prints, and writes the tables where asked for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the tables there")
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")
    args = parser.parse_args()
    try:
        tables = []
        for table in all_tables():
            print_table(table)
            tables.append(table)
        if args.markdown:
            with new_file(args.markdown, args.overwrite) as path:
                path.write_text(titled_markdown(tables), encoding="utf-8")
    except InputError as error:
        print(f"slow_kites: {error}", file=sys.stderr)
        return 2
    return 0


def all_tables() -> Iterator[Table]:
    """Each when it is flown."""
    yield stands()
    yield reaches()
    yield swings()
    yield steadied()
    yield agreement()
    yield other_winds()
    for name in SETS:
        yield holds(name)


def stands() -> Table:
    """Full stick from the top."""
    heads = (
        *("set", "azimuth [deg]", "elevation [deg]", "90 % of it after [s]"),
        *("nose from up at most [deg]", "turn rate at most [deg/s]"),
    )
    rows = []
    for name in SETS:
        at = stand(parameter_set(name))
        numbers = (f"{x:.1f}" for x in at[:4])
        rows.append((name, *numbers, f"{at.turning:.2f}"))
    return Table("full stick from the top, held", heads, rows)


def reaches() -> Table:
    """How far full stick holds the kite aside, by wind."""
    rows: list[tuple[Cell, ...]] = []
    for name in SETS:
        known, row = parameter_set(name), []
        for wind in WINDS:
            steady = known._replace(wind=known.wind._replace(speed=wind))
            try:
                row.append(
                    f"{-degrees(equilibria(steady, None, -steady.stick.delta)[0].azimuth):.1f}"
                )
            except InputError:
                row.append("none")
        rows.append((name, *row))
    return Table("azimuth of full stick [deg]", ("set", *(f"{w:g} m/s" for w in WINDS)), rows)


def swings() -> Table:
    """Swaying from side to side, as far as hands may."""
    heads = ("set", "period [s]", "azimuth, linear [deg]", "flown [deg]", "elevation, flown [deg]")
    rows: list[tuple[Cell, ...]] = []
    for name in SETS:
        parameters = parameter_set(name)
        kite = drift_design(parameters).sideways
        for period in PERIODS:
            linear = degrees(swing(kite, parameters.stick, period))
            flown, up = np.degrees(swing_flown(parameters, period))
            rows.append((name, f"{period:.0f}", f"±{linear:.1f}", f"±{flown:.1f}", f"±{up:.2f}"))
    return Table("swaying as far as the hands' limits let it", heads, rows)


def holds(name: str) -> Table:
    """A hold for 5 min, by start, point, noise and gusts; the azimuth of the last minute."""
    heads = (
        *("start, held at [deg]", "noise [deg]", "gusts", "rms [deg]", "largest [deg]"),
        *("|δ| [rad]", "|δ̇| [rad/s]", "ending"),
    )
    rows: list[tuple[Cell, ...]] = []
    parameters = parameter_set(name)
    design = drift_design(parameters)
    for start, point, noise in HOLDS:
        for amplitude, omega in GUSTS:
            gusty = in_gusts(parameters, amplitude, omega)
            flight = flight_of(gusty, aside(gusty, radians(start)))
            flown = held(flight, radians(point), LONG, noise, design)
            came = measured(flown[0], radians(point), flown[1])
            wind = f"{amplitude:g} at {omega:g} rad/s" if amplitude else "none"
            where, numbers = f"{start:g}, {point:g}", (f"{came.rms:.3f}", f"{came.largest:.3f}")
            stick = (f"{came.stick:.3f}", f"{came.rate:.4f}")
            rows.append((where, f"{degrees(noise):.0f}", wind, *numbers, *stick, came.ending))
    return Table(f"{name}, held for {LONG:.0f} s; azimuth in the last minute", heads, rows)


def in_gusts(parameters: Parameters, amplitude: float, omega: float) -> Parameters:
    """The set in gusts of an `amplitude` [1] at `omega` [rad/s]."""
    wind = parameters.wind._replace(gust_amplitude=amplitude, gust_frequency=omega)
    return parameters._replace(wind=wind)


def other_winds() -> Table:
    """Held at 0 from 8° aside by a pilot who believes in 7 m/s, in winds from 3° aside."""
    rows: list[tuple[Cell, ...]] = []
    for name in SETS:
        known, row = parameter_set(name), []
        for speed in WINDS:
            wind = known.wind._replace(speed=speed, azimuth=radians(3.0))
            real = known._replace(wind=wind)
            flight = flight_of(real, aside(real, radians(8.0)))
            flown, ending = held(flight, 0.0, 180.0, 0.0, drift_design(known))
            row.append(ending or f"{measured(flown, 0.0, ending).largest:.2f}")
        rows.append((name, *row))
    title = "largest azimuth in the last of 3 min [deg], gains made for 7 m/s, wind from 3° aside"
    return Table(title, ("set", *(f"{w:g} m/s" for w in WINDS)), rows)


def agreement() -> Table:
    """How far the formulations part under a hold of their own."""
    rows: list[tuple[Cell, ...]] = []
    for name in SETS:
        for amplitude, omega in ((0.0, 0.6), (0.3, 1.0)):
            gap = largest_gap(in_gusts(parameter_set(name), amplitude, omega), tuple(MODELS), 60.0)
            rows.append((name, f"{amplitude:g}", f"{1e6 * gap:.2g}"))
    heads = ("set", "gusts", "largest gap in 60 s [µm]")
    return Table("three models, each under its own hold, from 10° aside", heads, rows)


def steadied() -> Table:
    """`laksa` made less and less stable: the loop's margins, and what the hold still catches."""
    heads = (
        *("C_lβ", "least stable mode alone [1/s]", "gain margin [dB]", "phase [deg]"),
        *("delay [s]", "disk [1]", "caught [deg]", "what ends a larger one"),
    )
    rows: list[tuple[Cell, ...]] = []
    sets = {f"laksa, {value:g}": with_roll(value) for value in UNSTABLE}
    for name, parameters in {**sets, "thesis, -0.1": parameter_set("thesis")}.items():
        design = drift_design(parameters)
        mode = growing(design)[0]
        up, down, phase, later, disk = margins(design)
        gain = f"+{up:.1f}" + (f", {down:.1f}" if np.isfinite(down) else "")
        stopped, beyond = "stable alone", ""
        if mode.real > 0.0:
            most, why = caught(parameters)
            stopped, beyond = f"{degrees(most):.1f}", why or "hands too slow"
        alone = f"{mode.real:.3f} ± {abs(mode.imag):.2f}i"
        rows.append(
            (name, alone, gain, f"{phase:.0f}", f"{later:.2f}", f"{disk:.2f}", stopped, beyond)
        )
    return Table("margins at the lines, and the largest swing that is caught", heads, rows)


def with_roll(value: float) -> Parameters:
    """`laksa` with another C_lβ."""
    known = parameter_set("laksa")
    return known._replace(aero=known.aero._replace(Cl_beta=value))


if __name__ == "__main__":
    sys.exit(main())
