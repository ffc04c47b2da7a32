"""Files that appear whole or not at all, and never in place of another unasked."""

import csv
import os
from collections.abc import Iterator
from contextlib import contextmanager
from math import degrees
from pathlib import Path

from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError

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


def check_new(path: Path, overwrite: bool) -> None:
    """Raises InputError where `path` exists (and `overwrite` is off) or cannot be written."""
    if path.is_dir():
        raise InputError(f"{path} is a folder; give the name of a file")
    if path.exists() and not overwrite:
        raise InputError(f"{path} exists; give another name, or --overwrite")
    if not path.parent.is_dir():
        raise InputError(f"there is no folder {path.parent}; make it first")
    if not os.access(path.parent, os.W_OK):
        raise InputError(f"the folder {path.parent} is not writable; choose another")


@contextmanager
def new_file(path: Path, overwrite: bool = False) -> Iterator[Path]:
    """A name beside `path` to write to; it becomes `path` when the block ends without error."""
    check_new(path, overwrite)
    part = path.with_name(f"{path.name}.part")
    try:
        yield part
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


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
