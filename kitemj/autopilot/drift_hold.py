"""Holds and parks a kite that drifts away from the hand that pulls, and barely turns."""

from math import degrees, nan, pi

import numpy as np

from kitemj.autopilot.drift_design import QUICK, DriftDesign, drift_design
from kitemj.autopilot.follow import Estimate
from kitemj.autopilot.sensors import Sensors
from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.flight.equilibrium import equilibrium
from kitemj.flight.live import TICK, Command
from kitemj.flight.pilot_settings import Guided, PilotSettings
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control
from kitemj.turning.gains import ACTUATOR
from kitemj.turning.hands import moved
from kitemj.turning.linear_law import in_still_air

AHEAD = QUICK / ACTUATOR**2
"""s; a wish so far ahead of the hands moves them at the rate that is wanted."""
SPARE = 0.8
"""Of full stick, what a point that is held may need; the rest is for gusts."""


class DriftHold:
    """The stick of a hold at `azimuth` [rad], right positive; None: parked at the top.

    To be asked every tick. It believes where the kite is by the linear system, which is told the
    lines as they really move: so nothing winds up when the hands are at a limit.
    """

    def __init__(
        self,
        parameters: Parameters,
        azimuth: float | None = 0.0,
        design: DriftDesign | None = None,
    ) -> None:
        """Raises InputError for an azimuth out of reach; `design`: None for that of the set."""
        self.limits = parameters.stick
        self.design = design or drift_design(parameters)
        self.azimuth = azimuth
        check_reach(parameters, self.design, azimuth)
        self.restart()

    def restart(self) -> None:
        """Knows nothing of the kite."""
        self._x: Array = np.zeros(6)
        self._last: Control | None = None

    @property
    def wind(self) -> float:
        """Where the wind is believed to blow to, azimuth [rad]."""
        return float(self._x[4])

    def wish(self, seen: Estimate, control: Control) -> float:
        """The wished δ [rad]."""
        self._believe(np.array([seen.azimuth, seen.heading]), control)
        now, limits = self.design, self.limits
        most = SPARE * limits.delta
        rest = 0.0 if self.azimuth is None else (self.azimuth - self.wind) / now.azimuth
        rest = max(-most, min(most, rest))
        z = np.array([*self._x[:4] - rest * now.rest, control.delta - rest, control.delta_dot])
        rate = max(-limits.delta_dot, min(limits.delta_dot, -float(now.K @ z)))
        return max(-limits.delta, min(limits.delta, control.delta + AHEAD * rate))

    def _believe(self, seen: Array, now: Control) -> None:
        """The kite a tick later, and corrected by what is seen of it."""
        kite = self.design.sideways
        if self._last is None:
            self._x[:4] = now.delta * self.design.rest
            first = seen - kite.C @ self._x[:4] - kite.D @ np.array([now.delta, 0.0, 0.0])
            # off to the side, not in a wind that comes from there
            self._x[0] += first[0] / kite.C[0, 0]
        else:
            last, ddot = self._last, (now.delta_dot - self._last.delta_dot) / TICK
            z = np.array([*self._x[:4], last.delta, last.delta_dot])
            self._x[:4] = (self.design.later @ z + self.design.moved * ddot)[:4]
        inputs = np.array([now.delta, now.delta_dot, 0.0])
        believed = kite.C @ self._x[:4] + kite.D @ inputs + self._x[4:]
        self._x = self._x + self.design.L @ (seen - believed)
        self._last = now


def reach(parameters: Parameters, design: DriftDesign) -> float:
    """How far to each side [rad] a point can be held, with some stick to spare."""
    return abs(design.azimuth) * SPARE * parameters.stick.delta


def check_reach(parameters: Parameters, design: DriftDesign, azimuth: float | None) -> None:
    """Raises InputError where it cannot be held there."""
    most = reach(parameters, design)
    if azimuth is not None and abs(azimuth) > most:
        raise InputError(
            f"pilot.azimuth_deg must be within ±{degrees(most):.1f}°, got {degrees(azimuth):.1f}°: "
            f"that is how far ±{parameters.stick.delta:g} rad of this kite's stick hold it aside"
        )


def check_slow(settings: PilotSettings, parameters: Parameters) -> None:
    """Raises InputError where a kite that barely turns is to do more than hold."""
    if not parameters.stick.mirrored:
        return
    beyond = [phase for phase in settings.phases if phase != "hold"]
    design = drift_design(parameters)
    if beyond:
        raise InputError(
            f'pilot.phases must be ["hold"] for a kite that drifts away from the hand that pulls '
            f"(stick.mirrored), got {beyond[0]!r}: it does not turn, and what it can do is stand "
            f"within ±{degrees(reach(parameters, design)):.0f}° of azimuth and sway slowly there"
        )
    check_reach(parameters, design, settings.azimuth)


NOTHING_SEEN = Estimate(0.0, 0.0, nan, nan, 0.0, nan, nan, 0.0)
"""Before the first measurement, which arrives at once; of speeds nothing is told."""


class DriftPilot:
    """An autopilot of such a kite: it holds the point of the settings until the end.

    It goes by the last angles that its sensors told, which the design's filter smooths.
    """

    def __init__(self, parameters: Parameters, settings: PilotSettings) -> None:
        """Raises InputError as `check_slow`, and for sensors that there cannot be."""
        check_slow(settings, parameters)
        self.settings, self._limits = settings, parameters.stick
        self._sensors, self._seen = Sensors(settings.sensors, settings.seed), NOTHING_SEEN
        self.hold = DriftHold(parameters, settings.azimuth)
        self._top = pi / 2 - equilibrium(in_still_air(parameters)).gamma
        self.restart(0.0)

    def restart(self, t: float) -> None:
        """Begins anew at time `t` [s]."""
        self.hold.restart()
        self._sensors.resume(None)  # they looked away meanwhile
        self._t = t
        self.guided = Guided("hold", nan, nan, self.settings.azimuth, self._top, 0.0, t)

    def command(self, motion: Motion) -> Command:
        """The stick, which asks for δ̈."""
        if motion.t < self._t:
            self.restart(motion.t)
        self._t = motion.t
        for told in self._sensors.look(motion):
            angles = {name: getattr(told, name) for name in ("azimuth", "elevation", "heading")}
            self._seen = NOTHING_SEEN._replace(**angles)
        return moved(self.hold.wish(self._seen, motion.control), motion.control, self._limits)
