"""The kite as its observer knows it: a point that glides on the sphere and turns by its law.

The air pushes it along the nose (lift over drag), across it (side force, and the lift that leans
with δ), and the nose answers to δ after a way flown. Wind is a state, to be found.
"""

from math import exp, hypot, sqrt
from typing import NamedTuple

import numpy as np

from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.paths.glide import trim
from kitemj.paths.sphere import right_of, tangential
from kitemj.physics.aerodynamics import coefficients
from kitemj.physics.compiled import Array, compiled
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, norm, plus, times
from kitemj.turning.gains import turn_gain

STATES = 8
"""Errors along the nose and to its right [rad], of the heading [rad], of along, across [m/s],
turning, bias [rad/s] and wind [m/s]: rows of the covariance."""
SLIP = 0.05
"""rad of β between which the slope of the side force is taken."""
SLOWEST = 1.0
"""m/s of air, at least, that the model reckons with."""


class Glide(NamedTuple):
    """Numbers of a set: `push` ρ S / (2 m) [1/m]; lift, drag, normal force, and the slope of the
    side force [1/rad] at trim; `mass` [kg], `gravity` [m/s²], `beyond` [m], G from the midpoint
    of the attachments."""

    push: float
    lift: float
    drag: float
    normal: float
    side: float
    mass: float
    gravity: float
    beyond: float


class Flying(NamedTuple):
    """The kite at `t` [s]: where G and its nose are seen, unit vectors; velocity of G `along` the
    nose and `across` it to the right [m/s]; `turning` of the nose about the line and what the law
    does not know of it, `bias` [rad/s]; `wind` [m/s]."""

    t: float
    p: Vector
    nose: Vector
    along: float
    across: float
    turning: float
    bias: float
    wind: float


def glide_of(parameters: Parameters) -> Glide:
    """Of a set. Raises InputError where it has no trim."""
    kite, air, found = parameters.kite, parameters.environment, trim(parameters)
    still, side = Vector(0.0, 0.0, 0.0), []
    for beta in (-SLIP, SLIP):
        side.append(coefficients(parameters.aero, kite, found.alpha, beta, still, 10.0).y)
    normal = -coefficients(parameters.aero, kite, found.alpha, 0.0, still, 10.0).z
    slope = (side[0] - side[1]) / (2 * SLIP)
    push = air.air_density * kite.area / (2 * kite.mass)
    numbers = push, found.lift, found.drag, normal, slope
    return Glide(*numbers, kite.mass, air.gravity, kite.z_A)


@compiled
def air_met(k: Flying) -> Vector:
    """Velocity through the air [m/s]: along the nose, to its right, and how it meets the sail."""
    right = right_of(k.p, k.nose)
    return Vector(k.along - k.wind * k.nose.x, k.across - k.wind * right.x, k.wind * k.p.x)


@compiled
def moved_on(
    k: Flying, h: float, delta: float, length: float, g: Glide, law: TurnRateLaw
) -> Flying:
    """The kite `h` [s] later, with the stick at `delta` [rad] and G `length` [m] away.

    Forces implicitly in the velocity, since the air stops a light kite within a few ticks.
    """
    right, air = right_of(k.p, k.nose), air_met(k)
    v = max(norm(air), SLOWEST)
    pull = g.push * v
    forward = pull * (g.lift * air.z + g.drag * k.wind * k.nose.x) - g.gravity * k.nose.z
    aside = pull * (g.side * (k.wind * right.x - delta * air.z) + g.normal * v * delta)
    aside -= g.gravity * right.z
    along = (k.along + h * (forward + k.turning * k.across)) / (1.0 + h * pull * g.drag)
    across = (k.across + h * (aside - k.turning * k.along)) / (1.0 + h * pull * g.side)
    asked = turn_gain(law, v) * delta - law.c2 / v * right.z + k.bias
    keep = exp(-h * v / max(law.lag, 0.1))
    turning = asked + (k.turning - asked) * keep
    u, w, r = (k.along + along) / 2, (k.across + across) / 2, (k.turning + turning) / 2
    p = plus(k.p, times(h / length, plus(times(u, k.nose), times(w, right))))
    p = times(1.0 / norm(p), p)
    nose = tangential(p, plus(k.nose, times(h * r, right)))
    nose = times(1.0 / norm(nose), nose)
    return Flying(k.t + h, p, nose, along, across, turning, k.bias, k.wind)


@compiled
def errors_grow(k: Flying, h: float, length: float, g: Glide, law: TurnRateLaw) -> Array:
    """(STATES, STATES): what errors now make of errors `h` [s] later, by the same equations."""
    right, air = right_of(k.p, k.nose), air_met(k)
    v = max(norm(air), SLOWEST)
    pull, F = g.push * v, np.eye(STATES)
    F[0, 1], F[0, 2], F[0, 3] = h * k.turning, -h * k.across / length, h / length
    F[1, 0], F[1, 2], F[1, 4] = -h * k.turning, h * k.along / length, h / length
    F[2, 5] = h
    d, s = 1.0 / (1.0 + h * pull * g.drag), 1.0 / (1.0 + h * pull * g.side)
    F[3, 3], F[3, 4], F[3, 5] = d, d * h * k.turning, d * h * k.across
    F[3, 2] = d * h * (pull * g.drag * k.wind * right.x - g.gravity * right.z)
    F[3, 7] = d * h * pull * (g.lift * k.p.x + g.drag * k.nose.x)
    F[4, 4], F[4, 3], F[4, 5] = s, -s * h * k.turning, -s * h * k.along
    F[4, 2] = s * h * (-pull * g.side * k.wind * k.nose.x + g.gravity * k.nose.z)
    F[4, 7] = s * h * pull * g.side * right.x
    keep = exp(-h * v / max(law.lag, 0.1))
    F[5, 5], F[5, 6] = keep, 1.0 - keep
    return F


@compiled
def airspeed_by_pull(pull: float, k: Flying, length: float, g: Glide) -> float:
    """Airspeed [m/s] of a kite at trim whose lines pull with `pull` [N] in all.

    T = ½ ρ S C_R v_a² + m v²/ℓ - m g sin(elevation).
    """
    inertia = g.mass * (k.along * k.along + k.across * k.across) / length
    air = pull + g.mass * g.gravity * k.p.z - inertia
    return sqrt(max(air, 0.0) / (g.push * g.mass * hypot(g.lift, g.drag)))
