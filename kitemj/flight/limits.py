"""The list of limits: how each is decided, what is told beyond it, and which a flight left first.

One expression decides for an instant and for columns: `Numbers` hold floats or arrays alike.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from enum import Enum
from functools import reduce
from math import degrees, inf, nan, tau
from operator import and_
from typing import Any, NamedTuple

import numpy as np

from kitemj.dynamics.batch import ALPHA, BETA, CLEARANCE, TENSIONS
from kitemj.dynamics.ground import TOUCH
from kitemj.dynamics.ground import clearance as clearance_of
from kitemj.dynamics.motion import Motion
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import Limits, Parameters


class Numbers(NamedTuple):
    """What limits are about: floats of an instant, or columns of shape (rows,) each.

    `tensions` [N] of the lines, the left first; `alpha`, `beta` [rad]; `speed` [m/s] of the air;
    `clearance` [m] of the hull's lowest corner; `twist` [rad] of the lines, positive to the right.
    """

    tensions: Sequence[Any] = ()
    alpha: Any = nan
    beta: Any = nan
    speed: Any = nan
    clearance: Any = inf
    twist: Any = 0.0

    def row(self, i: int) -> "Numbers":
        """One instant of columns."""
        tensions, *others = self
        return Numbers([T[i] for T in tensions], *(x[i] if np.ndim(x) else x for x in others))


Rule = Callable[[Limits, Numbers], Any]


@dataclass(frozen=True, eq=False)
class Limit:
    """One limit; `sentence` says what is the matter beyond it, `advice` what a pilot does then.

    `kept` decides, by rows where the numbers are columns. `reading` is told beside the sentence.
    `ratio` is how much of the limit is taken up, where it has a measure.
    """

    name: str
    sentence: str
    advice: str
    kept: Rule
    reading: Callable[[Limits, Numbers], str]
    ratio: Rule = lambda limits, now: nan

    def __repr__(self) -> str:
        """Its name in this module; pickled by it, each limit is one object in every process."""
        return self.name.upper()

    __reduce__ = __repr__


SLACK = Limit(
    "slack",
    "a line is slack, or would have to push",
    "take line in, or steer up",
    lambda limits, now: reduce(and_, [pull > 0.0 for pull in now.tensions]),
    lambda limits, now: (
        f"left {now.tensions[0]:.2f} N, right {now.tensions[-1]:.2f} N, at least 0 N"
    ),
)
STALL = Limit(
    "stall",
    "the angle of attack is outside 0 < α < α_stall",
    "ease the stick, let it gather speed",
    lambda limits, now: (now.alpha > 0.0) & (now.alpha < limits.alpha_stall),
    lambda limits, now: f"α = {_deg(now.alpha, '.2f')}, α_stall = {_deg(limits.alpha_stall)}",
    lambda limits, now: now.alpha / limits.alpha_stall,
)
SIDESLIP = Limit(
    "sideslip",
    "the sideslip angle is beyond β_max",
    "ease the stick",
    lambda limits, now: abs(now.beta) < limits.beta_max,
    lambda limits, now: f"β = {_deg(now.beta, '.2f')}, β_max = {_deg(limits.beta_max)}",
    lambda limits, now: abs(now.beta) / limits.beta_max,
)
OVERLOAD = Limit(
    "overload",
    "a line carries more than it may",
    "let line out, or steer to the side",
    lambda limits, now: reduce(and_, [pull <= limits.tension_max for pull in now.tensions]),
    lambda limits, now: f"{max(now.tensions):.0f} N of {limits.tension_max:.0f} N",
    lambda limits, now: np.max(now.tensions, axis=0) / limits.tension_max,
)
GROUND = Limit(
    "ground",
    "the kite touches the ground",
    "start again, or go back a few seconds",
    lambda limits, now: now.clearance >= TOUCH,
    lambda limits, now: f"{now.speed:.0f} m/s of air",
)
TWIST = Limit(
    "twist",
    "the lines are twisted too far to slide",
    "fly as many loops the other way",
    lambda limits, now: abs(now.twist) <= limits.twist_max,
    lambda limits, now: f"{abs(now.twist) / tau:.1f} turns of {limits.twist_max / tau:g}",
    lambda limits, now: abs(now.twist) / limits.twist_max,
)

VALIDITY = (SLACK, STALL, SIDESLIP)
"""Where the models stop being true, in the order in which they are told."""
RECORDED = (*VALIDITY, OVERLOAD, GROUND)
"""Those with a column in recordings."""
LIMITS = (GROUND, *VALIDITY, OVERLOAD, TWIST)
"""All, the gravest for a pilot first."""


class Departure(NamedTuple):
    """The first moment beyond a limit: when [s], which, and by how much."""

    t: float
    limit: Limit
    reading: str

    def __str__(self) -> str:
        """One sentence."""
        return f"t = {self.t:.2f} s: {self.limit.sentence} ({self.reading})"


class Ending(Enum):
    """How a flight ends; the value is the sentence."""

    FINISHED = "the flight lasted as long as was asked"
    GROUND = GROUND.sentence
    DIVERGED = "the numbers left the finite, or the equations their domain"


def departure_at(
    parameters: Parameters, motion: Motion, among: Iterable[Limit] = VALIDITY, twist: float = 0.0
) -> Departure | None:
    """The first of `among` that is not kept at this instant, with `twist` [rad] of the lines."""
    limits, kite = parameters.limits, parameters.kite
    p, R = motion.body[:2]
    clearance = inf
    if -p.z < kite.span + kite.chord:  # else no corner is near the ground
        clearance = clearance_of(kite.chord, kite.span, p, R)
    now = Numbers(motion.tensions, *motion.air, clearance, twist)
    for limit in among:
        if not limit.kept(limits, now):
            return Departure(motion.t, limit, limit.reading(limits, now))
    return None


def touches_ground(parameters: Parameters, motion: Motion) -> bool:
    """Whether a corner of the kite's hull is on the ground (or below, with none to stop it)."""
    return departure_at(parameters, motion, (GROUND,)) is not None


def first_departure(
    parameters: Parameters, motions: Iterable[Motion], among: Iterable[Limit] = VALIDITY
) -> Departure | None:
    """The first departure from `among` in `motions`; None: all are within."""
    found = (departure_at(parameters, motion, among) for motion in motions)
    return next(filter(None, found), None)


def departure_in(
    limits: Limits, t: Sequence[float], columns: Numbers, among: Sequence[Limit] = VALIDITY
) -> Departure | None:
    """The first departure in columns with rows at the times `t` [s]; as `departure_at`."""
    kept = np.array([limit.kept(limits, columns) for limit in among])
    if kept.all():
        return None
    row = int(kept.all(axis=0).argmin())
    limit = among[int(kept[:, row].argmin())]
    return Departure(float(t[row]), limit, limit.reading(limits, columns.row(row)))


def batch_numbers(rows: Array) -> Numbers:
    """What limits are about, of the rows of a batch (`kitemj.dynamics.batch`)."""
    tensions = tuple(rows[:, TENSIONS:].T)
    return Numbers(tensions, rows[:, ALPHA], rows[:, BETA], clearance=rows[:, CLEARANCE])


def left_limits(departure: Departure | None) -> str:
    """What to say of a flight with this first departure."""
    if departure is None:
        return "within all limits of validity throughout"
    return f"left the limits of validity at {departure}"


def _deg(angle: float, digits: str = "g") -> str:
    return f"{degrees(angle):{digits}}°"
