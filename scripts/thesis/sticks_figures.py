"""Section 4.2: figures of the signals over time, and of their peaks over the tick."""

from typing import TYPE_CHECKING

from kitemj.physics.parameters import StickLimits
from kitemj.physics.shaping import StickLaw
from thesis.sticks_flights import FINE_TICKS, SIGNALS, AllSignals, SolvedFlight, StickSignals
from thesis.subplots import subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def signals_figure(limits: StickLimits, signals: list[StickSignals]) -> "Figure":
    """A column for each law, a row for each signal."""
    figure, axes = subplots(len(SIGNALS), len(signals), (10.5, 6.5), sharex=True)
    for column, s in zip(axes.T, signals, strict=True):
        t = [k * s.tick for k in range(len(s.controls))]
        column[0].set_title(f"the stick is {s.law.symbol}, {s.kind}", fontsize=10)
        for ax, (name, label) in zip(column, SIGNALS.items(), strict=True):
            limit = getattr(limits, name)
            ax.axhspan(-limit, limit, color="tab:green", alpha=0.15, lw=0)
            values = [getattr(c, name) for c in s.controls]
            ax.step(t, values, where="post", lw=1.1)
            ax.margins(y=0.12)
            ax.set_ylabel(label)
            ax.grid(alpha=0.3)
        column[-1].set_xlabel("time [s]")
    return figure


def growth_figure(at: AllSignals, flights: list[SolvedFlight]) -> "Figure":
    """Peaks over the tick, on logarithms."""
    figure, axes = subplots(1, 2, (10.5, 4.2))
    left, right = axes[0]
    ticks = [1e3 * tick for tick in FINE_TICKS]
    for law in StickLaw:
        for kind, style in (("raw", "o-"), ("shaped", "s--")):
            label, colour = f"{law.symbol} {kind}", f"C{law.value}"
            peaks = [at[kind, law, tick].peak("delta_ddot") for tick in FINE_TICKS]
            left.loglog(ticks, peaks, style, ms=4, color=colour, label=label)
            own = [f for f in flights if f.signals.law is law and f.signals.kind == kind]
            forces = [max(map(abs, f.tension_range)) for f in own]
            right.loglog(
                [1e3 * f.signals.tick for f in own], forces, style, ms=4, color=colour, label=label
            )
    left.set(xlabel="tick [ms]", ylabel=r"largest $|\ddot\delta|$ [rad/s²]")
    right.set(xlabel="tick [ms]", ylabel="largest |tension| [N]")
    for ax in (left, right):
        ax.grid(alpha=0.3, which="both")
    figure.legend(
        *left.get_legend_handles_labels(), loc="outside lower center", ncols=6, fontsize=8
    )
    return figure
