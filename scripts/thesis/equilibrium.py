"""Section 3: the equilibrium, by a scalar equation and by each of the three models."""

from math import atan2, cos, degrees, hypot, radians, sin
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from kitemj.equilibria.trim import equilibria
from kitemj.equilibria.vary import with_value
from kitemj.physics.aerodynamics import LinearAero
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.tables import Cell, Table
from thesis.section import Answer, Drawing, NamedTable, Section
from thesis.subplots import subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SETS = ("thesis", "laksa")
LENGTHS = (80.0, 200.0)
ANSWERS: tuple[Answer, ...] = ()


def section(scratch: Path) -> Section:
    """Both sets on lines of both `LENGTHS`."""
    table = equilibrium_table()
    worst = max(float(row[-1]) for row in table.rows)
    return Section(
        "The equilibrium (section 3, Equilibrium_KA)",
        ANSWERS,
        thesis=[
            "Every flight starts where the kite stands still in the wind. A function of LAKSA "
            "looks for that place and stops with an error where there is none; the thesis prints "
            "no numbers of it.",
        ],
        here=[
            "At rest the angle of attack solves one scalar equation that needs no dynamics: "
            "Λ (X_A cos α + Z_A sin α) + c (C_m0 + C_mα α) − Z_A (C_x0 + C_xα α) + "
            "X_A (C_z0 + C_zα α) = 0, with Λ = 2 m g / (ρ S V²). It is solved here by itself, "
            "and each of the three models finds its own place of no acceleration.",
            f"All agree to {worst:.0e}° in α. Neither the length of the lines nor C_lβ is in the "
            "equation, so the kite stands at the same α, γ and θ on 80 m and on 200 m; only the "
            "tension differs, by the angle between the lines. Between nose down and stall there is "
            "one equilibrium.",
        ],
        drawings=[
            Drawing(
                "standing_equation",
                "The scalar equation, divided by c: it balances where the curve crosses zero. "
                "Shaded: beyond stall, or nose down.",
                _figure(),
            )
        ],
        tables=[NamedTable("standing", table)],
    )


def imbalance(parameters: Parameters, alpha: float) -> float:
    """The scalar equation at `alpha` [rad], divided by the chord."""
    kite, aero, environment = parameters.kite, parameters.aero, parameters.environment
    assert isinstance(aero, LinearAero)  # the equation is that of the linear law
    load = 2 * kite.mass * environment.gravity
    load /= environment.air_density * kite.area * parameters.wind.speed**2
    return (
        load * (kite.x_A * cos(alpha) + kite.z_A * sin(alpha))
        + kite.chord * (aero.Cm_0 + aero.Cm_alpha * alpha)
        - kite.z_A * (aero.Cx_0 + aero.Cx_alpha * alpha)
        + kite.x_A * (aero.Cz_0 + aero.Cz_alpha * alpha)
    ) / kite.chord


def by_equation(parameters: Parameters) -> tuple[float, float, float, float]:
    """α, γ, θ [rad] and the tension of a line [N]: the equation, then the sum of all forces."""
    kite, aero, environment = parameters.kite, parameters.aero, parameters.environment
    assert isinstance(aero, LinearAero)
    alpha = float(
        brentq(lambda a: imbalance(parameters, a), 0.0, parameters.limits.alpha_stall, xtol=1e-15)
    )
    air = 0.5 * environment.air_density * kite.area * parameters.wind.speed**2
    X, Z = air * (aero.Cx_0 + aero.Cx_alpha * alpha), air * (aero.Cz_0 + aero.Cz_alpha * alpha)
    ahead = X * cos(alpha) + Z * sin(alpha)
    down = Z * cos(alpha) - X * sin(alpha) + kite.mass * environment.gravity
    gamma = atan2(-ahead, -down)
    half_angle_cosine = (1 - (kite.y_A / parameters.lines.length) ** 2) ** 0.5
    return alpha, gamma, alpha - gamma, hypot(ahead, down) / (2 * half_angle_cosine)


def equilibrium_table() -> Table:
    """A row for each set, length and way to find it."""
    rows: list[tuple[Cell, ...]] = []
    for name in SETS:
        for length in LENGTHS:
            parameters = with_value(parameter_set(name), "lines.length", length)
            alpha, gamma, theta, tension = by_equation(parameters)
            angles = map(degrees, (alpha, gamma, theta))
            rows.append((name, length, "scalar equation", *angles, tension, tension, 0.0))
            for model in ("lagrange", "newton-euler", "mujoco"):
                [found] = equilibria(parameters, model=model)
                angles = map(degrees, (found.alpha, found.q.gamma, found.q.theta))
                gap = abs(degrees(found.alpha - alpha))
                rows.append((name, length, model, *angles, *found.tensions, gap))
    columns = ("set", "length_m", "found_by", "alpha_deg", "gamma_deg", "theta_deg")
    tensions = ("tension_plus_N", "tension_minus_N")
    return Table("The equilibrium", (*columns, *tensions, "alpha_to_equation_deg"), rows)


def _figure() -> "Figure":
    figure, ((ax,),) = subplots(1, 1, (7.0, 3.4))
    alpha: NDArray[np.float64] = np.linspace(-10.0, 40.0, 301)
    for name, style in zip(SETS, ("-", "--"), strict=True):
        parameters = parameter_set(name)
        values = [imbalance(parameters, radians(a)) for a in alpha]
        (line,) = ax.plot(alpha, values, style, color="black" if style == "-" else "tab:blue")
        root = degrees(by_equation(parameters)[0])
        line.set_label(f"{name}: α = {root:.4f}°")
        ax.plot(root, 0.0, "o", color=line.get_color(), ms=5)
    stall = degrees(parameter_set("thesis").limits.alpha_stall)
    for low, high in ((-10.0, 0.0), (stall, 40.0)):
        ax.axvspan(low, high, color="0.92", zorder=0)
    ax.axhline(0.0, color="0.4", lw=0.8)
    ax.set(xlabel="α [°]", ylabel="sum of the moments / c [-]", xlim=(-10.0, 40.0))
    ax.legend(frameon=False)
    return figure
