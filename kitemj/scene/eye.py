"""The eye of a view: where it is, from one motion to the next."""

from collections.abc import Callable
from math import exp
from typing import Any, NamedTuple

from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.physics.parameters import Parameters
from kitemj.scene.views import (
    CAMERAS,
    Camera,
    ChaseAim,
    PilotAim,
    chase_aim,
    chase_camera,
    first_orbit,
    orbiting,
    pilot_aim,
    pilot_camera,
)

GAP = 0.5
"""s; after a longer time without a look there is nothing to follow."""


class Follower(NamedTuple):
    """How a view follows: what it aims at, and the camera of an aim.

    Each number of the aim has its own of `rates` [1/s], of critical damping, and of `leads`: 1
    keeps up with a steady motion, 0 lags 2/rate behind it.
    """

    aim: Callable[[Parameters, Motion], Any]
    camera: Callable[[Parameters, Any], Camera]
    rates: Any
    leads: Any


FOLLOWERS = {
    "pilot": Follower(pilot_aim, pilot_camera, PilotAim(2.5, 4.0, 1.0), PilotAim(0.5, 1.0, 0.0)),
    "chase": Follower(chase_aim, chase_camera, ChaseAim(6.0, 6.0, 6.0), ChaseAim(1.0, 1.0, 1.0)),
}


class Past(NamedTuple):
    """Where a view was at `t` [s]: what it aimed at, where it stood, and how fast that moved.

    `speed` is None at a first look.
    """

    t: float
    aim: Any
    place: Any
    speed: Any


class Eye:
    """Looks at motions in their order; each view is seen as from the place that it keeps.

    It is a function of the motions alone, by their times: a pause stands still, slow motion is
    slow. A flight that is shown out of order, or a view that was not looked from, has no past.
    """

    def __init__(self, parameters: Parameters) -> None:
        self._parameters, self._orbit = parameters, first_orbit(parameters)
        self._past: dict[str, Past] = {}

    def look(self, motion: Motion, view: str) -> Camera:
        """The camera of `view`, "orbit" or a name of `CAMERAS`, for `motion`."""
        if view == "orbit":
            return orbiting(self._parameters, motion, self._orbit)
        follower = FOLLOWERS.get(view)
        if follower is None:
            return CAMERAS[view](self._parameters, motion)
        aim = follower.aim(self._parameters, motion)
        now = _followed(self._past.get(view), follower, motion.t, aim)
        self._past[view] = now
        return follower.camera(self._parameters, now.place)

    def turn(self, d_azimuth: float, d_elevation: float) -> None:
        """Turns the orbit: to the right and up by angles in rad."""
        self._orbit = self._orbit.turned(d_azimuth, d_elevation)

    def zoom(self, factor: float) -> None:
        """Goes `factor` times nearer on the orbit; InputError for a factor that is not > 0."""
        if not factor > 0:
            raise InputError(f"zoom must be by a factor > 0, got {factor:g}")
        self._orbit = self._orbit.zoomed(factor, self._parameters)


def _followed(past: Past | None, follower: Follower, t: float, aim: Any) -> Past:
    """Where the view is at `t` [s], which now aims at `aim`."""
    if past is not None and t == past.t and aim == past.aim:
        return past
    if past is None or not 0.0 < t - past.t <= GAP:
        return Past(t, aim, aim, None)
    dt, moved = t - past.t, []
    for i, (rate, lead) in enumerate(zip(follower.rates, follower.leads, strict=True)):
        drift = (aim[i] - past.aim[i]) / dt
        speed = past.speed[i] if past.speed else lead * drift  # no running after a first look
        moved.append(damped(past.place[i], speed, past.aim[i], drift, rate, lead, dt))
    places, speeds = (type(aim)(*numbers) for numbers in zip(*moved, strict=True))
    return Past(t, aim, places, speeds)


def damped(
    place: float,
    speed: float,
    aim: float,
    drift: float,
    rate: float,
    lead: float,
    dt: float,
) -> tuple[float, float]:
    """(place, speed) after `dt` [s] of a critically damped oscillator that follows an aim.

    place, speed: of the follower, at the start
    aim, drift: where the aim is at the start, and how fast it moves, evenly
    rate: 1/s, both poles at -rate
    lead: of the aim's speed, how much is felt: 1 follows an even motion without a lag
    dt: s

    The exact solution of x'' = rate² (a - x) + 2 rate (lead a' - x'), so that steps of any size
    agree.
    """
    lag = 2 * (1 - lead) * drift / rate
    gap, closing = place - (aim - lag), speed - drift
    pull, fade = closing + rate * gap, exp(-rate * dt)
    end = aim + drift * dt - lag
    return end + (gap + pull * dt) * fade, drift + (closing - rate * pull * dt) * fade
