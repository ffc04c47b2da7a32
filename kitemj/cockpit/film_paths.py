"""The path that an autopilot flies, for pictures of a flight that is over."""

from kitemj.flight.pilot_settings import PilotSettings
from kitemj.paths.check_path import usual_path
from kitemj.paths.glide import glide_ratio
from kitemj.paths.path import path_of
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import Parameters
from kitemj.turning.identify import identified_law


def path_flown(parameters: Parameters, pilot: PilotSettings | None) -> Array | None:
    """Directions (n, 3) in the axes of `kitemj.paths.sphere`; None: there is no path.

    The path that is not said is found as before the flight.
    """
    if pilot is None or "path" not in pilot.phases:
        return None
    path = pilot.path
    if path is None:
        path = usual_path(parameters, pilot.law or identified_law(parameters))
    return path_of(path, glide_ratio(parameters)).points
