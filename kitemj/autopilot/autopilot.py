"""The autopilot: sensors, phases and guidance between motion and stick."""

from math import nan

from kitemj.autopilot.follow import (
    follow,
    learn,
    length_of,
    nearest,
    nothing_learnt,
    stick_for,
)
from kitemj.autopilot.gains import Gains
from kitemj.autopilot.glide import glide_ratio
from kitemj.autopilot.hands import moved
from kitemj.autopilot.paths import path_of
from kitemj.autopilot.sphere import (
    ahead_of,
    azimuth_of,
    direction,
    elevation_of,
)
from kitemj.autopilot.truth import true_estimate
from kitemj.dynamics.motion import Motion
from kitemj.flight.live import Command
from kitemj.flight.pilot_settings import Guided, PilotSettings, TurnRateLaw
from kitemj.physics.parameters import Parameters


class Autopilot:
    """Flies by what [pilot] says; `guided` tells what it is at. Knows nothing of the wind."""

    def __init__(
        self, parameters: Parameters, settings: PilotSettings, law: TurnRateLaw | None = None
    ) -> None:
        """`law`: how the kite turns; None: as in the settings, else identified."""
        self._parameters, self.settings = parameters, settings
        self.law = law or settings.law or TurnRateLaw(0.29, -3.0, 0.4, 16.0, 2.8)
        self.gains = Gains(settings.crossover)
        self.path = path_of(settings.path, glide_ratio(parameters))
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
        return moved(wish, motion.control, limits)
