"""Restless sticks of all laws: no exception, no limit left, and always the quickest way.

The quickest way under limits on rate and acceleration is known in closed form (full push, coast
at the largest rate, full brakes: any textbook on motion control); the planner is held to it.
"""

from functools import partial
from math import copysign, sqrt
from pathlib import Path
from random import Random
from typing import NamedTuple

from attacks.victim import Attack
from kitemj.controls.stick_mapping import Deflections, command_of
from kitemj.flight.live import TICK
from kitemj.physics.parameter_files import parameter_set, set_names
from kitemj.physics.parameters import Parameters, StickLimits
from kitemj.physics.shaping import StickLaw, asked, shaped
from kitemj.physics.steering import Control, rest_ell, segment_control

HANDS = ("pad", "keys", "jumps", "touches")
"""How the stick moves: a walk on the steps of a pad, pressed and let go, anywhere, barely."""
FLIGHTS = 250
"""Of each set and way to move the stick: four million ticks in all."""
TICKS = 1000
ROUNDING = 1e-12
"""Relative, of a limit on a rate or an acceleration."""
PASSED = 1.0
"""Of limit tick²/4 [rad, m]: what a tick's mean acceleration leaves at δ and ℓ."""
QUICKEST = 1e-6
"""Of what a tick can change a rate by: the planner's own rounding."""

WILD = {
    "delta": (-3.0, 0.1),
    "delta_dot": (-4.0, 3.0),
    "delta_ddot": (-4.0, 4.0),
    "ell": (-2.0, 1.3),
    "ell_dot": (-4.0, 3.0),
    "ell_ddot": (-4.0, 4.0),
}
"""Powers of ten, between which limits of hands that nobody has are drawn."""


class Excess(NamedTuple):
    """The worst of a flight: beyond rates and accelerations (relative), places (limit tick²/4).

    `quickest`: how far from the quickest way, in parts of what a tick can change a rate by.
    """

    rate: float = -1.0
    acceleration: float = -1.0
    place: float = -1.0
    quickest: float = 0.0


def attacks() -> list[Attack]:
    """Ten seconds of ticks for each set that ships (and wild limits), stick and seed."""
    return [
        Attack(f"{TICKS} ticks of {hands}, {name}, seed {seed}", partial(_harm, name, hands, seed))
        for name in (*set_names(), "wild")
        for hands in HANDS
        for seed in range(FLIGHTS)
    ]


def _harm(name: str, hands: str, seed: int, folder: Path) -> str:
    try:
        worst = flown(name, hands, seed)
    except Exception as error:
        return f"traceback: {error!r}"
    allowed = Excess(ROUNDING, ROUNDING, PASSED, QUICKEST)
    beyond = [f for f in Excess._fields if not getattr(worst, f) <= getattr(allowed, f)]
    return f"wrong: beyond {', '.join(beyond)}: {worst}" if beyond else ""


def flown(name: str, hands: str, seed: int, ticks: int = TICKS) -> Excess:
    """What a restless stick makes of the limits of the set `name`, or of "wild" ones."""
    random = Random(f"{name} {hands} {seed}")
    parameters = _wild(random) if name == "wild" else parameter_set(name)
    limits, rest = parameters.stick, rest_ell(parameters.lines.length, parameters.kite.y_A)
    now, worst, at = Control(rest, 0.0, 0.0, 0.0, 0.0, 0.0), Excess(), Deflections()
    law, two = StickLaw.ANGLE, False
    for _ in range(ticks):
        if random.random() < 0.02:
            law, two = StickLaw(random.randrange(3)), random.random() < 0.3
        at = _moved(at, hands, random)
        command = command_of(at, parameters, law, two)
        wish, rate = asked(limits, command.law, command.delta, now, TICK)
        reach = rest + command.ell * limits.ell
        segment = shaped(limits, now, 0.0, TICK, wish, reach, rest, rate)
        then = segment_control(segment, TICK)
        fastest = min(rate, limits.delta_dot)
        new = (
            quickest_rate(now.delta, now.delta_dot, wish, fastest, limits.delta_ddot),
            quickest_rate(now.ell, now.ell_dot, reach, limits.ell_dot, limits.ell_ddot),
        )
        worst = Excess(*map(max, worst, _excess(limits, rest, then, new)))
        now = then
    return worst


def quickest_rate(place: float, rate: float, target: float, fastest: float, most: float) -> float:
    """The rate after a `TICK` of the quickest way from `place` at `rate` to rest at `target`.

    `fastest` and `most` are the limits on rate and acceleration; who is faster brakes first.
    """
    left, side = TICK, copysign(1.0, rate)
    if fastest < 1e-9:
        return side * max(abs(rate) - most * left, 0.0)
    if abs(rate) > fastest:
        if abs(rate) - most * left >= fastest:
            return rate - side * most * left
        place += side * (rate * rate - fastest * fastest) / (2 * most)
        left -= (abs(rate) - fastest) / most
        rate = side * fastest
    side = copysign(1.0, target - place - rate * abs(rate) / (2 * most))
    way = side * (target - place)
    peak = min(fastest, sqrt(max(most * way + rate * rate / 2, 0.0)))
    push = max(peak - side * rate, 0.0) / most
    coast = max(way - (2 * peak * peak - rate * rate) / (2 * most), 0.0) / peak if peak else 0.0
    if left <= push:
        return rate + side * most * left
    return side * max(peak - most * max(left - push - coast, 0.0), 0.0)


def _excess(limits: StickLimits, rest: float, c: Control, new: tuple[float, float]) -> Excess:
    places = (
        (abs(c.delta) - limits.delta) / (limits.delta_ddot * TICK**2 / 4),
        (abs(c.ell - rest) - limits.ell) / (limits.ell_ddot * TICK**2 / 4),
    )
    return Excess(
        max(abs(c.delta_dot) / limits.delta_dot, abs(c.ell_dot) / limits.ell_dot) - 1,
        max(abs(c.delta_ddot) / limits.delta_ddot, abs(c.ell_ddot) / limits.ell_ddot) - 1,
        max(places),
        max(
            abs(c.delta_dot - new[0]) / (limits.delta_ddot * TICK),
            abs(c.ell_dot - new[1]) / (limits.ell_ddot * TICK),
        ),
    )


def _moved(at: Deflections, hands: str, random: Random) -> Deflections:
    """Where the stick is a tick later."""
    if hands == "pad":  # steps of 16 bits
        walk = (round((each + random.gauss(0.0, 0.03)) * 32767) / 32767 for each in at)
        return Deflections(*(max(-1.0, min(1.0, each)) for each in walk))
    if random.random() > 0.05:
        return at
    if hands == "keys":
        return Deflections(*random.choices((-1.0, -0.4, 0.0, 0.4, 1.0), k=4))
    least = 0.0 if hands == "jumps" else -12.0
    sizes = (random.random() * 10.0 ** random.uniform(least, 0.0) for _ in at)
    return Deflections(*(random.choice((-1.0, 1.0)) * size for size in sizes))


def _wild(random: Random) -> Parameters:
    """The sport kite with hands that nobody has."""
    sport = parameter_set("sport")
    limits = {name: 10.0 ** random.uniform(*powers) for name, powers in WILD.items()}
    return sport._replace(stick=sport.stick._replace(**limits))
