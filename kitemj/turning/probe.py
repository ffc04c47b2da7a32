"""The test flight: sines on the stick, of a kite at rest or on gentle figures of eight."""

from math import pi, radians
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.motion import Motion
from kitemj.errors import FlightError
from kitemj.flight.equilibrium import equilibrium_state
from kitemj.flight.limits import GROUND, Departure
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.flight.scenario import Scenario, Times
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Sines, rest_ell
from kitemj.pilots.manoeuvres import DIVE, Pilot
from kitemj.pilots.sight import sight, turned
from kitemj.turning.gains import HANDS
from kitemj.turning.hands import moved
from kitemj.turning.turning_fit import SLOWEST, Flown

HARMONICS = np.array([3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 15.0])
"""Of the slowest wave, which are flown: seven sines."""
BASE = 0.1
"""Of V/b [rad/s], the wave of which they are harmonics: 0.1 to 0.5 of a turn in the time in which
the wind passes 2π spans, which is quick and slow beside how a kite answers."""
UNHURRIED = 0.5
"""Of the hands' limits on δ̇ and δ̈, at most, when all sines pull at once."""
EARLY = 2.0
"""s, after which eights are looked at: they begin at rest."""
LOOSE = 0.01
"""Of a flight, so much may be outside the limits of validity."""
QUICK = 0.35
"""K T: K [1/s] takes away what the nose is off, T [s] is its delay and that of the hands."""
EASE = 0.3
"""Of the turn rate, how much is taken back at once."""


class Signal(NamedTuple):
    """Sines of these amplitudes [rad], frequencies [rad/s] and phases [rad], and their `period`."""

    amplitudes: Array
    frequencies: Array
    phases: Array
    period: float

    def at(self, t: float) -> float:
        """δ [rad] at `t` [s]."""
        return float(self.amplitudes @ np.sin(self.frequencies * t + self.phases))


class Way(NamedTuple):
    """How eights are flown while the signal is on the stick, the gentlest last.

    `wide` [rad] of azimuth, where it turns back; `low` [rad], the elevation of the middle;
    `steering`, `signal`: parts of full stick for either, the second a standard deviation.
    """

    wide: float
    low: float
    steering: float
    signal: float


WAYS = (
    Way(radians(18.0), radians(38.0), 0.6, 0.085),
    Way(radians(5.0), radians(50.0), 0.7, 0.07),
    Way(radians(5.0), radians(50.0), 0.6, 0.04),
)
LONG = 40.0
"""s of eights."""
AT_REST = 0.03
"""Of full stick, a standard deviation, of a kite that stands."""
PERIODS, SETTLED = 3, 2
"""Of the signal, that are flown at rest; after how many what began it has died away."""


class Probe(NamedTuple):
    """A test flight: what was flown, and the first departure from the limits, if any.

    `outside`: the share of the flight outside the limits of validity; `whole`: whether it
    lasted as long as was asked.
    """

    flown: Flown
    departure: Departure | None
    outside: float
    whole: bool

    @property
    def clean(self) -> bool:
        """Whether it is what a law can be fitted to."""
        return self.whole and self.outside <= LOOSE


def signal_for(parameters: Parameters, part: float) -> Signal:
    """Sines of equal amplitude, which are `part` of full stick (a standard deviation) or less.

    Less where hands are too slow for it. Their phases are those of least peaks (Schroeder, IEEE
    Trans. Inf. Theory 16 (1970) 85). The frequencies follow from span and wind.
    """
    slowest = BASE * parameters.wind.speed / parameters.kite.span
    frequencies, k = slowest * HARMONICS, np.arange(len(HARMONICS))
    stick = parameters.stick
    amplitude = min(
        part * stick.delta * float(np.sqrt(2.0 / len(k))),
        UNHURRIED * stick.delta_dot / float(np.sum(frequencies)),
        UNHURRIED * stick.delta_ddot / float(np.sum(frequencies**2)),
    )
    phases = -pi * k * (k - 1) / len(k)
    return Signal(np.full(len(k), amplitude), frequencies, phases, 2 * pi / slowest)


