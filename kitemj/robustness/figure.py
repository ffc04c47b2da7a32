"""The figure of margins: Nyquist plots at points of a lap, and the margins along it."""

from typing import TYPE_CHECKING

import numpy as np

from kitemj.flight.live import TICK
from kitemj.robustness.frozen import response
from kitemj.robustness.margins import GAIN, PHASE, LoopMargins

if TYPE_CHECKING:
    from matplotlib.figure import Figure

VIEW = 2.5
"""Of the Nyquist plot, its half width."""


def margins_figure(found: LoopMargins) -> "Figure":
    """Left L(jω) at the points, with the disk that the worst keeps clear; right margins by time."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10, 5), layout="constrained")
    left, right = figure.subplots(1, 2)
    omega = np.geomspace(4 * np.pi / found.lap.period, 0.99 * np.pi / TICK, 1000)
    for i in found.at:
        A, B, C = found.opened.along_path(i)
        L = response(A, B, -C, omega)
        left.plot(L.real, L.imag, lw=0.8)
    worst = min(margins.disk for margins in found.frozen)
    ends = -(1 - worst / 2) / (1 + worst / 2), -(1 + worst / 2) / max(1 - worst / 2, 0.05)
    angle = np.linspace(0, 2 * np.pi, 200)
    middle, radius = sum(ends) / 2, (ends[0] - ends[1]) / 2
    disk = {"alpha": 0.3, "color": "tab:red", "label": f"disk {worst:.2f}"}
    left.fill(middle + radius * np.cos(angle), radius * np.sin(angle), **disk)
    left.plot(-1, 0, "k+", label="-1")
    left.set(xlim=(-VIEW, VIEW), ylim=(-VIEW, VIEW), aspect="equal", xlabel="Re L", ylabel="Im L")
    left.legend(loc="upper right")
    left.set_title("Opened at the stick, frozen at points")
    t = np.array(found.at) * TICK
    right.plot(t, [min(m.gain_up, m.gain_down) for m in found.frozen], "o-", label="gain [dB]")
    right.plot(t, [m.phase / 10 for m in found.frozen], "s-", label="phase [10°]")
    right.plot(t, [m.disk * 10 for m in found.frozen], "^-", label="disk [0.1]")
    right.axhline(GAIN, color="tab:blue", ls=":", lw=1)
    right.axhline(PHASE / 10, color="tab:orange", ls=":", lw=1)
    right.set(xlabel="time in the lap [s]", ylim=(0, 20))
    right.set_title("Margins along the lap")
    right.legend()
    return figure
