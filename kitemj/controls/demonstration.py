"""Who flies where nobody can."""

from kitemj.controls.programmed import show
from kitemj.controls.stick import PilotStick, Stick
from kitemj.physics.parameters import Parameters
from kitemj.pilots.manoeuvres import Eight


def show_of(parameters: Parameters) -> Stick:
    """Eights with a kite that turns, else a table of the stick.

    A kite turns where its nose follows its motion: C_nβ > 0.
    """
    turns = getattr(parameters.aero, "Cn_beta", 0.0) > 0
    return PilotStick(Eight()) if turns else show(parameters)
