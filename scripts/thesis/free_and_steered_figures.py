"""Section 3.2: figures of β over time, of cycles, and of where stability is lost."""

from math import atan2, degrees, nan
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.batch import BETA
from kitemj.tables import Table
from thesis.forced_response import SineSteering
from thesis.free_and_steered_flights import (
    FAST,
    LENGTHS,
    NO_STEERING,
    OMEGAS,
    SAMPLE_TIME,
    SLOW,
    START_PHI,
    THESIS,
    VORTEX_LATTICE,
    cycle_at,
    flight_rows,
    steady_rows,
)
from thesis.subplots import subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SHOWN_CL_BETAS = (THESIS, -0.3, -0.36, VORTEX_LATTICE)


def beta_figure(steering: SineSteering) -> "Figure":
    """β over time: a column for each length, a row for each C_lβ."""
    figure, axes = subplots(len(SHOWN_CL_BETAS), 2, (7.2, 6.4), sharex=True, sharey=True)
    for column, length in enumerate(LENGTHS):
        for ax, value in zip(axes[:, column], SHOWN_CL_BETAS, strict=True):
            rows = flight_rows(length, value, steering, 0.0 if steering.delta else START_PHI)[:3001]
            ax.plot(
                np.arange(len(rows)) * SAMPLE_TIME, np.degrees(rows[:, BETA]), lw=0.9, color="black"
            )
            ax.axhline(0.0, color="0.7", lw=0.6, zorder=0)
            ax.set_title(f"{length:g} m, $C_{{l\\beta}}$ = {value:g}", fontsize=9, loc="left")
            ax.tick_params(labelsize=8)
        axes[-1, column].set_xlabel("time [s]")
    for ax in axes[:, 0]:
        ax.set_ylabel("β [°]")
    axes[0, 0].set(xlim=(0.0, 300.0), ylim=(-3.2, 3.2))
    return figure


def sky_figure() -> "Figure":
    """Where the cycles go, in angles as the pilot sees them."""
    figure, (axes,) = subplots(1, 2, (7.2, 3.8), sharey=True)
    looks: Any = {-0.36: "-", -0.4: "--", VORTEX_LATTICE: "-."}
    for ax, length in zip(axes, LENGTHS, strict=True):
        for value, style in looks.items():
            flown = cycle_at(length, value)
            seen = [motion.body.p_G_E for motion in flown.orbit.motions]
            right = [-degrees(atan2(p.y, -p.x)) for p in seen]
            up = [degrees(atan2(-p.z, float(np.hypot(p.x, p.y)))) for p in seen]
            label = f"$C_{{l\\beta}}$ = {value:g}: {flown.period:.2f} s"
            ax.plot(right, up, style, lw=1.3, label=label)
        ax.set(xlabel="to the pilot's right [°]", title=f"{length:g} m")
        ax.grid(color="0.92")
        ax.legend(fontsize=8, frameon=False, loc="lower center")
    axes[0].set(ylabel="elevation [°]")
    low, high = axes[0].get_ylim()
    axes[0].set_ylim(low - 0.45 * (high - low), high)
    return figure


def amplitude_figure(lost: dict[float, float]) -> "Figure":
    """What stays of |β| over C_lβ; `lost` [1/rad] by length [m]."""
    figure, (axes,) = subplots(1, 2, (7.2, 3.4), sharey=True)
    values: NDArray[np.float64] = np.round(np.arange(-0.6, -0.01, 0.04), 3)
    looks = {
        "no control": (NO_STEERING, "o-", "black"),
        "slow hands": (SLOW, "s--", "#B8560A"),
        "fast hands": (FAST, "^-.", "#0B6FA4"),
    }
    for ax, length in zip(axes, LENGTHS, strict=True):
        for name, (steering, style, colour) in looks.items():
            label = name
            if steering.delta:
                label += f": {steering.delta:g} rad at {steering.omega:g} rad/s"
            beta = [_steady_beta(length, float(value), steering) for value in values]
            ax.plot(values, beta, style, color=colour, ms=3.5, lw=1.1, label=label)
        ax.axvline(lost[length], color="0.4", lw=0.9, ls=":")
        ax.set(xlabel=r"$C_{l\beta}$ [1/rad]", title=f"{length:g} m", ylim=(0.0, None))
        ax.grid(color="0.92")
    axes[0].set_ylabel("largest |β| [°]")
    axes[1].legend(fontsize=8, frameon=False)
    return figure


def _steady_beta(length: float, cl_beta: float, steering: SineSteering) -> float:
    """Largest |β| [°] of what stays; not a number where the flight ended early."""
    end = steady_rows(length, cl_beta, steering)
    return degrees(np.abs(end[:, BETA]).max()) if len(end) else nan


def threshold_figure(table: Table, lost: dict[float, float]) -> "Figure":
    """The columns of `table` over the width of the swing; `lost` as above."""
    figure, (axes,) = subplots(1, 2, (7.2, 3.4), sharey=True)
    looks = dict(zip(OMEGAS, ("o-", "s--", "^-."), strict=True))
    for ax, length in zip(axes, LENGTHS, strict=True):
        for omega, style in looks.items():
            own = [row for row in table.rows if row[0] == length and row[1] == omega]
            widths = [0.0, *(float(row[2]) for row in own)]
            values = [lost[length], *(float(row[4]) for row in own)]
            ax.plot(widths, values, style, ms=4, lw=1.1, label=f"ω = {omega:g} rad/s")
        ax.set(xlabel="δ₀ [rad]", title=f"{length:g} m")
        ax.grid(color="0.92")
    axes[0].set_ylabel(r"$C_{l\beta}$ where stability is lost [1/rad]")
    axes[0].legend(fontsize=8, frameon=False, loc="lower left")
    where: Any = {"xycoords": "axes fraction", "ha": "right", "va": "top", "fontsize": 8}
    axes[1].annotate("stable above the line", (0.97, 0.95), **where)
    return figure
