"""What a guided flight is about: the kite that is flown, what is remembered, what is asked for."""

from math import nan
from typing import NamedTuple

from kitemj.autopilot.follow import Estimate, Guidance
from kitemj.autopilot.joining import NOWHERE, Joining
from kitemj.autopilot.nose import leaning, turn_rate_for, within_half_turn
from kitemj.autopilot.sketch import Glider, HandLimits, lowest, most_turning, wind_felt
from kitemj.flight.pilot_settings import PhaseName, PilotSettings, TurnRateLaw
from kitemj.paths.path import Path
from kitemj.paths.sphere import direction
from kitemj.physics.compiled import Array
from kitemj.physics.vectors import Vector
from kitemj.pilots.sight import LEFT, RIGHT
from kitemj.turning.gains import Gains


class Kite(NamedTuple):
    """What does not change in a flight: the kite on its lines, how it turns, what it flies.

    The `glide` ratio; `length` [m] of the lines; `full` [rad]: largest |δ|, and
    the limits of the `hands`; `low` [m]: how high G must stay; `top` [rad]: the elevation of
    rest; `most_twist` [rad] that lines can take.
    """

    settings: PilotSettings
    law: TurnRateLaw
    gains: Gains
    path: Path
    glide: float
    length: float
    full: float
    hands: HandLimits
    low: float
    top: float
    most_twist: float


class Memory(NamedTuple):
    """What is remembered from tick to tick.

    `step`: which of the settings' phases is on, `phase`: what is flown now, in which `t` [s] is
    the time and `since` [s] its beginning; `delta` [rad], `delta_dot` [rad/s]: where the hands
    are. `progress` [rad] along the path, `laps` flown of it before it was joined last, at `began`
    [rad]; `learnt` of it. `way`: to the path, as `planned` at that time [s]. `pressed` [rad]: how
    far the nose is pressed down to land, once `at_edge`, or leans to a point. `refused`: the side
    to which a dive is turned up, 0: none. `goal` [rad]: the twist at which a loop is over; not a
    number where none is flown.
    """

    step: int
    phase: PhaseName
    since: float
    t: float
    delta: float
    delta_dot: float
    learnt: Array
    progress: float = nan
    began: float = nan
    laps: float = 0.0
    way: Joining = NOWHERE
    planned: float = nan
    pressed: float = 0.0
    at_edge: bool = False
    refused: float = 0.0
    goal: float = nan


class Asked(NamedTuple):
    """What a phase asks for, and what is remembered."""

    guidance: Guidance
    memory: Memory


def to_heading(
    kite: Kite, seen: Estimate, heading: float, aim: Vector, about: float = 0.0
) -> Guidance:
    """To turn the nose to `heading` [rad], on the way to `aim`; there is no path.

    It goes the way round that is nearest to `about` [rad]; 0: the shorter one.
    """
    off = about + within_half_turn(heading - seen.heading - about)
    turning = turn_rate_for(off, kite.law, kite.gains, seen, kite.full)
    return ask_for(turning, aim, nan)


def ask_for(turning: float, aim: Vector, error: float) -> Guidance:
    """To turn so [rad/s], now and soon, on the way to `aim`; the path is `error` [rad] away."""
    return Guidance(turning, turning, turning, nan, error, aim)


def to_point(kite: Kite, seen: Estimate, memory: Memory, azimuth: float) -> Asked:
    """The nose up, leaning to `azimuth` [rad]."""
    aim = direction(azimuth, kite.top)
    return Asked(to_heading(kite, seen, leaning(seen, azimuth), aim), memory)


def glider_of(kite: Kite, seen: Estimate, memory: Memory) -> Glider:
    """The kite as a sketch knows it, in the wind that it feels now."""
    wind = wind_felt(seen, kite.glide, kite.length) / kite.length
    known = kite.glide, kite.length, kite.law, kite.gains, kite.full, kite.hands
    return Glider(wind, *known, memory.delta, memory.delta_dot)


def upward(kite: Kite, seen: Estimate, memory: Memory) -> tuple[Guidance, float, float]:
    """What turns the nose up from a dive; to which side, and the least height [m] of it.

    To the side that is better. It is kept while a dive is turned up: who changes his mind turns
    neither way.
    """
    glider = glider_of(kite, seen, memory)
    low = {side: lowest(glider, seen, side) for side in (LEFT, RIGHT)}
    side = memory.refused or (RIGHT if low[RIGHT] > low[LEFT] else LEFT)
    turning = side * most_turning(glider, direction(seen.azimuth, seen.elevation))
    return ask_for(turning, direction(seen.azimuth, kite.top), nan), side, max(low.values())
