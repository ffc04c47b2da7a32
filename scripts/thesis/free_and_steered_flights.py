"""Section 3.2: the flights without control and under δ = δ₀ sin ωt, at any C_lβ."""

from functools import cache
from math import atan2, degrees, radians

import numpy as np

from kitemj.dynamics.batch import BETA
from kitemj.dynamics.formulation import make_model
from kitemj.dynamics.ground import TOUCH
from kitemj.equilibria.cycle import Cycle, cycle
from kitemj.equilibria.minimal import state_of
from kitemj.equilibria.modes import crossings
from kitemj.equilibria.trim import trimmed
from kitemj.equilibria.vary import with_value
from kitemj.physics.compiled import Array as Rows
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import rest_ell
from thesis.forced_response import SineSteering

LENGTHS = (80.0, 200.0)  # m
PARAFOIL, THESIS, VORTEX_LATTICE = -0.037, -0.1, -0.49
"""1/rad; C_lβ as section 2.2 quotes it from parafoils, that of Table 2, and of a vortex lattice."""
SLOW, FAST = SineSteering(0.1, 0.1), SineSteering(0.03, 0.6)
"""The most that |δ| < 0.1 rad and |δ̇| < 0.01 rad/s allow; near the kite's own swing."""
NO_STEERING = SineSteering(0.0, 0.1)
AMPLITUDES = (0.02, 0.05, 0.1)  # rad
OMEGAS = (0.1, 0.3, 0.6)  # rad/s
START_PHI = radians(5.0)
"""rad; φ at the start of a free flight."""
DURATION, TRANSIENT_END = 600.0, 470.0
"""s; a flight, and from when on it is taken for what stays."""
SAMPLE_TIME = 0.1  # s
TOLERANCE = 1e-8
"""Of a step, in rad and rad/s; β is then known to 1e-5°."""
SETTLED = 50.0
"""s; after which only the growing mode is left to see."""


def parameters_at(length: float, cl_beta: float) -> Parameters:
    """The set thesis with these lines [m] and this C_lβ [1/rad]."""
    lines = with_value(parameter_set("thesis"), "lines.length", length)
    return with_value(lines, "aero.Cl_beta", cl_beta)


@cache
def flight_rows(
    length: float,
    cl_beta: float,
    steering: SineSteering,
    phi: float,
    tolerance: float = TOLERANCE,
) -> Rows:
    """A flight from the equilibrium turned by `phi` [rad]: a row of a batch every `SAMPLE_TIME`."""
    parameters = parameters_at(length, cl_beta)
    state = state_of(trimmed(parameters)[0])
    state = state._replace(q=state.q._replace(phi=state.q.phi + phi))
    kite, programme = make_model("lagrange", parameters), steering.programme(parameters)
    kite.start(state, programme)
    times = np.arange(0.0, DURATION + SAMPLE_TIME / 2, SAMPLE_TIME)
    return kite.batch(programme, times, TOUCH, tolerance)


def steady_rows(length: float, cl_beta: float, steering: SineSteering) -> Rows:
    """A flight from `TRANSIENT_END` to `DURATION` s; no rows where it met the ground before."""
    return flight_rows(length, cl_beta, steering, 0.0 if steering.delta else START_PHI)[
        round(TRANSIENT_END / SAMPLE_TIME) :
    ]


def loss_of_stability(length: float) -> float:
    """C_lβ [1/rad] at which the free flight loses its stability."""
    [crossing] = crossings(parameters_at(length, THESIS), "aero.Cl_beta", -0.6, 0.0)
    return crossing.value


@cache
def cycle_at(length: float, cl_beta: float) -> Cycle:
    """The cycle that the kite flies by itself there."""
    return cycle(parameters_at(length, cl_beta))


def measured_growth(length: float, cl_beta: float) -> float:
    """Growth [1/s] of the peaks of |β| in a flight that begins 1e-8 rad to the side.

    Between `SETTLED`, when all other modes have died out, and 1e-3 rad, where the air is no
    longer felt as linear.
    """
    beta = np.abs(flight_rows(length, cl_beta, NO_STEERING, 1e-8, 1e-13)[:, BETA])[
        round(SETTLED / SAMPLE_TIME) :
    ]
    beta = beta[: int(np.argmax(beta > 1e-3)) or None]
    top = 1 + np.flatnonzero((beta[1:-1] > beta[:-2]) & (beta[1:-1] >= beta[2:]))
    bend = beta[top - 1] - 2 * beta[top] + beta[top + 1]
    heights = beta[top] - (beta[top - 1] - beta[top + 1]) ** 2 / (8 * bend)  # of parabolas
    return float(np.polyfit(top * SAMPLE_TIME, np.log(heights), 1)[0])


def start_beta(length: float, steering: SineSteering) -> float:
    """|β| [°] of the kite at t = 0: at rest in q, but with lines that move at once."""
    parameters = parameters_at(length, THESIS)
    sideways = rest_ell(length, parameters.kite.y_A) * steering.delta * steering.omega
    return degrees(atan2(sideways, parameters.wind.speed))
