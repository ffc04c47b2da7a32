"""The eye of a view: where it is, from one motion to the next."""

from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.physics.parameters import Parameters
from kitemj.scene.views import CAMERAS, Camera, first_orbit, orbiting


class Eye:
    """Looks at motions in their order; each view is seen as from the place that it keeps.

    A flight that is shown out of order, or a view that was not looked from, has no past.
    """

    def __init__(self, parameters: Parameters) -> None:
        self._parameters, self._orbit = parameters, first_orbit(parameters)

    def look(self, motion: Motion, view: str) -> Camera:
        """The camera of `view`, "orbit" or a name of `CAMERAS`, for `motion`."""
        if view == "orbit":
            return orbiting(self._parameters, motion, self._orbit)
        return CAMERAS[view](self._parameters, motion)

    def turn(self, d_azimuth: float, d_elevation: float) -> None:
        """Turns the orbit: to the right and up by angles in rad."""
        self._orbit = self._orbit.turned(d_azimuth, d_elevation)

    def zoom(self, factor: float) -> None:
        """Goes `factor` times nearer on the orbit; InputError for a factor that is not > 0."""
        if not factor > 0:
            raise InputError(f"zoom must be by a factor > 0, got {factor:g}")
        self._orbit = self._orbit.zoomed(factor, self._parameters)
