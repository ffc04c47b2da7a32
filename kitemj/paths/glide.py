"""How a kite glides: lift over drag, and the speed along a path with weight and mass."""

from math import cos, hypot, sin
from typing import NamedTuple

import numpy as np

from kitemj.flight.equilibrium import equilibrium
from kitemj.paths.path import Path, nose_turning
from kitemj.physics.aerodynamics import coefficients
from kitemj.physics.compiled import Array, compiled
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector
from kitemj.physics.wind import Wind

STOPPED = 0.1
"""winds; a kite that would be slower has stopped on its way, and is held at this."""
LAPS = 20
"""Of the sum for the speed, at most; it forgets its beginning in a lap or two."""
SETTLED = 1e-9
"""winds; a lap that ends as it began, to this, is the one that repeats."""
NEWTON, NUDGE = 4, 1e-6
"""Steps to the speed at the next point; winds, for a difference."""
ASKEW = 0.2
"""Cosine of the drift, at least: beyond 78° a course is no use of the nose."""


class Trim(NamedTuple):
    """A kite that glides without weight: its angle of attack [rad], and coefficients there."""

    alpha: float
    lift: float
    drag: float


def trim(parameters: Parameters) -> Trim:
    """Of the set where the moments of the air and the lines balance, at any speed.

    That is the equilibrium without weight, so that the wind does not matter. Raises InputError
    where there is none.
    """
    air = parameters.environment._replace(gravity=0.0)
    weightless = parameters._replace(environment=air, wind=Wind(1.0))
    alpha = equilibrium(weightless).alpha
    still = Vector(0.0, 0.0, 0.0)
    C = coefficients(parameters.aero, parameters.kite, alpha, 0.0, still, 1.0)
    s, c = sin(alpha), cos(alpha)
    return Trim(alpha, -C.z * c + C.x * s, -C.x * c - C.z * s)


def glide_ratio(parameters: Parameters) -> float:
    """Lift over drag of the kite of the set at its `trim`; the wind does not matter."""
    found = trim(parameters)
    return found.lift / found.drag


def with_weight(path: Path, parameters: Parameters) -> Path:
    """`path` with the speed and the turning of a kite that has weight and mass.

    In the steady wind of the set; it is for before the flight. The sum goes around until it
    repeats. A speed of `STOPPED` says that the kite does not come past that place.
    """
    kite, air, wind = parameters.kite, parameters.environment, parameters.wind.speed
    length, found = parameters.lines.length, trim(parameters)
    drag = air.air_density * kite.area * found.drag * length / (2 * kite.mass)
    weight = air.gravity * length / wind**2
    speed = _speeds(path, found.lift / found.drag, drag, weight)
    return path._replace(speed=speed, turning=nose_turning(path, speed))


@compiled
def _speeds(path: Path, glide: float, drag: float, weight: float) -> Array:
    """Speeds (n,) in winds: v²/2 along the way by backward differences of second order.

    They are steady for any mass, however little.

    glide   lift over drag
    drag    ρ S C_D L / (2 m)
    weight  g L / W²
    """
    n, found = len(path.points), path.speed.copy()
    v = max(STOPPED, found[0])
    last, now = v * v / 2, v * v / 2
    for _ in range(LAPS):
        before = v
        for i in range(n):
            found[i] = v
            known = (4 * now - last) / 3
            for _ in range(NEWTON):
                push = _push(path, (i + 1) % n, v, glide, drag, weight)
                slope = (_push(path, (i + 1) % n, v + NUDGE, glide, drag, weight) - push) / NUDGE
                step = 2 * path.spacing / 3
                v -= (v * v / 2 - known - step * push) / max(v - step * slope, STOPPED)
                v = max(v, STOPPED)
            last, now = now, v * v / 2
        if abs(v - before) < SETTLED:
            break
    return found


@compiled
def _push(path: Path, i: int, v: float, glide: float, drag: float, weight: float) -> float:
    """What drives the kite on at point `i` at the speed `v`: change of v²/2 for each rad of way.

    The air pushes along the nose, and across it as the path demands; in winds, lines, masses.
    """
    p, t = path.points[i], path.ahead[i]
    inflow = p[0]
    # right of the course, ahead x p: its downwind and its upward part
    right_x, right_z = t[1] * p[2] - t[2] * p[1], t[0] * p[1] - t[1] * p[0]
    along, aside = v - t[0], -right_x
    across = hypot(along, aside)
    c, s = along / across, aside / across
    airspeed = hypot(across, inflow)
    push = drag * airspeed * (glide * inflow - across) - weight * (t[2] * c + right_z * s)
    return float((push - v * v * path.curvature[i] * s) / max(c, ASKEW))


def airspeeds(path: Path) -> Array:
    """Speeds (n,) in winds at which the kite meets the air along `path`."""
    downwind = np.array([1.0, 0.0, 0.0])
    return np.asarray(np.linalg.norm(path.speed[:, None] * path.ahead - downwind, axis=1))
