"""The ladder: one scenario through three formulations, compared from the inside out.

accelerations -> tensions -> trajectories -> energy balance -> order of convergence. The three
share the forces of the air, the frames and the steering; what the ladder checks is what they
do not share: gravity, inertia, kinematics, the lines, the integrators.
"""

from math import isnan, nan
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.formulation import DEFAULT_STEP, MODELS, make_model
from kitemj.dynamics.motion import Motion, State
from kitemj.errors import FlightError
from kitemj.flight.agreement import imbalance, orders, relative, spatial_accelerations
from kitemj.flight.compare import TENSION_TOLERANCE, compare, position_gap
from kitemj.flight.restless import restless
from kitemj.flight.scenario import Scenario
from kitemj.flight.simulate import Simulation, simulate
from kitemj.physics.steering import control

REFERENCE = "lagrange"

ACCELERATION = {"newton-euler": 1e-9, "mujoco": 1e-6}
"""Relative (to at least 1 m/s², rad/s² or N). The first two differ by rounding only; the
engine's lines are softened by a force that is fed forward once it has settled."""
POSITION = {"newton-euler": 1e-7, "mujoco": 1e-6}
"""m (and rad). Adaptive integrators at rtol 1e-12 both; fixed steps of 2 ms."""
BALANCE = {"newton-euler": 1e-5, "mujoco": 1e-4}
"""Of the energy turned over, in steps of 2 ms: the error of Simpson's rule; and the force
with which the engine pulls a line back onto its length."""
ORDER = {"newton-euler": 3.0, "mujoco": 2.0}
"""Runge-Kutta's is four, and both show it in calm flight. In loops the engine's lines, held the
more stiffly the shorter the step (k = 1/(4 step)²), bring it down to two."""
ROUNDING = 1e-10
"""m; gaps below this are rounding on a long line and have no order."""
INSTANTS = 100
"""Moments of the flight at which accelerations are compared."""
WINDOW = 5.0
"""s; the stretch over which energy is balanced and the order measured."""
STEPS = (0.01, 0.005, 0.0025)
"""s; the steps between which the order is measured."""


class Rung(NamedTuple):
    """What was measured of `model`; `at_least`: the limit is to be reached, not kept below.

    Not a number: there was nothing to measure (a kite at rest has no order of convergence).
    """

    name: str
    model: str
    measured: float
    limit: float
    unit: str
    at_least: bool = False

    @property
    def holds(self) -> bool:
        """Whether the limit is kept."""
        if isnan(self.measured):
            return self.at_least
        return self.measured >= self.limit if self.at_least else self.measured <= self.limit


def ladder(scenario: Scenario, step: float = DEFAULT_STEP) -> list[Rung]:
    """Every other model (in steps of `step` [s]) against Lagrange's, rung by rung.

    A scenario that names no steering programme is flown with restless hands.
    """
    scenario = scenario if scenario.steered else restless(scenario)
    reference, instants = simulate(scenario, REFERENCE), _instants(scenario)
    rungs = []
    for model in reversed([name for name in MODELS if name != REFERENCE]):
        rungs += _at_instants(scenario, instants, model)
        rungs += _flown(scenario, reference, model, step)
    return rungs


def _limit(of: dict[str, float], model: str) -> float:
    """What a rung asks of `model`; of one that is not ours as much as of the engine."""
    return of.get(model, of["mujoco"])


def _instants(scenario: Scenario) -> list[tuple[float, State]]:
    """Times [s] and states of the reference flight."""
    kite = make_model(REFERENCE, scenario.parameters)
    kite.start(scenario.start, scenario.programme)
    found = [(0.0, kite.state)]
    for t in np.linspace(0.0, scenario.times.duration, INSTANTS)[1:].tolist():
        try:
            kite.trajectory(scenario.programme, [t])
        except FlightError:
            break
        if kite.t < t:  # it is on the ground
            break
        found.append((t, kite.state))
    return found


def _at_instants(scenario: Scenario, instants: list[tuple[float, State]], model: str) -> list[Rung]:
    """Accelerations and tensions from one and the same pose, velocity and control."""
    parameters, programme = scenario.parameters, scenario.programme
    kite, reference = make_model(model, parameters), make_model(REFERENCE, parameters)
    errors, tension_errors = [], []
    for t, state in instants:
        c = control(programme, t)
        right, met = reference.at(state, c, t), kite.at(state, c, t)
        a, alpha = spatial_accelerations(parameters, c, state, right.q_ddot)
        errors += [relative(met.a_G_E, a, 1.0), relative(met.omega_dot_B, alpha, 1.0)]
        tension_errors.append(relative(met.tensions, right.tensions, 1.0))
    limit = _limit(ACCELERATION, model)
    return [
        Rung("accelerations", model, float(np.max(errors)), limit, "relative"),
        Rung("tensions", model, float(np.max(tension_errors)), limit, "relative"),
    ]


def _flown(scenario: Scenario, reference: Simulation, model: str, step: float) -> list[Rung]:
    """Trajectories, energy balance and order of convergence."""
    gaps = compare(simulate(scenario, model, step), reference)
    balance = imbalance(scenario.parameters, every_step(scenario, model, step))
    order = min(orders(convergence(scenario, model), ROUNDING), default=nan)
    between = "between steps of 10 and 2.5 ms"
    return [
        Rung("position", model, gaps.position.value, _limit(POSITION, model), "m"),
        Rung("attitude", model, gaps.attitude.value, _limit(POSITION, model), "rad"),
        Rung("tension in flight", model, gaps.tension.value, TENSION_TOLERANCE, "N"),
        Rung("energy balance", model, balance, _limit(BALANCE, model), "of the energy turned over"),
        Rung("order", model, order, _limit(ORDER, model), between, at_least=True),
    ]


def every_step(scenario: Scenario, model: str, step: float) -> list[Motion]:
    """The motion after each step of the first `WINDOW` seconds: an odd number of them."""
    kite = make_model(model, scenario.parameters, step)
    kite.start(scenario.start, scenario.programme)
    motions = [kite.motion(scenario.programme)]
    for _ in range(2 * max(1, int(min(WINDOW, scenario.times.duration) / step / 2))):
        kite.advance(scenario.programme, step)
        motions.append(kite.motion(scenario.programme))
    return motions


def convergence(scenario: Scenario, model: str) -> list[float]:
    """Largest gap [m] to the reference within `WINDOW`, flown in each of `STEPS`."""
    parameters, programme = scenario.parameters, scenario.programme
    times = np.arange(0.1, min(WINDOW, scenario.times.duration) + 1e-9, 0.1).tolist()
    exact = make_model(REFERENCE, parameters)
    exact.start(scenario.start, programme)
    reference, gaps = exact.trajectory(programme, times), []
    for step in STEPS:
        kite, found = make_model(model, parameters, step), []
        kite.start(scenario.start, programme)
        for motion in reference:
            kite.advance(programme, motion.t - kite.t)
            found.append(position_gap(kite.motion(programme), motion))
        gaps.append(float(np.max(found)))
    return gaps
