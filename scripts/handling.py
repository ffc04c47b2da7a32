"""How a kite handles: what it does left alone, tapped, pushed and looped, in 5, 6.5 and 8 m/s.

.venv/bin/python scripts/handling.py trainer sport
.venv/bin/python scripts/handling.py trainer --assist
.venv/bin/python scripts/handling.py trainer sport --markdown docs/tables/handling.md --overwrite
"""

import argparse
import sys
from collections.abc import Sequence
from math import degrees, inf, isfinite
from pathlib import Path

import numpy as np

from handling_flights import (
    KEY,
    LEVEL,
    PUSH,
    TAP,
    Place,
    Push,
    answer,
    assisted_after,
    back_after,
    flown,
    inside,
    loop,
    places,
)
from kitemj.dynamics.formulation import MODELS
from kitemj.dynamics.motion import Motion
from kitemj.equilibria.modes import MOTIONS, stability
from kitemj.errors import InputError
from kitemj.files import new_file
from kitemj.flight.compare import position_gap
from kitemj.flight.equilibrium import equilibrium
from kitemj.flight.scenario import parameters_named
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import Parameters
from kitemj.pilots.registry import PILOTS
from kitemj.progress_bar import with_progress
from kitemj.tables import Cell, Table, print_table, titled_markdown
from sway_yaw import levers, sway_yaw

WINDS = (5.0, 6.5, 8.0)
"""m/s."""
SOON = 10.0
"""s; who is back at the top by then is back."""
NOSES = (30.0, 60.0, 90.0, 120.0, 180.0)
"""deg from up; starts are counted by them."""
FEW = [
    Place(*map(float, place)) for place in ((20, 30, 60), (40, 35, -60), (60, 25, 30), (0, 45, 90))
]
"""Starts that all formulations fly."""
AIDE = "assist"
"""The pilot who helps, where there is one."""


