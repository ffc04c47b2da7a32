"""The figure of an identification: turn rates over time, what is left, and how they depend on δ."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from kitemj.physics.compiled import Array
from kitemj.turning.identification import Identification
from kitemj.turning.turning_fit import EVEN, Fit, Flown, delayed, first, looked_at, predicted

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

EVERY = 4
"""Ticks; more points a reader does not see."""
FLOWN, LAW, LEFT = "0.55", "tab:blue", "tab:red"


SIZE = (11.0, 5.2)
"""inches."""


def identification_figure(found: Identification) -> Figure:
    """The figure, with no screen behind it."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=SIZE, layout="constrained")
    FigureCanvasAgg(figure)
    draw_identification(figure, found)
    return figure


def draw_identification(figure: Figure, found: Identification) -> None:
    """Turn rate and law, the residual below, and turning per speed over the delayed δ."""
    whole, fit = found.probe.flown, found.fit
    if fit is None:
        figure.suptitle(found.in_words, fontsize=8, wrap=True)
        return
    grid: Any = figure.add_gridspec(2, 2, height_ratios=(2, 1), width_ratios=(2, 1))
    top = figure.add_subplot(grid[0, 0])
    below = figure.add_subplot(grid[1, 0], sharex=top)
    rows = np.flatnonzero(looked_at(whole))[::EVERY]
    flown = Flown(*(column[rows] for column in whole))
    _over_time(top, below, flown, predicted(whole, fit)[rows], first(whole))
    _over_delta(figure.add_subplot(grid[:, 1]), fit, flown, delayed(whole, fit)[rows])
    holds = "the law of turning holds" if found.holds else "the law of turning does not hold"
    figure.suptitle(f"{found.source}, flown by {found.model}: {holds}", fontsize=11)


def _over_time(top: Axes, below: Axes, flown: Flown, law: Array, fitted: float) -> None:
    t = flown.t
    top.plot(t, flown.turning, color=FLOWN, lw=2.2, label="flown")
    top.plot(t, law, color=LAW, lw=1.0, label="law")
    below.plot(t, law - flown.turning, color=LEFT, lw=0.9)
    for ax in (top, below):
        ax.axhline(0.0, color="0.8", lw=0.6, zorder=0)
        ax.axvspan(fitted, t[-1], color="0.93", zorder=-1)
    top.set(ylabel="turn rate [rad/s]", title="white: fitted; grey: tried on", xlim=(t[0], t[-1]))
    top.tick_params(labelbottom=False)
    top.legend(fontsize=8, loc="upper right")
    below.set(ylabel="law - flown", xlabel="time [s]")


def _over_delta(ax: Axes, fit: Fit, flown: Flown, delta: Array) -> None:
    """The slope is c₁ (v_a/v₀)ⁿ⁻¹: one line where n = 1."""
    c2, v = fit.numbers.c2, flown.airspeed
    weight = c2 / v * np.sin(flown.heading) * np.cos(flown.elevation)
    dots = ax.scatter(delta, (flown.turning - weight) / v, c=v, s=5, cmap="viridis", lw=0)
    ends = np.array([delta.min(), delta.max()])
    law = fit.law
    for speed in dict.fromkeys((float(v.min()), fit.airspeed, float(v.max()))):
        style = "-" if speed == fit.airspeed else "--"
        ax.plot(ends, ends * law.gain(speed) / speed, style, color=LAW, lw=0.9)
    ax.set(xlabel="δ when it began to act [rad]", ylabel="(turn rate - weight's) / v_a [rad/m]")
    ax.locator_params(axis="x", nbins=5)
    if np.ptp(v) > EVEN * fit.airspeed:
        ax.set_title("lines: the law at least, median, most v_a", fontsize=9)
        ax.figure.colorbar(dots, ax=ax, label="airspeed v_a [m/s]")
