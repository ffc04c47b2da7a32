"""The layout that figures share: as wide as the text of an A4 page, readable in grey.

What a colour tells, a kind of line tells as well; no text is below 8 pt. Red is the
pilot's left, A₊, and blue the right, A₋, as on the kite.
"""

from __future__ import annotations

from textwrap import fill
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kitemj.plots.flight import Array, Flight

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WIDTH = 7.0
"""inches; an A4 page less its margins."""
TEXT_SIZE, SMALL = 9.0, 8.0  # pt
LINE = 105  # letters of the small kind, across

LEFT, RIGHT = "#D0101A", "#1A3DF2"
AFTER, BEYOND = "0.94", "0.82"
"""Greys: after the flight was first beyond a limit of validity, and while it is beyond one."""

MOST_OUTSIDE = 1.5
"""How far beyond a limit is shown, parts of what lies between both limits."""


LEAST_SPAN = {"N": 0.01, "m": 1e-3, "deg": 0.01, "deg/s": 0.01, "-": 1e-3}
"""What an axis spans at least, by its unit: less than anybody measures on a kite, and far more than
the rounding of a flight at rest."""


class LineStyle(NamedTuple):
    """The style of a curve: its name in the legend, colour, and matplotlib's kind of line."""

    label: str
    color: str = "black"
    linestyle: Any = "-"
    linewidth: float = 1.3


PLUS = LineStyle("left, A₊", LEFT)
MINUS = LineStyle("right, A₋", RIGHT, (0, (5, 2)))
LEFT_WING = LineStyle("left wing, A₊", LEFT, "-", 3.2)
RIGHT_WING = LineStyle("right wing, A₋", RIGHT, "-", 1.4)
ON_WHITE = {"facecolor": "white", "edgecolor": "none", "alpha": 0.7, "pad": 0.5}
"""The box of a text over curves."""


def blank(title: str, height: float) -> Figure:
    """An empty figure of `height` [inches], with no screen behind it."""
    from kitemj.plots.inline_figure import InlineFigure

    figure = InlineFigure(figsize=(WIDTH, height), layout="constrained")
    figure.suptitle(title, fontsize=TEXT_SIZE + 1)
    return figure


def time_sheet(flight: Flight, title: str, rows: int, height: float) -> tuple[Figure, list[Axes]]:
    """Diagrams over the time of `flown`, one above the other; grey where it is beyond limits."""
    figure = blank(title, height)
    axes: list[Axes] = list(figure.subplots(rows, 1, sharex=True, squeeze=False)[:, 0])
    for ax in axes:
        plain(ax)
        _shade(ax, flight)
    start, end = flight.t[[0, -1]]
    axes[0].set_xlim(start, end if end > start else start + 1.0)
    axes[-1].set_xlabel("time [s]", fontsize=TEXT_SIZE)
    figure.align_ylabels(axes)
    _name_greys(figure, flight)
    return figure, axes


def plain(ax: Axes) -> None:
    """Gives a diagram a quiet grid and small numbers."""
    ax.grid(color="0.9", linewidth=0.6)
    ax.set_axisbelow(True)
    ax.tick_params(labelsize=SMALL)


def name_axis(ax: Axes, quantity: str, unit: str) -> None:
    """Names the vertical axis, whose curves are drawn; it spans `LEAST_SPAN` at least."""
    ax.set_ylabel(f"{quantity} [{unit}]", fontsize=TEXT_SIZE)
    ax.ticklabel_format(axis="y", useOffset=False)
    _widen(ax, ax.dataLim.y0, ax.dataLim.y1, unit)


def _widen(ax: Axes, low: float, high: float, unit: str) -> None:
    """Sets the limits of an axis where `low` to `high` is less than it must span."""
    least = LEAST_SPAN.get(unit, 0.0)
    if 0.0 <= high - low < least:
        middle = 0.5 * (low + high)
        ax.set_ylim(middle - 0.5 * least, middle + 0.5 * least)


def subtitle(ax: Axes, text: str) -> None:
    """Writes above a diagram, at the left."""
    ax.set_title(text, fontsize=SMALL, loc="left", pad=2)


def curve(ax: Axes, flight: Flight, values: Array, style: LineStyle) -> None:
    """Draws `values` (rows,) over time; what follows a touch of the ground sets no scale."""
    from matplotlib.lines import Line2D

    t, down = flight.t, flight.down
    ax.plot(t[:down], values[:down], **style._asdict())
    if down < len(t):
        rest = slice(max(down - 1, 0), None)
        ax.add_artist(Line2D(t[rest], values[rest], **style._replace(label="_")._asdict()))


