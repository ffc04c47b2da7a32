"""Flights that show how a kite handles: left alone from anywhere, tapped, pushed, looped.

By newton-euler where no model is named: its coordinates go everywhere a kite goes.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from math import acos, cos, degrees, inf, isfinite, pi, radians
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.batch import X, Z
from kitemj.dynamics.formulation import make_model
from kitemj.dynamics.ground import TOUCH
from kitemj.dynamics.motion import Motion, State
from kitemj.flight.equilibrium import equilibrium
from kitemj.flight.gliding import gliding
from kitemj.flight.limits import touches_ground
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.physics.compiled import Array
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Segment, rest_ell
from kitemj.pilots.manoeuvres import Pilot
from kitemj.pilots.sight import Twist, sight

WATCHED, EVERY = 20.0, 0.1
"""s; how long a kite is watched after it was left alone, and how often it is looked at."""
HOME, DEEP = 10.0, 10.0
"""deg of azimuth, and of elevation below that of rest: no farther off is back at the top."""
LEVEL = 3.0
"""deg of azimuth; what nobody sees any more."""
KEY, TAP, PUSH = 0.4, 0.3, 0.5
"""Of the stick, a key without Shift; s, how long a tap of it is, and a push of the full stick."""


class Place(NamedTuple):
    """Where a kite is and points [deg], as the pilot sees it: right positive, heading 0 up."""

    azimuth: float
    elevation: float
    heading: float


def places() -> Iterator[Place]:
    """0 to 60° to the right, 25 to 80° up, all headings; the left is the same in a mirror."""
    for place in product(range(0, 61, 10), range(25, 81, 5), range(-150, 181, 30)):
        if place[0] or not -180 < place[2] < 0:
            yield Place(*map(float, place))


def inside(parameters: Parameters, place: Place) -> bool:
    """Whether a kite can stay there: no farther from downwind than at rest at the top."""
    off = acos(cos(radians(place.azimuth)) * cos(radians(place.elevation)))
    return off <= pi / 2 - equilibrium(parameters).gamma + 1e-9


def flying(parameters: Parameters, place: Place) -> State:
    """The state of a kite that flies where it points, straight on, at the α of rest."""
    return gliding(parameters, *map(radians, place))


def back_after(parameters: Parameters, place: Place, model: str = "newton-euler") -> float:
    """s until it is back at the top for good, hands level; inf: down, or not in `WATCHED`."""
    return home_after(parameters, left_alone(parameters, place, model))


def left_alone(parameters: Parameters, place: Place, model: str = "newton-euler") -> Array:
    """The path (n, 3) [m, E] of G with the hands level, a row each `EVERY`, until the ground."""
    times = np.arange(0.0, WATCHED + EVERY / 2, EVERY)
    kite, held = make_model(model, parameters), at_rest(parameters)
    kite.start(flying(parameters, place), held)
    return kite.batch(held, times, TOUCH, 1e-6)[:, X : Z + 1]


def assisted_after(parameters: Parameters, place: Place, pilot: Pilot) -> float:
    """The same with a pilot at the stick."""
    motions = flown(parameters, pilot, WATCHED, start=flying(parameters, place))
    every = round(EVERY / TICK)
    return home_after(parameters, np.array([m.body.p_G_E for m in motions[::every]]))


def home_after(parameters: Parameters, path: Array) -> float:
    """s until the last time that a path (n, 3) [m, E] comes to the top; inf: it does not stay."""
    azimuth, elevation = on_the_sky(path)
    low = 90.0 - degrees(equilibrium(parameters).gamma) - DEEP
    away = np.flatnonzero((np.abs(azimuth) > HOME) | (elevation < low))
    first = int(away[-1]) + 1 if len(away) else 0
    whole = len(path) > round(WATCHED / EVERY)
    return first * EVERY if whole and first < len(path) else inf


def on_the_sky(path: Array) -> tuple[Array, Array]:
    """Azimuth to the right and elevation [deg] of a path (n, 3) [m, E]."""
    x, y, z = path.T
    return np.degrees(np.arctan2(-y, -x)), np.degrees(np.arctan2(-z, np.hypot(x, y)))


def at_rest(parameters: Parameters) -> Segment:
    """Lines of even length, held."""
    ell = rest_ell(parameters.lines.length, parameters.kite.y_A)
    return Segment(0.0, Control(ell, 0.0, 0.0, 0.0, 0.0, 0.0))


class Push:
    """A pilot who pushes the stick `part` of its way for `duration` [s], then lets go."""

    def __init__(self, part: float, duration: float) -> None:
        self._part, self._duration = part, duration

    def command(self, motion: Motion) -> Command:
        """Where the stick is now."""
        return Command(self._part if motion.t < self._duration - TICK / 2 else 0.0)


def flown(
    parameters: Parameters,
    pilot: Pilot,
    duration: float,
    model: str = "newton-euler",
    start: State | None = None,
) -> list[Motion]:
    """A motion a tick, from `start` (None: rest at the top), until the ground."""
    scenario = scenario_of({"set": "sport", "duration": duration}, "handling")
    begin = start or _top(parameters)
    held = at_rest(parameters)
    scenario = replace(scenario, parameters=parameters, start=begin, programme=held)
    flight = SteeredFlight(scenario, model)
    motions = [flight.result.motion]
    while len(motions) <= round(duration / TICK) and not touches_ground(parameters, motions[-1]):
        motions.append(flight.tick(pilot.command(motions[-1])).motion)
    return motions


def _top(parameters: Parameters) -> State:
    rest = equilibrium(parameters)
    return State(Angles(0.0, rest.gamma, 0.0, rest.theta), Angles(0.0, 0.0, 0.0, 0.0))


class Answer(NamedTuple):
    """What a push did: azimuths [deg], `level_after` [s] within LEVEL for good, `down` [s]."""

    aside: float
    level_after: float
    at_end: float
    lowest: float  # m, of G
    down: float  # inf: it stayed aloft


def answer(parameters: Parameters, part: float, duration: float, seconds: float = 15.0) -> Answer:
    """A push of the stick at the top, and what comes of it within `seconds`."""
    motions = flown(parameters, Push(part, duration), seconds)
    azimuths = np.degrees([sight(motion).azimuth for motion in motions])
    off = np.flatnonzero(np.abs(azimuths) > LEVEL)
    level = (int(off[-1]) + 1) * TICK if len(off) else 0.0
    lowest = min(-motion.body.p_G_E.z for motion in motions)
    down = motions[-1].t if touches_ground(parameters, motions[-1]) else inf
    level = level if level < seconds and not isfinite(down) else inf
    aside = float(azimuths[np.argmax(np.abs(azimuths))])
    return Answer(aside, level, float(azimuths[-1]), lowest, down)


class Round(NamedTuple):
    """The first loop of a held full stick: s, m above ground at least, m/s of air at most."""

    seconds: float
    lowest: float
    fastest: float


def loop(parameters: Parameters, seconds: float = 8.0) -> Round | None:
    """A full stick from the top until the nose has gone round once; None: it does not."""
    motions, twist = flown(parameters, Push(1.0, seconds), seconds), Twist()
    lowest, fastest = inf, 0.0
    for motion in motions:
        lowest, fastest = min(lowest, -motion.body.p_G_E.z), max(fastest, motion.air.speed)
        if twist.look(motion) >= 1.0:
            return Round(motion.t, lowest, fastest)
    return None
