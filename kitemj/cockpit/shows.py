"""Who flies where nobody can."""

from kitemj.cockpit.programmed import show
from kitemj.cockpit.stick import PilotStick, Stick
from kitemj.flight.pilots import Eight
from kitemj.physics.parameters import Parameters


def show_of(parameters: Parameters) -> Stick:
    """Eights with a kite that turns, else a table of the stick.

    A kite turns where its nose follows its motion: C_nβ > 0.
    """
    turns = getattr(parameters.aero, "Cn_beta", 0.0) > 0
    return PilotStick(Eight()) if turns else show(parameters)
