"""The margins of the loop as it is designed: known before the flight, in a moment.

The course answers like an integrator after the delay T of the whole loop, and the attractor turns
an error of the place into one of the course: with s in units of 1/T, x = ω_c T and the outlook o,

    L(s) = (x / s) (1 + x / (o s)) e^(-s).
"""

from math import atan, degrees, inf, log10, pi, sqrt
from typing import NamedTuple

from scipy.optimize import brentq

from kitemj.errors import InputError
from kitemj.flight.pilot_settings import PilotSettings, TurnRateLaw
from kitemj.turning.gains import Gains, lead_time

LEAST_GAIN = 3.0
"""dB; a loop that keeps less is not flown: the kite's own gain changes by as much on its path."""


class DesignMargins(NamedTuple):
    """Gain [dB], phase [deg] and delay [parts of T] that the designed loop has to spare."""

    gain: float
    phase: float
    delay: float


def design_margins(gains: Gains) -> DesignMargins:
    """The margins of the designed loop; below 0 it is unstable."""
    x, corner = gains.crossover, gains.crossover / gains.outlook

    def size(w: float) -> float:
        return x / w * sqrt(1.0 + (corner / w) ** 2)

    def lag(w: float) -> float:
        return w + pi / 2 + atan(corner / w)

    # |L| falls with w, from inf to 0; the lag is π at 0 where corner < 1, then less, then more
    at_one = brentq(lambda w: size(w) - 1.0, 1e-9, 10.0 * (x + 1.0))
    phase = pi - lag(at_one)
    if corner >= 1.0:
        return DesignMargins(-inf, degrees(phase), phase / at_one)
    dip = sqrt(max(0.0, corner - corner**2))
    at_turn = brentq(lambda w: lag(w) - pi, max(dip, 1e-9), pi / 2)
    return DesignMargins(-20.0 * log10(size(at_turn)), degrees(phase), phase / at_one)


def largest_crossover(gains: Gains) -> float:
    """ω_c T, up to which the designed loop keeps `LEAST_GAIN`."""

    def spare(x: float) -> float:
        return design_margins(gains._replace(crossover=x)).gain - LEAST_GAIN

    return float(brentq(spare, 1e-3, 0.99 * min(gains.outlook, pi / 2)))


def check_gain(settings: PilotSettings, gains: Gains, law: TurnRateLaw) -> DesignMargins:
    """The margins of the designed loop. Raises InputError for one that is (nearly) unstable."""
    gains = gains._replace(crossover=settings.crossover)
    found = design_margins(gains)
    if found.gain >= LEAST_GAIN:
        return found
    says = "is unstable" if found.gain <= 0.0 else f"has {found.gain:.2g} dB to spare"
    late = lead_time(law, gains, law.airspeed)
    raise InputError(
        f"pilot.crossover must be <= {largest_crossover(gains):.2f}, got {settings.crossover:g}: "
        f"with a delay of {late:.2g} s the loop {says}, and {LEAST_GAIN:g} dB are needed"
    )
