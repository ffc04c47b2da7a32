"""The autopilot: sensors, phases and guidance between motion and stick."""

from math import nan

from kitemj.autopilot.follow import Estimate, follow, nearest, place_of, stick_for
from kitemj.autopilot.paths import path_of
from kitemj.autopilot.sphere import ahead_of, course, direction, tangential
from kitemj.dynamics.motion import Motion
from kitemj.flight.live import Command
from kitemj.flight.pilot_settings import Guided, PilotSettings, TurnRateLaw
from kitemj.physics.parameters import Parameters
from kitemj.physics.shaping import StickLaw
from kitemj.physics.vectors import Vector, norm, times
from kitemj.pilots.sight import sight

ACTUATOR, DAMPING = 15.0, 0.8
"""rad/s, 1; the hands follow the wished δ like a damped spring, within their limits."""
GLIDE = 3.6


class Autopilot:
    """Flies by what [pilot] says; `guided` tells what it is at. Knows nothing of the wind."""

    def __init__(
        self, parameters: Parameters, settings: PilotSettings, law: TurnRateLaw | None = None
    ) -> None:
        """`law`: how the kite turns; None: as in the settings, else identified."""
        self._parameters, self.settings = parameters, settings
        self.law = law or settings.law or TurnRateLaw(0.33, 0.0, 0.3, 16.0, 2.8)
        self.path = path_of(settings.path, GLIDE)
        self.guided = Guided(settings.phases[0], nan, nan, nan, nan, 0.0)
        self._progress = nan

    def command(self, motion: Motion) -> Command:
        """The stick, which asks for δ̈."""
        seen = true_estimate(motion)
        p = direction(seen.azimuth, seen.elevation)
        if self._progress != self._progress:
            self._progress = nearest(self.path, p, ahead_of(p, seen.course))
        lead = self.law.delay(max(seen.airspeed, 1.0)) + 2 * DAMPING / ACTUATOR
        quick = self.settings.crossover / lead
        look_ahead = max(0.05, 2.0 * seen.speed / quick)
        asked = follow(self.path, seen, self._progress, look_ahead, lead, quick)
        self._progress = asked.progress
        lap = asked.progress / (self.path.spacing * len(self.path.points))
        self.guided = Guided("path", asked.error, lap, *place_of(asked.attractor), seen.twist)
        limits = self._parameters.stick
        wish = stick_for(self.law, seen, asked, 0.3)
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
