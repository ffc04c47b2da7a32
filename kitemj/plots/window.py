"""The figure of the wind window: azimuth and elevation of the kite."""

from __future__ import annotations

from math import ceil, cos, floor, log10, sin
from typing import TYPE_CHECKING, Any

import numpy as np

from kitemj.plots import sheet
from kitemj.plots.flight import Array, Flight
from kitemj.plots.path import POSITION, attitude

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

MARKS = 8
"""Spaces of time between moments that are marked along the way, at most."""
WING = 0.06
"""Half the wing that is drawn, parts of what the way takes up."""


def window_figure(flight: Flight) -> Figure:
    """Azimuth (from downwind, to the pilot's right) and elevation of G [deg]; below, closer.

    Raises InputError where position or state lack.
    """
    p = flight.matrix(POSITION, "the wind window")
    seen = bearing(flight, p)
    figure = sheet.blank(f"Wind window, as the pilot sees it: {flight.name}", 8.5)
    whole, close = figure.subplots(2, 1, height_ratios=(2, 3))
    for ax in (whole, close):
        sheet.plain(ax)
        ways = [(unbroken(seen[rows]), style) for rows, style in sheet.parts_of_way(flight)]
        drawn = [ax.plot(*way.T, **style._asdict())[0] for way, style in ways]
        ax.set_xlabel("azimuth, to the pilot's right [deg]", fontsize=sheet.TEXT_SIZE)
        ax.set_ylabel("elevation [deg]", fontsize=sheet.TEXT_SIZE)
    whole.set(xlim=(-90, 90), ylim=(min(0.0, float(np.nanmin(seen[:, 1]))), 90), aspect="equal")
    whole.set_xticks(range(-90, 91, 30))
    whole.set_yticks(range(0, 91, 30))
    half = WING * max(1.0, float(np.nanmax(np.ptp(seen, axis=0))))
    rows = _apart(_round_times(flight.t), seen, half)
    wings = [wing for row in rows for wing in _mark(close, flight, p, row, half)]
    close.set_aspect("equal", adjustable="datalim")
    close.margins(0.1)
    sheet.subtitle(close, "the same, closer; the kite enlarged at round times")
    sheet.foot(figure, drawn + wings[:2])
    return figure


def bearing(flight: Flight, p_E: Array) -> Array:
    """Azimuth from downwind, positive to the pilot's right, and elevation [deg] from O_E.

    `p_E` [m] of shape (rows, 3), the result (rows, 2).
    """
    wind = flight.parameters.wind.azimuth
    x, y, z = p_E.T
    ahead, right = -x * cos(wind) - y * sin(wind), x * sin(wind) - y * cos(wind)
    return np.degrees([np.arctan2(right, ahead), np.arctan2(-z, np.hypot(x, y))]).T


def unbroken(seen: Array) -> Array:
    """The angles with a gap where azimuth jumps by a whole turn, behind the pilot."""
    jumps = np.flatnonzero(np.abs(np.diff(seen[:, 0])) > 180.0) + 1
    return np.insert(seen, jumps, np.nan, axis=0)


def _round_times(t: Array) -> list[int]:
    """Rows nearest to moments that are 1, 2 or 5 times a power of ten [s] apart."""
    length = float(t[-1] - t[0])
    if length <= 0.0:
        return [0]
    decade = 10.0 ** floor(log10(length / MARKS))
    step = next(s * decade for s in (1, 2, 5, 10) if s * decade * MARKS >= 0.999 * length)
    moments = np.arange(ceil(t[0] / step - 1e-9), floor(t[-1] / step + 1e-9) + 1) * step
    return [int(np.argmin(np.abs(t - moment))) for moment in moments]


def _apart(rows: list[int], seen: Array, least: float) -> list[int]:
    """Those of `rows` that are at least so far [deg] from all before them."""
    kept: list[int] = []
    for row in rows:
        if (np.linalg.norm(seen[kept] - seen[row], axis=1) >= least).all():
            kept.append(row)
    return kept


def _mark(ax: Axes, flight: Flight, p_E: Array, row: int, half: float) -> list[Line2D]:
    """Draws the kite, enlarged to wings of `half` [deg] each, and the time; returns the wings."""
    G, y_B = p_E[row], attitude(flight, row)[1]
    reach = float(np.radians(half) * np.linalg.norm(G))
    wings = []
    for side, style in ((1.0, sheet.LEFT_WING), (-1.0, sheet.RIGHT_WING)):
        wing = bearing(flight, np.array([G, G + side * reach * y_B]))
        wings += ax.plot(*wing.T, **style._asdict())
    place = wing[0]
    ax.plot(*place, "o", color="black", markersize=3.5)
    how: Any = {"textcoords": "offset points", "fontsize": sheet.SMALL, "bbox": sheet.ON_WHITE}
    ax.annotate(f"{flight.t[row]:.4g} s", place, (5, 5), **how)
    return wings
