"""ẋ = A (x - x₀) + B u, y = y₀ + C (x - x₀) + D u about an equilibrium, with its error.

x = (q, q̇) and u = (ℓ, ℓ̇, ℓ̈, δ, δ̇, δ̈) less their values at the equilibrium. The six inputs
are listed as if independent; in flight they are three derivatives of two motions.

Derivatives are central differences at steps h, h/2 and h/4, extrapolated twice (Richardson):
their error falls with h⁶. The error that is shown is the change that the second
extrapolation made, which is that of the first one, and the rounding of the differences.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise, product
from math import hypot

import numpy as np

from kitemj.dynamics.motion import air_of
from kitemj.equilibria.minimal import Array, Minimal, finite, seen
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, line_motion

STATES = ("phi", "gamma", "eta", "theta", "phi_dot", "gamma_dot", "eta_dot", "theta_dot")
"""x [rad, rad/s]."""
INPUTS = ("ell", "ell_dot", "ell_ddot", "delta", "delta_dot", "delta_ddot")
"""u [m, m/s, m/s², rad, rad/s, rad/s²]."""
OUTPUTS = (
    *("tension_plus", "tension_minus", "alpha", "beta", "airspeed", "elevation", "azimuth"),
    *("x_E", "y_E", "z_E", "length_plus", "length_minus"),
)
"""y [N, N, rad, rad, m/s, rad, rad, m, m, m, m, m]; azimuth positive to the pilot's left."""

STEP = 4e-3
"""h, of the wind's speed, of ℓ, or in rad: a change of the air's angles by a quarter degree."""
LINEAR = 100.0
"""m/s²; ℓ̈ and δ̈ enter linearly, so that a step too large does not exist."""
EPSILON = float(np.finfo(float).eps)


@dataclass(frozen=True)
class Linear:
    """A (8, 8), B (8, 6), C (12, 8), D (12, 6) about `x0` (8,) and the held `control`.

    Units follow from `STATES`, `INPUTS`, `OUTPUTS`. `error`: the same shapes, what each
    number is uncertain by.
    """

    model: str
    x0: Array
    control: Control
    y0: Array
    A: Array
    B: Array
    C: Array
    D: Array
    A_error: Array
    B_error: Array
    C_error: Array
    D_error: Array

    @property
    def error(self) -> float:
        """The largest uncertainty in A, relative to the largest of A."""
        return float(self.A_error.max() / np.abs(self.A).max())


def jacobian(
    f: Callable[[Array], Array], z0: Array, units: Array, step: float = STEP
) -> tuple[Array, Array]:
    """df/dz at `z0` (n,), shape (m, n), and the uncertainty of each element.

    `units` (n,): the size of a change that matters; each z_i is moved by `step` of it.
    """
    columns, errors = [], []
    for i, e in enumerate(np.eye(len(z0))):
        differences, size, unit = [], np.zeros(1), units[i]
        for h in (step * unit, step * unit / 2, step * unit / 4):
            above, below = z0 + h * e, z0 - h * e
            after, before = f(above), f(below)
            differences.append((after - before) / (above[i] - below[i]))  # as rounded
            size = np.maximum(np.abs(after), np.abs(before))
        once = [(4 * b - a) / 3 for a, b in pairwise(differences)]
        twice = (16 * once[1] - once[0]) / 15
        columns.append(twice)
        rounded = size + np.abs(twice * z0[i])  # of f, and of z within f
        errors.append(np.abs(twice - once[1]) + 8 * EPSILON * rounded / (step * unit))
    return np.column_stack(columns), np.column_stack(errors)


def state_units(parameters: Parameters, ell: float) -> Array:
    """Changes of x (8,) that matter to the air: 1 rad; rates that move the kite as fast as it."""
    V, arm = parameters.wind.speed, hypot(parameters.kite.x_A, parameters.kite.z_A)
    turn = V / max(arm, parameters.kite.chord)
    return np.array([1.0, 1.0, 1.0, 1.0, V / ell, V / ell, V / ell, turn])


def outputs(kite: Minimal, x: Array, control: Control) -> tuple[Array, Array]:
    """ẋ (8,) and y (12,)."""
    x_dot, (T_plus, T_minus), body = kite.answer(x, control)
    air, p, y_A = air_of(kite.parameters, body, 0.0), body.p_G_E, kite.parameters.kite.y_A
    lengths = (line_motion(y_A, control, side).length for side in (1.0, -1.0))
    return x_dot, np.array([T_plus, T_minus, *air, *seen(p), *p, *lengths])


def state_matrix(kite: Minimal, x0: Array, control: Control) -> Array:
    """A (8, 8) alone."""
    units = state_units(kite.parameters, control.ell)
    A = jacobian(lambda x: kite.answer(x, control).x_dot, x0, units)[0]
    return finite(A, "derivatives", kite.name)


def linearise(kite: Minimal, x0: Array, control: Control) -> Linear:
    """The linear system about the equilibrium `x0` (8,) with `control` held.

    Raises InputError where it is not finite.
    """

    def everything(z: Array) -> Array:
        return np.concatenate(outputs(kite, z[:8], Control(*map(float, z[8:]))))

    V, ell = kite.parameters.wind.speed, control.ell
    inputs = (ell, V, LINEAR, 1.0, V / ell, LINEAR / ell)
    units = np.array([*state_units(kite.parameters, ell), *inputs])
    J, error = jacobian(everything, np.array([*x0, *control]), units)
    y0 = finite(outputs(kite, x0, control)[1], "tensions", kite.name)
    finite(J + error, "derivatives", kite.name)
    parts = list(product((slice(8), slice(8, None)), repeat=2))
    blocks = [m[rows, columns] for m in (J, error) for rows, columns in parts]
    return Linear(kite.name, x0, control, y0, *blocks)
