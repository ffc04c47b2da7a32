"""Figures of trim, stability and cycles; matplotlib is imported when one is drawn."""

from __future__ import annotations

from math import degrees
from typing import TYPE_CHECKING, Any

import numpy as np

from kitemj.equilibria.cycle import Cycle
from kitemj.equilibria.maps import Axis, StabilityMap
from kitemj.equilibria.minimal import seen
from kitemj.equilibria.modes import Stability
from kitemj.equilibria.tables import v_ref_note
from kitemj.equilibria.trim import Trim

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def trim_figure(trims: list[Trim]) -> Figure:
    """The equilibria from the side: the lines to scale, the kite enlarged, at its pitch."""
    figure, (ax,) = _figure(1)
    for trim in trims:
        back, up = trim.height / np.tan(trim.elevation) * np.cos(trim.azimuth), trim.height
        seen_at = f"α {degrees(trim.alpha):.2f}°, elevation {degrees(trim.elevation):.1f}°"
        left, right = trim.tensions
        label = f"{trim.model}: {seen_at}, {left:.1f} N + {right:.1f} N"
        (line,) = ax.plot([0, back], [0, up], lw=1.2, label=label)
        half = 0.06 * trim.ell * np.array([-1.0, 1.0])  # the kite itself would be too small to see
        pitch = trim.q.gamma + trim.q.theta
        x, y = back - half * np.cos(pitch), up + half * np.sin(pitch)
        ax.plot(x, y, lw=4, color=line.get_color(), solid_capstyle="round")
    ax.axhline(0, color="0.6", lw=2)
    ax.set(xlabel="downwind [m]", ylabel="height [m]", aspect="equal", title="Equilibrium")
    ax.margins(0.12)
    figure.legend(loc="outside lower center", fontsize=8)
    return figure


def modes_figure(found: Stability) -> Figure:
    """Eigenvalues in the complex plane; a second view close to the imaginary axis."""
    figure, axes = _figure(2)
    slowest = max(2 * abs(found.modes[0].real), *(1.3 * m.imag for m in found.modes[:3]), 0.2)
    for ax in axes:
        for mode in found.modes:
            imag = [mode.imag, -mode.imag] if mode.imag else [0.0]
            ax.plot([mode.real] * len(imag), imag, "x", ms=8, mew=2, label=mode.name)
        ax.axvline(0, color="0.4", lw=0.8)
        ax.axvspan(0, 1e3, color="tab:red", alpha=0.08)
        ax.set(xlabel="real [1/s]", ylabel="imaginary [rad/s]")
    reals = [mode.real for mode in found.modes]
    stable = "stable" if found.stable else "unstable"
    right = max(0.1 * abs(min(reals)), 1.2 * max(reals))
    axes[0].set(xlim=(1.1 * min(reals), right), title=f"Modes ({stable}, {found.linear.model})")
    axes[1].set(xlim=(-slowest, slowest), ylim=(-slowest, slowest), title="close to the axis")
    axes[1].set_aspect("equal")
    axes[0].text(0.02, 0.02, "axes of different scale", transform=axes[0].transAxes, fontsize=7)
    axes[0].legend(fontsize=7)
    _note(figure, v_ref_note(found.V_ref))
    return figure


def map_figure(found: StabilityMap) -> Figure:
    """Growth of the least stable mode in colour; the black line is where stability is lost."""
    figure, (ax,) = _figure(1)
    x, y, real = found.x.values, found.y.values, found.real
    limit = float(np.nanpercentile(np.abs(real), 98))
    mesh = ax.pcolormesh(x, y, real, cmap="RdBu_r", vmin=-limit, vmax=limit, shading="nearest")
    if np.nanmin(real) < 0 < np.nanmax(real):
        ax.contour(x, y, real, levels=[0.0], colors="black", linewidths=1.5)
        omega = np.where((real > 0) & (found.omega > 0), found.omega, np.nan)
        if np.isfinite(omega).any():
            lines = ax.contour(x, y, omega, levels=6, colors="0.25", linewidths=0.5)
            ax.clabel(lines, fmt="%.2g rad/s", fontsize=6)
    ax.set_facecolor("0.8")
    ax.set(xlabel=_label(found.x), ylabel=_label(found.y))
    ax.set_title("Stable (blue), unstable (red), no equilibrium (grey)")
    figure.colorbar(mesh, ax=ax, label="largest real part [1/s]")
    _note(figure, v_ref_note(found.V_ref))
    return figure


def cycle_figure(found: Cycle) -> Figure:
    """The cycle as the pilot sees it, and angles and tensions over one round."""
    figure, (sky, angles, pull) = _figure(3)
    motions = found.orbit.motions
    t = np.array([motion.t for motion in motions])
    elevation, azimuth = np.degrees([seen(motion.body.p_G_E) for motion in motions]).T
    sky.plot(-azimuth, elevation, lw=1.5)
    sky.plot(-azimuth[0], elevation[0], "o", ms=5)
    stable = "stable" if found.stable else "unstable"
    sky.set(xlabel="to the pilot's right [deg]", ylabel="elevation [deg]")
    sky.set_aspect("equal", adjustable="datalim")
    sky.set_title(f"{stable} cycle, {found.period:.4f} s ({found.model})")
    q = np.degrees([motion.q or () for motion in motions])
    angles.plot(t, q, label=["φ", "γ", "η", "θ"])
    angles.set(xlabel="time [s]", ylabel="[deg]", title="coordinates")
    angles.legend(fontsize=8, ncols=2)
    tensions = [motion.tensions for motion in motions]
    pull.plot(t, tensions, label=["left (A₊)", "right (A₋)"])
    pull.set(xlabel="time [s]", ylabel="tension [N]", title="lines", ylim=(0, None))
    pull.legend(fontsize=8, loc="lower center")
    _note(figure, v_ref_note(found.V_ref))
    return figure


def _figure(columns: int) -> tuple[Figure, list[Axes]]:
    """A figure with no screen behind it."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(2.5 + 4.2 * columns, 4.6), layout="constrained")
    FigureCanvasAgg(figure)
    axes: Any = figure.subplots(1, columns, squeeze=False)
    return figure, list(axes[0])


def _label(axis: Axis) -> str:
    return f"{axis.name} [{axis.unit}]" if axis.unit else axis.name


def _note(figure: Figure, text: str) -> None:
    if text:
        figure.supxlabel(text, fontsize=7, color="0.35")
