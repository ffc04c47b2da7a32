"""The kite that flew a table which does not say so: as somebody says, or a guess by its lines."""

import numpy as np

from kitemj.dynamics.motion import Body, attachment_E
from kitemj.errors import InputError
from kitemj.flight.scenario import parameters_named
from kitemj.physics.frames import R_BE, Angles
from kitemj.physics.parameter_files import set_names
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, norm
from kitemj.plots.flight import Flight

FITS = 1e-3
"""m; far above what a model leaves between a taut line and its attachment, far below any kite."""
STYLES = 200
DEFAULT = "laksa"
"""Tried first; `thesis` has the same attachments and the same limits."""

POSE = ("phi_rad", "gamma_rad", "eta_rad", "theta_rad", "x_E_m", "y_E_m", "z_E_m")
TENSIONS, LENGTHS = ("tension_plus_N", "tension_minus_N"), ("length_plus_m", "length_minus_m")
STILL = Vector(0.0, 0.0, 0.0)


def kite_of_table(table: Flight, kite: str = "") -> tuple[str, Parameters, list[str]]:
    """`kite` (a set, or a scenario's file), else the first set that fits; the parameters it has.

    Third, what is to be said of a guess. The parameters of `table` are not looked at. Raises
    InputError where its lines do not end at that kite, or at none, or where it lacks the columns
    to tell and no kite is given.
    """
    names = [kite] if kite else sorted(set_names(), key=lambda name: name != DEFAULT)
    kites = {name: parameters_named(name) for name in names}
    lacks = [name for name in (*POSE, *TENSIONS, *LENGTHS) if name not in table.columns]
    if lacks and not kite:
        raise InputError(
            f"{table.name} does not say which kite flew it, and lacks the column {lacks[0]} to "
            f"guess by: give `kite`: one of {', '.join(set_names())}, or a scenario's file"
        )
    gaps = {name: 0.0 if lacks else line_gap(kites[name], table) for name in kites}
    best = min(gaps, key=lambda name: gaps[name])
    if gaps[best] > FITS:
        raise InputError(
            f"{table.name} was not flown by {' or '.join(kites)}: its lines end {gaps[best]:.2g} m "
            f"from where they should; give another `kite`: a set, or its scenario's file"
        )
    if kite:
        return best, kites[best], []
    others = [name for name, gap in gaps.items() if gap <= FITS and name != best]
    too = f" (so does {' or '.join(others)})" if others else ""
    note = (
        f"{table.name} does not say which kite flew it, or was changed since: {best} is a guess, "
        f"which fits its lines{too}; the option kite says it: a set, or a scenario's file"
    )
    return best, kites[best], [note]


def line_gap(parameters: Parameters, table: Flight) -> float:
    """How far [m] taut lines end from the attachments of this kite, in the median; 0: none is."""
    purpose = "finding its kite"
    rows = np.flatnonzero(table.matrix(TENSIONS, purpose).min(axis=1) > 0.0)
    rows = rows[:: max(1, len(rows) // STYLES)]
    poses, lengths = table.matrix(POSE, purpose)[rows], table.matrix(LENGTHS, purpose)[rows]
    gaps = []
    for pose, pair in zip(poses.tolist(), lengths, strict=True):
        body = Body(Vector(*pose[4:]), R_BE(Angles(*pose[:4])), STILL, STILL)
        ends = [norm(attachment_E(parameters, body, side)) for side in (1.0, -1.0)]
        gaps.append(np.abs(ends - pair))
    return float(np.median(gaps)) if gaps else 0.0
