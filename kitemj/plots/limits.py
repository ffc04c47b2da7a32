"""Ratios of a flight to its physical limits: extremes, and the plot over time.

The thesis's plot (section 4.6, Figures 33-37): T₊/T_max, T₋/T_max, α/α_stall and |β|/β_max. A
value above 1, or a tension or an α of 0 or less, is outside what the model is valid for.
"""

from __future__ import annotations

from math import nan
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kitemj.flight.limits import OVERLOAD, SIDESLIP, SLACK, STALL, Limit, Numbers, departure_in
from kitemj.plots import sheet
from kitemj.plots.flight import Array, Flight

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STYLES = {
    "T₊/T_max": sheet.LineStyle(r"$T_+/T_\mathrm{max}$ (left)", sheet.LEFT),
    "T₋/T_max": sheet.LineStyle(r"$T_-/T_\mathrm{max}$ (right)", sheet.RIGHT, (0, (5, 2))),
    "α/α_stall": sheet.LineStyle(r"$\alpha/\alpha_\mathrm{stall}$", "black", "-."),
    "|β|/β_max": sheet.LineStyle(r"$|\beta|/\beta_\mathrm{max}$", "#A05A00", (0, (1.2, 1.2)), 1.8),
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


def limit_ratios(flight: Flight) -> dict[str, Array]:
    """The ratios by their names in `STYLES`, shape (rows,) each; InputError: a column lacks."""
    limits = flight.parameters.limits
    return {name: held[0].ratio(limits, now) for name, now, held in _held(flight)}


def extremes(flight: Flight) -> list[Extremes]:
    """The smallest and largest of each ratio, when, and when and why it was first outside.

    Raises InputError where `flight` lacks a column.
    """
    t, limits, found = flight.t.tolist(), flight.parameters.limits, []
    for name, now, held in _held(flight):
        ratio = held[0].ratio(limits, now)
        low, high = int(np.argmin(ratio)), int(np.argmax(ratio))
        left = departure_in(limits, t, now, held)
        first, reason = (left.t, left.limit.sentence) if left else (nan, "")
        r = ratio.tolist()
        found.append(Extremes(name, r[low], t[low], r[high], t[high], first, reason))
    return found


def _held(flight: Flight) -> list[tuple[str, Numbers, tuple[Limit, ...]]]:
    """Each ratio's name, the number that it is of, and the limits which this is held to."""
    (left, right), alpha, beta, *_ = flight.numbers
    return [
        ("T₊/T_max", Numbers((left,)), (OVERLOAD, SLACK)),
        ("T₋/T_max", Numbers((right,)), (OVERLOAD, SLACK)),
        ("α/α_stall", Numbers(alpha=alpha), (STALL,)),
        ("|β|/β_max", Numbers(beta=beta), (SIDESLIP,)),
    ]


def limits_figure(flight: Flight, title: str = "") -> Figure:
    """The ratios over time, shaded where they are outside; `title` in place of the flight's name.

    Raises InputError where `flight` lacks a column.
    """
    figure, (ax,) = sheet.time_sheet(flight, title or f"Physical limits: {flight.name}", 1, 4.2)
    for name, ratio in limit_ratios(flight).items():
        sheet.curve(ax, flight, ratio, STYLES[name])
    sheet.name_axis(ax, "part of the limit", "-")
    sheet.show_limits(ax, (0.0, 1.0), ("0: slack, or α = 0", "1: the limit"))
    sheet.legend(ax)
    return figure
