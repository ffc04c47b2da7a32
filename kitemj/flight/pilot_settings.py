"""What the table [pilot] of a scenario says: phases, path, sensors, how quickly it steers."""

from math import nan, radians
from typing import Annotated, Literal, NamedTuple

from kitemj.physics.quantity import Quantity

PhaseName = Literal["launch", "climb", "path", "untwist", "hold", "land"]
PHASES: tuple[PhaseName, ...] = ("launch", "climb", "path", "untwist", "hold", "land")
"""Of a flight, by name."""


class PathSettings(NamedTuple):
    """A closed curve in the sky; angles as the pilot sees them, azimuth positive to the right."""

    kind: Literal["lemniscate", "circle", "points"] = "lemniscate"
    azimuth: Annotated[float, Quantity("rad", "azimuth of its middle")] = 0.0
    elevation: Annotated[float, Quantity("rad", "elevation of its middle")] = radians(38.0)
    width: Annotated[float, Quantity("rad", "of a lemniscate, along a great circle", gt=0)] = (
        radians(76.0)
    )
    height: Annotated[float, Quantity("rad", "of a lemniscate", gt=0)] = radians(28.0)
    radius: Annotated[float, Quantity("rad", "of a circle", gt=0)] = radians(22.0)
    turn: Literal["up", "down", "right", "left"] = "up"
    points: Annotated[tuple[tuple[float, float], ...], Quantity("rad", "azimuth, elevation")] = ()


class SensorSettings(NamedTuple):
    """What the pilot measures: angles, pull and lengths of lines, never the wind."""

    rate: Annotated[float, Quantity("1/s", "measurements per second", gt=0)] = 100.0
    delay: Annotated[float, Quantity("s", "from the instant to the pilot", ge=0, le=1)] = 0.0
    noise: Annotated[float, Quantity("rad", "of angles, one standard deviation", ge=0)] = 0.0
    pull_noise: Annotated[float, Quantity("", "of a line's pull, a part of it", ge=0, le=1)] = 0.0
    length_noise: Annotated[float, Quantity("m", "of a line's length", ge=0)] = 0.0


class TurnRateLaw(NamedTuple):
    """How the kite turns: χ̇(t) = c₁ v₀ (v_a/v₀)ⁿ u(t - d/v_a) + (c₂/v_a) sin ψ cos β.

    With n = 1 that is χ̇ = c₁ v_a u + ... (Erhard & Strauch 2013; Fagiano et al. 2014; Jehle &
    Schmehl 2014). u = δ [rad], ψ the heading, β the elevation of the kite.
    """

    c1: Annotated[float, Quantity("1/(m rad)", "turning for each m of air and rad of δ")]
    c2: Annotated[float, Quantity("m/s²", "turning by weight")] = 0.0
    exponent: Annotated[float, Quantity("", "n", ge=-1, le=3)] = 1.0
    airspeed: Annotated[float, Quantity("m/s", "v₀, where c₁ holds", gt=0)] = 10.0
    lag: Annotated[float, Quantity("m", "d, what is flown before the nose answers", ge=0)] = 0.0

    def gain(self, airspeed: float) -> float:
        """Turn rate [rad/s] for each rad of δ at an `airspeed` [m/s]."""
        return float(self.c1 * self.airspeed * (airspeed / self.airspeed) ** self.exponent)

    def delay(self, airspeed: float) -> float:
        """From δ to the nose [s] at an `airspeed` [m/s]."""
        return self.lag / airspeed


class PilotSettings(NamedTuple):
    """All of [pilot].

    Without a `law` it is identified before the flight; the `path` is the usual eight for the kite
    unless one is said.

    `crossover`: ω_c T, how quickly course errors are taken away, times the delay of the whole
    loop: the one number from which all gains follow.
    """

    phases: tuple[PhaseName, ...] = ("climb", "path")
    path: PathSettings | None = None
    laps: Annotated[float, Quantity("", "of the path; 0: until the end", ge=0)] = 0.0
    hold: Annotated[float, Quantity("s", "how long a point is held; 0: until the end", ge=0)] = 0.0
    azimuth: Annotated[float, Quantity("rad", "of the point that is held")] = 0.0
    side: Literal["right", "left"] = "right"
    crossover: Annotated[float, Quantity("", "ω_c T", gt=0, le=2)] = 0.4
    sensors: SensorSettings = SensorSettings()
    seed: Annotated[int, Quantity("", "of the noise", ge=0)] = 0
    law: TurnRateLaw | None = None


class Guided(NamedTuple):
    """What an autopilot tells of itself at an instant.

    `error` [rad]: across the path, positive to its right; `lap`: laps flown, not whole;
    `azimuth`, `elevation` [rad] of the attractor, the point it flies to; `since` [s]: when it was
    handed the kite. Not a number where the phase has no such thing.
    """

    phase: PhaseName
    error: float
    lap: float
    azimuth: float
    elevation: float
    twist: float
    since: float = nan
