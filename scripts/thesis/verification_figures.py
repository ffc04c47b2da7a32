"""Sections 4.3 and 4.4: figures of control and state of all replays, and of the differences."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from kitemj.recording.file import Recording
from thesis.subplots import subplots
from thesis.verification_flights import ANGLES, Array, ReplayedFlight, delta_series, distances

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

ROUNDING = 1e-17
"""rad; smaller differences of δ are not drawn."""

COLOURS = {
    "lagrange, exact": "C0",
    "newton-euler, exact": "C1",
    "ode45 tight, interp1": "C2",
    "ode45, interp1": "C3",
}
"""The flights that are drawn; MuJoCo's own would be an empty curve."""


def control_figure(
    recording: Recording, replays: list[ReplayedFlight], errors: Mapping[str, Array]
) -> "Figure":
    """δ, and the differences."""
    figure, axes = subplots(2, 1, (8.5, 6.0), sharex=True)
    above, below = axes[:, 0]
    t, flown = recording.columns["t_s"], delta_series(recording.parameters, recording.columns)
    above.plot(t, flown, color="0.6", lw=4, label="in real time")
    for a in replays:
        if a.name in ("lagrange, exact", "newton-euler, exact"):
            own = delta_series(recording.parameters, a.columns)
            style = {"color": COLOURS[a.name], "label": a.name}
            above.plot(t, own, "--" if a.name[0] == "l" else ":", lw=1.6, **style)
            _logarithmic(below, t, np.abs(own - flown), **style)
    _logarithmic(below, errors["t_s"], errors["delta"], color="C3", label="interp1")
    below.set_ylim(bottom=ROUNDING)
    above.set_ylabel(r"$\delta$ [rad]")
    below.set(xlabel="time [s]", ylabel=r"difference of $\delta$ [rad]")
    _finish(figure, above, below)
    return figure


def state_figure(recording: Recording, replays: list[ReplayedFlight]) -> "Figure":
    """φ, γ, η, θ, and the differences."""
    figure, axes = subplots(len(ANGLES), 2, (10.5, 9.0), sharex=True)
    t = recording.columns["t_s"]
    for (left, right), name, symbol in zip(
        axes, ANGLES, (r"\varphi", r"\gamma", r"\eta", r"\theta"), strict=True
    ):
        left.plot(t, np.degrees(recording.columns[name]), color="0.6", lw=4, label="in real time")
        for a in replays:
            if a.name in COLOURS:
                style = {"color": COLOURS[a.name], "label": a.name}
                own = t[:: a.every]
                left.plot(own, np.degrees(a.columns[name]), "--", lw=1.2, **style)
                _logarithmic(right, own, distances(recording, a, (name,)), **style)
        left.set_ylabel(f"${symbol}$ [deg]")
        right.set_ylabel(f"difference of ${symbol}$ [rad]")
    for ax in axes[-1]:
        ax.set_xlabel("time [s]")
    _finish(figure, *axes.flat)
    return figure


def _logarithmic(ax: "Axes", t: Array, values: Array, **style: str) -> None:
    """Zeros are left out: there is no place for them."""
    ax.semilogy(t, np.where(values > 0, values, np.nan), lw=1.0, **style)


def _finish(figure: "Figure", *axes: "Axes") -> None:
    for ax in axes:
        ax.grid(alpha=0.3)
    known = {
        label: handle
        for ax in axes
        for handle, label in zip(*ax.get_legend_handles_labels(), strict=True)
    }
    figure.legend(
        known.values(), known.keys(), loc="outside lower center", ncols=len(known), fontsize=9
    )
