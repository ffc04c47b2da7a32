"""The autopilot: sensors, phases and guidance between motion and stick."""

from math import hypot, nan, pi
from typing import NamedTuple

from kitemj.autopilot.design_margins import check_gain
from kitemj.autopilot.follow import Estimate, stick_for
from kitemj.autopilot.laps import laps
from kitemj.autopilot.memory import Kite, Memory
from kitemj.autopilot.nose import CLEAR, most_delta
from kitemj.autopilot.observer import Observer, SavedObserver
from kitemj.autopilot.phases import flown
from kitemj.autopilot.rehearse import rehearsed
from kitemj.autopilot.sketch import HandLimits, wind_felt
from kitemj.dynamics.motion import Motion
from kitemj.flight.equilibrium import equilibrium
from kitemj.flight.live import Command
from kitemj.flight.pilot_settings import Guided, PathSettings, PilotSettings, TurnRateLaw
from kitemj.paths.check_path import check_path, usual_path
from kitemj.paths.glide import glide_ratio
from kitemj.paths.path import path_of
from kitemj.paths.sphere import azimuth_of, direction, elevation_of
from kitemj.physics.parameters import Parameters
from kitemj.turning.gains import Gains
from kitemj.turning.hands import moved
from kitemj.turning.identify import identified_law

SLIP = 0.8
"""Of the largest sideslip angle, what the pilot asks for; gusts take the rest."""


class SavedAutopilot(NamedTuple):
    """An autopilot in the midst of a flight."""

    memory: Memory
    guided: Guided
    observer: SavedObserver


class Autopilot:
    """Flies by what [pilot] says; `guided` tells what it is at.

    What it knows of the wind it learns beforehand, in the steady wind of the parameters: how the
    kite turns, and how it flies its path. In flight it is told lines and angles only.
    """

    def __init__(
        self, parameters: Parameters, settings: PilotSettings, law: TurnRateLaw | None = None
    ) -> None:
        """`law`: how the kite turns; None: as in the settings, else identified.

        Raises InputError for a kite that does not turn, and a path that it cannot fly.
        """
        self._parameters, self.settings = parameters, settings
        self.law = law or settings.law or identified_law(parameters)
        self.gains = Gains(settings.crossover)
        check_gain(settings, self.gains, self.law)
        self.kite = kite_of(parameters, settings, self.law, self.gains)
        self.path = self.kite.path
        self._rehearsed = rehearsed(parameters, self.path, self.law, self.gains)
        self._observer = Observer(parameters, self.law, settings.sensors, settings.seed)
        self.restart(0.0)

    def restart(self, t: float) -> None:
        """Begins anew with the first phase, at time `t` [s]."""
        first = self.settings.phases[0]
        self.memory = Memory(0, first, t, t, 0.0, 0.0, self._rehearsed)
        self.guided = Guided(first, nan, nan, nan, nan, 0.0, t)
        self._observer.resume(SavedObserver(None, None))  # it looked away meanwhile

    def save(self) -> SavedAutopilot:
        """All that is remembered of the flight."""
        return SavedAutopilot(self.memory, self.guided, self._observer.save())

    def resume(self, saved: SavedAutopilot) -> None:
        """Back to a moment that `save` returned, to fly on to the same bits."""
        self.memory, self.guided, observer = saved
        self._observer.resume(observer)

    def command(self, motion: Motion) -> Command:
        """The stick, which asks for δ̈."""
        if motion.t < self.memory.t:
            self.restart(motion.t)
        seen, now = self._observer.look(motion), motion.control
        memory = self.memory._replace(t=motion.t, delta=now.delta, delta_dot=now.delta_dot)
        asked, self.memory = flown(self.kite, seen, memory)
        to, memory = asked.attractor, self.memory
        lap = laps(self.kite, memory) if memory.phase == "path" else memory.laps
        at = azimuth_of(to), elevation_of(to)
        now_at = asked.error, lap, *at, seen.twist
        self.guided = Guided(memory.phase, *now_at, self.guided.since)
        wish, most = stick_for(self.law, self.gains, seen, asked), self._most_delta(seen)
        wish = max(-most, min(most, wish))
        return moved(wish, now, self._parameters.stick)

    def _most_delta(self, seen: Estimate) -> float:
        """So that the sideslip angle stays within its limit."""
        inflow = (
            wind_felt(seen, self.kite.glide, self.kite.length)
            * direction(seen.azimuth, seen.elevation).x
        )
        return most_delta(seen, inflow, SLIP * self._parameters.limits.beta_max)


def kite_of(
    parameters: Parameters, settings: PilotSettings, law: TurnRateLaw, gains: Gains
) -> Kite:
    """What does not change in a flight. Raises InputError for a path that is none."""
    glide, size = glide_ratio(parameters), parameters.kite
    along = {"climb", "path"} & set(settings.phases)
    path = settings.path or (usual_path(parameters, law) if along else PathSettings())
    if settings.path:
        check_path(path, parameters, law)
    return Kite(
        settings,
        law,
        gains,
        path_of(path, glide),
        glide,
        parameters.lines.length,
        parameters.stick.delta,
        HandLimits(parameters.stick.delta_dot, parameters.stick.delta_ddot),
        CLEAR + hypot(size.span, size.chord) / 2,
        pi / 2 - equilibrium(parameters).gamma,
        parameters.limits.twist_max,
    )
