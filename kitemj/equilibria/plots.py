"""Figures of trim, stability and cycles; matplotlib is imported when one is drawn."""

from __future__ import annotations

from math import atan2, degrees, hypot
from typing import TYPE_CHECKING, Any

import numpy as np

from kitemj.dynamics.motion import Motion
from kitemj.equilibria.cycle import Cycle
from kitemj.equilibria.maps import Axis, StabilityMap
from kitemj.equilibria.modes import Stability
from kitemj.equilibria.tables import v_ref_note
from kitemj.equilibria.trim import Trim
from kitemj.errors import InputError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def trim_figure(trims: list[Trim]) -> Figure:
    """The equilibria from the side: the lines to scale, the kite enlarged, at its pitch."""
    figure, (ax,) = _figure(1)
    for trim in trims:
        back, up = _side(trim)
        label = (
            f"{trim.model}: α {degrees(trim.alpha):.2f}°, "
            f"elevation {degrees(trim.elevation):.1f}°, "
            f"{trim.tensions[0]:.1f} N + {trim.tensions[1]:.1f} N"
        )
        (line,) = ax.plot([0, back], [0, up], lw=1.2, label=label)
        half = 0.06 * trim.ell  # the kite itself would be too small to see
        pitch = trim.q.gamma + trim.q.theta
        nose = half * np.array([-np.cos(pitch), np.sin(pitch)])
        ax.plot(
            [back - nose[0], back + nose[0]],
            [up - nose[1], up + nose[1]],
            lw=4,
            color=line.get_color(),
            solid_capstyle="round",
        )
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
    axes[0].set(
        xlim=(1.1 * min(reals), max(0.1 * abs(min(reals)), 1.2 * max(reals))),
        title=f"Modes ({'stable' if found.stable else 'unstable'}, {found.linear.model})",
    )
    axes[1].set(xlim=(-slowest, slowest), ylim=(-slowest, slowest), title="close to the axis")
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
    ax.set(
        xlabel=_label(found.x),
        ylabel=_label(found.y),
        title="Stable (blue), unstable (red), no equilibrium (grey)",
    )
    figure.colorbar(mesh, ax=ax, label="largest real part [1/s]")
    _note(figure, v_ref_note(found.V_ref))
    return figure


def cycle_figure(found: Cycle) -> Figure:
    """The cycle as the pilot sees it, and angles and tensions over one round."""
    figure, (sky, angles, pull) = _figure(3)
    motions = found.orbit.motions
    t = np.array([motion.t for motion in motions])
    azimuth, elevation = np.degrees([_seen(motion) for motion in motions]).T
    sky.plot(-azimuth, elevation, lw=1.5)
    sky.plot(-azimuth[0], elevation[0], "o", ms=5)
    stable = "stable" if found.stable else "unstable"
    sky.set(
        xlabel="to the pilot's right [deg]",
        ylabel="elevation [deg]",
        title=f"{stable} cycle, {found.period:.4f} s ({found.model})",
    )
    q = np.degrees([motion.q or () for motion in motions])
    for column, name in zip(q.T, ("φ", "γ", "η", "θ"), strict=True):
        angles.plot(t, column, label=name)
    angles.set(xlabel="time [s]", ylabel="[deg]", title="coordinates")
    angles.legend(fontsize=8, ncols=2)
    tensions = np.array([motion.tensions for motion in motions])
    pull.plot(t, tensions[:, 0], label="left (A₊)")
    pull.plot(t, tensions[:, 1], label="right (A₋)")
    pull.set(xlabel="time [s]", ylabel="tension [N]", title="lines", ylim=(0, None))
    pull.legend(fontsize=8)
    _note(figure, v_ref_note(found.V_ref))
    return figure


def _figure(columns: int) -> tuple[Figure, list[Axes]]:
    """A figure with no screen behind it."""
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError:
        raise InputError("figures need matplotlib: pip install matplotlib") from None
    figure = Figure(figsize=(2.5 + 4.2 * columns, 4.6), layout="constrained")
    FigureCanvasAgg(figure)
    axes: Any = figure.subplots(1, columns, squeeze=False)
    return figure, list(axes[0])


def _side(trim: Trim) -> tuple[float, float]:
    """Downwind and up [m] of G."""
    distance = trim.height / np.tan(trim.elevation)
    return float(distance * np.cos(trim.azimuth)), trim.height


def _seen(motion: Motion) -> tuple[float, float]:
    """Azimuth and elevation [rad] of G from the ground."""
    p = motion.body.p_G_E
    return atan2(p.y, -p.x), atan2(-p.z, hypot(p.x, p.y))


def _label(axis: Axis) -> str:
    return f"{axis.name} [{axis.unit}]" if axis.unit else axis.name


def _note(figure: Figure, text: str) -> None:
    if text:
        figure.supxlabel(text, fontsize=7, color="0.35")
