"""Ratios of a flight to its physical limits: extremes, headroom, and the plot over time.

The thesis's plot (section 4.6, Figures 33-37): T₊/T_max, T₋/T_max, α/α_stall and |β|/β_max. A
value above 1, or a tension or an α of 0 or less, is outside what the model is valid for.
"""

from __future__ import annotations

from math import degrees, isnan, nan
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kitemj.flight.equilibrium import pull_at_rest
from kitemj.flight.limits import OVERLOAD, SIDESLIP, SLACK, STALL, Limit, Numbers, departure_in
from kitemj.plots import sheet
from kitemj.plots.flight import Array, Flight
from kitemj.tables import Cell, Table

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


def headroom(flight: Flight) -> Table:
    """For people: each quantity itself at its extremes, its limit, and what is left of that.

    Raises InputError where `flight` lacks a column.
    """
    limits = flight.parameters.limits
    pull = ("N", limits.tension_max)
    stall, slip = degrees(limits.alpha_stall), degrees(limits.beta_max)
    measures = {"T₊, left": pull, "T₋, right": pull, "α": ("°", stall), "|β|": ("°", slip)}
    rows: list[tuple[Cell, ...]] = []
    for each, (name, (unit, limit)) in zip(extremes(flight), measures.items(), strict=True):

        def told(value: float, unit: str = unit) -> str:
            return f"{value:.3g}{unit}" if unit == "°" else f"{value:.3g} {unit}"

        least = f"{told(each.smallest * limit)} at {each.smallest_at_s:.3g} s"
        most = f"{told(each.largest * limit)} at {each.largest_at_s:.3g} s"
        left = told((1.0 - each.largest) * limit)
        outside = f"from {each.outside_from_s:.3g} s: {each.reason}"
        never = isnan(each.outside_from_s)
        taken = f"{100.0 * each.largest:.3g} %"
        rows.append((name, least, most, told(limit), taken, left, "never" if never else outside))
    columns = ("", "least", "most", "limit", "taken up", "headroom", "outside")
    return Table(f"limits: {flight.name}", columns, rows)


def beside_rest(flight: Flight) -> str:
    """A sentence: the hardest pull beside the pull at rest; empty where the kite cannot rest."""
    rest = pull_at_rest(flight.parameters)
    if rest is None:
        return ""
    most = max(float(np.max(pull)) for pull in flight.numbers.tensions)
    speed = flight.parameters.wind.speed
    hardest = f"the hardest pull of this flight, {most:.3g} N, is {most / rest:.2g} times that"
    return f"at rest in a wind of {speed:g} m/s each line pulls {rest:.3g} N; {hardest}"


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
    """The ratios over time, shaded where they are outside, and the tensions [N] closer, with rest.

    `title` stands in place of the flight's name. Raises InputError where `flight` lacks a column.
    """
    figure, axes = sheet.time_sheet(flight, title or f"Physical limits: {flight.name}", 2, 6.2)
    for name, ratio in limit_ratios(flight).items():
        sheet.curve(axes[0], flight, ratio, STYLES[name])
    sheet.name_axis(axes[0], "part of the limit", "-")
    sheet.show_limits(axes[0], (0.0, 1.0), ("0: slack, or α = 0", "1: the limit"))
    sheet.legend(axes[0])
    for pull, style in zip(flight.numbers.tensions, (sheet.PLUS, sheet.MINUS), strict=False):
        sheet.curve(axes[1], flight, pull, style)
    sheet.name_axis(axes[1], "tension", "N")
    sheet.closer(axes[1], flight, "N")
    sheet.subtitle(axes[1], "the tensions, closer")
    if rest := pull_at_rest(flight.parameters):
        label = f"at rest: {rest:.3g} N"
        axes[1].axhline(rest, color="black", linewidth=0.9, linestyle=(0, (1.2, 1.2)), label=label)
    sheet.legend(axes[1])
    return figure
