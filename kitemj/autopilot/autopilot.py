"""The autopilot: sensors, phases and guidance between motion and stick."""

from math import nan

from kitemj.autopilot.follow import (
    Estimate,
    follow,
    learn,
    length_of,
    nearest,
    nothing_learnt,
    stick_for,
)
from kitemj.autopilot.gains import ACTUATOR, DAMPING, Gains
from kitemj.autopilot.paths import path_of
from kitemj.autopilot.sphere import (
    ahead_of,
    azimuth_of,
    course,
    direction,
    elevation_of,
    tangential,
)
from kitemj.dynamics.motion import Motion
from kitemj.flight.live import Command
from kitemj.flight.pilot_settings import Guided, PilotSettings, TurnRateLaw
from kitemj.physics.parameters import Parameters
from kitemj.physics.shaping import StickLaw
from kitemj.physics.vectors import Vector, norm, times
from kitemj.pilots.sight import sight

GLIDE = 3.6


class Autopilot:
    """Flies by what [pilot] says; `guided` tells what it is at. Knows nothing of the wind."""

    def __init__(
        self, parameters: Parameters, settings: PilotSettings, law: TurnRateLaw | None = None
    ) -> None:
        """`law`: how the kite turns; None: as in the settings, else identified."""
        self._parameters, self.settings = parameters, settings
        self.law = law or settings.law or TurnRateLaw(0.29, -3.0, 0.4, 16.0, 2.8)
        self.gains = Gains(settings.crossover)
        self.path = path_of(settings.path, GLIDE)
        self.guided = Guided(settings.phases[0], nan, nan, nan, nan, 0.0)
        self._progress, self._learnt = nan, nothing_learnt()

    def command(self, motion: Motion) -> Command:
        """The stick, which asks for δ̈."""
        seen, limits = true_estimate(motion), self._parameters.stick
        path, law, gains, before = self.path, self.law, self.gains, self._progress
        if before != before:
            p = direction(seen.azimuth, seen.elevation)
            before = nearest(path, p, ahead_of(p, seen.course))
        asked = follow(path, law, gains, seen, before, self._learnt, limits.delta)
        self._learnt = learn(path, law, gains, seen, asked, asked.progress - before, self._learnt)
        self._progress = asked.progress
        lap, to = asked.progress / length_of(path), asked.attractor
        self.guided = Guided("path", asked.error, lap, azimuth_of(to), elevation_of(to), seen.twist)
        wish = stick_for(law, gains, seen, asked)
        wish = max(-limits.delta, min(limits.delta, wish))
        now = motion.control
        pull = ACTUATOR**2 * (wish - now.delta) - 2 * DAMPING * ACTUATOR * now.delta_dot
        part = pull / limits.delta_ddot
        return Command(max(-1.0, min(1.0, part)), 0.0, StickLaw.ACCELERATION)


def true_estimate(motion: Motion) -> Estimate:
    """What a pilot without errors believes; in place of sensors and observer."""
    seen, g, v = sight(motion), motion.body.p_G_E, motion.body.v_G_E
    length = norm(g)
    p = Vector(-g.x / length, -g.y / length, -g.z / length)
    across = tangential(p, Vector(-v.x / length, -v.y / length, -v.z / length))
    speed = norm(across)
    return Estimate(
        seen.azimuth,
        seen.elevation,
        speed,
        course(p, times(1.0 / max(speed, 1e-9), across)),
        seen.heading,
        seen.turning,
        motion.air.speed,
        0.0,
    )
