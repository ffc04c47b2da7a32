"""Section 4.2: signals from moves of a stick, raw and shaped, and a solver's flights with them."""

from bisect import bisect_right
from functools import partial
from math import inf
from typing import NamedTuple

from kitemj.flight.limits import Departure, first_departure
from kitemj.flight.live import TICK
from kitemj.flight.scenario import Scenario
from kitemj.physics.parameters import StickLimits
from kitemj.physics.shaping import StickLaw, asked, shaped
from kitemj.physics.steering import Control, Segment, control
from thesis.ode45 import Solution, Steering, solve

MOVES = ((0.0, 0.0), (1.0, 1.0), (13.0, -1.0), (18.0, 0.0))
"""Time [s] and stick from then on; the thesis does not tell its own."""

DURATION = 25.0  # s
TICKS = (0.1, 0.02, TICK)
"""s; how often the knob is read, in flight."""

FINE_TICKS = (0.1, 0.05, 0.02, TICK, 0.005, 0.002, 0.001)
"""s; the same for the peaks alone."""

SIGNALS = {
    "delta": r"$\delta$ [rad]",
    "delta_dot": r"$\dot\delta$ [rad/s]",
    "delta_ddot": r"$\ddot\delta$ [rad/s²]",
}


class StickSignals(NamedTuple):
    """The control at the start of each `tick` [s], and how it goes on until the next."""

    kind: str
    law: StickLaw
    tick: float
    controls: list[Control]
    steering: list[Steering]

    def peak(self, signal: str) -> float:
        """The largest |`signal`|."""
        return max(abs(float(getattr(c, signal))) for c in self.controls)


class SolvedFlight(NamedTuple):
    """What the solver made of it, and where that first left the limits of validity."""

    signals: StickSignals
    found: Solution
    departure: Departure | None

    @property
    def tension_range(self) -> tuple[float, float]:
        """The least and the largest tension [N] at the end of a tick."""
        tensions = [tension for motion in self.found.motions for tension in motion.tensions]
        return min(tensions), max(tensions)


def stick_at(t: float) -> float:
    """The stick at time `t` [s]."""
    return MOVES[bisect_right(MOVES, (t + 1e-9, inf)) - 1][1]


def raw_signals(limits: StickLimits, ell: float, law: StickLaw, tick: float) -> StickSignals:
    """As blocks make it of a knob: differences and sums at each tick, held until the next.

    δ is cut at its limit, where δ̇ and δ̈ become zero; nothing else is limited.
    """
    rule, last = _RULES[law], Control(ell, 0.0, 0.0, 0.0, 0.0, 0.0)
    controls = []
    for k in range(round(DURATION / tick)):
        last = Control(ell, 0.0, 0.0, *rule(limits, stick_at(k * tick), last, tick))
        controls.append(last)
    return StickSignals("raw", law, tick, controls, [partial(_held, c) for c in controls])


def shaped_signals(limits: StickLimits, ell: float, law: StickLaw, tick: float) -> StickSignals:
    """As kitemj flies the same moves."""
    segment = Segment(0.0, Control(ell, 0.0, 0.0, 0.0, 0.0, 0.0))
    segments = []
    for k in range(round(DURATION / tick)):
        now = control(segment, k * tick)
        wish, rate = asked(limits, law, stick_at(k * tick), now, tick)
        segment = shaped(limits, now, k * tick, tick, wish, ell, ell, rate)
        segments.append(segment)
    controls = [segment.control for segment in segments]
    return StickSignals("shaped", law, tick, controls, [partial(control, s) for s in segments])


AllSignals = dict[tuple[str, StickLaw, float], StickSignals]
"""By kind, law and tick [s]."""


def _held(c: Control, t: float) -> Control:
    return c


Signals = tuple[float, float, float]


def _from_angle(limits: StickLimits, knob: float, last: Control, tick: float) -> Signals:
    """The knob is δ: two differences."""
    delta = knob * limits.delta
    rate = (delta - last.delta) / tick
    return delta, rate, (rate - last.delta_dot) / tick


def _from_rate(limits: StickLimits, knob: float, last: Control, tick: float) -> Signals:
    """The knob is δ̇: a sum and a difference."""
    delta = _sum(limits, last, tick)
    rate = _stopped_at_limit(limits, delta, knob * limits.delta_dot)
    return delta, rate, (rate - last.delta_dot) / tick


def _from_acceleration(limits: StickLimits, knob: float, last: Control, tick: float) -> Signals:
    """The knob is δ̈: two sums."""
    delta = _sum(limits, last, tick)
    rate = _stopped_at_limit(limits, delta, last.delta_dot + tick * last.delta_ddot)
    return delta, rate, _stopped_at_limit(limits, delta, knob * limits.delta_ddot)


def _sum(limits: StickLimits, last: Control, tick: float) -> float:
    return max(-limits.delta, min(limits.delta, last.delta + tick * last.delta_dot))


def _stopped_at_limit(limits: StickLimits, delta: float, push: float) -> float:
    """`push`, or nothing where it is against the end of δ's way."""
    return 0.0 if abs(delta) >= limits.delta and push * delta > 0 else push


_RULES = {
    StickLaw.ANGLE: _from_angle,
    StickLaw.RATE: _from_rate,
    StickLaw.ACCELERATION: _from_acceleration,
}


def solve_flight(scenario: Scenario, signals: StickSignals) -> SolvedFlight:
    """The thesis's solver through it."""
    found = solve(scenario.parameters, scenario.start, signals.steering, signals.tick)
    return SolvedFlight(signals, found, first_departure(scenario.parameters, found.motions))
