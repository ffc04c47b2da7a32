"""Hands that follow a wished δ: a damped spring within the limits of any hand."""

from kitemj.flight.live import Command
from kitemj.physics.parameters import StickLimits
from kitemj.physics.shaping import StickLaw
from kitemj.physics.steering import Control
from kitemj.turning.gains import ACTUATOR, DAMPING


def moved(wish: float, now: Control, limits: StickLimits) -> Command:
    """The stick, which asks for δ̈, of hands that are `now` and want to be at `wish` [rad].

    They go on from where they are, so that taking over is no jerk; and below the limits they
    are linear, as the margins of the loop demand.
    """
    wish = max(-limits.delta, min(limits.delta, wish))
    pull = ACTUATOR**2 * (wish - now.delta) - 2 * DAMPING * ACTUATOR * now.delta_dot
    part = pull / limits.delta_ddot
    return Command(max(-1.0, min(1.0, part)), 0.0, StickLaw.ACCELERATION)
