"""A path flown beforehand, by the Lagrangian kite in its steady wind, to know how it turns.

The law of turning is short, and a path says how the nose turns as if the kite had no mass. What is
missing repeats in each lap, and is learnt here before the first.
"""

from kitemj.autopilot.follow import (
    follow,
    learn,
    length_of,
    nothing_learnt,
    stick_for,
    vector_at,
)
from kitemj.autopilot.truth import true_estimate
from kitemj.errors import FlightError
from kitemj.flight.gliding import gliding
from kitemj.flight.limits import touches_ground
from kitemj.flight.live import TICK, SteeredFlight
from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.flight.scenario import Scenario, Times
from kitemj.paths.path import Path
from kitemj.paths.sphere import azimuth_of, course, elevation_of
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Sines, rest_ell
from kitemj.turning.gains import Gains
from kitemj.turning.hands import moved

LAPS = 10
"""Each takes away half of what is missing, or more."""
LONGEST = 90.0
"""s; a path that is not flown so often by then is learnt as far as it went."""
LEARNING = 0.8
"""Of what errors asked for in a lap; no noise is learnt here."""


def rehearsed(parameters: Parameters, path: Path, law: TurnRateLaw, gains: Gains) -> Array:
    """What is learnt of `path` in `LAPS`, as `kitemj.autopilot.follow.learn` has it.

    Nothing where the kite does not stay on the path: the flight itself must then show it.
    """
    flight = on_path(parameters, path)
    gains = gains._replace(learning=LEARNING)
    progress, learnt = 0.0, nothing_learnt()
    full = parameters.stick.delta
    try:
        for _ in range(round(LONGEST / TICK)):
            motion = flight.result.motion
            seen = true_estimate(motion)
            asked = follow(path, law, gains, seen, progress, learnt, full)
            learnt = learn(path, law, gains, seen, asked, asked.progress - progress, learnt)
            progress = asked.progress
            if progress > LAPS * length_of(path):
                return learnt
            wish = stick_for(law, gains, seen, asked)
            result = flight.tick(moved(wish, motion.control, parameters.stick))
            if touches_ground(parameters, result.motion):
                return nothing_learnt()
    except FlightError:
        return nothing_learnt()
    return learnt


def on_path(parameters: Parameters, path: Path) -> SteeredFlight:
    """A flight of the Lagrangian kite that begins on the path, along it."""
    p, ahead = vector_at(path, path.points, 0.0), vector_at(path, path.ahead, 0.0)
    heading = course(p, ahead)
    start = gliding(parameters, azimuth_of(p), elevation_of(p), heading)
    rest = Sines(rest_ell(parameters.lines.length, parameters.kite.y_A))
    scenario = Scenario("rehearsal", parameters, rest, start, Times(LONGEST), False)
    return SteeredFlight(scenario, "lagrange")
