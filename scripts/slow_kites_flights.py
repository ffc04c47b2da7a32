"""Flights of kites that barely turn: held, swung, brought aside, caught; and their margins."""

from math import degrees, inf, log10, pi, radians
from random import Random
from typing import NamedTuple

import control
import numpy as np

from kitemj.autopilot.drift_design import DriftDesign, Sideways, drift_design
from kitemj.autopilot.drift_hold import DriftHold
from kitemj.autopilot.follow import Estimate
from kitemj.autopilot.truth import true_estimate
from kitemj.dynamics.formulation import make_model
from kitemj.dynamics.motion import Motion, State
from kitemj.equilibria.minimal import state_of
from kitemj.equilibria.trim import equilibria, trimmed
from kitemj.errors import FlightError
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.scenario import Scenario, Times
from kitemj.physics.compiled import Array
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters, StickLimits
from kitemj.physics.shaping import StickLaw
from kitemj.physics.steering import Sines
from kitemj.pilots.sight import sight
from kitemj.robustness.drift_loop import kite_answer, loop_gain
from kitemj.turning.hands import moved
from kitemj.turning.linear_law import in_still_air

NEARLY = 0.9
"""Of the way; who is so far has arrived."""
EVERY = 2
"""Ticks between measurements of a real kite, which has 50 a second."""
FREQUENCIES = np.geomspace(1e-3, 50.0, 4000)
"""rad/s; where margins are looked for."""
BACK = radians(1.0)
"""rad; a kite that stays so near the top is caught."""


class Held(NamedTuple):
    """A hold; deg of azimuth in the last minute, |δ| [rad], |δ̇| [rad/s], and how it ended."""

    rms: float
    largest: float
    stick: float
    rate: float
    ending: str


class Stand(NamedTuple):
    """Full stick from the top; deg, right positive.

    `after` [s]: nearly there; `nose`: farthest from up; `turning` [deg/s], largest.
    """

    azimuth: float
    elevation: float
    after: float
    nose: float
    turning: float


def aside(parameters: Parameters, azimuth: float) -> State:
    """Rest at the top, turned about z_E to `azimuth` [rad], right positive."""
    x, _ = trimmed(in_still_air(parameters))
    return State(Angles(float(x[0]) + azimuth, *map(float, x[1:4])), state_of(x).q_dot)


def flight_of(parameters: Parameters, start: State, model: str = "lagrange") -> SteeredFlight:
    """A flight that begins at `start`, lines even."""
    _, lines = trimmed(in_still_air(parameters))
    scenario = Scenario("slow", parameters, Sines(lines.ell), start, Times(1.0), False)
    return SteeredFlight(scenario, model)


def held(
    flight: SteeredFlight,
    azimuth: float | None,
    duration: float,
    noise: float = 0.0,
    design: DriftDesign | None = None,
) -> tuple[list[Motion], str]:
    """Motions under the hold, with `noise` [rad] of angles 50 times a second; how it ended."""
    parameters, random = flight.parameters, Random(1)
    pilot = DriftHold(parameters, azimuth, design or drift_design(parameters))
    motions, seen = [flight.result.motion], true_estimate(flight.result.motion)
    for i in range(round(duration / TICK)):
        now = motions[-1]
        if not noise or i % EVERY == 0:
            seen = noisy(true_estimate(now), noise, random)
        wish = pilot.wish(seen, now.control)
        try:
            result = flight.tick(moved(wish, now.control, parameters.stick))
        except FlightError as error:
            return motions, str(error)
        motions.append(result.motion)
        if result.departure:
            return motions, result.departure.limit.sentence
    return motions, ""


def noisy(seen: Estimate, noise: float, random: Random) -> Estimate:
    """Angles with errors of one standard deviation `noise` [rad]."""
    azimuth, heading = seen.azimuth + random.gauss(0, noise), seen.heading + random.gauss(0, noise)
    return seen._replace(azimuth=azimuth, heading=heading)


def measured(motions: list[Motion], azimuth: float, ending: str) -> Held:
    """What came of a hold at `azimuth` [rad]."""
    last = [m for m in motions if m.t > motions[-1].t - 60.0]
    off = np.degrees([sight(m).azimuth - azimuth for m in last])
    lines = np.abs([[m.control.delta, m.control.delta_dot] for m in motions]).max(axis=0)
    rms = float(np.sqrt(np.mean(off**2)))
    return Held(rms, float(np.abs(off).max()), float(lines[0]), float(lines[1]), ending)


def stick_swing(limits: StickLimits, omega: float) -> float:
    """Largest amplitude of δ [rad] that swings at `omega` [rad/s] within the hands' limits."""
    return float(min(limits.delta, limits.delta_dot / omega, limits.delta_ddot / omega**2))


