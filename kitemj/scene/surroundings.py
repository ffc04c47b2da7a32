"""What is around the kite and changes from frame to frame: its shadow, and signs of the wind."""

from typing import Any

from kitemj.dynamics.motion import Motion
from kitemj.physics.frames import world
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector
from kitemj.scene.canopy import canopy
from kitemj.scene.cloth import Fill
from kitemj.scene.gusts_and_grass import GustsAndGrass
from kitemj.scene.landscape import SKY, follow
from kitemj.scene.shadow import add_shadow, few_points
from kitemj.scene.sun import sun
from kitemj.scene.wind_signs import WindSigns


class Surroundings:
    """The surroundings of a parameter set's kite in scenes of its drawing model."""

    def __init__(self, parameters: Parameters, model: Any) -> None:
        self._sun, self._signs = sun(parameters), WindSigns(parameters)
        self._gusts_and_grass = GustsAndGrass(parameters, model)
        self._sky = {model.geom(name).id for name in SKY}
        self._kite = few_points(canopy(parameters.kite).shape(Fill(1.0, 1.0, 0.0)))

    def show_details(self, shown: bool) -> None:
        """Says whether scenes that are made from now on have grass and gusts."""
        self._gusts_and_grass.show(shown)

    def add(self, mjv: Any, motion: Motion, scale: float, eye: Vector) -> None:
        """Adds them to a scene just made of `motion`, as seen from `eye` [m, E].

        Its kite is drawn `scale` times as large.
        """
        follow(mjv, self._sky, world(eye))
        self._gusts_and_grass.place(mjv, motion.t)
        self._signs.add(mjv, motion.t)
        add_shadow(mjv, self._kite, motion.body, self._sun, scale)
