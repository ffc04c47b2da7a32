"""A table of motions: its columns, and a row for each motion."""

import csv
from math import degrees
from pathlib import Path

from kitemj.dynamics.motion import Motion
from kitemj.files import new_file
from kitemj.physics.rig import TWO_LINES, Rig


def columns_of(rig: Rig) -> tuple[str, ...]:
    """Names of the columns; angles of the state in rad, α and β in degrees, axes E."""
    return (
        "t_s",
        *(f"{name}_rad" for name in rig.coordinates),
        *("x_E_m", "y_E_m", "z_E_m", "alpha_deg", "beta_deg"),
        *(f"tension_{name}_N" for name in rig.lines),
        *(f"length_{name}_m" for name in rig.lines),
    )


COLUMNS = columns_of(TWO_LINES)


def write_csv(
    path: Path, motions: list[Motion], overwrite: bool = False, rig: Rig = TWO_LINES
) -> None:
    """A row for each motion, in the columns of `rig`, all digits kept."""
    with new_file(path, overwrite) as part, part.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns_of(rig))
        writer.writerows(row(motion) for motion in motions)


def row(motion: Motion) -> list[float]:
    """One motion in the order of its rig's columns."""
    angles = [degrees(motion.air.alpha), degrees(motion.air.beta)]
    position = motion.body.p_G_E
    q = motion.q or ()
    return [motion.t, *q, *position, *angles, *motion.tensions, *motion.lengths]
