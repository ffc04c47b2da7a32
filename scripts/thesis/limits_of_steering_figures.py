"""Section 4.6: figures of the limits over time, and of β by case, schedule and steering limits."""

from math import degrees
from typing import TYPE_CHECKING

import numpy as np

from kitemj.dynamics.motion import Motion
from kitemj.plots.limits import limits_figure
from kitemj.tables import Table
from thesis.limits_of_steering_flights import CASES, LENGTHS, Flights, case_flight, held_beta
from thesis.limits_of_steering_tables import ACCELERATIONS, RATES
from thesis.programmed_steering import FULL_DEFLECTION
from thesis.subplots import subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SHOWN_EVERY = 10
"""Ticks between the points of a drawing."""
DARK = 1.6
"""°; cells beyond are so dark that their numbers are white."""
_STYLES = (("-", 1.2), ("-.", 1.2), ("-", 2.4), ("--", 1.0))
_COLOURS = {1: "#0B6FA4", 2: "#B8560A", 3: "0.7", 4: "black"}


def case_figure(case: int, motions: list[Motion]) -> "Figure":
    """All limits of one case over time, as kitemj plots them."""
    return limits_figure(case_flight(case, motions[::SHOWN_EVERY]), f"Case {case}")


def cases_figure(flights: Flights) -> "Figure":
    """δ and β of all cases over time."""
    figure, ((top,), (bottom,)) = subplots(2, 1, (7.0, 4.6), sharex=True)
    for (case, models), (style, width) in zip(flights.items(), _STYLES, strict=True):
        motions = models["mujoco"][::SHOWN_EVERY]
        t = [motion.t for motion in motions]
        look = {"label": f"case {case}", "color": _COLOURS[case], "ls": style, "lw": width}
        top.plot(t, [motion.control.delta for motion in motions], **look)
        bottom.plot(t, [degrees(motion.air.beta) for motion in motions], **look)
    held = held_beta(LENGTHS[0])
    for side in (held, -held):
        bottom.axhline(side, color="0.4", lw=0.9, ls=":")
    top.set(ylabel="δ [rad]")
    bottom.set(ylabel="β [°]", xlabel="time [s]", xlim=(0.0, FULL_DEFLECTION[-1][0]))
    for ax in (top, bottom):
        ax.grid(color="0.92")
    figure.legend(*top.get_legend_handles_labels(), loc="outside upper center", ncols=4, fontsize=8)
    return figure


def square_wave_figure(table: Table) -> "Figure":
    """Largest |β| over how long the stick is held."""
    figure, ((ax,),) = subplots(1, 1, (7.0, 3.3))
    held = [float(row[0]) for row in table.rows]
    for (case, colour), (style, width), mark in zip(
        _COLOURS.items(), _STYLES, ("o", "^", "", "x"), strict=True
    ):
        beta = [float(row[case]) for row in table.rows]
        ax.plot(
            held, beta, marker=mark, ls=style, lw=width, color=colour, label=f"case {case}", ms=4
        )
    ax.set(xlabel="held for [s]", ylabel="largest |β| [°]", xlim=(0.0, None), ylim=(0.0, None))
    ax.grid(color="0.92")
    ax.legend(fontsize=8, frameon=False)
    return figure


def map_figure(table: Table) -> "Figure":
    """Largest |β| over the limits of δ̇ and δ̈."""
    figure, ((ax,),) = subplots(1, 1, (7.4, 5.0))
    beta = np.array([float(row[2]) for row in table.rows])
    cells = beta.reshape(len(ACCELERATIONS), len(RATES))
    mesh = ax.pcolormesh(cells, cmap="YlGnBu", vmin=0.4, vmax=2.6, edgecolor="white", lw=0.5)
    for row in table.rows:
        x, y = RATES.index(float(row[0])), ACCELERATIONS.index(float(row[1]))
        value, slack = float(row[2]), float(row[3]) <= 0
        dark = "white" if value > DARK else "black"
        look = {"ha": "center", "va": "center", "fontsize": 8, "color": dark}
        ax.text(x + 0.5, y + 0.5, f"{value:.2f}{'*' if slack else ''}", **look)
    for case, limits in CASES.items():
        x, y = RATES.index(limits.delta_dot), ACCELERATIONS.index(limits.delta_ddot)
        ax.plot([x, x + 1, x + 1, x, x], [y, y, y + 1, y + 1, y], color="#D0101A", lw=1.8)
        ax.text(x + 0.06, y + 0.95, str(case), color="#D0101A", va="top", fontsize=8, weight="bold")
    ax.set_xticks(np.arange(len(RATES)) + 0.5, [f"{rate:g}" for rate in RATES], fontsize=8)
    heights = np.arange(len(ACCELERATIONS)) + 0.5
    ax.set_yticks(heights, [f"{each:g}" for each in ACCELERATIONS], fontsize=8)
    ax.set(xlabel=r"largest $|\dot\delta|$ [rad/s]", ylabel=r"largest $|\ddot\delta|$ [rad/s²]")
    figure.colorbar(mesh, ax=ax, label="largest |β| [°]")
    return figure
