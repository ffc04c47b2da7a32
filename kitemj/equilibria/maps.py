"""Maps of the growth of the least stable mode over two parameters."""

from dataclasses import dataclass

import numpy as np

from kitemj.equilibria.minimal import Array
from kitemj.equilibria.modes import growth_or_nan
from kitemj.equilibria.vary import check_range, unit_of, with_value
from kitemj.errors import InputError
from kitemj.physics.parameters import Parameters
from kitemj.progress_bar import with_progress

MOST_POINTS = 1000
"""Along each parameter: a million in all take an hour or two."""


@dataclass(frozen=True)
class Axis:
    """One parameter of a map: `name`, `unit`, `values` (n,)."""

    name: str
    unit: str
    values: Array


@dataclass(frozen=True)
class StabilityMap:
    """`real` [1/s] and `omega` [rad/s] of the least stable eigenvalue, indexed [y, x].

    Not a number where there is no equilibrium. `V_ref` [m/s] is what the rates were scaled
    by all over the map; None: it is one of the axes, or the law has none.
    """

    x: Axis
    y: Axis
    real: Array
    omega: Array
    V_ref: float | None


def stability_map(
    parameters: Parameters,
    x: tuple[str, float, float],
    y: tuple[str, float, float],
    points: int = 100,
    ell: float | None = None,
    delta: float = 0.0,
) -> StabilityMap:
    """The map of stability over two parameters, by Lagrange's equations.

    parameters: the set; the two are changed in it
    x: name, least and largest value (in the parameter's unit) along the map
    y: the same up the map
    points: how many values along either
    ell: m; None: ℓ₀, which follows `lines.length`
    delta: rad

    Raises InputError for unknown names, ranges no set may have, and where nothing stands anywhere.
    """
    if x[0] == y[0]:
        raise InputError(f"a map needs two different parameters, got {x[0]} twice")
    if not 2 <= points <= MOST_POINTS:
        known = f"a map needs 2 or more points along each parameter, {MOST_POINTS} at most"
        raise InputError(f"{known}, got {points}")
    for name, low, high in (x, y):
        check_range(parameters, name, low, high)
    axes = [
        Axis(name, unit_of(parameters, name), np.linspace(low, high, points))
        for name, low, high in (x, y)
    ]
    values = np.full((points, points), complex(np.nan, np.nan))
    for j, y_value in enumerate(with_progress("rows of the map", axes[1].values, points)):
        row = with_value(parameters, y[0], float(y_value))
        for i, x_value in enumerate(axes[0].values):
            values[j, i] = growth_or_nan(with_value(row, x[0], float(x_value)), ell, delta)
    if np.isnan(values.real).all():
        where = ", ".join(f"{name} {low:g} to {high:g}" for name, low, high in (x, y))
        raise InputError(f"there is no equilibrium anywhere in {where}; give other ranges")
    varied = "aero.V_ref" in (x[0], y[0])
    V_ref = None if varied else getattr(parameters.aero, "V_ref", None)
    return StabilityMap(axes[0], axes[1], values.real.copy(), values.imag.copy(), V_ref)
