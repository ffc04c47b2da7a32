"""The stick of a demonstration, which flies by itself."""

from kitemj.controls.programmed import show
from kitemj.controls.stick import PilotStick, Stick
from kitemj.physics.parameters import Parameters
from kitemj.pilots.manoeuvres import Eight


def show_of(parameters: Parameters) -> Stick:
    """A pilot of figures of eight for a kite that turns, else a programmed stick.

    A kite turns where its nose follows its motion: C_nβ > 0.
    """
    turns = getattr(parameters.aero, "Cn_beta", 0.0) > 0
    return PilotStick(Eight()) if turns else show(parameters)