class Standing:
    """Hands that move by the signal alone."""

    def __init__(self, parameters: Parameters, signal: Signal) -> None:
        self._limits, self._signal = parameters.stick, signal

    def command(self, motion: Motion) -> Command:
        """Where the stick is now."""
        return moved(self._signal.at(motion.t), motion.control, self._limits)


class Weaving:
    """Lying eights as by `Eight`, steered by a rough law, and the signal on the stick."""

    def __init__(self, parameters: Parameters, rough: TurnRateLaw, signal: Signal, way: Way):
        self._limits, self._law, self._signal, self._way = parameters.stick, rough, signal, way
        self._side = 1.0

    def command(self, motion: Motion) -> Command:
        """Where the stick is now."""
        seen, law, way = sight(motion), self._law, self._way
        if self._side * seen.azimuth > way.wide:
            self._side = -self._side
        dive = max(-DIVE, min(DIVE, 2.0 * (seen.elevation - way.low)))
        off = turned(self._side * (pi / 2 + dive) - seen.heading, self._side * pi / 2)
        speed = max(law.airspeed, min(2 * law.airspeed, motion.air.speed))
        quick = QUICK / (law.delay(speed) + HANDS)
        wish = (quick * off - EASE * seen.turning) / law.gain(law.airspeed)
        most = way.steering * self._limits.delta
        wish = max(-most, min(most, wish)) + self._signal.at(motion.t)
        return moved(wish, motion.control, self._limits)


def eights(parameters: Parameters, rough: TurnRateLaw, model: str = "lagrange") -> Probe:
    """The first of `WAYS` that a kite flies as it should, else as far as it came on the last.

    `rough`: a law to steer by.
    """
    for way in WAYS:
        signal = signal_for(parameters, way.signal)
        pilot = Weaving(parameters, rough, signal, way)
        found = probe(parameters, pilot, LONG, EARLY, model)
        if found.clean:
            break
    return found


def standing(parameters: Parameters, model: str = "lagrange") -> Probe:
    """One period of the signal about rest, after `SETTLED`."""
    signal = signal_for(parameters, AT_REST)
    pilot = Standing(parameters, signal)
    return probe(parameters, pilot, PERIODS * signal.period, SETTLED * signal.period, model)


def probe(
    parameters: Parameters, pilot: Pilot, duration: float, early: float, model: str = "lagrange"
) -> Probe:
    """A flight from rest, by any pilot, for `duration` [s] or until the ground.

    What is more than `SLOWEST` before `early` [s] is left out. The wind comes from ahead, whatever
    its azimuth: the law is the same.
    """
    parameters = parameters._replace(wind=parameters.wind._replace(azimuth=0.0))
    rest = Sines(rest_ell(parameters.lines.length, parameters.kite.y_A))
    start = equilibrium_state(parameters, "test flight")
    scenario = Scenario("test flight", parameters, rest, start, Times(duration), False)
    flight, rows, outside = SteeredFlight(scenario, model), list[tuple[float, ...]](), 0
    departure = None
    ticks = round(duration / TICK)
    try:
        while flight.ticks < ticks:
            result = flight.tick(pilot.command(flight.result.motion))
            departure = departure or result.departure
            if result.departure and result.departure.limit is GROUND:
                break
            outside += result.departure is not None
            rows.append(_row(result.motion))
    except FlightError:
        pass  # the coordinates end beyond the zenith; what was flown until then counts
    seen = np.array([row for row in rows if row[0] >= early - SLOWEST - TICK / 2]).reshape(
        -1, len(LOOKS)
    )
    whole = len(rows) == ticks
    return Probe(Flown(*seen.T), departure, outside / max(1, len(rows)), whole)


LOOKS = Flown._fields


def _row(motion: Motion) -> tuple[float, ...]:
    """A row of `Flown`."""
    seen, now = sight(motion), motion.control
    at = seen.turning, motion.air.speed, seen.heading, seen.elevation
    return (motion.t, *at, now.delta, now.delta_dot)
