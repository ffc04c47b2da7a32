"""The periodic flight about an unstable equilibrium, found by shooting.

A flight from beside the unstable equilibrium is let settle (Lagrange's equations). Where it
comes back to where it was, a state x on the section x_k = its value at the equilibrium, and a
period T, are corrected by Newton's method until the flow of the asked model closes,
Φ_T(x) = x. The derivative of Φ_T, the monodromy matrix, has the Floquet multipliers as
eigenvalues; one of them is 1 (along the orbit), and how close it comes to that tells the
accuracy of the others. A cycle that repels is not found this way.

`aero.V_ref` stays what the set says, whatever the wind (see `kitemj.equilibria.modes`).
"""

from dataclasses import dataclass
from math import cos, degrees

import numpy as np
from numpy.typing import NDArray

from kitemj.equilibria.linearise import state_matrix, state_units
from kitemj.equilibria.minimal import Array, Minimal, finite, steps_for
from kitemj.equilibria.orbit import SAMPLES, Orbit, orbit
from kitemj.equilibria.shooting import (
    MOST_ROUNDS,
    STANDS,
    Closed,
    Section,
    closed,
    monodromy,
    primitive,
)
from kitemj.equilibria.trim import trimmed
from kitemj.errors import NothingFound
from kitemj.flight.limits import Departure, first_departure
from kitemj.physics.parameters import Parameters
from kitemj.tables import Cell, Table, Tabled

NUDGE = 0.2
"""rad; how far beside the equilibrium, in its growing mode, the settling flight begins."""
PATIENCE = 6000.0
"""s; of settling flight."""
LOOK = 0.05
"""s; between two looks for a crossing of the section."""
RETURNS = (1e-2, 1e-3, 1e-4, 1e-6)
"""Change from one return to the next, of the distance to the equilibrium, from which
Newton's method is tried."""

UNITS = {
    **{"x_E": "m", "y_E": "m", "height": "m", "airspeed": "m/s", "speed": "m/s"},
    **{"tension_plus": "N", "tension_minus": "N", "tension_both": "N"},
}
"""Of the quantities of an orbit; the others are angles, told in degrees."""


@dataclass(frozen=True)
class Cycle(Tabled):
    """A periodic flight with the lines held.

    `period` [s], `frequency` [Hz]; `x0` (8,) [rad, rad/s]: a state on it; `multipliers` (8,),
    largest first without the one that is 1; `trivial`: |μ - 1| of that; `residual`: how far
    it is from closing, in rad and scaled rates; `orbit`: the flight itself and its ranges;
    `departure`: the first limit of validity that it leaves, if any; `V_ref` [m/s].
    """

    model: str
    period: float
    x0: Array
    multipliers: NDArray[np.complex128]
    trivial: float
    residual: float
    orbit: Orbit
    departure: Departure | None
    V_ref: float | None

    @property
    def frequency(self) -> float:
        """Rounds a second [Hz]."""
        return 1 / self.period

    @property
    def stable(self) -> bool:
        """Whether the kite comes back to it after any small disturbance."""
        return bool(np.abs(self.multipliers[:-1]).max() < 1)

    def tables(self) -> list[Table]:
        """Least, largest and half of what lies between; the Floquet multipliers, largest first.

        The last of these would be 1 without rounding.
        """
        rows = list[tuple[Cell, ...]]()
        for name in Orbit._fields[1:]:
            span, unit = getattr(self.orbit, name), UNITS.get(name, "deg")
            low, high = map(degrees, span) if unit == "deg" else span
            rows.append((self.model, name, unit, low, high, 0.5 * (high - low)))
        columns = ("model", "quantity", "unit", "low", "high", "swing")
        sizes: list[tuple[Cell, ...]] = [
            (self.model, float(m.real), float(m.imag), float(abs(m))) for m in self.multipliers
        ]
        return [
            Table(f"cycle of {self.period:.6g} s", columns, rows),
            Table("Floquet multipliers", ("model", "real", "imag", "size"), sizes),
        ]


