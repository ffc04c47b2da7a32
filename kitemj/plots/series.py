"""Figures over time: the state, its rates, tensions, angles of the air, steering."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees
from typing import TYPE_CHECKING

import numpy as np

from kitemj.errors import InputError
from kitemj.physics.rig import rig_of
from kitemj.physics.steering import rest_ell
from kitemj.plots import sheet
from kitemj.plots.flight import Array, Flight
from kitemj.plots.rates import q_dot
from kitemj.recording.table import STICK

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STATE = ("phi_rad", "gamma_rad", "eta_rad", "theta_rad")
SYMBOLS = (r"\varphi", r"\gamma", r"\eta", r"\theta")
LENGTHS = ("length_plus_m", "length_minus_m")
ASKED = sheet.LineStyle("asked for by the stick", "#A05A00", (0, (1.2, 1.2)), 1.8)
FLOWN = sheet.LineStyle("flown")
TALL = 7.5  # inches, of four diagrams


def state_figure(flight: Flight) -> Figure:
    """The figure of φ, γ, η, θ [deg], free of jumps by a whole turn."""
    q = np.degrees(np.unwrap(flight.matrix(STATE, "the state"), axis=0))
    figure, axes = sheet.time_sheet(flight, f"State: {flight.name}", 4, TALL)
    for ax, column, symbol in zip(axes, q.T, SYMBOLS, strict=True):
        sheet.curve(ax, flight, column, sheet.LineStyle(symbol))
        sheet.name_axis(ax, f"${symbol}$", "deg")
    return figure


def rates_figure(flight: Flight) -> Figure:
    """The figure of φ̇, γ̇, η̇, θ̇ [deg/s], from the body's own rates and velocity."""
    rates = np.degrees(q_dot(flight))
    figure, axes = sheet.time_sheet(flight, f"Rates of the state: {flight.name}", 4, TALL)
    for ax, column, symbol in zip(axes, rates.T, SYMBOLS, strict=True):
        sheet.curve(ax, flight, column, sheet.LineStyle(symbol))
        sheet.name_axis(ax, rf"$\dot{{{symbol}}}$", "deg/s")
    return figure


def tensions_figure(flight: Flight) -> Figure:
    """The figure of the tensions [N] between slack and the largest allowed, and closer."""
    names = rig_of(flight.parameters).lines
    pulls = flight.matrix([f"tension_{name}_N" for name in names], "the tensions").T
    ceiling = flight.parameters.limits.tension_max
    figure, axes = sheet.time_sheet(flight, f"Line tensions: {flight.name}", 2, 6.0)
    for ax in axes:
        for pull, style in zip(pulls, _line_styles(names), strict=True):
            sheet.curve(ax, flight, pull, style)
        sheet.name_axis(ax, "tension", "N")
    sheet.legend(axes[0])
    sheet.show_limits(axes[0], (0.0, ceiling), ("slack", f"ceiling {ceiling:g} N"))
    sheet.closer(axes[1], flight, "N")
    return figure


def angles_figure(flight: Flight) -> Figure:
    """The figure of α and β [deg] between their limits, and closer."""
    alpha, beta = flight.matrix(("alpha_deg", "beta_deg"), "the angles").T
    limits = flight.parameters.limits
    stall, largest = degrees(limits.alpha_stall), degrees(limits.beta_max)
    figure, axes = sheet.time_sheet(flight, f"Angles of the air: {flight.name}", 4, TALL)
    for ax, angle, symbol in zip(axes, (alpha, alpha, beta, beta), "ααββ", strict=True):
        sheet.curve(ax, flight, angle, sheet.LineStyle(symbol))
        sheet.name_axis(ax, symbol, "deg")
    sheet.show_limits(axes[0], (0.0, stall), ("0", f"α_stall {stall:g}°"))
    sheet.show_limits(axes[2], (-largest, largest), ("−β_max", f"β_max {largest:g}°"))
    sheet.closer(axes[1], flight, "deg")
    sheet.closer(axes[3], flight, "deg")
    return figure


def steering_figure(flight: Flight) -> Figure:
    """δ [deg] and ℓ [m] that were flown (and asked for, where a stick was), all lengths [m]."""
    names = rig_of(flight.parameters).lines
    lengths = flight.matrix([f"length_{name}_m" for name in names], "the steering").T
    ell, delta = ell_and_delta(flight)
    figure, axes = sheet.time_sheet(flight, f"Steering: {flight.name}", 3, 6.5)
    wish = _asked(flight)
    for ax, column, asked in zip(axes, (np.degrees(delta), ell), wish, strict=False):
        if asked is not None:
            sheet.curve(ax, flight, asked, ASKED)
        sheet.curve(ax, flight, column, FLOWN)
    sheet.name_axis(axes[0], "δ", "deg")
    sheet.name_axis(axes[1], "ℓ", "m")
    if any(asked is not None for asked in wish):
        sheet.legend(axes[0])
    for column, style in zip(lengths, _line_styles(names), strict=True):
        sheet.curve(axes[2], flight, column, style)
    sheet.name_axis(axes[2], "length", "m")
    sheet.legend(axes[2])
    return figure


def ell_and_delta(flight: Flight) -> tuple[Array, Array]:
    """ℓ [m] and δ [rad] at each row, of the lengths of the lines; `steering.ell_delta` for many.

    Raises InputError where lengths lack, or no triangle has such sides.
    """
    plus, minus = flight.matrix(LENGTHS, "the steering").T
    y_A = flight.parameters.kite.y_A
    with np.errstate(invalid="ignore", divide="ignore"):
        ell = np.sqrt((plus**2 + minus**2 - 2 * y_A**2) / 2)
        sine = (plus**2 - minus**2) / (4 * ell * y_A)
    if not np.all(np.abs(sine) <= 1.0):
        raise InputError(f"the lines of {flight.name} do not reach attachments {2 * y_A} m apart")
    return ell, np.arcsin(sine)


def _line_styles(names: Sequence[str]) -> list[sheet.LineStyle]:
    """A style for each line; those beyond the pilot's left and right are told by their names."""
    return [sheet.PLUS, sheet.MINUS, *(sheet.LineStyle(name, "#3A7D44") for name in names[2:])]


def _asked(flight: Flight) -> tuple[Array | None, Array | None]:
    """δ [deg] and ℓ [m] that the stick asked for; None: no stick, or one that asked for rates."""
    if not set(STICK) <= set(flight.columns):
        return None, None
    delta, ell, law = flight.matrix(STICK, "the stick").T
    kite, lines, stick = flight.parameters.kite, flight.parameters.lines, flight.parameters.stick
    wish = rest_ell(lines.length, kite.y_A) + ell * stick.ell
    angle = np.where(law == 0, degrees(stick.delta) * delta, np.nan)
    return (angle if np.isfinite(angle).any() else None), wish