def show_limits(ax: Axes, limits: tuple[float, float], labels: tuple[str, str]) -> None:
    """Draws both limits, named at the left and hatched outside; a curve far outside leaves."""
    low, high = limits
    span = high - low
    bottom, top = ax.dataLim.y0, ax.dataLim.y1
    bottom = max(min(low - 0.15 * span, bottom - 0.05 * span), low - MOST_OUTSIDE * span)
    top = min(max(high + 0.15 * span, top + 0.05 * span), high + MOST_OUTSIDE * span)
    ax.set_ylim(bottom, top)
    for start, end in ((bottom, low), (high, top)):
        ax.axhspan(start, end, facecolor="none", edgecolor="0.75", hatch="////", linewidth=0)
    how: Any = {"xycoords": ("axes fraction", "data"), "textcoords": "offset points"}
    for value, label, side, shift in ((low, labels[0], "top", -2), (high, labels[1], "bottom", 2)):
        ax.axhline(value, color="black", linewidth=0.9, linestyle=(0, (8, 3)))
        place, offset = (0.0, value), (3, shift)
        ax.annotate(label, place, offset, va=side, fontsize=SMALL, bbox=ON_WHITE, **how)


def closer(ax: Axes, flight: Flight, unit: str) -> None:
    """Scales a diagram to its curves [unit] where they are within all limits, and says so."""
    within = ~flight.any_beyond[: flight.down]
    curves = [np.asarray(line.get_ydata(), np.float64) for line in ax.get_lines()]
    values = np.concatenate([each[within] for each in curves if len(each) == len(within)])
    if len(values) and np.ptp(values) > 0.0:
        low, high = float(np.nanmin(values)), float(np.nanmax(values))
        room = 0.05 * (high - low)
        ax.set_ylim(low - room, high + room)
        _widen(ax, low, high, unit)
    subtitle(ax, "the same, closer")


def legend(ax: Axes) -> None:
    """Adds the legend of one diagram, above it, so that it hides nothing."""
    place: Any = {"loc": "lower right", "bbox_to_anchor": (1.0, 1.0), "borderaxespad": 0.1}
    ax.legend(ncols=4, frameon=False, fontsize=SMALL, **place)


def _name_greys(figure: Figure, flight: Flight) -> None:
    """Writes under the figure what the greys mean, from when on and why."""
    from matplotlib.patches import Patch

    if flight.departure:
        beyond = f"beyond the limits of validity; first at {flight.departure}"
        greys = ((BEYOND, beyond), (AFTER, "after that, not vouched for"))
        foot(figure, [Patch(fc=grey, ec="0.35", label=text) for grey, text in greys])


def parts_of_way(flight: Flight) -> list[tuple[slice, LineStyle]]:
    """The rows of a way within all limits, and those after; how each is drawn."""
    within, after = flight.parts
    if not flight.departure:
        return [(within, LineStyle("path of G"))]
    label = f"path after it was first beyond the limits of validity, at {flight.departure}"
    beyond = LineStyle(label, "0.45", (0, (1.2, 1.2)))
    return [(within, LineStyle("path of G")), (after, beyond)]


def foot(figure: Figure, handles: list[Any]) -> None:
    """Adds a legend under the figure; long lines are broken."""
    for handle in handles:
        handle.set_label(fill(str(handle.get_label()), LINE))
    figure.legend(handles=handles, loc="outside lower left", fontsize=SMALL, frameon=False)


def _shade(ax: Axes, flight: Flight) -> None:
    """Greys the time after the first departure, darker while the flight is beyond a limit."""
    departure, t = flight.departure, flight.t
    if departure is None:
        return
    ax.axvspan(departure.t, float(t[-1]), color=AFTER, linewidth=0, zorder=0.3)
    edges = np.flatnonzero(np.diff(flight.any_beyond, prepend=False, append=False))
    starts, ends = t[edges[::2]], t[np.minimum(edges[1::2], len(t) - 1)]
    spans = np.column_stack([starts, ends - starts]).tolist()
    dark: Any = {"facecolor": BEYOND, "edgecolor": BEYOND, "linewidth": 0.5, "zorder": 0.4}
    ax.broken_barh(spans, (0.0, 1.0), transform=ax.get_xaxis_transform(), **dark)
