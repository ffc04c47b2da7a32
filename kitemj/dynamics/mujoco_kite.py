"""The kite as a MuJoCo rigid body on two tendons, stepped by one compiled loop.

Classical Runge-Kutta of the 13 numbers (position, quaternion, velocity, body rates), with
line targets and aerodynamic wrench written anew at each of the four stages.
"""

from math import ceil, sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.batch import carry_law, present_law, rows_at
from kitemj.dynamics.engine import Engine, body_of, build, place
from kitemj.dynamics.formulation import DEFAULT_STEP, Instant
from kitemj.dynamics.ground import CLOSE, above, down_to_ground
from kitemj.dynamics.motion import (
    Motion,
    Snapshot,
    State,
    air_of,
    angles_of,
    straight_lines,
    told,
)
from kitemj.dynamics.slack import TAUT, catch, release, run_out, slack_excess
from kitemj.dynamics.straight import q_ddot_of, state_of, straight_body
from kitemj.dynamics.taut import evaluate, settle, tensions
from kitemj.physics.compiled import Array, compiled
from kitemj.physics.frames import world
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import TWO_LINES, Rig
from kitemj.physics.steering import Control, Programme, Segment, control
from kitemj.physics.vectors import Vector

MAX_CATCHES = 8
"""In one step; what is left of the step then goes on without looking for more."""

SEARCH = 40
"""Trials, at most, in search of the moment at which a line runs out, or the kite is down."""


@compiled
def _add_rate(engine: Engine, sum_: Array, weight: float) -> None:
    """sum += weight d/dt(qpos, qvel) of the present stage; q̇ = ½ q ∘ (0, ω) for the quaternion.

    The quaternion is integrated as four plain numbers and made a unit one after the step,
    which keeps the method's fourth order.
    """
    p, v, a = engine.qpos, engine.qvel, engine.qacc
    half = 0.5 * weight
    for i in range(3):
        sum_[i] += weight * v[i]
    sum_[3] += half * (-p[4] * v[3] - p[5] * v[4] - p[6] * v[5])
    sum_[4] += half * (p[3] * v[3] + p[5] * v[5] - p[6] * v[4])
    sum_[5] += half * (p[3] * v[4] + p[6] * v[3] - p[4] * v[5])
    sum_[6] += half * (p[3] * v[5] + p[4] * v[4] - p[5] * v[3])
    for i in range(6):
        sum_[7 + i] += weight * a[i]


@compiled
def _read(engine: Engine, x: Array) -> None:
    """x = (qpos, qvel)."""
    for i in range(7):  # loops, here and below: slices cost 0.1 µs each, and 2 s to compile
        x[i] = engine.qpos[i]
    for i in range(6):
        x[7 + i] = engine.qvel[i]


@compiled
def _write(engine: Engine, x: Array) -> None:
    """(qpos, qvel) = x."""
    for i in range(7):
        engine.qpos[i] = x[i]
    for i in range(6):
        engine.qvel[i] = x[7 + i]


@compiled
def _keep(softness: Array, where: Array) -> None:
    """R f of both lines copied to `where`."""
    for i in range(2):
        where[i] = softness[i]


@compiled
def rk4(engine: Engine, parameters: Parameters, programme: Programme, t: float, h: float) -> None:
    """One classical Runge-Kutta step of `h` [s] from time `t` [s]; lines keep their switches."""
    start, stage, total = engine.start, engine.stage, engine.total
    _read(engine, start)
    _read(engine, total)
    for i in range(4):
        reach = 0.0 if i == 0 else (h if i == 3 else 0.5 * h)
        if i > 0:
            for j in range(13):
                stage[j] = start[j]
            _add_rate(engine, stage, reach)
            _write(engine, stage)
        evaluate(engine, parameters, programme, t + reach)
        _add_rate(engine, total, h / 6 if i in (0, 3) else h / 3)
    size = sqrt(total[3] ** 2 + total[4] ** 2 + total[5] ** 2 + total[6] ** 2)
    for j in range(3, 7):
        total[j] /= size
    _write(engine, total)


@compiled
def _runs_out_after(
    engine: Engine, parameters: Parameters, programme: Programme, t: float, h: float, line: int
) -> float:
    """The part [s] of a step `h` after which slack `line` is just taut; leaves that state.

    Regula falsi, Illinois variant, on the line's excess; each trial is one from ``engine.before``.
    """
    before, softness, early, late = engine.before, engine.softness_before, 0.0, h
    over_late = slack_excess(engine, parameters, programme, t + h, line)
    _write(engine, before)
    over_early = slack_excess(engine, parameters, programme, t, line)
    part, side = 0.0, 0
    for _ in range(SEARCH):
        if over_early >= -TAUT:
            return part
        part = early + (late - early) * over_early / (over_early - over_late)
        _write(engine, before)
        _keep(softness, engine.softness)
        rk4(engine, parameters, programme, t, part)
        over = slack_excess(engine, parameters, programme, t + part, line)
        if abs(over) <= TAUT:
            return part
        if over > 0.0:
            late, over_late = part, over
            over_early = 0.5 * over_early if side == 1 else over_early
            side = 1
        else:
            early, over_early = part, over
            over_late = 0.5 * over_late if side == -1 else over_late
            side = -1
    return part


