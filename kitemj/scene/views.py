"""Cameras of the views, and the pixel where a point appears. All in frame E, no state.

A camera is a function of the parameters and a few numbers, and those are a function of one
motion. `kitemj.scene.eye` lets the numbers of pilot and chase follow softly.
"""

from collections.abc import Callable
from math import atan, atan2, cos, hypot, pi, radians, remainder, sin, sqrt, tan
from typing import NamedTuple

from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, cross, dot, minus, norm, plus, times

UP = Vector(0.0, 0.0, -1.0)
FIELD = radians(58.0)  # vertical angle of view
NEAR = 0.25  # m, closer is not drawn
HIGHEST = radians(85.0)  # elevation of an orbit
LOWEST = 0.6  # m above the ground that an eye stands
NEAR_ORBIT = 8.0  # spans, up to here the kite is seen with its forces
OVERHEAD = 0.7  # how far from the zenith, in parts of the lines, yaws begin to go to zero

BEHIND, ASIDE, EYE = 5.0, 0.9, 1.5  # m from O_E: behind the pilot, to the right, above ground
HORIZON = 0.78  # half heights of the frame below its middle
KITE, KITE_LOW = 0.53, 0.60  # half heights above the middle, and below it for one on the ground
EASING = radians(3.0)
WIDE, NARROW, NARROWEST = radians(53.0), radians(36.0), radians(22.0)  # with the horizon; low; far
LOW_SPAN, HIGH_SPAN = 0.035, 0.075  # of the width of a frame, at least, for a kite low and high
LOW, HIGH = radians(37.0), radians(56.0)

CHASE_FIELD = radians(50.0)
CHASE_SPANS = 3.6  # from the kite
CHASE_ABOVE = radians(7.0)  # the lines, which else would be seen from their end
CHASE_LOW = radians(3.0)  # how much lower than the kite it looks
LEAST_EYE = 0.7  # m above the ground


class Camera(NamedTuple):
    """Position [m, E]; unit vectors forward and up [E]; vertical angle of view [rad].

    `near`: whether it is near the kite, which is then seen with its forces; `wide`: whether it
    sees the whole wind window, where the kite is enlarged.
    """

    position: Vector
    forward: Vector
    up: Vector
    field: float
    near: bool = False
    wide: bool = False


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


def bearing_of(parameters: Parameters, p_E: Vector) -> tuple[float, float]:
    """(yaw to the right of downwind, elevation) [rad] of a point, for one who looks at it from O_E.

    The yaw is the azimuth, but for points high up it goes to zero: it has no jump at the
    zenith, nor for a kite that flies over the pilot, whose elevation is then beyond π/2.
    """
    wind = downwind(parameters)
    size = norm(p_E) or 1.0
    ahead, aside = dot(p_E, wind) / size, dot(p_E, cross(wind, UP)) / size
    height = dot(p_E, UP) / size
    bias = OVERHEAD * max(height, 0.0) ** 2
    yaw = atan2(aside, (ahead + sqrt(ahead * ahead + bias * bias)) / 2)
    return yaw, atan2(height, ahead * cos(yaw) + aside * sin(yaw))


def turned_to(parameters: Parameters, yaw: float, pitch: float) -> Vector:
    """Unit vector [E] `yaw` [rad] to the right of downwind and `pitch` [rad] up."""
    wind = downwind(parameters)
    level = plus(times(cos(yaw), wind), times(sin(yaw), cross(wind, UP)))
    return plus(times(cos(pitch), level), times(sin(pitch), UP))


class PilotAim(NamedTuple):
    """Yaw and elevation [rad] of the kite from the eye of the pilot view; its `field` [rad]."""

    yaw: float
    elevation: float
    field: float


def pilot_aim(parameters: Parameters, motion: Motion) -> PilotAim:
    """What the pilot view follows. Its field has room for horizon and kite alike.

    But it is never so wide that the span is less than `LOW_SPAN` of the width of a frame of 16:9,
    for which the horizon leaves it as the kite climbs; then less wide than that.
    """
    G = motion.body.p_G_E
    yaw, _ = bearing_of(parameters, G)
    sight = minus(G, _shoulder(parameters, yaw))
    elevation = atan2(dot(sight, UP), dot(sight, turned_to(parameters, yaw, 0.0)))
    # half the field has the tangent T: HORIZON T below the middle, KITE T above it
    t = tan(min(max(elevation, 0.01), HIGHEST))
    both, product = HORIZON + KITE, HORIZON * KITE
    T = (sqrt(both * both + 4 * product * t * t) - both) / (2 * product * t)
    climbed = min(max((elevation - LOW) / (HIGH - LOW), 0.0), 1.0)
    share = LOW_SPAN + (HIGH_SPAN - LOW_SPAN) * climbed
    widest = parameters.kite.span / parameters.lines.length / (share * 2 * 16 / 9)
    T = min(max(T, tan(NARROW / 2)), max(widest, tan(NARROWEST / 2)), tan(WIDE / 2))
    return PilotAim(yaw, elevation, 2 * atan(T))


