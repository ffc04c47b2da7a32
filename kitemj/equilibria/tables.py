"""Results of trim and stability as tables: for people, CSV, Parquet and JSON alike."""

from collections.abc import Sequence
from math import degrees

import numpy as np

from kitemj.equilibria.linearise import INPUTS, OUTPUTS, STATES, Linear
from kitemj.equilibria.maps import StabilityMap
from kitemj.equilibria.modes import Crossing
from kitemj.equilibria.trim import Trim
from kitemj.tables import Cell, Table


def v_ref_note(V_ref: float | None) -> str:
    """The convention that moves the threshold of C_lβ by half, in one sentence; or nothing."""
    fixed = "a fixed number of the set that does not follow the wind"
    return "" if V_ref is None else f"rates are scaled by aero.V_ref = {V_ref:g} m/s, {fixed}"


def trim_table(trims: Sequence[Trim]) -> Table:
    """A row for each equilibrium and model."""
    columns = (
        *("model", "alpha_deg", "beta_deg", "phi_rad", "gamma_rad", "eta_rad", "theta_rad"),
        *("elevation_deg", "azimuth_deg", "height_m", "tension_plus_N", "tension_minus_N"),
        *("ell_m", "delta_rad", "residual"),
    )
    rows = list[tuple[Cell, ...]]()
    for trim in trims:
        air, seen = (trim.alpha, trim.beta), (trim.elevation, trim.azimuth)
        pose = (*map(degrees, air), *trim.q, *map(degrees, seen), trim.height)
        rows.append((trim.model, *pose, *trim.tensions, trim.ell, trim.delta, trim.residual))
    return Table("equilibria", columns, rows)


def crossing_table(found: list[Crossing]) -> Table:
    """A row for each change of stability."""
    columns = ("model", "parameter", "value", "unit", "omega_rad_per_s", "frequency_Hz", "mode")
    rows: list[tuple[Cell, ...]] = [
        (crossing.model, *crossing[:6], "above" if crossing.above else "below")
        for crossing in found
    ]
    return Table("changes of stability", (*columns, "stable"), rows)


def map_table(found: StabilityMap) -> Table:
    """A row for each point; not-a-number where there is no equilibrium."""
    columns = (found.x.name, found.y.name, "real_per_s", "imag_rad_per_s")
    values = (*np.meshgrid(found.x.values, found.y.values), found.real, found.omega)
    rows = zip(*(each.ravel().tolist() for each in values), strict=True)
    return Table("stability map", columns, list(rows))


def matrices(linear: Linear) -> dict[str, object]:
    """A, B, C, D, their uncertainties and the names of rows and columns, as JSON has them."""
    names = ("A", "B", "C", "D", "A_error", "B_error", "C_error", "D_error", "x0", "y0")
    return {
        "model": linear.model,
        "states": list(STATES),
        "inputs": list(INPUTS),
        "outputs": list(OUTPUTS),
        "u0": list(linear.control),
        **{name: getattr(linear, name).tolist() for name in names},
    }