@compiled
def step(engine: Engine, parameters: Parameters, programme: Programme, t: float, h: float) -> None:
    """One step of `h` [s], cut where a slack line runs out."""
    left, now = h, t
    for catches in range(MAX_CATCHES + 1):
        _read(engine, engine.before)
        _keep(engine.softness, engine.softness_before)
        rk4(engine, parameters, programme, now, left)
        line = run_out(engine, parameters, programme, now + left)
        if line < 0 or catches == MAX_CATCHES:
            break
        part = _runs_out_after(engine, parameters, programme, now, left, line)
        catch(engine, parameters, programme, now + part, line)
        now, left = now + part, left - part
        if left <= 0.0:
            break
    release(engine, parameters)


@compiled
def flown(
    engine: Engine, parameters: Parameters, programme: Programme, t: float, steps: int, h: float
) -> None:
    """`steps` steps of `h` [s] from time `t` [s]."""
    for i in range(steps):
        step(engine, parameters, programme, t + i * h, h)


@compiled
def _exchange(engine: Engine, back: bool) -> None:
    """Keeps what a step begins with in ``engine.kept``, or goes `back` to it."""
    kept = engine.kept
    for i in range(2):
        if back:
            engine.softness[i], engine.eq_active[i] = kept[13 + i], np.uint8(kept[15 + i])
        else:
            kept[13 + i], kept[15 + i] = engine.softness[i], engine.eq_active[i]
    if back:
        _write(engine, kept)
    else:
        _read(engine, kept)


@compiled
def flown_down(
    engine: Engine, parameters: Parameters, programme: Programme, t: float, steps: int, h: float
) -> float:
    """As `flown`, but at most to where the kite touches the ground; the time [s] reached.

    It is then no more than `CLOSE` beyond `TOUCH`: regula falsi, Illinois variant.
    """
    over_early, over, now = above(parameters, body_of(engine)), 0.0, t
    if over_early < 0.0:
        return t
    for i in range(steps):
        now = t + i * h
        _exchange(engine, back=False)
        step(engine, parameters, programme, now, h)
        over = above(parameters, body_of(engine))
        if over < 0.0:
            break
        over_early = over
    else:
        return t + steps * h
    part, early, late, over_late, side = h, 0.0, h, over, 0
    for _ in range(SEARCH):
        if -CLOSE <= over < 0.0:
            break
        aim = (over_early + CLOSE / 2) / (over_early - over_late)
        part = early + (late - early) * aim
        _exchange(engine, back=True)
        step(engine, parameters, programme, now, part)
        over = above(parameters, body_of(engine))
        if over < 0.0:
            late, over_late = part, over
            over_early = 0.5 * over_early if side == 1 else over_early
            side = 1
        else:
            early, over_early = part, over
            over_late = 0.5 * over_late if side == -1 else over_late
            side = -1
    return now + part


@compiled
def put(
    engine: Engine, parameters: Parameters, programme: Programme, t: float, state: State
) -> None:
    """The kite at `state` at time `t` [s], both lines straight."""
    place(engine, straight_body(parameters, state.q, state.q_dot, control(programme, t)))
    for i in range(2):
        engine.eq_active[i], engine.softness[i] = 1, 0.0
    settle(engine, parameters, programme, t)


@compiled
def instant_at(
    engine: Engine, parameters: Parameters, c: Control, t: float, state: State
) -> Instant:
    """The accelerations at `state`, the lines at `c`, time `t` [s]; the kite is left there."""
    put(engine, parameters, Segment(t, c), t, state)
    body, a = body_of(engine), engine.qacc
    a_G_E, omega_dot_B = world(Vector(a[0], a[1], a[2])), Vector(a[3], a[4], a[5])
    q_ddot = q_ddot_of(parameters, body, a_G_E, omega_dot_B)
    wrench = aerodynamic_wrench(parameters, body.p_G_E, body.R_BE, body.v_G_E, body.omega_B, t)
    pulls = tensions(engine, parameters, body)
    return Instant(body, a_G_E, omega_dot_B, q_ddot, pulls, wrench)


