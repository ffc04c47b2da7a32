"""Cameras of the views, and the pixel where a point appears. All in frame E, no state.

A view is a function of the parameters and one motion: the same motion gives the same
picture, live or from a recording, and a smooth motion a smooth picture.
"""

from collections.abc import Callable
from math import cos, hypot, pi, radians, remainder, sin, tan
from typing import NamedTuple

from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, cross, dot, minus, norm, plus, times

UP = Vector(0.0, 0.0, -1.0)
FIELD = radians(58.0)  # vertical angle of view
NEAR = 0.25  # m, closer is not drawn
HIGHEST = radians(85.0)  # elevation of an orbit
LOWEST = 0.6  # m above the ground that an eye stands
NEAR_ORBIT = 8.0  # spans, up to here the kite is seen in its true size


class Camera(NamedTuple):
    """Position [m, E]; unit vectors forward and up [E]; vertical angle of view [rad].

    `near`: whether it is near the kite, which is then seen in its true size, with its forces.
    """

    position: Vector
    forward: Vector
    up: Vector
    field: float
    near: bool = False


class Pixel(NamedTuple):
    """Column and row (pixel centres are whole numbers, row 0 on top) and depth [m] ahead."""

    column: float
    row: float
    depth: float


def pixel(camera: Camera, p_E: Vector, width: int, height: int) -> Pixel:
    """The pixel where the point `p_E` [m, E] appears; without meaning unless depth > 0."""
    sight = minus(p_E, camera.position)
    depth = dot(sight, camera.forward)
    right = cross(camera.forward, camera.up)
    focal = height / 2 / tan(camera.field / 2) / (depth if depth != 0.0 else 1e-12)
    column = width / 2 - 0.5 + focal * dot(sight, right)
    return Pixel(column, height / 2 - 0.5 - focal * dot(sight, camera.up), depth)


def looking(position: Vector, target: Vector) -> Camera:
    """Camera at `position` [m, E] that looks at `target`, upright; not straight up or down."""
    forward = _unit(minus(target, position))
    right = _unit(cross(forward, UP))
    return Camera(position, forward, cross(right, forward), FIELD)


def chase(parameters: Parameters, motion: Motion) -> Camera:
    """The view a few spans from the kite, from the pilot's side and above, downwind and down.

    It turns with the kite's place in the wind window and never with its attitude.
    """
    span, G = parameters.kite.span, motion.body.p_G_E
    wind = downwind(parameters)
    # the bias keeps the direction defined and steady when the kite stands above the pilot
    heading = _level(plus(G, times(parameters.lines.length, wind)), wind)
    kite = Vector(G.x, G.y, min(G.z, 0.0))
    eye = plus(kite, plus(times(-2.1 * span, heading), times(1.1 * span, UP)))
    return looking(eye, plus(kite, times(0.25 * span, UP)))._replace(near=True)


def pilot(parameters: Parameters, _: Motion) -> Camera:
    """The view from behind the pilot, downwind: pilot, lines, kite and the whole wind window."""
    L, wind = parameters.lines.length, downwind(parameters)
    position = plus(times(-1.35 * L, wind), times(0.3 * L, UP))
    return looking(position, plus(times(0.2 * L, wind), times(0.395 * L, UP)))


def side(parameters: Parameters, _: Motion) -> Camera:
    """The view from the pilot's right: the wind blows from left to right."""
    L, wind = parameters.lines.length, downwind(parameters)
    target = plus(times(0.62 * L, wind), times(0.4 * L, UP))
    return looking(plus(target, times(1.5 * L, cross(wind, UP))), target)


def top(parameters: Parameters, _: Motion) -> Camera:
    """The view from straight above: the wind blows up the picture, the pilot's left is left."""
    L, wind = parameters.lines.length, downwind(parameters)
    position = plus(times(0.42 * L, wind), times(1.9 * L, UP))
    return Camera(position, times(-1.0, UP), wind, FIELD)


class Orbit(NamedTuple):
    """The place of an eye that is free to go round the kite.

    `azimuth` [rad] from where chase stands, positive to the pilot's right; `elevation` [rad]
    above the kite's level; `distance` [m].
    """

    azimuth: float
    elevation: float
    distance: float

    def turned(self, d_azimuth: float, d_elevation: float) -> "Orbit":
        """The orbit further round, by angles in rad; never quite overhead or underfoot."""
        elevation = min(max(self.elevation + d_elevation, -HIGHEST), HIGHEST)
        return Orbit(remainder(self.azimuth + d_azimuth, 2 * pi), elevation, self.distance)

    def zoomed(self, factor: float, parameters: Parameters) -> "Orbit":
        """The orbit `factor` times nearer, between a span and four line lengths."""
        least, most = parameters.kite.span, 4.0 * parameters.lines.length
        return self._replace(distance=min(max(self.distance / factor, least), most))


def first_orbit(parameters: Parameters) -> Orbit:
    """The orbit that begins behind the pilot's right shoulder, near the kite."""
    return Orbit(radians(35.0), radians(20.0), 3.0 * parameters.kite.span)


def orbiting(parameters: Parameters, motion: Motion, orbit: Orbit) -> Camera:
    """The camera of an orbit: at the kite from near, from afar at the middle of its lines."""
    G, span = motion.body.p_G_E, parameters.kite.span
    share = (orbit.distance - NEAR_ORBIT * span) / (2.0 * parameters.lines.length)
    target = times(1.0 - 0.5 * min(max(share, 0.0), 1.0), G)
    wind = downwind(parameters)
    right = cross(wind, UP)
    level = plus(times(-cos(orbit.azimuth), wind), times(sin(orbit.azimuth), right))
    away = plus(times(cos(orbit.elevation), level), times(sin(orbit.elevation), UP))
    eye = plus(target, times(orbit.distance, away))
    camera = looking(Vector(eye.x, eye.y, min(eye.z, -LOWEST)), target)
    return camera._replace(near=orbit.distance < NEAR_ORBIT * span)


View = Callable[[Parameters, Motion], Camera]
CAMERAS: dict[str, View] = {"chase": chase, "pilot": pilot, "side": side, "top": top}


def downwind(parameters: Parameters) -> Vector:
    """Unit vector [E] that the wind blows along."""
    azimuth = parameters.wind.azimuth
    return Vector(-cos(azimuth), -sin(azimuth), 0.0)


def _level(v_E: Vector, otherwise: Vector) -> Vector:
    """The horizontal direction of `v_E`, or `otherwise` where it has none."""
    size = hypot(v_E.x, v_E.y)
    return Vector(v_E.x / size, v_E.y / size, 0.0) if size > 1e-9 else otherwise


def _unit(v: Vector) -> Vector:
    return times(1.0 / norm(v), v)
