"""How far arms can steer: from the way of a hand along its line to the largest δ."""

from math import degrees, sin, sqrt
from typing import NamedTuple

from kitemj.errors import InputError
from kitemj.physics.parameters import Parameters
from kitemj.physics.quantity import SENSIBLE
from kitemj.physics.steering import ell_delta, rest_ell

LEAST, MOST = SENSIBLE["m"]
STEEPEST = 1.5
"""rad; what a set allows as its largest δ."""

THESIS_ARM, THESIS_LENGTH, THESIS_Y_A, THESIS_DELTA = 0.25, 200.0, 2.9, 0.1
"""m, m, m and rad: what the thesis prints for arms of ±25 cm, δ with one decimal."""

COLUMNS = ("arm_m", "length_m", "attachments_m", "ell_rest_m", "ell_m", "delta_rad")
"""Fields of `Reach`, for machines."""


class Reach(NamedTuple):
    """One hand pulls its line by `arm`, the other lets out as much, and the kite is at (ℓ, δ).

    `length` L₀ and `attachments` (2 Y_A, between them) in m, `ell` and `ell_rest` (ℓ₀) in m,
    `delta` in rad.
    """

    arm: float
    length: float
    attachments: float
    ell_rest: float
    ell: float
    delta: float


def reach(parameters: Parameters, arm: float) -> float:
    """The largest δ [rad] with arms that move each line by ± `arm` [m]; see `reach_of`."""
    return reach_of(arm, parameters.lines.length, 2 * parameters.kite.y_A).delta


def reach_of(arm: float, length: float, attachments: float) -> Reach:
    """L± = L₀ ± arm put into equations 8 and 9 of the thesis; all in m.

    Raises InputError where the lines do not reach the attachments, or the arms are as long
    as `longest_arm`.
    """
    for name, value in (("arm", arm), ("length", length), ("attachments", attachments)):
        if not value > 0:
            raise InputError(f"`{name}` must be > 0 m, got {value} m")
        if not LEAST <= value <= MOST:
            raise InputError(f"`{name}` must be {LEAST:g} to {MOST:g} m, got {value} m")
    y_A = attachments / 2
    if length <= y_A:
        raise InputError(
            f"lines of {length:g} m do not reach attachments {attachments:g} m apart: "
            f"`length` must be > {y_A:g} m"
        )
    longest = longest_arm(length, attachments)
    if arm >= longest:
        raise InputError(
            f"`arm` must be < {longest:.4g} m for attachments {attachments:g} m apart, "
            f"got {arm:g} m: it would turn the kite over"
        )
    ell, delta = ell_delta(length + arm, length - arm, y_A)
    return Reach(arm, length, attachments, rest_ell(length, y_A), ell, delta)


def longest_arm(length: float, attachments: float) -> float:
    """The arm [m] that makes δ = `STEEPEST`: a little less than half of `attachments` [m]."""
    squared, y_A = length**2, attachments / 2
    part = sin(STEEPEST) * y_A
    return part * sqrt((squared - y_A**2) / (squared - part**2))


def told(reach: Reach) -> str:
    """A few lines for people, the last ones to be put into a file."""
    delta = f"{reach.delta:.6g}"
    text = (
        f"arms         ±{reach.arm:g} m on each line of {reach.length:g} m, "
        f"attachments {reach.attachments:g} m apart\n"
        f"ℓ            {reach.ell:.6f} m; {reach.ell_rest:.6f} m when the hands are level\n"
        f"δ_max        {delta} rad = {degrees(reach.delta):.4g}°\n"
    )
    if (reach.arm, reach.length, reach.attachments) == (THESIS_ARM, THESIS_LENGTH, 2 * THESIS_Y_A):
        text += f"the thesis   prints {THESIS_DELTA:g} rad for these numbers\n"
    return text + f"\n[stick]\ndelta = {delta}\narm = {reach.arm:g}"
