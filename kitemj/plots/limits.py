"""Ratios of a flight to its physical limits: extremes, and the plot over time.

The thesis's plot (section 4.6, Figures 33-37): T₊/T_max, T₋/T_max, α/α_stall and |β|/β_max. A
value above 1, or a tension or an α of 0 or less, is outside what the model is valid for.
"""

from __future__ import annotations

from math import nan
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kitemj.physics.parameters import Parameters
from kitemj.plots.flight import AIR_AND_LINES, Array, Flight
from kitemj.plots.sheet import (
    LEFT,
    RIGHT,
    LineStyle,
    curve,
    legend,
    name_axis,
    show_limits,
    time_sheet,
)
from kitemj.recording.table import Columns

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STYLES = {
    "T₊/T_max": LineStyle(r"$T_+/T_\mathrm{max}$ (left)", LEFT),
    "T₋/T_max": LineStyle(r"$T_-/T_\mathrm{max}$ (right)", RIGHT, (0, (5, 2))),
    "α/α_stall": LineStyle(r"$\alpha/\alpha_\mathrm{stall}$", "black", "-."),
    "|β|/β_max": LineStyle(r"$|\beta|/\beta_\mathrm{max}$", "#A05A00", (0, (1.2, 1.2)), 1.8),
}
CEILINGS = ("T₊/T_max", "T₋/T_max")
LOW = {
    "T₊/T_max": "the left line went slack",
    "T₋/T_max": "the right line went slack",
    "α/α_stall": "α was not above 0",
}
HIGH = {
    "T₊/T_max": "the left line carried more than its ceiling",
    "T₋/T_max": "the right line carried more than its ceiling",
    "α/α_stall": "α reached α_stall",
    "|β|/β_max": "|β| reached β_max",
}


class Extremes(NamedTuple):
    """One ratio over a flight, times in s; `outside_from_s` is not a number if it stayed within."""

    ratio: str
    smallest: float
    smallest_at_s: float
    largest: float
    largest_at_s: float
    outside_from_s: float
    reason: str


def limit_ratios(parameters: Parameters, columns: Columns) -> dict[str, Array]:
    """T₊/T_max, T₋/T_max, α/α_stall, |β|/β_max by these names, shape (rows,) each.

    `columns` hold at least `AIR_AND_LINES`, as a recording or `kitemj simulate` has them.
    """
    limits = parameters.limits
    return {
        "T₊/T_max": columns["tension_plus_N"] / limits.tension_max,
        "T₋/T_max": columns["tension_minus_N"] / limits.tension_max,
        "α/α_stall": np.radians(columns["alpha_deg"]) / limits.alpha_stall,
        "|β|/β_max": np.abs(np.radians(columns["beta_deg"])) / limits.beta_max,
    }


def flight_ratios(flight: Flight) -> dict[str, Array]:
    """The ratios of a flight; InputError where it lacks a column."""
    columns = {name: flight.column(name, "the limits") for name in AIR_AND_LINES}
    return limit_ratios(flight.parameters, columns)


def extremes(flight: Flight) -> list[Extremes]:
    """The smallest and largest of each ratio, when, and when and why it was first outside.

    Raises InputError where `flown` lacks a column.
    """
    t = flight.t.tolist()
    found = []
    for name, ratio in flight_ratios(flight).items():
        too_low = (ratio <= 0.0) & (name in LOW)
        # the ceiling of a line may be reached, the angles must stay below theirs
        too_high = ratio > 1.0 if name in CEILINGS else ratio >= 1.0
        first, reason = nan, ""
        if np.any(too_low | too_high):
            row = int(np.argmax(too_low | too_high))
            first, reason = t[row], (HIGH if too_high[row] else LOW)[name]
        low, high = int(np.argmin(ratio)), int(np.argmax(ratio))
        r = ratio.tolist()
        found.append(Extremes(name, r[low], t[low], r[high], t[high], first, reason))
    return found


def limits_figure(flight: Flight, title: str = "") -> Figure:
    """The ratios over time, shaded where they are outside; `title` in place of the flight's name.

    Raises InputError where `flown` lacks a column.
    """
    ratios = flight_ratios(flight)
    figure, (ax,) = time_sheet(flight, title or f"Physical limits: {flight.name}", 1, 4.2)
    for name, ratio in ratios.items():
        curve(ax, flight, ratio, STYLES[name])
    name_axis(ax, "part of the limit", "-")
    show_limits(ax, (0.0, 1.0), ("0: slack, or α = 0", "1: the limit"))
    legend(ax)
    return figure
