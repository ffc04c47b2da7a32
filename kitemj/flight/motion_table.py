"""A table of motions: its columns, and a row for each motion."""

import csv
from math import degrees
from pathlib import Path

from kitemj.dynamics.motion import Motion
from kitemj.files import new_file

COLUMNS = (
    "t_s",
    "phi_rad",
    "gamma_rad",
    "eta_rad",
    "theta_rad",
    "x_E_m",
    "y_E_m",
    "z_E_m",
    "alpha_deg",
    "beta_deg",
    "tension_plus_N",
    "tension_minus_N",
    "length_plus_m",
    "length_minus_m",
)
"""Of a table of motions; angles of the state in rad, α and β in degrees, axes E."""


def write_csv(path: Path, motions: list[Motion], overwrite: bool = False) -> None:
    """A row for each motion, in the columns and units of `COLUMNS`, all digits kept."""
    with new_file(path, overwrite) as part, part.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(row(motion) for motion in motions)


def row(motion: Motion) -> list[float]:
    """One motion in the order of `COLUMNS`."""
    angles = [degrees(motion.air.alpha), degrees(motion.air.beta)]
    position = motion.body.p_G_E
    return [motion.t, *motion.q, *position, *angles, *motion.tensions, *motion.lengths]
