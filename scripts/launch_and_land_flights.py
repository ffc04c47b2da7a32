"""Flights by the autopilot from the ground at one edge of the window to the ground at another."""

from math import inf, nan, pi
from random import Random
from typing import NamedTuple

from guidance_flights import IDEAL
from kitemj.autopilot.autopilot import Autopilot
from kitemj.errors import FlightError
from kitemj.flight.limits import VALIDITY, departure_at
from kitemj.flight.live import TICK, SteeredFlight
from kitemj.flight.on_the_ground import launching
from kitemj.flight.pilot_settings import PhaseName, PilotSettings, SensorSettings
from kitemj.flight.scenario import Scenario, Times
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.steering import Sines, rest_ell
from kitemj.pilots.crash import FirstTouch
from kitemj.pilots.sight import sight

PHASES: tuple[PhaseName, ...] = ("launch", "hold", "land")
HOLD, LONGEST = 6.0, 90.0
"""s; how long it is held at the top, and of a flight at most."""


class Hop(NamedTuple):
    """A flight, all of it drawn from its `seed`."""

    seed: int
    kite: str = "sport"
    sensors: SensorSettings = IDEAL
    model: str = "lagrange"


class Hopped(NamedTuple):
    """What came of a flight.

    Started at `azimuth` [rad], to land on `side`; `launched`: the launch was over before the
    ground was met; `landed`: the ground was met while landing, at `speed` [m/s]; `twist` [turns]
    then; `pull` [N]: least of a line; `left`: phases with limits left in them; `ending`, in words.
    """

    hop: Hop
    wind: float
    azimuth: float
    side: str
    launched: bool
    landed: bool
    speed: float
    twist: float
    pull: float
    left: frozenset[tuple[str, str]]
    ending: str


def hop(given: Hop) -> Hopped:
    """Flies it: wind 5-8 m/s, from either side, to either side."""
    random = Random(given.seed)
    known = parameter_set(given.kite)
    wind, start_side = random.uniform(5.0, 8.0), random.choice((-1.0, 1.0))
    side = random.choice(("left", "right"))
    parameters = known._replace(wind=known.wind._replace(speed=wind))
    start = launching(
        parameters,
        start_side,
        random.uniform(0.0, 0.12),
        random.uniform(0.05, 0.25),
        random.uniform(0.7, 1.0),
    )
    rest = Sines(rest_ell(parameters.lines.length, parameters.kite.y_A))
    scenario = Scenario("hop", parameters, rest, start, Times(LONGEST), False)
    settings = PilotSettings(
        phases=PHASES, hold=HOLD, side=side, sensors=given.sensors, seed=given.seed
    )
    pilot, flight = Autopilot(parameters, settings), SteeredFlight(scenario, given.model)
    watch, first = FirstTouch(parameters), flight.result.motion
    phase, pull, left, ending = "start", inf, set(), f"not down after {LONGEST:g} s"
    for _ in range(round(LONGEST / TICK)):
        motion = flight.result.motion
        pull = min(pull, *motion.tensions)
        if departure := departure_at(parameters, motion, VALIDITY):
            left.add((phase, departure.limit.name))
        try:
            motion = flight.tick(pilot.command(motion)).motion
        except FlightError as error:
            ending = str(error)
            break
        phase = pilot.guided.phase
        if watch.watch(motion):
            ending = f"in {phase}: {watch.touch}"
            break
    touch, azimuth = watch.touch, sight(first).azimuth
    down = touch is not None and phase == "land"
    speed, twist = touch.speed if touch else nan, pilot.guided.twist / (2 * pi)
    told = phase not in ("start", "launch"), down, speed, twist, pull, frozenset(left), ending
    return Hopped(given, wind, azimuth, side, *told)
