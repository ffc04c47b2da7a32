"""Section 4.7: figures of how late ticks were, and how many were missed."""

from math import ceil
from typing import TYPE_CHECKING

import numpy as np

from kitemj.flight.live import TICK
from thesis.real_time_flights import FLY_INTERVAL, Run
from thesis.subplots import subplots

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def lateness_figure(runs: list[Run]) -> "Figure":
    """A panel for each flight."""
    columns = min(len(runs), 3)
    rows = ceil(len(runs) / columns)
    figure, axes = subplots(
        rows, columns, (4.0 * columns + 0.5, 2.9 * rows), sharex=True, sharey=True
    )
    worst = max(10 * TICK, *(float(run.late.max()) for run in runs))
    most = max(4, *(int(run.missed.sum()) for run in runs))
    for ax, run in zip(axes.flat, runs, strict=False):
        _panel(ax, run)
        ax.set_ylim(1e-2, 2e3 * worst)
        count = ax.twinx()
        t = TICK * np.arange(len(run.late))
        count.step(t, np.cumsum(run.missed), where="post", color="tab:red", lw=1.4)
        count.set_ylim(-0.05 * most, 1.1 * most)
        count.tick_params(axis="y", colors="tab:red")
        count.set_ylabel("missed ticks", color="tab:red", fontsize=8)
    for ax in axes[-1]:
        ax.set_xlabel("time [s]")
    return figure


def _panel(ax: "Axes", run: Run) -> None:
    """How late ticks were; where frames are few, when they were begun."""
    case = run.case
    if case.frames is not None and case.frames > 10 * FLY_INTERVAL:
        for frame in run.frames:
            ax.axvline(frame.t, color="0.7", lw=3)
    t = TICK * np.arange(len(run.late))
    ax.semilogy(t, 1e3 * np.maximum(run.late, 1e-5), color="tab:blue", lw=0.7)
    ax.axhline(1e3 * TICK, color="0.3", ls="--", lw=0.9)
    figure = f" ({case.thesis[0]})" if case.thesis else ""
    ax.set_title(case.name + figure, fontsize=9)
    ax.set_ylabel("late [ms]", color="tab:blue", fontsize=8)
