"""The mapping from deflections of sticks to a command of the lines."""

from math import copysign
from typing import NamedTuple

from kitemj.flight.live import Command
from kitemj.physics.parameters import Parameters
from kitemj.physics.shaping import StickLaw
from kitemj.physics.steering import ell_delta, rest_ell


class Deflections(NamedTuple):
    """Deflections in -1..1.

    `steer` is positive to the right, `reel` when line is let out; `left` and `right` are how
    far that hand pulls its own line (positive: the line gets shorter).
    """

    steer: float = 0.0
    reel: float = 0.0
    left: float = 0.0
    right: float = 0.0


def shaped_deflection(deflection: float, dead_zone: float, expo: float) -> float:
    """The deflection after dead zone and curve: odd in it, 0 within the dead zone, ±1 at the ends.

    What is left of the way, x in 0..1, becomes (1 - expo) x + expo x³.
    """
    size = max(0.0, min(1.0, (abs(deflection) - dead_zone) / (1 - dead_zone)))
    return copysign((1 - expo) * size + expo * size**3, deflection)


def command_of(
    hands: Deflections, parameters: Parameters, law: StickLaw, two_sticks: bool
) -> Command:
    """The command of these deflections.

    With one stick, stick right is the right hand's pull, or the left's where the kite is
    `mirrored`; with a stick for each line the hands are the hands.
    """
    if two_sticks:
        return one_line_each(parameters, hands.left, hands.right)
    side = -1.0 if parameters.stick.mirrored else 1.0
    return Command(side * hands.steer, hands.reel, law)


def one_line_each(parameters: Parameters, left: float, right: float) -> Command:
    """The command of a stick for each line, A₊ on the left.

    L₊ = L₀ - arm·left, L₋ = L₀ - arm·right.

    Exact as long as the set's limits on δ and ℓ leave the arms their way.
    """
    limits, length, y_A = parameters.stick, parameters.lines.length, parameters.kite.y_A
    plus, minus = length - limits.arm * left, length - limits.arm * right
    rest = rest_ell(length, y_A)
    try:
        ell, delta = ell_delta(plus, minus, y_A)
    except ValueError:  # arms as long as the kite is wide would turn it over: as far as it may
        ell, delta = rest, copysign(limits.delta, plus - minus)
    return Command(_part(delta, limits.delta), _part(ell - rest, limits.ell))


def _part(value: float, limit: float) -> float:
    return max(-1.0, min(1.0, value / limit))