def pilot_camera(parameters: Parameters, aim: PilotAim) -> Camera:
    """Behind the pilot's shoulder: the horizon low, the kite in the sky, as high as it is."""
    T = tan(aim.field / 2)
    pitch = _larger(atan(HORIZON * T), aim.elevation - atan(KITE * T))
    pitch = -_larger(-pitch, -aim.elevation - atan(KITE_LOW * T))
    return _level(_shoulder(parameters, aim.yaw), parameters, aim.yaw, pitch, aim.field)


def _larger(a: float, b: float) -> float:
    """The larger of two angles [rad], without a corner where they are equal."""
    return (a + b + hypot(a - b, EASING)) / 2


def _shoulder(parameters: Parameters, yaw: float) -> Vector:
    """The eye [m, E] behind one who has turned by `yaw` [rad]."""
    back, aside = turned_to(parameters, yaw, 0.0), turned_to(parameters, yaw + pi / 2, 0.0)
    return plus(plus(times(-BEHIND, back), times(ASIDE, aside)), times(EYE, UP))


def pilot(parameters: Parameters, motion: Motion) -> Camera:
    """The view from behind the pilot's shoulder, as it stands for a kite at rest."""
    return pilot_camera(parameters, pilot_aim(parameters, motion))


class ChaseAim(NamedTuple):
    """The kite's place [m, E]."""

    x: float
    y: float
    z: float


def chase_aim(_: Parameters, motion: Motion) -> ChaseAim:
    """What the chase view follows."""
    return ChaseAim(*motion.body.p_G_E)


def chase_camera(parameters: Parameters, aim: ChaseAim) -> Camera:
    """Some spans from the kite on the pilot's side, along the lines, a little above them."""
    kite, span = Vector(*aim), parameters.kite.span
    yaw, elevation = bearing_of(parameters, kite)
    pitch = min(max(elevation, 0.0) - CHASE_ABOVE, HIGHEST)
    distance = min(CHASE_SPANS * span, 0.6 * parameters.lines.length)
    eye = plus(kite, times(-distance, turned_to(parameters, yaw, pitch)))
    height = (LEAST_EYE - eye.z + hypot(LEAST_EYE + eye.z, 0.5)) / 2  # the larger
    camera = _level(eye._replace(z=-height), parameters, yaw, pitch - CHASE_LOW, CHASE_FIELD)
    return camera._replace(near=True)


def chase(parameters: Parameters, motion: Motion) -> Camera:
    """The view along the lines at the kite, as it stands for a kite at rest."""
    return chase_camera(parameters, chase_aim(parameters, motion))


def side(parameters: Parameters, _: Motion) -> Camera:
    """The view from the pilot's right: the wind blows from left to right."""
    L, wind = parameters.lines.length, downwind(parameters)
    target = plus(times(0.62 * L, wind), times(0.4 * L, UP))
    return looking(plus(target, times(1.5 * L, cross(wind, UP))), target)._replace(wide=True)


def top(parameters: Parameters, _: Motion) -> Camera:
    """The view from straight above: the wind blows up the picture, the pilot's left is left."""
    L, wind = parameters.lines.length, downwind(parameters)
    position = plus(times(0.42 * L, wind), times(1.9 * L, UP))
    return Camera(position, times(-1.0, UP), wind, FIELD, wide=True)


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
    return Orbit(radians(35.0), radians(-12.0), 3.0 * parameters.kite.span)


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
CAMERAS: dict[str, View] = {"pilot": pilot, "chase": chase, "side": side, "top": top}


def downwind(parameters: Parameters) -> Vector:
    """Unit vector [E] that the wind blows along."""
    azimuth = parameters.wind.azimuth
    return Vector(-cos(azimuth), -sin(azimuth), 0.0)


def _level(
    position: Vector, parameters: Parameters, yaw: float, pitch: float, field: float
) -> Camera:
    """The camera at `position` [m, E] that looks `yaw`, `pitch` [rad], the horizon level."""
    forward, up = (turned_to(parameters, yaw, p) for p in (pitch, pitch + pi / 2))
    return Camera(position, forward, up, field)


def _unit(v: Vector) -> Vector:
    return times(1.0 / norm(v), v)
