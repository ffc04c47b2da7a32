"""An hour of hostile flight: random sticks of all laws, gusts, slack lines, the ground, restarts.

Winds from the weakest a set is made for to twice the strongest, in the program's default steps.
Prints what was met and how far taut lines were off; status 1 where something was thrown that is
no named ending, a number was not finite, or a divergence has no cause that is known.

.venv/bin/python scripts/hostile_flight.py --hours 0.05
.venv/bin/python scripts/hostile_flight.py --markdown docs/tables/hostile.md --overwrite
"""

import argparse
import sys
from collections import defaultdict, deque
from collections.abc import Iterable, MutableSequence
from itertools import chain
from math import isfinite
from pathlib import Path
from random import Random
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.formulation import DEFAULT_STEP
from kitemj.dynamics.motion import Body, Motion
from kitemj.errors import FlightError
from kitemj.files import new_file
from kitemj.flight.limits import GROUND
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.scenario import Scenario, scenario_of
from kitemj.physics.compiled import Array
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.shaping import StickLaw
from kitemj.physics.vectors import Vector, norm, rotated, unrotated
from kitemj.progress_bar import with_progress
from kitemj.tables import Table, markdown, print_table

WINDS = {"sport": (5.0, 8.0), "laksa": (5.0, 7.0), "thesis": (5.0, 7.0)}
"""m/s; what each set is made for."""
FLIGHT = 60.0
"""s; then comes another set, wind and seed."""
BOUND = 2.785
"""Of decay rate x step: what classical Runge-Kutta can follow without growing."""
LAST = 200
"""Ticks before a divergence: its cause is looked for in them, and they say nothing of lines."""
QUICK = 150.0
"""m/s; a kite that meets the air no faster flies still, and has not diverged yet."""
Counts = defaultdict[str, float]
"""By name; of ticks and events, and the largest errors [m]."""
COLUMNS = (
    *("set", "wind [m/s]", "flown [s]", "slack [s]", "on the ground [s]", "restarts", "gone back"),
    *("diverged", "thrown", "taut line off, aloft [µm]", "on the ground [µm]"),
)


class Seen(NamedTuple):
    """A tick: its motion, `where` the kite was, how far [m] a taut line was off its length."""

    motion: Motion
    where: str
    off: float