@compiled
def motion_at(engine: Engine, parameters: Parameters, programme: Programme, t: float) -> Motion:
    """All that is asked of one instant; leaves the flight as it was."""
    _keep(engine.softness, engine.softness_before)
    for _ in range(2):  # R f is of the step's last stage: 10⁻⁴, then 10⁻⁸ of its change is left
        evaluate(engine, parameters, programme, t)
    _keep(engine.softness_before, engine.softness)
    body, c = body_of(engine), control(programme, t)
    lines = straight_lines(parameters, body, c, tensions(engine, parameters, body))
    return Motion(t, angles_of(parameters, body), body, c, lines, air_of(parameters, body, t))


class MujocoFlight(NamedTuple):
    """A flight in steps of at most `longest` [s]."""

    engine: Engine
    parameters: Parameters
    programme: Programme
    longest: float


@carry_law.of(MujocoFlight)
@compiled
def carry(flight: MujocoFlight, t: float, end: float) -> float:
    """On from time `t` to `end` [s] in equal steps."""
    steps = max(1, ceil((end - t) / flight.longest - 1e-9))
    h = (end - t) / steps
    flown(flight.engine, flight.parameters, flight.programme, t, steps, h)
    return end


@present_law.of(MujocoFlight)
@compiled
def present(flight: MujocoFlight, t: float) -> Motion:
    """The flight at its present time `t` [s]."""
    return motion_at(flight.engine, flight.parameters, flight.programme, t)


class MujocoKite:
    """A free rigid body; each line is exactly straight, or slack.

    `step` [s] is the longest step; 2 ms holds micrometres in any flight, 20 ms a tenth of
    a millimetre in a calm one.
    """

    name = "mujoco"
    rigs: tuple[Rig, ...] = (TWO_LINES,)

    def __init__(self, parameters: Parameters, step: float = DEFAULT_STEP) -> None:
        self.parameters, self.step, self.t = parameters, step, 0.0
        self._model, self._data, self._engine = build(parameters, step)

    def start(self, state: State, programme: Programme) -> None:
        """Puts the kite at `state` at t = 0 s."""
        self.t = 0.0
        put(self._engine, self.parameters, programme, 0.0, state)

    def at(self, state: State, control: Control, t: float) -> Instant:
        """The instant at `state`."""
        kept = self.snapshot()
        now = instant_at(self._engine, self.parameters, control, t, state)
        self.restore(kept)
        return now

    @property
    def state(self) -> State:
        """The present q and q̇."""
        return state_of(self.parameters, body_of(self._engine))

    def advance(self, programme: Programme, duration: float) -> None:
        """Flies on for `duration` [s]."""
        steps = max(1, ceil(duration / self.step - 1e-9))
        flown(self._engine, self.parameters, programme, self.t, steps, duration / steps)
        self.t += duration

    def motion(self, programme: Programme) -> Motion:
        """The present instant; raises FlightError where it is not finite."""
        return told(self.name, motion_at(self._engine, self.parameters, programme, self.t))

    def snapshot(self) -> Snapshot:
        """qpos, qvel, each line's switch and R f, and where the engine's solver starts from."""
        return Snapshot(self.t, tuple(np.concatenate(self._remembered()).tolist()))

    def restore(self, kept: Snapshot) -> None:
        """Back to a snapshot."""
        self.t, numbers = kept.t, np.array(kept.numbers)
        for array in self._remembered():
            array[:], numbers = numbers[: len(array)], numbers[len(array) :]

    def _remembered(self) -> tuple[NDArray[Any], ...]:
        """All that one step hands to the next; everything else is written anew."""
        e = self._engine
        return e.qpos, e.qvel, e.eq_active, e.softness, self._data.qacc_warmstart

    def trajectory(self, programme: Programme, times: list[float]) -> list[Motion]:
        """The motion at each of `times` [s] down to the ground, stepped from one to the next.

        Raises FlightError, with what was flown until then, where it is not finite.
        """

        def fly(end: float) -> None:
            steps = max(1, ceil((end - self.t) / self.step - 1e-9))
            where, h = (self._engine, self.parameters, programme), (end - self.t) / steps
            reached = flown_down(*where, self.t, steps, h)
            landed = above(self.parameters, body_of(self._engine)) < 0.0
            self.t = reached if landed else end

        return down_to_ground(self, fly, programme, times)

    def batch(self, programme: Programme, times: Array, touch: float, tolerance: float) -> Array:
        """Rows of `rows_at`; in the model's own steps, `tolerance` is for others."""
        flight = MujocoFlight(self._engine, self.parameters, programme, self.step)
        return rows_at(flight, self.parameters, times, touch, len(TWO_LINES.lines))
