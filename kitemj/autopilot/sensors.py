"""Sensors between motion and pilot: what a real kite lets itself be measured, when, how well."""

from random import Random
from typing import NamedTuple

from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.flight.live import TICK
from kitemj.flight.pilot_settings import SensorSettings
from kitemj.pilots.sight import sight

SLOWEST = 1.0
"""1/s; who measures less often than that flies blind."""
INSTANT = 1e-6
"""s; times of ticks are sums, and equal to this."""


class Measurement(NamedTuple):
    """Of the kite at the time `t` [s]: angles [rad], as `kitemj.pilots.sight` has them, the pulls
    [N] of the lines at the ground and their lengths [m], in the order of the rig's."""

    t: float
    azimuth: float
    elevation: float
    heading: float
    pulls: tuple[float, ...]
    lengths: tuple[float, ...]


class Underway(NamedTuple):
    """All that sensors remember: the time `t` [s] of the last look, of the first, how many
    measurements were taken since, and those that did not arrive yet, oldest first."""

    t: float
    began: float
    taken: int
    waiting: tuple[Measurement, ...]


class Sensors:
    """Looks at the motions of a flight tick by tick, and tells what was measured.

    The k-th measurement is taken at the first tick at or after k / rate, and arrives at the first
    tick at or after `delay` from then; the first one arrives at once, since a kite is looked at
    before it flies. Noise depends on seed and k alone.
    """

    def __init__(self, settings: SensorSettings, seed: int) -> None:
        """Raises InputError for a rate that there cannot be."""
        if not SLOWEST <= settings.rate <= 1 / TICK:
            raise InputError(
                f"sensors measure {settings.rate:g} times a second (`rate`): from {SLOWEST:g} to "
                f"{1 / TICK:g} are possible, since a tick of the flight takes {TICK:g} s"
            )
        self._settings, self._seed = settings, seed
        self._now: Underway | None = None

    def save(self) -> Underway | None:
        """All that is remembered."""
        return self._now

    def resume(self, saved: Underway | None) -> None:
        """Goes on from what was saved, to the same bits."""
        self._now = saved

    def look(self, motion: Motion) -> tuple[Measurement, ...]:
        """What arrives by the time of `motion`, oldest first; begins anew when time goes back."""
        now = self._now
        if now is None or motion.t < now.t:
            first = measured(motion, self._settings, self._seed, 0)
            self._now = Underway(motion.t, motion.t, 1, ())
            return (first,)
        taken, waiting = now.taken, now.waiting
        due = now.began + taken / self._settings.rate
        if motion.t > now.t and motion.t >= due - INSTANT:
            waiting = (*waiting, measured(motion, self._settings, self._seed, taken))
            taken += 1
        last = motion.t - self._settings.delay + INSTANT
        arrived = tuple(one for one in waiting if one.t <= last)
        self._now = Underway(motion.t, now.began, taken, waiting[len(arrived) :])
        return arrived


def measured(motion: Motion, settings: SensorSettings, seed: int, k: int) -> Measurement:
    """The `k`-th measurement, with its noise, drawn in the order of the fields."""
    draw, seen = Random((seed << 32) + k).gauss, sight(motion)
    angles = [seen.azimuth, seen.elevation, seen.heading]
    angles = [angle + draw(0.0, settings.noise) for angle in angles]
    pulls = [line.tension_ground * (1.0 + draw(0.0, settings.pull_noise)) for line in motion.lines]
    lengths = [length + draw(0.0, settings.length_noise) for length in motion.lengths]
    return Measurement(motion.t, angles[0], angles[1], angles[2], tuple(pulls), tuple(lengths))