def main() -> int:
    """The exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--hours", type=float, default=1.0)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--step", type=float, default=DEFAULT_STEP, help="s")
    parser.add_argument("--markdown", type=Path, help="a file for the table")
    parser.add_argument("--overwrite", action="store_true")
    words = parser.parse_args()
    count = max(1, round(words.hours * 3600 / FLIGHT))
    met: dict[tuple[str, str], Counts] = {}
    for seed in with_progress("flying", range(words.seed, words.seed + count), count):
        name, strong = (*WINDS,)[seed % 3], seed // 3 % 2 == 1
        low, high = WINDS[name]
        told = f"{high:g} to {2 * high:g}" if strong else f"{low:g} to {high:g}"
        here = met.setdefault((name, told), Counts(float))
        for what, value in hostile(name, strong, seed, words.step).items():
            here[what] = max(here[what], value) if what.startswith("off") else here[what] + value
    rows = [(*key, *_cells(here)) for key, here in sorted(met.items())]
    table = Table(f"Hostile flight in steps of {words.step * 1e3:g} ms", COLUMNS, rows)
    print_table(table, most=len(COLUMNS))
    if words.markdown:
        with new_file(words.markdown, words.overwrite) as part:
            part.write_text(markdown(table), encoding="utf-8")
    return int(any(here["thrown"] or here["unexplained"] for here in met.values()))


def _cells(here: Counts) -> tuple[str, ...]:
    seconds = (f"{here[what] * TICK:.0f}" for what in ("ticks", "slack", "ground"))
    counts = (f"{here[what]:.0f}" for what in ("restarts", "gone back", "diverged", "thrown"))
    return (*seconds, *counts, *(f"{here[what] * 1e6:.2g}" for what in ("off", "off, ground")))


def hostile(name: str, strong: bool, seed: int, step: float, seconds: float = FLIGHT) -> Counts:
    """What one flight of the set `name` met: counts of ticks and events, and errors [m].

    `strong`: in winds up to twice what the set is made for. Prints every divergence.
    """
    random, met = Random(seed), Counts(float)
    flight = SteeredFlight(_scenario(random, name, strong), step=step)
    saved, command, down = flight.save(), Command(), 0
    before: deque[Seen] = deque()
    for k in range(round(seconds / TICK)):
        if k % random.choice((7, 30, 90)) == 0:
            stick = random.choice((-1.0, 0.0, 1.0, random.uniform(-1, 1)))
            command = Command(stick, random.uniform(-1, 1), random.choice((*StickLaw,)))
        if random.random() < TICK / 10:
            met["gone back"] += 1
            flight.resume(saved)
        if random.random() < TICK / 10:
            saved = flight.save()
        try:
            motion = flight.tick(command).motion
        except FlightError as error:
            cause = _cause(flight.parameters, [seen.motion for seen in before], step)
            before.clear()
            met["diverged"] += 1
            met["unexplained"] += not cause
            print(f"{name}, seed {seed}: {error}; {cause or 'NOBODY KNOWS WHY'}", flush=True)
            motion = None
        except Exception as error:  # the very thing that is looked for
            met["thrown"] += 1
            print(f"{name}, seed {seed}, tick {k}: {error!r}", flush=True)
            motion = None
        if motion is not None and not _finite(motion):
            met["thrown"] += 1
        if motion is None or down > 200 or random.random() < TICK / 30:
            met["restarts"] += 1
            flight.restart()
            saved, down = flight.save(), 0
            _note(met, before)
            continue
        before.append(_look(met, motion, flight))
        if len(before) > LAST:
            _note(met, [before.popleft()])
        down += flight.result.departure is not None and flight.result.departure.limit is GROUND
    _note(met, before)
    return met


def _note(met: Counts, seen: MutableSequence[Seen]) -> None:
    """Takes note of how far off lines were in ticks that led to no divergence; clears `seen`."""
    for _, where, off in seen:
        met[where] = max(met[where], off)
    seen.clear()


def _cause(parameters: Parameters, before: Iterable[Motion], step: float) -> str:
    """Why a flight diverged after the motions `before`; empty: not for want of a short step."""
    for motion in before:
        if motion.air.speed < QUICK and (rate := decay_rate(parameters, motion)) * step > BOUND:
            met = f"at t = {motion.t:.2f} s the air, met at {motion.air.speed:.0f} m/s, moved it at"
            return f"{met} {rate:.0f}/s: steps of {step * 1e3:g} ms follow {BOUND / step:.0f}/s"
    return ""


def _scenario(random: Random, name: str, strong: bool) -> Scenario:
    low, high = WINDS[name]
    wind = {
        "speed": random.uniform(high, 2 * high) if strong else random.uniform(low, high),
        "exponent": random.choice((0.0, 0.14)),
        "gust_amplitude": random.uniform(0.0, 0.5),
        "gust_frequency": random.uniform(0.1, 20.0),
        "azimuth": random.uniform(-0.3, 0.3),
    }
    return scenario_of({"set": name, "duration": FLIGHT, "wind": wind}, "hostile")


def _finite(motion: Motion) -> bool:
    lines = chain(*(line[:3] for line in motion.lines))
    body = chain(motion.body.p_G_E, *motion.body.R_BE, motion.body.v_G_E, motion.body.omega_B)
    return all(map(isfinite, chain(motion.q or (), body, motion.control, lines, motion.air)))


def _look(met: Counts, motion: Motion, flight: SteeredFlight) -> Seen:
    """Counts the tick; how far taut lines are off their lengths in it."""
    departure = flight.result.departure
    ground = departure is not None and departure.limit is GROUND
    met["ticks"] += 1
    met["ground"] += ground
    met["slack"] += min(motion.tensions) <= 0.0
    taut = [line for line in motion.lines if line.tension_kite > 0.0]
    off = max((abs(norm(line.points[1]) - line.length) for line in taut), default=0.0)
    return Seen(motion, "off, ground" if ground else "off", off)


def decay_rate(parameters: Parameters, motion: Motion) -> float:
    """How fast [1/s] the air damps or drives the free kite: |λ| of ∂(a, ω̇)/∂(v, ω), the largest."""
    kite, body, h = parameters.kite, motion.body, 1e-4
    inertia = np.diag((kite.inertia_x, kite.inertia_y, kite.inertia_z))
    inertia[0, 2] = inertia[2, 0] = -kite.inertia_xz

    def accelerations(change: Array) -> Array:
        v_B = rotated(body.R_BE, body.v_G_E)
        v = unrotated(body.R_BE, Vector(*(np.array(v_B) + change[:3]).tolist()))
        omega = np.array(body.omega_B) + change[3:]
        moved = Body(body.p_G_E, body.R_BE, v, Vector(*omega.tolist()))
        force, moment = aerodynamic_wrench(parameters, *moved, motion.t)
        turning = np.array(moment) - np.cross(omega, inertia @ omega)
        return np.array([*(np.array(force) / kite.mass), *np.linalg.solve(inertia, turning)])

    columns = [(accelerations(h * e) - accelerations(-h * e)) / (2 * h) for e in np.eye(6)]
    return float(np.abs(np.linalg.eigvals(np.column_stack(columns))).max())


if __name__ == "__main__":
    sys.exit(main())
