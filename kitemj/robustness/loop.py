"""The loop that keeps a kite on its path, as a map from one tick to the next.

x = (q, q̇, δ, δ̇, progress): what kite, hands and pilot remember, once what is learnt over laps is
taken to be learnt. The pilot's wished δ is told apart from the δ that the hands are sent to, so
that the loop can be opened between them: at the stick.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from kitemj.autopilot.autopilot import Autopilot
from kitemj.autopilot.follow import follow, length_of, stick_for
from kitemj.autopilot.truth import true_estimate
from kitemj.dynamics.formulation import Model, make_model
from kitemj.dynamics.motion import Motion, State
from kitemj.errors import FlightError, InputError
from kitemj.flight.limits import touches_ground
from kitemj.flight.live import TICK, SteeredFlight
from kitemj.flight.pilot_settings import PilotSettings, TurnRateLaw
from kitemj.flight.scenario import Scenario
from kitemj.paths.path import Path
from kitemj.physics.compiled import Array
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.shaping import asked, shaped
from kitemj.physics.steering import Control, Segment, control, rest_ell
from kitemj.turning.gains import Gains
from kitemj.turning.hands import moved

STATES = 11
DELTA, DELTA_DOT, PROGRESS = 8, 9, 10
"""Places in x."""


class Tick(NamedTuple):
    """What a tick begins with: the motion, δ [rad] that is wished, the place [rad], the error."""

    motion: Motion
    wish: float
    progress: float
    error: float


@dataclass(frozen=True)
class Loop:
    """Kite, hands and pilot on a path; nothing of it changes in flight.

    `learnt`: what the path asks for beside its shape, `kitemj.autopilot.follow.learn`.
    """

    parameters: Parameters
    path: Path
    law: TurnRateLaw
    gains: Gains
    learnt: Array
    kite: Model

    def begin(self, x: Array) -> Tick:
        """What is known at the beginning of a tick, at x."""
        now = self.held(x)
        state = State(Angles(*map(float, x[:4])), Angles(*map(float, x[4:8])))
        self.kite.start(state, now)
        motion = self.kite.motion(now)
        seen, full = true_estimate(motion), self.parameters.stick.delta
        to = follow(self.path, self.law, self.gains, seen, float(x[PROGRESS]), self.learnt, full)
        return Tick(motion, stick_for(self.law, self.gains, seen, to), to.progress, to.error)

    def end(self, x: Array, progress: float, wish: float) -> Array:
        """x after the tick that begins at x, the hands sent to `wish` [rad]."""
        now, limits = self.held(x), self.parameters.stick
        command = moved(wish, now.control, limits)
        rest = now.control.ell
        delta, rate = asked(limits, command.law, command.delta, now.control, TICK)
        segment = shaped(limits, now.control, 0.0, TICK, delta, rest, rest, rate)
        state = State(Angles(*map(float, x[:4])), Angles(*map(float, x[4:8])))
        self.kite.start(state, segment)
        self.kite.advance(segment, TICK)
        after, (q, q_dot) = control(segment, TICK), self.kite.state
        return np.array([*q, *q_dot, after.delta, after.delta_dot, progress])

    def held(self, x: Array) -> Segment:
        """The lines at x, unmoved from outside."""
        lines, kite = self.parameters.lines, self.parameters.kite
        rest = rest_ell(lines.length, kite.y_A)
        return Segment(0.0, Control(rest, 0.0, 0.0, float(x[DELTA]), float(x[DELTA_DOT]), 0.0))


def flown_loop(scenario: Scenario, settings: PilotSettings) -> tuple[Loop, Array]:
    """The loop of a pilot, with what it learnt in `LEARNING` laps, and x at their end.

    It climbs from the scenario's start.

    Raises InputError for a kite that does not turn, and a path that is not followed.
    """
    on_it = settings._replace(phases=("climb", "path"), laps=0.0)
    parameters = scenario.parameters
    pilot = Autopilot(parameters, on_it)
    flight, full = SteeredFlight(scenario, "lagrange"), round(LONGEST / TICK)
    for _ in range(LEARNING * full):
        memory, lap = pilot.memory, pilot.guided.lap
        if memory.phase == "path" and lap >= LEARNING:
            break
        result = flight.tick(pilot.command(flight.result.motion))
        if touches_ground(parameters, result.motion):
            raise InputError(NOT_FOLLOWED)
    else:
        raise InputError(NOT_FOLLOWED)
    kite = make_model("lagrange", parameters)
    loop = Loop(parameters, pilot.path, pilot.law, pilot.gains, memory.learnt, kite)
    (q, q_dot), hands = flight.kite.state, flight.result.motion.control
    return loop, np.array([*q, *q_dot, hands.delta, hands.delta_dot, memory.progress])


class Lap(NamedTuple):
    """A lap that repeats: x (n + 1, 11) at its ticks, δ wished (n,) [rad] and each `Tick`.

    `closing`: how far its end is from its beginning [rad across the path].
    """

    x: Array
    wish: Array
    ticks: list[Tick]
    closing: float

    @property
    def period(self) -> float:
        """[s], whole ticks."""
        return len(self.ticks) * TICK


LEARNING, SETTLING = 8, 2
"""Laps flown while it learns; laps before the one that is looked at, once nothing more is."""
LONGEST = 60.0
"""s of a lap; a kite that takes longer does not follow its path."""
NOT_FOLLOWED = (
    "the kite does not come round its path, so its loop has no margins: "
    "lower pilot.crossover, or make the path larger"
)


def steady_lap(loop: Loop, x: Array, settling: int = SETTLING) -> Lap:
    """The lap flown after `settling` others from x. Raises InputError where none is."""
    around = length_of(loop.path)
    for _ in range(settling):
        x = _once(loop, x, around)[-1][0]
        x[PROGRESS] -= around
    rows = _once(loop, x, around)
    points, ticks = np.array([row[0] for row in rows]), [row[1] for row in rows]
    closing = abs(ticks[-1].error - ticks[0].error)
    wish = np.array([tick.wish for tick in ticks[:-1]])
    return Lap(points, wish, ticks[:-1], closing)


def _once(loop: Loop, x: Array, around: float) -> list[tuple[Array, Tick]]:
    rows, start = [(x, loop.begin(x))], float(x[PROGRESS])
    for _ in range(round(LONGEST / TICK)):
        x, tick = rows[-1]
        try:
            after = loop.end(x, tick.progress, tick.wish)
            rows.append((after, loop.begin(after)))
        except FlightError:
            break
        if touches_ground(loop.parameters, rows[-1][1].motion):
            break
        if rows[-1][0][PROGRESS] >= start + around:
            return rows
    raise InputError(NOT_FOLLOWED)
