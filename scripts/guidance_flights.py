"""Flights by the autopilot that are measured: laps of a path, and hundreds in gusts."""

from collections import deque
from math import acos, cos, degrees, inf, isfinite, pi, radians, sqrt
from random import Random
from typing import Literal, NamedTuple

import numpy as np

from kitemj.autopilot.autopilot import Autopilot
from kitemj.autopilot.follow import advanced, vector_at
from kitemj.dynamics.motion import Motion
from kitemj.errors import FlightError, InputError
from kitemj.flight.equilibrium import equilibrium
from kitemj.flight.gliding import gliding
from kitemj.flight.limits import GROUND, VALIDITY, departure_at
from kitemj.flight.live import TICK, SteeredFlight
from kitemj.flight.pilot_settings import PilotSettings, SensorSettings
from kitemj.flight.scenario import Scenario, Times
from kitemj.paths.check_path import usual_path
from kitemj.paths.sphere import direction, right_of
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Sines, rest_ell
from kitemj.physics.vectors import dot, minus
from kitemj.pilots.sight import sight
from kitemj.turning.identify import identified_law

LAPS, PATIENCE = 12, 150.0
"""Laps of a trial, and s until then at most."""
IDEAL = SensorSettings()
REAL = SensorSettings(rate=50.0, delay=0.05, noise=radians(1.0))
"""Of a real kite: 1° of noise, 50 measurements a second, 50 ms late."""


class Kite(NamedTuple):
    """A set, how many times as large, on lines of `length` [m]."""

    set: str
    size: float
    length: float


KITES = {
    "sport, 25 m": Kite("sport", 1.0, 25.0),
    "sport, 15 m": Kite("sport", 1.0, 15.0),
    "sport, 60 m": Kite("sport", 1.0, 60.0),
    "trainer (1.2 m), 22 m": Kite("trainer", 1.0, 22.0),
    "sport of 1.2 m, 15 m": Kite("sport", 0.6, 15.0),
    "sport of 3 m, 30 m": Kite("sport", 1.5, 30.0),
    "sport of 3 m, 60 m": Kite("sport", 1.5, 60.0),
}


class Trial(NamedTuple):
    """One flight that is measured.

    Its path is the usual one of its kind. `c1`: the law's over the kite's; `later`: how much of
    the kite's own delay is added.
    """

    kite: str
    wind: float
    path: str
    sensors: SensorSettings = IDEAL
    c1: float = 1.0
    later: float = 0.0
    model: str = "lagrange"
    seed: int = 1


class Result(NamedTuple):
    """What came of a trial; angles in deg, `ending` "" where it flew as long as was asked."""

    trial: Trial
    laps: float
    rms: float
    largest: float
    stick: float
    beta: float
    pull: float
    ending: str


def of(kite: Kite, wind: float) -> Parameters:
    """The set, scaled: areas by the square of the size, masses too (cloth), inertias its 4th."""
    known, s = parameter_set(kite.set), kite.size
    body = known.kite
    lengths = {name: s * getattr(body, name) for name in ("chord", "span", "x_A", "y_A", "z_A")}
    inertias = {
        name: s**4 * getattr(body, name)
        for name in ("inertia_x", "inertia_y", "inertia_z", "inertia_xz")
    }
    body = body._replace(mass=s**2 * body.mass, area=s**2 * body.area, **lengths, **inertias)
    return known._replace(
        kite=body,
        lines=known.lines._replace(length=kite.length),
        wind=known.wind._replace(speed=wind),
    )


def fly(trial: Trial) -> Result:
    """Flies it: from rest at the top to the path, and `LAPS` of it."""
    parameters = of(KITES[trial.kite], trial.wind)
    try:
        kind: Literal["lemniscate", "circle"]
        kind = "circle" if trial.path == "circle" else "lemniscate"
        path = usual_path(parameters, identified_law(parameters), kind)
        settings = PilotSettings(path=path, sensors=trial.sensors, seed=trial.seed)
        pilot = Autopilot(parameters, settings)
        if trial.c1 != 1.0:
            law = pilot.law._replace(c1=trial.c1 * pilot.law.c1, c2=trial.c1 * pilot.law.c2)
            pilot = Autopilot(parameters, settings, law)
    except InputError as error:
        return Result(trial, 0.0, inf, inf, inf, inf, -inf, str(error))
    return measured(trial, parameters, pilot)


def measured(trial: Trial, parameters: Parameters, pilot: Autopilot) -> Result:
    """What comes of the trial with this pilot."""
    flight = SteeredFlight(still(parameters), trial.model)
    late = round(trial.later * pilot.law.delay(pilot.law.airspeed) / TICK)
    seen = deque([flight.result.motion], late + 1)
    rows, first, ending = [], None, "not 12 laps in time"
    for _ in range(round(PATIENCE / TICK)):
        now = flight.result.motion
        command = pilot.command(seen[0]._replace(t=now.t, control=now.control))
        try:
            result = flight.tick(command)
        except FlightError as error:
            ending = str(error)
            break
        motion, guided = result.motion, pilot.guided
        seen.append(motion)
        if departure_at(parameters, motion, (GROUND,)):
            ending = f"on the ground at {motion.t:.1f} s"
            break
        if guided.phase != "path" or not isfinite(guided.error):
            continue
        first = guided.lap if first is None else first
        now = motion.control.delta, motion.air.beta, min(motion.tensions), guided.lap
        rows.append((off_path(pilot, motion), *now))
        if guided.lap - first >= LAPS:
            ending = ""
            break
    return summary(trial, np.array(rows).reshape(-1, 5), ending)


