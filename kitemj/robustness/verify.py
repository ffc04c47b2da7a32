"""Flights that try what the margins say: nothing here is linear."""

from collections import deque
from math import degrees, inf, nan, sqrt
from typing import NamedTuple

import numpy as np

from kitemj.autopilot.autopilot import Autopilot
from kitemj.autopilot.follow import length_of
from kitemj.errors import FlightError
from kitemj.flight.limits import touches_ground
from kitemj.flight.live import TICK, SteeredFlight
from kitemj.flight.pilot_settings import PilotSettings, TurnRateLaw
from kitemj.flight.scenario import Scenario
from kitemj.paths.check_path import usual_path
from kitemj.physics.compiled import Array
from kitemj.robustness.loop import PROGRESS, Lap, Loop

PUSH = 1e-3
"""rad, of the heading: small enough that nothing comes to its limits while it dies out."""
AWAY = 0.1
"""rad off the lap; who is there has left it."""
LAPS = 5
"""Flown after the push."""
SECONDS = 60.0
"""Of a flight that tries a pilot who is told wrong."""


def growth_flown(loop: Loop, lap: Lap, gain: float = 1.0, delay: int = 0) -> float:
    """By what a deviation has grown in the last of `LAPS` over the first, flown; inf: it left.

    What answers errors is multiplied by `gain` and comes `delay` ticks later; what the place on
    the path asks for comes as in the lap.
    """
    around, x = length_of(loop.path), lap.x[0].copy()
    way, n = lap.x[1:, PROGRESS], len(lap.wish)
    errors = np.array([tick.error for tick in lap.ticks])
    x[2] += PUSH
    waiting, apart = deque([0.0] * delay), []

    def by_place(values: Array, s: float) -> float:
        return float(np.interp(s, way, values, period=around))

    for _ in range(LAPS * n):
        try:
            tick = loop.begin(x)
            usual = by_place(lap.wish, tick.progress)
            waiting.append(tick.wish - usual)
            apart.append(tick.error - by_place(errors, tick.progress))
            if not abs(apart[-1]) < AWAY:
                return inf
            x = loop.end(x, tick.progress, usual + gain * waiting.popleft())
        except FlightError:
            return inf
    sizes = np.abs(apart).reshape(LAPS, n).max(axis=1)
    return float(sizes[-1] / sizes[0])


class Trial(NamedTuple):
    """A flight with a pilot who is told wrong: error [deg] on the path, laps, whether it flies.

    `ended`: in which phase, and when.
    """

    what: str
    rms: float
    largest: float
    laps: float
    flies: bool
    ended: str


def trials(scenario: Scenario, settings: PilotSettings) -> list[Trial]:
    """As it is; with the delay of the law once more; told 30 % more and less than it turns.

    All on the path of the pilot who is told right.
    """
    law = Autopilot(scenario.parameters, settings).law
    path = settings.path or usual_path(scenario.parameters, law)
    settings = settings._replace(path=path)
    more = max(1, round(law.delay(law.airspeed) / TICK))
    found = [trial("as it is", scenario, settings, law, law)]
    for from_path, when in ((False, ""), (True, ", on the path")):
        for what, told, ticks in (
            (f"{more * TICK:.2f} s later, twice the delay", law, more),
            ("c1 30 % above what it is told", _scaled(law, 1 / 1.3), 0),
            ("c1 30 % below what it is told", _scaled(law, 1 / 0.7), 0),
        ):
            found.append(trial(what + when, scenario, settings, law, told, ticks, from_path))
    return found


def trial(
    what: str,
    scenario: Scenario,
    settings: PilotSettings,
    known: TurnRateLaw,
    law: TurnRateLaw,
    delay: int = 0,
    from_path: bool = False,
) -> Trial:
    """Climbs to the path and flies it with `law`, seeing all `delay` ticks too late.

    The path was checked and rehearsed with the law that is `known`. `from_path`: it climbs as it
    should, and is told wrong only once it is on the path.
    """
    settings = settings._replace(phases=("climb", "path"), laps=0.0)
    pilot = Autopilot(scenario.parameters, settings, known)
    wrong = False
    flight = SteeredFlight(scenario, "lagrange")
    seen, errors, lost = deque([flight.result.motion] * (delay + 1)), [], False
    for i in range(round(SECONDS / TICK)):
        now = flight.result.motion
        if not wrong and (not from_path or pilot.guided.phase == "path"):
            wrong, pilot.law, pilot.kite = True, law, pilot.kite._replace(law=law)
        late = (seen[0] if wrong else now)._replace(control=now.control, t=now.t)
        try:
            result = flight.tick(pilot.command(late))
        except FlightError:
            lost = True
            break
        seen.append(result.motion)
        seen.popleft()
        on_path = pilot.guided.phase == "path"
        if i * TICK > SECONDS / 2:
            lost = lost or not on_path
            errors.append(pilot.guided.error)
        if touches_ground(scenario.parameters, result.motion):
            lost = True
            break
    told = [error for error in errors if error == error]
    rms = degrees(sqrt(sum(e * e for e in told) / len(told))) if told else nan
    largest = degrees(max(map(abs, told))) if told else nan
    ended = f"{pilot.guided.phase} {flight.result.motion.t:.1f} s"
    return Trial(what, rms, largest, pilot.guided.lap, not lost, ended)


def _scaled(law: TurnRateLaw, factor: float) -> TurnRateLaw:
    return law._replace(c1=law.c1 * factor)
