"""How far the wind has come: what gusts and ribbons are moved by, a function of time alone."""

from math import atan, hypot, pi

from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector
from kitemj.physics.wind import wind_velocity
from kitemj.scene.sun import land_to_E

STEP = 0.25  # s, of the sum over the wind's speed
GUST_HEIGHT = 10.0  # m, of the air that moves over the field


class Airflow:
    """The wind of a parameter set as it is seen; the same at the same time, asked in any order."""

    def __init__(self, parameters: Parameters) -> None:
        self._parameters, self._way = parameters, [0.0]

    def at(self, place_L: Vector, t: float) -> Vector:
        """Velocity [m/s, E] of the air at a place [m, L]."""
        return wind_velocity(self._parameters.wind, land_to_E(self._parameters, place_L), t)

    def drift(self, t: float) -> float:
        """The way [m] downwind of the air over the field since t = 0 s."""
        whole, rest = divmod(max(t, 0.0), STEP)
        while len(self._way) <= whole:
            middle = (len(self._way) - 0.5) * STEP
            self._way.append(self._way[-1] + STEP * self._speed(middle))
        here = int(whole)
        return self._way[here] + rest * self._speed(here * STEP + 0.5 * rest)

    def strength(self, t: float) -> float:
        """The speed over the field now in parts of the wind's usual; 0 without any."""
        usual = self._parameters.wind.speed
        return self._speed(t) / usual if usual > 0 else 0.0

    def _speed(self, t: float) -> float:
        v = self.at(Vector(0.0, 0.0, GUST_HEIGHT), t)
        return hypot(v.x, v.y)


def droop(speed: float, light: float) -> float:
    """How far [rad] below level cloth hangs that stands at 45° in a wind of `light` m/s."""
    return atan((light / speed) ** 2) if speed > 1e-6 else pi / 2
