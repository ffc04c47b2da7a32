"""Schedules of the stick, the motion of the lines that follows, and flights under them.

A schedule is a list of (until [s], stick); the stick is in parts of the largest δ, positive where
the right hand pulls. The lines follow as in a live flight: tick by tick, within the limits.
"""

from collections.abc import Sequence

import numpy as np

from kitemj.dynamics.formulation import make_model
from kitemj.dynamics.ground import TOUCH
from kitemj.dynamics.motion import Motion
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.scenario import Scenario, scenario_of
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import StickLimits
from kitemj.physics.shaping import StickLaw, asked, shaped
from kitemj.physics.steering import Control, Segment, Spline, control, rest_ell

Schedule = Sequence[tuple[float, float]]

FULL_DEFLECTION: Schedule = ((2.0, 0.0), (30.0, 1.0), (75.0, -1.0), (100.0, 0.0))
"""Rest, full right, full left, rest: each long enough for the slowest case to get there (20 s to
the first end, 40 s from end to end) and for the kite to follow."""
TOLERANCE = 1e-9
"""Of a step, in rad and rad/s."""


def square_wave(half_period: float) -> Schedule:
    """Full right and full left in turn, `half_period` [s] each, after 2 s of rest; 80 s or more."""
    swings = max(3, round(80.0 / half_period))
    return ((2.0, 0.0), *((2.0 + half_period * (i + 1), (-1.0) ** i) for i in range(swings)))


def scenario(length: float, limits: StickLimits | None = None) -> Scenario:
    """The set thesis at its equilibrium, lines of `length` [m], with these limits of the stick."""
    stick = {} if limits is None else {"stick": limits._asdict()}
    tables = {"set": "thesis", "duration": 1.0, "lines": {"length": length}, **stick}
    return scenario_of(tables, "thesis")


def steering_spline(limits: StickLimits, schedule: Schedule, ell: float) -> Spline:
    """The motion of the lines: a parabola a tick, as pieces of a spline; `ell` [m] stays."""
    ticks = round(schedule[-1][0] / TICK)
    segment, pieces = Segment(0.0, Control(ell, 0.0, 0.0, 0.0, 0.0, 0.0)), np.zeros((4, ticks))
    for i, stick in enumerate(stick_values(schedule)):
        now = control(segment, i * TICK)
        wish, rate = asked(limits, StickLaw.ANGLE, stick, now, TICK)
        segment = shaped(limits, now, i * TICK, TICK, wish, ell, ell, rate)
        c = segment.control
        pieces[1:, i] = 0.5 * c.delta_ddot, c.delta_dot, c.delta
    lengths = np.zeros((4, ticks))
    lengths[3] = ell
    return Spline(np.arange(ticks + 1.0) * TICK, lengths, pieces)


def stick_values(schedule: Schedule) -> list[float]:
    """The stick at each tick."""
    found: list[float] = []
    for until, stick in schedule:
        found += [stick] * (round(until / TICK) - len(found))
    return found


def lagrange_rows(length: float, limits: StickLimits, schedule: Schedule) -> Array:
    """The flight of `schedule` by Lagrange's equations: a row at every tick."""
    start = scenario(length)
    parameters = start.parameters
    programme = steering_spline(limits, schedule, rest_ell(length, parameters.kite.y_A))
    kite = make_model("lagrange", parameters)
    kite.start(start.start, programme)
    times = np.arange(round(schedule[-1][0] / TICK) + 1.0) * TICK
    return kite.batch(programme, times, TOUCH, TOLERANCE)


def live_flights(length: float, limits: StickLimits, schedule: Schedule) -> dict[str, list[Motion]]:
    """The same schedule through two live flights: the motions of all three models at every tick."""
    found: dict[str, list[Motion]] = {"lagrange": [], "newton-euler": [], "mujoco": []}
    for model in ("mujoco", "newton-euler"):
        flight = SteeredFlight(scenario(length, limits), model, "lagrange")
        results = [
            flight.restart(),
            *(flight.tick(Command(stick)) for stick in stick_values(schedule)),
        ]
        found[model] = [result.motion for result in results]
        references = [result.reference for result in results]
        found["lagrange"] = [motion for motion in references if motion is not None]
    return found
