"""The modes of an equilibrium, and the values of a parameter at which stability is lost.

The aerodynamic rates are scaled by `aero.V_ref`, a fixed number of the set (7 m/s) that does
NOT follow the wind. This moves the threshold of C_lβ by half: in a wind of 10 m/s the laksa
kite loses its stability at -0.4927 with V_ref = 7 m/s, and at -0.2986 with V_ref = 10 m/s.
"""

from dataclasses import dataclass
from math import log, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from kitemj.dynamics.lagrange import body
from kitemj.equilibria.linearise import Linear, linearise, state_matrix
from kitemj.equilibria.minimal import Array, Minimal, state_of
from kitemj.equilibria.trim import Trim, trimmed
from kitemj.equilibria.vary import check_range, unit_of, with_value
from kitemj.errors import InputError, NothingFound
from kitemj.physics.frames import R_1E, Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control
from kitemj.tables import Table, Tabled

POINTS = 81
"""Of a range in which changes of stability are looked for."""
SHARE = 0.01
"""Of a mode's kinetic energy; a motion with more of it is named: on long lines 1 % is much yaw."""
MOTIONS = ("sway", "heave", "roll", "pitch", "yaw")
"""G sideways; G within the plane of symmetry; turns about x_B, y_B, z_B."""


PLAINLY = {
    "sway": "sideways",
    "heave": "up and down",
    "roll": "rolling",
    "pitch": "nose up and down",
    "yaw": "nose left and right",
}
"""Each of `MOTIONS` as anybody calls it."""


class Mode(NamedTuple):
    """One real eigenvalue, or a pair λ = real ± i imag [1/s].

    `frequency` [Hz] = imag/2π; `damping` = -real/|λ|; `time_constant` [s] = 1/|real|;
    `error` [1/s]: what λ is uncertain by for the shown error of A. `name`: what moves, most
    first, and how; `shares` of the kinetic energy in the order of `MOTIONS`.
    """

    real: float
    imag: float
    frequency: float
    damping: float
    time_constant: float
    error: float
    name: str
    shares: tuple[float, ...]


@dataclass(frozen=True)
class Stability(Tabled):
    """The linear system, its modes (least stable first), and the V_ref [m/s] it holds for."""

    linear: Linear
    modes: list[Mode]
    V_ref: float | None

    @property
    def stable(self) -> bool:
        """Whether every disturbance dies out."""
        return self.modes[0].real < 0

    @property
    def in_words(self) -> str:
        """Whether it stays there, and the motion that decides it, in a sentence."""
        mode, growing = self.modes[0], sum(mode.real > 0 for mode in self.modes)
        moves = PLAINLY[MOTIONS[int(np.argmax(mode.shares))]]
        if mode.imag:
            moves = f"swinging {moves}, {_seconds(1 / mode.frequency)} a swing"
        if abs(mode.real) <= mode.error:
            known = f"{mode.real:.2g} ± {mode.error:.2g} 1/s"
            return f"on the border of stability: {moves}, neither dies out nor grows ({known})"
        change = _seconds(log(2) * mode.time_constant)
        if self.stable:
            return f"stable; slowest: {moves}, halved in {change}"
        more = f"; others that grow: {growing - 1}" if growing > 1 else ""
        return f"unstable: {moves}, doubled in {change}{more}"

    def tables(self) -> list[Table]:
        """A row for each mode, least stable first."""
        columns = (
            *("model", "mode", "real_per_s", "imag_rad_per_s", "frequency_Hz", "damping"),
            *("time_constant_s", "error_per_s", *(f"share_{motion}" for motion in MOTIONS)),
        )
        model = self.linear.model
        return [Table("modes", columns, [(model, m.name, *m[:6], *m.shares) for m in self.modes])]


class Crossing(NamedTuple):
    """Where a parameter takes or gives stability.

    `value` in the parameter's `unit`; `omega` [rad/s] and `frequency` [Hz] of the mode there
    (0: it leaves without swinging); `above`: whether the kite is stable above `value`.
    """

    parameter: str
    value: float
    unit: str
    omega: float
    frequency: float
    mode: str
    above: bool
    model: str


def stability(
    parameters: Parameters,
    ell: float | None = None,
    delta: float = 0.0,
    model: str = "lagrange",
    source: str = "parameters",
) -> Stability:
    """The linear system and modes about the equilibrium of least α, lines held.

    `ell` [m] (None: ℓ₀), `delta` [rad]. Raises InputError where there is no equilibrium.
    """
    x0, control = trimmed(parameters, ell, delta, source)
    return _stability_at(parameters, model, x0, control)


def stability_of(parameters: Parameters, trim: Trim) -> Stability:
    """The same about an equilibrium that was found, by its own model."""
    x0 = np.concatenate((trim.q, np.zeros(4)))
    return _stability_at(parameters, trim.model, x0, trim.control)


def _stability_at(parameters: Parameters, model: str, x0: Array, control: Control) -> Stability:
    linear = linearise(Minimal(model, parameters), x0, control)
    return Stability(linear, modes(parameters, linear), getattr(parameters.aero, "V_ref", None))


def modes(parameters: Parameters, linear: Linear) -> list[Mode]:
    """The modes of `linear`, least stable first; a pair of eigenvalues is one mode."""
    values, vectors = np.linalg.eig(linear.A)
    rows = np.linalg.pinv(vectors)  # left eigenvectors; also where two modes coincide
    found = []
    for i in np.argsort(-values.real):
        if values[i].imag < 0:
            continue
        error = np.abs(rows[i]) @ linear.A_error @ np.abs(vectors[:, i])
        shares = energy_shares(parameters, linear, vectors[:, i])
        found.append(_mode(complex(values[i]), float(error), shares))
    return found


