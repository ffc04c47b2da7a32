"""The figure of the path in space, with lines, wind and the frame E."""

from __future__ import annotations

from math import cos, sin
from typing import TYPE_CHECKING, Any

import numpy as np

from kitemj.physics.frames import R_BE, Angles
from kitemj.plots import sheet
from kitemj.plots.flight import Array, Flight

if TYPE_CHECKING:
    from matplotlib.figure import Figure

POSITION = ("x_E_m", "y_E_m", "z_E_m")
ANGLES = ("phi_rad", "gamma_rad", "eta_rad", "theta_rad")
UPRIGHT = np.array([1.0, -1.0, -1.0])
"""Takes components in E to W, as `frames.world`: into the wind, to the pilot's right, up."""
KITES = 8
"""Drawn along the path, evenly apart in time."""
FLAT = 0.5
"""No side of the box is shorter than this part of its longest."""
EYE = {"elev": 18.0, "azim": 38.0}
"""deg; upwind of the pilot and to the right."""
GROUND = sheet.LineStyle("path on the ground", "0.7", "-", 0.8)


def path_figure(flight: Flight) -> Figure:
    """The path of G [m] with lines and wings, seen from behind the pilot's right shoulder.

    Raises InputError where position or state lack.
    """
    p = flight.matrix(POSITION, "the path") * UPRIGHT
    figure = sheet.blank(f"Path: {flight.name}", 6.8)
    ax: Any = figure.add_subplot(projection="3d", **EYE)
    size = 0.25 * float(np.abs(p).max())
    _set_box(ax, np.vstack([p, np.diag(UPRIGHT) * size, [[0, size, 0]]]))
    ways = sheet.parts_of_way(flight)
    drawn = [ax.plot(*p[rows].T, **style._asdict())[0] for rows, style in ways]
    drawn += ax.plot(p[:, 0], p[:, 1], 0.0 * p[:, 2], **GROUND._asdict())
    for row in np.unique(np.linspace(0, len(p) - 1, KITES).astype(int)):
        wings = _draw_kite(ax, flight, int(row))
    _draw_frame(ax, flight, size)
    ax.tick_params(labelsize=sheet.SMALL)
    ax.set_xlabel("$x_E$, into the wind [m]", fontsize=sheet.TEXT_SIZE)
    ax.set_ylabel("$-y_E$, to the right [m]", fontsize=sheet.TEXT_SIZE)
    ax.set_zlabel("$-z_E$, height [m]", fontsize=sheet.TEXT_SIZE)
    sheet.foot(figure, drawn + wings)
    return figure


def attitude(flight: Flight, row: int) -> Array:
    """R_BE at a row, shape (3, 3): x_B, y_B, z_B as rows, components in E."""
    q = flight.matrix(ANGLES, "the attitude")[row]
    return np.array(R_BE(Angles(*q.tolist())))


def _set_box(ax: Any, points: Array) -> None:
    """Sets limits that hold `points` (n, 3) [m] at one scale."""
    low, high = points.min(axis=0), points.max(axis=0)
    sides = np.maximum(high - low, FLAT * (high - low).max())
    edges = (low + high)[:, None] / 2 + np.outer(sides, (-0.5, 0.5))
    ax.set(xlim3d=edges[0], ylim3d=edges[1], zlim3d=edges[2])
    ax.set_box_aspect(sides, zoom=1.0)


def _draw_kite(ax: Any, flight: Flight, row: int) -> list[Any]:
    """Draws both lines to their attachments, and the wings, to scale; returns the wings."""
    kite, R = flight.parameters.kite, attitude(flight, row)
    G, wings = flight.matrix(POSITION, "the path")[row], []
    left, right = (1.0, sheet.PLUS, sheet.LEFT_WING), (-1.0, sheet.MINUS, sheet.RIGHT_WING)
    for side, style, broad in (left, right):
        A = G + np.array([kite.x_A, side * kite.y_A, kite.z_A]) @ R
        line = np.array([0.0 * A, A]) * UPRIGHT
        wing = np.array([G, G + side * kite.span / 2 * R[1]]) * UPRIGHT
        ax.plot(*line.T, **style._replace(label="_", linewidth=0.6)._asdict())
        wings += ax.plot(*wing.T, **broad._asdict())
    return wings


def _draw_frame(ax: Any, flight: Flight, size: float) -> None:
    """Draws x_E, y_E, z_E at O_E, arrows of `size` [m], and the wind beside them."""
    for axis, name in zip(np.diag(UPRIGHT) * size, ("$x_E$", "$y_E$", "$z_E$"), strict=True):
        ax.quiver(0, 0, 0, *axis, color="black", linewidth=1.0, arrow_length_ratio=0.12)
        ax.text(*(1.25 * axis), name, fontsize=sheet.TEXT_SIZE)
    wind = flight.parameters.wind
    blows = 1.5 * size * np.array([-cos(wind.azimuth), -sin(wind.azimuth), 0.0]) * UPRIGHT
    start = np.array([0.3 * size, 0.8 * size, 0.0])
    ax.quiver(*start, *blows, color="0.3", linewidth=2.2, arrow_length_ratio=0.12)
    ax.text(*(start + 1.1 * blows), f"wind {wind.speed:g} m/s", fontsize=sheet.SMALL)
