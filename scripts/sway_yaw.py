"""The slow sideways motion of a two-line kite, derived by hand: two equations, no dynamics code.

About rest with the hands level, to first order (docs/handling.md derives them):

    m (L σ̈ - a ψ̈)   = -Y w + m g (sin γ ψ + cos γ σ)
    I ψ̈ + I' σ̈      = -e Y w - D ψ̇ - X σ̇
    w = L σ̇ - a ψ̇ + V (sin γ σ - cos γ ψ)

σ is the lines' swing and ψ the nose's turn about them, both to the right [rad]; w the air from
the right [m/s]. `e` is how far the side force acts ahead of the centre of mass G, `a` how far the
tow points are.

.venv/bin/python scripts/sway_yaw.py trainer
"""

import sys
from math import cos, sin
from typing import NamedTuple

import numpy as np

from kitemj.equilibria.vary import value_of, with_value
from kitemj.flight.equilibrium import equilibrium
from kitemj.flight.scenario import parameters_named
from kitemj.physics.aerodynamics import LinearAero
from kitemj.physics.parameters import Parameters
from kitemj.tables import Cell, Table, print_table


class Levers(NamedTuple):
    """What decides; `authority` is the moment of full stick over the largest one of weight."""

    e: float  # m, side force ahead of G: weight turns the nose up if it is > 0
    a: float  # m, tow points ahead of G: the hand that pulls turns the nose if a > e
    authority: float  # 1; more than 1 loops from rest
    damping: float  # 1/s; D / I, of the nose's turning
    carried: float  # 1/s; V / L, how fast the kite flies off where it points


def levers(parameters: Parameters) -> Levers:
    """The levers of a set at rest in its wind, δ = 0."""
    kite, rest = parameters.kite, equilibrium(parameters)
    turned, damped = _yaw(parameters, rest.theta)
    e, a = _ahead(parameters, rest.theta)
    weight = kite.mass * parameters.environment.gravity
    pull = 2 * rest.tension * sin(parameters.stick.delta)
    authority = (a - e) * pull / (e * weight)
    return Levers(e, a, authority, damped / turned, parameters.wind.speed / parameters.lines.length)


def sway_yaw(parameters: Parameters) -> list[complex]:
    """The four eigenvalues [1/s] of the equations above, the slowest to decay first."""
    kite, aero, rest = parameters.kite, parameters.aero, equilibrium(parameters)
    assert isinstance(aero, LinearAero)
    s, c, sg, cg = sin(rest.theta), cos(rest.theta), sin(rest.gamma), cos(rest.gamma)
    m, V, q = kite.mass, parameters.wind.speed, _pressure(parameters)
    mg, Y = m * parameters.environment.gravity, q * abs(aero.Cy_beta) / V
    (e, a), (turned, D) = _ahead(parameters, rest.theta), _yaw(parameters, rest.theta)
    L = parameters.lines.length + kite.z_A * c - kite.x_A * s  # to G
    X = -q * kite.span**2 / (2 * aero.V_ref) * s * c * (aero.Cn_r - aero.Cl_p)
    inertia = np.array([[m * L, -m * a], [s * c * (kite.inertia_z - kite.inertia_x), turned]])
    rates = np.array([[Y * L, -Y * a], [e * Y * L + X, D - e * Y * a]])
    angles = np.array([[Y * V * sg - mg * cg, -Y * V * cg - mg * sg], [V * sg, -V * cg]])
    angles[1] *= e * Y
    right = -np.linalg.solve(inertia, np.hstack((angles, rates)))
    values = np.linalg.eigvals(np.vstack((np.eye(4)[2:], right)))
    return [complex(values[i]) for i in np.argsort(-values.real)]


def _pressure(parameters: Parameters) -> float:
    """½ρ V² S [N]."""
    air, V = parameters.environment.air_density, parameters.wind.speed
    return 0.5 * air * V * V * parameters.kite.area


def _ahead(parameters: Parameters, theta: float) -> tuple[float, float]:
    """(e, a) [m]: side force and tow points ahead of G, across the lines."""
    kite, aero, s, c = parameters.kite, parameters.aero, sin(theta), cos(theta)
    assert isinstance(aero, LinearAero)
    e = kite.span * (aero.Cn_beta * c - aero.Cl_beta * s) / aero.Cy_beta
    return e, kite.x_A * c + kite.z_A * s


def _yaw(parameters: Parameters, theta: float) -> tuple[float, float]:
    """(I [kg m²], D [N m s]) of turning about the lines."""
    kite, aero, s, c = parameters.kite, parameters.aero, sin(theta), cos(theta)
    assert isinstance(aero, LinearAero)
    turning = -(aero.Cn_r * c * c + aero.Cl_p * s * s) * kite.span**2 / (2 * aero.V_ref)
    return kite.inertia_x * s * s + kite.inertia_z * c * c, _pressure(parameters) * turning


MORE = 0.2
"""Of a parameter; how much it is made larger to see what it does."""
VARIED = (
    *("lines.length", "wind.speed", "kite.mass", "kite.inertia_z", "kite.x_A", "kite.z_A"),
    *("kite.area", "kite.span", "aero.Cx_0", "aero.Cm_0", "aero.Cy_beta", "aero.Cl_beta"),
    *("aero.Cl_p", "aero.Cn_beta", "aero.Cn_r"),
)


def sensitivity(kite: str) -> Table:
    """A row for each parameter made larger, by itself: the levers and the slow eigenvalues."""
    given, rows = parameters_named(kite), list[tuple[Cell, ...]]()
    for name in ("as it is", *VARIED):
        varied = given
        if name in VARIED:
            varied = with_value(given, name, (1 + MORE) * value_of(given, name))
        lever, values = levers(varied), sway_yaw(varied)[:3]
        slow = max(value.real for value in values)
        swing = max((value for value in values), key=lambda value: value.imag)
        shown = f"{swing.real:.2f} ± {swing.imag:.2f}i" if swing.imag else "none"
        numbers = (f"{1e3 * lever.e:.0f}", f"{1e3 * lever.a:.0f}", f"{lever.authority:.1f}")
        rows.append((name, *numbers, f"{lever.damping:.1f}", f"{slow:.2f}", shown))
    columns = ("20 % more", "e [mm]", "a [mm]", "full stick / weight", "D/I [1/s]")
    return Table(kite, (*columns, "slowest [1/s]", "swing [1/s]"), rows)


if __name__ == "__main__":
    for each in sys.argv[1:] or ["trainer"]:
        print_table(sensitivity(each))
