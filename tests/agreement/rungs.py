"""The rungs of the ladder, as questions to one formulation; the answer is the largest error.

Each is put to the shipped models and, with the same tolerances, to copies with a fault.
"""

import numpy as np

from kitemj.dynamics.lagrange_kite import LagrangeKite
from kitemj.dynamics.motion import State, attachment_E, attachment_velocity_E
from kitemj.flight.agreement import EIGHTH_ORDER, imbalance, orders, relative
from kitemj.flight.compare import position_gap
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Segment, Sines, control, line_motion
from kitemj.physics.vectors import dot, norm
from tests.agreement.formulations import Formulation, shipped
from tests.support import LAKSA, LAKSA_STEERING, SPORT, WEATHER, Case, aloft, rest

# what each formulation is held against: never itself
AGAINST = {"lagrange": "newton-euler", "newton-euler": "lagrange", "mujoco": "lagrange"}

MOTION = 1e-9
"""m, m/s, rad/s; rounding on 200 m is 3e-14, differences in time cost four digits of that."""
ACCELERATION = {"lagrange": 1e-9, "newton-euler": 1e-9, "mujoco": 1e-6}
"""Relative; rounding in two formulations; the engine's softness after four evaluations."""
TENSION = ACCELERATION
"""Relative, of both tensions together."""
TRAJECTORY = {"lagrange": 1e-6, "newton-euler": 1e-8, "mujoco": 2e-7}
"""m after 0.4 s of steps of 2 ms in a nervous flight; ten times what was measured."""
BALANCE = {"lagrange": 2e-6, "newton-euler": 2e-6, "mujoco": 2e-4}
"""Of the energy turned over; ten times what was measured."""
ORDER = 3.0
"""Of four; a force or a line taken at a wrong time leaves one or two."""

STEP = 0.002
"""s; the program's default."""
FLIGHT = 0.4
"""s; long enough for every error of the first order to show."""
NERVOUS = SPORT._replace(wind=WEATHER._replace(speed=10.0))
SWINGS = Sines(rest(NERVOUS), 0.05, 0.1, 3.0, 0.3, 2.0)
START = State(aloft(NERVOUS, -0.1).q, Angles(0.03, 0.02, -0.3, 0.2))  # no line goes slack

REFERENCE_CASE = 1.0
"""s of the case that LAKSA flew, over which the order is measured."""
COARSE = (0.02, 0.01, 0.005)
"""s; the steps between which it is measured."""


def motion(formulation: Formulation, cases: list[Case]) -> float:
    """Largest error of pose, velocity (also as the pose's own change), and lines' L± and L̇±."""
    other, errors = shipped(AGAINST[formulation.name]), []
    for case in cases:
        body, right = formulation.body(case), other.body(case)
        errors += [np.abs(np.subtract(a, b)).max() for a, b in zip(body, right, strict=True)]
        v, omega = _drift(formulation, case)
        errors += [np.abs(v - body.v_G_E).max(), np.abs(omega - body.omega_B).max()]
        for side, (length, rate) in zip((1.0, -1.0), _lines(formulation, case), strict=True):
            line = line_motion(case.parameters.kite.y_A, case.segment.control, side)
            errors += [abs(length - line.length), abs(rate - line.rate)]
    return largest(errors)


def largest(errors: list[float]) -> float:
    """The largest; not a number if one of them is not (``max`` would pass over it)."""
    return float(np.max(errors))


def _drift(formulation: Formulation, case: Case) -> tuple[np.ndarray, np.ndarray]:
    """d/dt of the position, and the body rates that d/dt of the attitude means."""
    h, v, R_dot = 0.005, np.zeros(3), np.zeros((3, 3))

    def pose(s: float) -> tuple[np.ndarray, np.ndarray]:
        q = Angles(*(a + s * b for a, b in zip(case.state.q, case.state.q_dot, strict=True)))
        moved = Segment(0.0, control(case.segment, s))
        body = formulation.body(Case(case.parameters, State(q, case.state.q_dot), moved))
        return np.array(body.p_G_E), np.array(body.R_BE)

    for k, weight in enumerate(EIGHTH_ORDER, start=1):
        (p_after, R_after), (p_before, R_before) = pose(k * h), pose(-k * h)
        v += weight * (p_after - p_before) / h
        R_dot += weight * (R_after - R_before) / h
    spin = R_dot @ pose(0.0)[1].T  # = -[ω]x
    return v, np.array((spin[1, 2], spin[2, 0], spin[0, 1]))