def growth(
    parameters: Parameters, ell: float | None = None, delta: float = 0.0, model: str = "lagrange"
) -> complex:
    """The least stable eigenvalue [1/s], imag >= 0; raises InputError without equilibrium."""
    x0, control = trimmed(parameters, ell, delta)
    values = np.linalg.eigvals(state_matrix(Minimal(model, parameters), x0, control))
    worst = complex(values[np.argmax(values.real)])
    return complex(worst.real, abs(worst.imag))


def growth_or_nan(
    parameters: Parameters, ell: float | None, delta: float, model: str = "lagrange"
) -> complex:
    """`growth`; not a number where there is no equilibrium."""
    try:
        return growth(parameters, ell, delta, model)
    except InputError:
        return complex(np.nan, np.nan)


def crossings(
    parameters: Parameters,
    name: str,
    low: float,
    high: float,
    ell: float | None = None,
    delta: float = 0.0,
    model: str = "lagrange",
) -> list[Crossing]:
    """Every value of a parameter in a range at which stability changes.

    parameters: the set; one number is changed in it
    name: of the parameter, with dots
    low: least value, in the parameter's unit
    high: largest value
    ell: m; None: ℓ₀, which follows the length of the lines
    delta: rad
    model: name of the formulation

    Looked for between `POINTS` values, so that two changes closer than the range over 80 can
    be missed; each is then found to 12 digits by Brent's method on the largest real part.
    Raises InputError for an unknown name and a range no set may have, NothingFound for a range
    with no change or no equilibrium in it.
    """
    check_range(parameters, name, low, high)

    def varied(value: float) -> Parameters:
        return with_value(parameters, name, value)

    def real(value: float) -> float:
        return growth(varied(value), ell, delta, model).real

    grid = np.linspace(low, high, POINTS)
    reals = np.array([growth_or_nan(varied(float(v)), ell, delta, model).real for v in grid])
    changed = ((reals[:-1] < 0) != (reals[1:] < 0)) & np.isfinite(reals[:-1] + reals[1:])
    if not changed.any():
        raise _no_change(parameters, name, grid, reals)
    found = []
    for i in np.flatnonzero(changed):
        value = float(brentq(real, grid[i], grid[i + 1], xtol=1e-13, rtol=1e-12))
        least = stability(varied(value), ell, delta, model).modes[0]
        unit, above = unit_of(parameters, name), bool(reals[i + 1] < 0)
        omega, what = least.imag, least.name.rsplit(" ", 1)[0]
        mode = f"{what} {'swing' if omega > 0 else 'drift'}"
        found.append(Crossing(name, value, unit, omega, omega / (2 * pi), mode, above, model))
    return found


def _no_change(parameters: Parameters, name: str, grid: Array, reals: Array) -> NothingFound:
    unit = f" {unit_of(parameters, name)}".rstrip()
    where = f"for {name} from {grid[0]:g} to {grid[-1]:g}{unit}"
    known = np.isfinite(reals)
    if not known.any():
        return NothingFound(f"there is no equilibrium {where}; give another range")
    what = "stable" if (reals[known] < 0).all() else "unstable"
    if (reals[known] < 0).any() and (reals[known] >= 0).any():
        what = "stable in part and unstable in part, with no equilibrium between,"
    missing = "" if known.all() else f" wherever it stands ({np.sum(known)} of {POINTS} values)"
    return NothingFound(
        f"the equilibrium is {what}{missing} {where}: no stability is lost (largest real part "
        f"{np.nanmin(reals):.4g} to {np.nanmax(reals):.4g} 1/s); give another range"
    )


def _seconds(duration: float) -> str:
    """A duration [s] as people say it."""
    return f"{duration:.2g} s" if duration < 99.5 else f"{duration:.0f} s"


def _mode(value: complex, error: float, shares: tuple[float, ...]) -> Mode:
    order = np.argsort(-np.array(shares))
    real, imag, size = value.real, abs(value.imag), abs(value)
    damping, time_constant = -real / size if size else 0.0, 1 / abs(real) if real else float("inf")
    how = "swing" if imag > 0 else "decay" if real < 0 else "growth"
    name = f"{' + '.join(MOTIONS[i] for i in order if shares[i] >= SHARE)} {how}"
    return Mode(real, imag, imag / (2 * pi), damping, time_constant, error, name, shares)


def energy_shares(
    parameters: Parameters, linear: Linear, vector: NDArray[np.complex128]
) -> tuple[float, ...]:
    """Parts of the kinetic energy of the motion q = `vector`[:4], in the order of `MOTIONS`.

    Products of inertia are left out; sideways is along y_1, across the plane of the lines.
    """
    kite, (q, _) = parameters.kite, state_of(linear.x0)
    sideways = np.array(R_1E(q.phi, q.gamma).y)
    energy = np.zeros(5)
    for part in (vector[:4].real, vector[:4].imag):
        moved = body(parameters, q, Angles(*map(float, part)), linear.control)
        v, w = np.array(moved.v_G_E), moved.omega_B
        across = float(sideways @ v)
        sway, heave = kite.mass * across**2, kite.mass * (float(v @ v) - across**2)
        turns = (kite.inertia_x * w.x**2, kite.inertia_y * w.y**2, kite.inertia_z * w.z**2)
        energy += (sway, heave, *turns)
    return tuple((energy / energy.sum()).tolist())