def main() -> int:
    """Flies, prints, and writes the tables where asked for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("kite", nargs="*", default=["trainer"], help="sets, or TOML files")
    parser.add_argument("--assist", action="store_true", help="with the pilot who helps")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the tables there")
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")
    args = parser.parse_args()
    try:
        tables = []
        for kite in args.kite:
            tables += [handling(kite), by_all(kite)]
            if args.assist and (table := assisted(kite)):
                tables.append(table)
        for table in tables:
            print_table(table)
        if args.markdown:
            with new_file(args.markdown, args.overwrite) as path:
                path.write_text(titled_markdown(tables), encoding="utf-8")
    except InputError as error:
        print(f"handling: {error}", file=sys.stderr)
        return 2
    return 0


def handling(kite: str) -> Table:
    """A row for each thing that is asked, a column for each wind."""
    columns = [asked(in_wind(kite, wind)) for wind in with_progress("flying", WINDS, len(WINDS))]
    rows: list[tuple[Cell, ...]] = [
        (name, *(column[name] for column in columns)) for name in columns[0]
    ]
    return Table(f"{kite}, hands level unless said", heads("what"), rows)


def heads(first: str) -> tuple[str, ...]:
    """Names of the columns."""
    return (first, *(f"{wind:g} m/s" for wind in WINDS))


def in_wind(kite: str, wind: float) -> Parameters:
    """A set in a steady wind [m/s]."""
    parameters = parameters_named(kite)
    return parameters._replace(wind=parameters.wind._replace(speed=wind))


def asked(parameters: Parameters) -> dict[str, str]:
    """Everything about a set in its wind, in words."""
    lever = levers(parameters)
    rows = {
        "rests at [deg]": f"{90 - degrees(equilibrium(parameters).gamma):.0f}",
        "sideways modes [1/s]": shown(sideways(parameters)),
        "the same by hand [1/s]": shown(sway_yaw(parameters)[:3]),
        "righting lever e [mm]": f"{1e3 * lever.e:.0f}",
        "steering lever a - e [mm]": f"{1e3 * (lever.a - lever.e):.0f}",
    }
    starts = list(places())
    after = [back_after(parameters, place) for place in starts]
    return rows | shares(parameters, starts, after) | pushes(parameters)


def sideways(parameters: Parameters) -> list[complex]:
    """The eigenvalues [1/s] of the slow sideways modes of `kitemj stability`, imag >= 0."""
    odd = [MOTIONS.index(name) for name in ("sway", "roll", "yaw")]
    modes = stability(parameters).modes
    found = [m for m in modes if sum(m.shares[i] for i in odd) > 0.5]
    return [complex(mode.real, mode.imag) for mode in found][:-1]  # the last is quick


def shown(values: Sequence[complex]) -> str:
    """Eigenvalues, pairs once, by rising imaginary part."""
    found = sorted((z for z in values if z.imag >= 0), key=lambda z: (z.imag, -z.real))
    return ", ".join(f"{z.real:.2f}" + (f" ± {z.imag:.2f}i" if z.imag else "") for z in found)


def shares(parameters: Parameters, starts: list[Place], times: list[float]) -> dict[str, str]:
    """How many starts are back after `times` [s] of `SOON` at most, by where the nose points."""
    within, after = [inside(parameters, place) for place in starts], np.array(times)
    noses, there = np.array([abs(place.heading) for place in starts]), np.array(within)
    rows = {}
    for nose in NOSES:
        chosen = after[there & (noses <= nose)]
        middle = float(np.median(chosen))
        when = f", median {middle:.1f} s" if isfinite(middle) else ""
        label = "any way" if nose == NOSES[-1] else f"{nose:.0f}° from up at most"
        rows[f"back in {SOON:.0f} s, nose {label}"] = share(chosen) + when
    rows["beyond the window, nose 60° from up at most"] = share(after[~there & (noses <= 60.0)])
    return rows


def share(after: Array) -> str:
    """How many of so many are back soon."""
    return f"{100 * np.mean(after <= SOON):.0f} % of {len(after)}" if len(after) else "none flown"


def pushes(parameters: Parameters) -> dict[str, str]:
    """What a tap, a held key, a push and a held full stick do at the top."""
    lines = {
        f"a tap: {KEY} of the stick for {TAP} s": (KEY, TAP),
        f"a held key: {KEY} for 1 s": (KEY, 1.0),
        f"a push: all of it for {PUSH} s": (1.0, PUSH),
    }
    rows = {name: told(parameters, *push) for name, push in lines.items()}
    turn = loop(parameters)
    rows["full stick: first loop"] = (
        f"{turn.seconds:.1f} s, {turn.lowest:.0f} m up at least, {turn.fastest:.0f} m/s"
        if turn
        else "none"
    )
    return rows


def told(parameters: Parameters, part: float, duration: float) -> str:
    """The answer to a push, in words."""
    found = answer(parameters, part, duration)
    if isfinite(found.down):
        return f"{found.aside:.0f}° aside, down after {found.down:.1f} s"
    level, then = found.level_after, f", {found.at_end:.0f}° after 15 s"
    if level < inf:
        then = f", {LEVEL:.0f}° after {level:.1f} s" if level else ""
    return f"{found.aside:.0f}° aside{then}, {found.lowest:.0f} m up at least"


def by_all(kite: str) -> Table:
    """A row for each wind and formulation: when a few starts are back, and how far off it ends."""
    rows: list[tuple[Cell, ...]] = []
    for wind in with_progress("by all", WINDS, len(WINDS)):
        parameters = in_wind(kite, wind)
        flights = {model: pushed(parameters, model) for model in MODELS}
        for model, flight in flights.items():
            back = ", ".join(f"{back_after(parameters, place, model):.1f}" for place in FEW)
            gap = 1e6 * largest_gap(flight, flights["lagrange"])
            rows.append((f"{wind:g}", model, back, f"{gap:.2g}"))
    columns = ("wind [m/s]", "model", "four starts back after [s]", "off in a tap and a push [µm]")
    return Table(f"{kite}, by every formulation", columns, rows)


def pushed(parameters: Parameters, model: str) -> list[Motion]:
    """A tap and a push, each for 6 s or until the tick before the ground."""
    pushes = Push(KEY, TAP), Push(1.0, PUSH)
    return [motion for push in pushes for motion in flown(parameters, push, 6.0, model)[:-1]]


def largest_gap(some: list[Motion], others: list[Motion]) -> float:
    """Largest distance [m] of the two."""
    return max(position_gap(a, b) for a, b in zip(some, others, strict=False))


def assisted(kite: str) -> Table | None:
    """How many come back with the stick let go and the assist on; None where there is none."""
    if AIDE not in PILOTS:
        print(f"no pilot is called {AIDE}: left out", file=sys.stderr)
        return None
    starts = [place for place in places() if some(place)]
    columns = []
    for wind in with_progress("assisted", WINDS, len(WINDS)):
        parameters = in_wind(kite, wind)
        after = [assisted_after(parameters, place, PILOTS[AIDE]()) for place in starts]
        columns.append(shares(parameters, starts, after))
    rows: list[tuple[Cell, ...]] = [(name, *(c[name] for c in columns)) for name in columns[0]]
    return Table(f"{kite}, hands off, assist on", heads("what"), rows)


def some(place: Place) -> bool:
    """Whether it is among the tenth that are flown with a pilot, who takes longer."""
    even = place.azimuth % 30 == 0 and place.heading % 60 == 0
    return even and place.elevation in (25, 45)


if __name__ == "__main__":
    sys.exit(main())
