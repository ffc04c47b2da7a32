"""Results of trim and stability as tables: for people, CSV, Parquet and JSON alike."""

from collections.abc import Sequence
from math import degrees

from kitemj.equilibria.linearise import INPUTS, OUTPUTS, STATES, Linear
from kitemj.equilibria.maps import StabilityMap
from kitemj.equilibria.modes import Crossing
from kitemj.equilibria.trim import Trim
from kitemj.tables import Cell, Table


def v_ref_note(V_ref: float | None) -> str:
    """The convention that moves the threshold of C_lβ by half, in one sentence; or nothing."""
    if V_ref is None:
        return ""
    return (
        f"rates are scaled by aero.V_ref = {V_ref:g} m/s, a fixed number of the set that does "
        f"not follow the wind"
    )


def trim_table(trims: Sequence[Trim]) -> Table:
    """A row for each equilibrium and model."""
    columns = (
        "model",
        "alpha_deg",
        "beta_deg",
        "phi_rad",
        "gamma_rad",
        "eta_rad",
        "theta_rad",
        "elevation_deg",
        "azimuth_deg",
        "height_m",
        "tension_plus_N",
        "tension_minus_N",
        "ell_m",
        "delta_rad",
        "residual",
    )
    rows: list[tuple[Cell, ...]] = [
        (
            trim.model,
            degrees(trim.alpha),
            degrees(trim.beta),
            *trim.q,
            degrees(trim.elevation),
            degrees(trim.azimuth),
            trim.height,
            *trim.tensions,
            trim.ell,
            trim.delta,
            trim.residual,
        )
        for trim in trims
    ]
    return Table("equilibria", columns, rows)


def crossing_table(found: list[Crossing]) -> Table:
    """A row for each change of stability."""
    columns = ("model", "parameter", "value", "unit", "omega_rad_per_s", "frequency_Hz", "mode")
    rows: list[tuple[Cell, ...]] = [
        (
            c.model,
            c.parameter,
            c.value,
            c.unit,
            c.omega,
            c.frequency,
            c.mode,
            "above" if c.above else "below",
        )
        for c in found
    ]
    return Table("changes of stability", (*columns, "stable"), rows)


def map_table(found: StabilityMap) -> Table:
    """A row for each point; not-a-number where there is no equilibrium."""
    columns = (found.x.name, found.y.name, "real_per_s", "imag_rad_per_s")
    return Table("stability map", columns, list(found.rows()))


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