def _lines(formulation: Formulation, case: Case) -> list[tuple[float, float]]:
    """Length [m] and rate [m/s] of both lines, as the engine measures them if there is one."""
    body = formulation.body(case)
    if formulation.name == "mujoco":
        engine = formulation.kite(case.parameters)._engine
        return list(zip(engine.ten_length, engine.ten_velocity, strict=True))
    lines = []
    for side in (1.0, -1.0):
        A = attachment_E(case.parameters, body, side)
        v = attachment_velocity_E(case.parameters, body, side)
        lines.append((norm(A), dot(A, v) / norm(A)))
    return lines


def accelerations(formulation: Formulation, cases: list[Case]) -> float:
    """a_G and ω̇, relative to the other model's."""
    other, errors = shipped(AGAINST[formulation.name]), []
    for case in cases:
        met, right = formulation.at(case), other.at(case)
        errors.append(relative(met.a_G_E, right.a_G_E))
        errors.append(relative(met.omega_dot_B, right.omega_dot_B))
    return largest(errors)


def tensions(formulation: Formulation, cases: list[Case]) -> float:
    """Both tensions, relative to the other model's."""
    other = shipped(AGAINST[formulation.name])
    pairs = [(formulation.at(case).tensions, other.at(case).tensions) for case in cases]
    return largest([relative(met, right) for met, right in pairs])


def trajectory(formulation: Formulation) -> float:
    """Gap [m] to Lagrange's adaptive flight after `FLIGHT` seconds."""
    return _gap(formulation, NERVOUS, START, SWINGS, FLIGHT, STEP)


def _gap(
    formulation: Formulation,
    parameters: Parameters,
    start: State,
    programme: Sines,
    duration: float,
    step: float,
) -> float:
    exact = LagrangeKite(parameters)
    exact.start(start, programme)
    [right] = exact.trajectory(programme, [duration])
    kite = formulation.kite(parameters, step)
    kite.start(start, programme)
    kite.advance(programme, duration)
    return position_gap(kite.motion(programme), right)


def balance(formulation: Formulation) -> float:
    """Energy that neither the air nor the lines account for, part of what was turned over."""
    kite = formulation.kite(NERVOUS, STEP)
    kite.start(START, SWINGS)
    motions = [kite.motion(SWINGS)]
    for _ in range(round(FLIGHT / STEP)):
        kite.advance(SWINGS, STEP)
        motions.append(kite.motion(SWINGS))
    return imbalance(NERVOUS, motions)


def order(formulation: Formulation) -> float:
    """The lowest order of convergence between steps of 20, 10 and 5 ms in the reference case."""
    gaps = [
        _gap(formulation, LAKSA, aloft(LAKSA), LAKSA_STEERING, REFERENCE_CASE, step)
        for step in COARSE
    ]
    return min(orders(gaps))


def holds(rung: str, formulation: Formulation, cases: list[Case]) -> bool:
    """Whether one rung, by name, bears the formulation; not if the answer is not a number."""
    name = formulation.name
    if rung == "motion":
        return motion(formulation, cases) <= MOTION
    if rung == "accelerations":
        return accelerations(formulation, cases) <= ACCELERATION[name]
    if rung == "tensions":
        return tensions(formulation, cases) <= TENSION[name]
    if rung == "trajectory":
        return trajectory(formulation) <= TRAJECTORY[name]
    if rung == "balance":
        return balance(formulation) <= BALANCE[name]
    return order(formulation) >= ORDER


RUNGS = ("motion", "accelerations", "tensions", "trajectory", "balance", "order")


def climb(formulation: Formulation, cases: list[Case]) -> str:
    """The first rung that breaks; '' where all hold."""
    return next((rung for rung in RUNGS if not holds(rung, formulation, cases)), "")