def still(parameters: Parameters, *place: float) -> Scenario:
    """A flight of which the lines rest: from the top, or gliding from (azimuth, elevation,
    heading) [rad]."""
    rest = Sines(rest_ell(parameters.lines.length, parameters.kite.y_A))
    if place:
        start = gliding(parameters, *place)
    else:
        start = gliding(parameters, 0.0, pi / 2 - equilibrium(parameters).gamma, 0.0)
    return Scenario("trial", parameters, rest, start, Times(PATIENCE), False)


def off_path(pilot: Autopilot, motion: Motion) -> float:
    """rad that G truly is off the path that is flown, where the pilot is on it; right positive."""
    seen = sight(motion)
    p, path = direction(seen.azimuth, seen.elevation), pilot.path
    place = advanced(path, pilot.memory.progress, p)
    ahead = vector_at(path, path.ahead, place)
    return dot(minus(p, vector_at(path, path.points, place)), right_of(p, ahead))


def summary(trial: Trial, rows: np.ndarray, ending: str) -> Result:
    """What the rows say: error, δ, β [rad], least pull [N], laps."""
    if not len(rows):
        return Result(trial, 0.0, inf, inf, inf, inf, -inf, ending or "never on the path")
    error, delta, beta, pull, lap = rows.T
    return Result(
        trial,
        float(lap[-1] - lap[0]),
        degrees(sqrt(float(np.mean(error**2)))),
        degrees(float(np.abs(error).max())),
        degrees(float(np.abs(delta).max())),
        degrees(float(np.abs(beta).max())),
        float(pull.min()),
        ending,
    )


class Gusty(NamedTuple):
    """A flight in gusts, all of it drawn from its `seed`."""

    seed: int
    kite: str = "sport, 25 m"
    sensors: SensorSettings = IDEAL
    model: str = "lagrange"
    seconds: float = 60.0


class Outcome(NamedTuple):
    """How a flight in gusts went: the first limit that it left, if any, when [s], by how much.

    `beyond`: in what part of the time it was beyond one; `rms` [deg] off the path; `place` [rad].
    """

    gusty: Gusty
    wind: float
    amplitude: float
    frequency: float
    place: tuple[float, float, float]
    limit: str
    t: float
    reading: str
    beyond: float
    rms: float


def gusts(gusty: Gusty) -> Outcome:
    """Flies it: wind 4.5-9 m/s, amplitude 0-0.3, 0.1-10 rad/s, from anywhere in the window."""
    random = Random(gusty.seed)
    wind, amplitude = random.uniform(4.5, 9.0), random.uniform(0.0, 0.3)
    frequency = 10.0 ** random.uniform(-1.0, 1.0)
    steady = of(KITES[gusty.kite], wind)
    place = somewhere(random, steady)
    blown = steady.wind._replace(gust_amplitude=amplitude, gust_frequency=frequency)
    parameters = steady._replace(wind=blown)
    settings = PilotSettings(sensors=gusty.sensors, seed=gusty.seed)
    pilot = Autopilot(steady, settings)
    flight = SteeredFlight(still(parameters, *place), gusty.model)
    limit, when, reading, beyond, errors = "", inf, "", 0, []
    ticks = round(gusty.seconds / TICK)
    for _ in range(ticks):
        try:
            result = flight.tick(pilot.command(flight.result.motion))
        except FlightError as error:
            limit, when, reading, beyond = "diverged", error.t, str(error), ticks
            break
        left = departure_at(parameters, result.motion, (GROUND, *VALIDITY))
        if left:
            beyond += 1
            if not limit or left.limit is GROUND:
                limit, when, reading = left.limit.name, left.t, left.reading
            if left.limit is GROUND:
                break
        if pilot.guided.phase == "path":
            errors.append(off_path(pilot, result.motion))
    rms = degrees(sqrt(float(np.mean(np.square(errors))))) if errors else inf
    drawn = gusty, wind, amplitude, frequency, place
    return Outcome(*drawn, limit, when, reading, beyond / ticks, rms)


def somewhere(random: Random, parameters: Parameters) -> tuple[float, float, float]:
    """Azimuth, elevation, heading [rad] of a start in the window, the nose level or above.

    Not lower than 25° up, nor farther from downwind than a kite at rest at the top, and not
    where a kite that flies so would be beyond a limit already.
    """
    farthest = pi / 2 - equilibrium(parameters).gamma
    while True:
        azimuth, elevation = random.uniform(-1.1, 1.1), random.uniform(radians(25.0), farthest)
        heading = random.uniform(-pi / 2, pi / 2)
        if acos(cos(azimuth) * cos(elevation)) > farthest:
            continue
        start = SteeredFlight(still(parameters, azimuth, elevation, heading), "lagrange")
        if departure_at(parameters, start.result.motion) is None:
            return azimuth, elevation, heading