def swing(kite: Sideways, limits: StickLimits, period: float) -> float:
    """Largest amplitude of azimuth [rad] in a swing of `period` [s], by the linear system."""
    omega = 2 * pi / period
    return float(abs(kite_answer(kite, omega)[0])) * stick_swing(limits, omega)


def swing_flown(parameters: Parameters, period: float) -> tuple[float, float]:
    """The same, flown, and the amplitude of elevation [rad]: in the last of some periods."""
    omega, steady = 2 * pi / period, in_still_air(parameters)
    x, lines = trimmed(steady)
    stick = Sines(lines.ell, 0.0, stick_swing(parameters.stick, omega), omega)
    count, kite = max(3, int(120.0 / period) + 1), make_model("lagrange", steady)
    kite.start(state_of(x), stick)
    times = [period * (count - 1 + i / 72) for i in range(73)]
    looks = np.array([sight(m)[:2] for m in kite.trajectory(stick, times)])
    across, up = np.ptp(looks, axis=0) / 2
    return float(across), float(up)


def stand(parameters: Parameters) -> Stand:
    """Full stick to the left hand's side, which drifts right, as quickly as hands may."""
    steady = in_still_air(parameters)
    there = equilibria(steady, None, -steady.stick.delta)[0]
    flight = flight_of(steady, aside(steady, 0.0))
    motions = [flight.tick(Command(-1.0, 0.0, StickLaw.ANGLE)).motion for _ in range(12000)]
    looks = np.array([sight(m) for m in motions])
    off = np.abs(looks[:, 0] + there.azimuth)
    away = np.nonzero(off > (1 - NEARLY) * abs(there.azimuth))[0]
    nose, turning = np.degrees(np.abs(looks[:, 2:]).max(axis=0))
    arrived = motions[min(int(away[-1]) + 1, len(motions) - 1)].t
    at = -degrees(there.azimuth), degrees(there.elevation)
    return Stand(*at, arrived, float(nose), float(turning))


def margins(design: DriftDesign) -> tuple[float, float, float, float, float]:
    """Gain [dB] up and down, phase [deg], delay [s], disk margin [1] of the loop at the lines."""
    loop = loop_gain(design, FREQUENCIES)
    turned = np.degrees(np.unwrap(np.angle(loop)))
    found = control.stability_margins((np.abs(loop), turned, FREQUENCIES), returnall=True)
    gains, phases, _, _, crossings, _ = map(np.atleast_1d, found)
    up = min((20 * log10(g) for g in gains if g > 1), default=inf)
    down = max((20 * log10(g) for g in gains if g < 1), default=-inf)
    phase = min(np.abs(phases), default=inf)
    later = np.radians(phases % 360.0) / crossings  # until the next encirclement
    # largest α of a symmetric disk (Seiler, Packard & Gahinet, IEEE Control Syst. 40 (2020) 78)
    disk = 1.0 / np.abs((1.0 - loop) / (1.0 + loop) / 2.0).max()
    return up, down, float(phase), float(min(later, default=inf)), float(disk)


def growing(design: DriftDesign) -> tuple[complex, Array]:
    """The least stable mode [1/s] and x (4,) [rad, rad/s] of it, 1 rad of azimuth at most."""
    values, modes = np.linalg.eig(design.sideways.A)
    i = int(np.argmax(values.real))
    seen = design.sideways.C[0] @ modes[:, i]
    return complex(values[i]), np.real(modes[:, i] / seen)


def caught(parameters: Parameters, within: float = radians(0.1)) -> tuple[float, str]:
    """Largest swing of the least stable mode [rad of azimuth] that is stopped, to `within`.

    And what ends the flight from a larger one; "" where it is the hands that are too slow.
    """
    design, x = drift_design(parameters), trimmed(in_still_air(parameters))[0]
    _, mode = growing(design)
    low, high, why = 0.0, radians(15.0), ""
    while high - low > within:
        middle, start = (low + high) / 2, x.copy()
        start[[0, 2, 4, 6]] += middle * mode
        flight = flight_of(parameters, state_of(start))
        motions, ending = held(flight, 0.0, 90.0, 0.0, design)
        last = [abs(sight(m).azimuth) for m in motions[-1000:]]
        if not ending and max(last) < BACK:
            low = middle
        else:
            high, why = middle, ending
    return low, why


def largest_gap(parameters: Parameters, models: tuple[str, ...], duration: float) -> float:
    """Largest distance [m] of the models, each under its own hold, from 10° aside."""
    paths = []
    for model in models:
        flight = flight_of(parameters, aside(parameters, radians(10.0)), model)
        motions, _ = held(flight, 0.0, duration)
        paths.append(np.array([m.body.p_G_E for m in motions]))
    return max(float(np.linalg.norm(a - paths[0], axis=1).max()) for a in paths[1:])