def cycle(
    parameters: Parameters,
    ell: float | None = None,
    delta: float = 0.0,
    model: str = "lagrange",
    source: str = "parameters",
) -> Cycle:
    """The cycle that the kite settles on when left beside its equilibrium, lines held.

    `ell` [m] (None: ℓ₀), `delta` [rad]. Raises InputError where there is no equilibrium, and
    NothingFound where it is stable, or no cycle was found.
    """
    x_eq, control = trimmed(parameters, ell, delta, source)
    lagrange = Minimal("lagrange", parameters)
    values, vectors = np.linalg.eig(state_matrix(lagrange, x_eq, control))
    worst = int(np.argmax(values.real))
    if values[worst].real <= 0:
        raise NothingFound(
            f"the equilibrium is stable (largest real part {values[worst].real:.4g} 1/s): no "
            f"cycle grows from it ({source}); vary a parameter to find where its stability is lost"
        )
    mode = vectors[:, worst]
    k = int(np.argmax(np.abs(mode[:4])))
    mode = (mode * np.exp(-1j * np.angle(mode[k]))).real
    x, t = x_eq + NUDGE * mode / np.abs(mode[:4]).max(), 0.0
    section = Section(x_eq, control, k, state_units(parameters, control.ell))
    for closeness in RETURNS:
        try:
            x, T, t = _settled(lagrange, section, x, closeness, t)
        except NothingFound as error:
            raise NothingFound(f"no cycle found ({source}): {error}") from None
        found = closed(lagrange, section, x, T)
        if found and np.abs((found.x - x_eq) / section.units).max() > STANDS:
            found = primitive(lagrange, section, found)
            break
    else:
        raise NothingFound(f"no cycle closes near the flight from the equilibrium ({source})")
    if model == "lagrange":
        return _told(lagrange, section, found)
    kite = Minimal(model, parameters)
    own = closed(kite, section, found.x, found.period, _monodromy(lagrange, section, found))
    if own is None:
        raise NothingFound(f"the cycle does not close by the model {model} ({source})")
    return _told(kite, section, own)


def _settled(
    kite: Minimal, section: Section, x: Array, closeness: float, t: float
) -> tuple[Array, float, float]:
    """Flies until the kite comes back to itself: x (8,) there, the period [s], the time [s].

    Goes on from `x` (8,) [rad, rad/s] at `t` [s]. Two passages through the section may differ
    by `closeness`, in parts of the distance to the equilibrium. Raises NothingFound.
    """
    x_eq, control, k, units = section
    returns: list[tuple[float, Array]] = []
    while t < PATIENCE:
        before, x, t = x, kite.flow(x, control, LOOK), t + LOOK
        turns = 2 * np.pi * np.round((x[:4] - x_eq[:4]) / (2 * np.pi))  # a kite that looped
        x[:4] -= turns
        before = np.concatenate((before[:4] - turns, before[4:]))
        if not np.isfinite(x).all() or cos(x[1]) < 1e-3:
            where = f"the equations' domain after {t:.0f} s"
            raise NothingFound(f"the flight from the unstable equilibrium leaves {where}")
        if not (before[k] < x_eq[k] <= x[k] < x_eq[k] + 1):
            continue
        part = (x_eq[k] - before[k]) / (x[k] - before[k])
        at = kite.flow(before, control, part * LOOK)
        at[k] = x_eq[k]
        returns.append((t - LOOK + part * LOOK, at))
        for time, other in returns[-2 : -2 - MOST_ROUNDS : -1]:
            change = np.linalg.norm((at - other) / units)
            if change < closeness * np.linalg.norm((at - x_eq) / units):
                return at, returns[-1][0] - time, t
    known = f"does not come back to itself within {PATIENCE:g} s"
    raise NothingFound(f"the flight from the unstable equilibrium {known}")


def _monodromy(kite: Minimal, section: Section, found: Closed) -> Array:
    x, T, _ = found
    M = monodromy(kite, x, T, section.control, steps_for(T), section.units)
    return finite(M, "derivatives of a round", kite.name)


def _told(kite: Minimal, section: Section, found: Closed) -> Cycle:
    x, T, gap = found
    values = np.linalg.eigvals(_monodromy(kite, section, found))
    trivial = int(np.argmin(np.abs(values - 1)))
    rest = np.delete(values, trivial)
    ordered = np.array([*rest[np.argsort(-np.abs(rest))], values[trivial]], dtype=complex)
    one, V_ref = float(abs(values[trivial] - 1)), getattr(kite.parameters.aero, "V_ref", None)
    flight = orbit(kite, x, T, section.control)
    departure = first_departure(kite.parameters, flight.motions[:SAMPLES])
    return Cycle(kite.name, T, x, ordered, one, gap, flight, departure, V_ref)
