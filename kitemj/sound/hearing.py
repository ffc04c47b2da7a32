"""What is heard of a motion: how fast the air is, how the lines pull, whether cloth flutters."""

from math import degrees
from typing import NamedTuple

from kitemj.dynamics.motion import Motion
from kitemj.flight.limits import SLACK, Numbers
from kitemj.physics.parameters import Parameters

FULLY = 8.0
"""deg beyond the stall, or below no lift, at which the whole sail flutters; an estimate."""
AT_THE_PILOT = 0.4
"""Of the wind's speed: what is heard while a kite lies on the ground."""


class Heard(NamedTuple):
    """What sounds at one moment; as it is, nothing does.

    `airspeed` [m/s]; `left` and `right`: pulls of the outer lines, in 0..1; `flutter` in 0..1 of
    a sail that is `chord` [m] deep.
    """

    airspeed: float = 0.0
    left: float = 0.0
    right: float = 0.0
    flutter: float = 0.0
    chord: float = 1.0


SILENCE = Heard()


def heard(parameters: Parameters, motion: Motion, down: bool = False) -> Heard:
    """What is heard of `motion`; of a kite that lies `down` only the wind.

    A pull is told beside what the wind alone presses on the sail: half of it at that pull, all
    of it at any that is much larger.
    """
    kite, wind = parameters.kite, parameters.wind.speed
    if down:
        return Heard(AT_THE_PILOT * wind, chord=kite.chord)
    usual = max(parameters.environment.air_density * wind * wind * kite.area, 1.0)
    pulls = [max(pull, 0.0) for pull in motion.tensions]
    left, right = (pull / (pull + usual) for pull in (pulls[0], pulls[-1]))
    return Heard(motion.air.speed, left, right, _flutter(parameters, motion), kite.chord)


def _flutter(parameters: Parameters, motion: Motion) -> float:
    """How much of the sail flutters, in 0..1: all of it where a line is slack."""
    if not SLACK.kept(parameters.limits, Numbers(tensions=motion.tensions)):
        return 1.0
    alpha, stall = degrees(motion.air.alpha), degrees(parameters.limits.alpha_stall)
    return min(max(alpha - stall, -alpha, 0.0) / FULLY, 1.0)
