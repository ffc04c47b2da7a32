"""The figure of a guided flight: the way that was flown over the path that was wished for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from kitemj.errors import InputError
from kitemj.flight.guided_table import NOBODY, PHASE
from kitemj.flight.pilot_settings import PHASES
from kitemj.plots import sheet
from kitemj.plots.flight import Array, Flight
from kitemj.plots.path import POSITION
from kitemj.plots.window import bearing, unbroken

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

ERROR, ATTRACTOR = "path_error_deg", ("attractor_azimuth_deg", "attractor_elevation_deg")
WISHED = sheet.LineStyle("wished for: the attractor's way", "#E0A030", "-", 3.5)
ON_PATH = sheet.LineStyle("flown along the path", "black", "-", 0.9)
ELSEWHERE = sheet.LineStyle("flown otherwise", "0.4", (0, (1.2, 1.2)), 1.2)
BEYOND = sheet.LineStyle("", "#A05A00", (0, (8, 3)), 1.2)
SHADES = ("0.97", "0.9")
"""Of the phases, in turn."""
NARROW = 0.07
"""Of the whole time; a phase that is shorter has no room for its name."""


def guidance_figure(flight: Flight) -> Figure:
    """Azimuth and elevation of G and of the attractor [deg]; below, the error [deg] over time.

    Raises InputError where no autopilot flew.
    """
    if PHASE not in flight.columns or not (flight.columns[PHASE] > NOBODY).any():
        raise InputError(f"no autopilot flew {flight.name}")
    phases = flight.columns[PHASE]
    on_path = phases == PHASES.index("path")
    figure = sheet.blank(f"Guidance: {flight.name}", 7.5)
    sky, below = figure.subplots(2, 1, height_ratios=(3, 2))
    for ax in (sky, below):
        sheet.plain(ax)
    _draw_ways(sky, flight, on_path)
    drawn = [*sky.get_lines(), *_mark_departure(below, flight)]
    sheet.foot(figure, drawn)
    for first, last, code in _bands(phases):
        _shade(below, flight.t[[first, last]], code, flight.t)
    error = np.where(on_path, _told(flight, ERROR), np.nan)
    below.plot(flight.t, error, **ON_PATH._asdict())
    below.axhline(0.0, color="0.5", linewidth=0.6)
    below.set_xlim(flight.t[0], flight.t[-1])
    below.set_xlabel("time [s]", fontsize=sheet.TEXT_SIZE)
    below.set_ylabel("off the path, to its right [deg]", fontsize=sheet.TEXT_SIZE)
    if on_path.any():
        rms, most = np.sqrt(np.nanmean(error**2)), np.nanmax(np.abs(error))
        sheet.subtitle(below, f"as it believed: {rms:.2f}° rms, {most:.2f}° at most")
    return figure


def _draw_ways(ax: Axes, flight: Flight, on_path: NDArray[np.bool_]) -> None:
    """Draws the attractor's way and the kite's, on equal scales."""
    seen = bearing(flight, flight.matrix(POSITION, "the way that was flown"))
    wished = np.column_stack([_told(flight, name) for name in ATTRACTOR])
    ways = ((wished, on_path, WISHED), (seen, ~on_path, ELSEWHERE), (seen, on_path, ON_PATH))
    for way, there, style in ways:
        shown = unbroken(np.where(there[:, None], way, np.nan))
        ax.plot(*shown.T, **style._asdict())
    ax.set_aspect("equal", adjustable="datalim")
    ax.set_xlabel("azimuth, to the pilot's right [deg]", fontsize=sheet.TEXT_SIZE)
    ax.set_ylabel("elevation [deg]", fontsize=sheet.TEXT_SIZE)


def _mark_departure(ax: Axes, flight: Flight) -> list[Any]:
    """Marks when the flight was first beyond the limits of validity; returns what is drawn."""
    departure = flight.departure
    if departure is None:
        return []
    style = BEYOND._replace(label=f"first beyond the limits of validity, at {departure}")
    return [ax.axvline(departure.t, **style._asdict())]


def _told(flight: Flight, name: str) -> Array:
    """What an autopilot told, which is not a number everywhere; InputError where it lacks."""
    if name not in flight.columns:
        raise InputError(f"{flight.name} lacks the column {name}, needed for the guidance")
    return np.asarray(flight.columns[name], np.float64)


def _bands(phases: NDArray[Any]) -> list[tuple[int, int, int]]:
    """First and last row of each stretch of one phase, and its number."""
    cuts = (np.flatnonzero(np.diff(phases)) + 1).tolist()
    ends = zip([0, *cuts], [*cuts, len(phases) - 1], strict=True)
    return [(first, last, int(phases[first])) for first, last in ends]


def _shade(ax: Axes, span: Array, code: int, t: Array) -> None:
    """Draws the band of a phase over its `span` [s], with its name where there is room."""
    ax.axvspan(*span, color=SHADES[code % 2], zorder=0)
    if span[1] - span[0] >= NARROW * (t[-1] - t[0]):
        name = "by hand" if code == NOBODY else PHASES[code]
        how: Any = {"xycoords": ("data", "axes fraction"), "va": "top", "fontsize": sheet.SMALL}
        place, shift = (float(span[0]), 1.0), (2, -2)
        ax.annotate(name, place, shift, textcoords="offset points", **how)
