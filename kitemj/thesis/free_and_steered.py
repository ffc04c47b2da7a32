"""Section 3.2: the kite left alone and under δ = δ₀ sin ωt, on both lengths, as C_lβ changes."""

from functools import cache
from math import atan2, degrees, isnan, nan, radians
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.survey import ALPHA, BETA, TENSION_MINUS, TENSION_PLUS
from kitemj.dynamics.survey import Array as Rows
from kitemj.flight.simulate import make_model
from kitemj.flight.validity import TOUCH
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import rest_ell
from kitemj.stability.cycle import Cycle, cycle
from kitemj.stability.minimal import state_of
from kitemj.stability.modes import crossings, stability
from kitemj.stability.trim import standing
from kitemj.stability.vary import with_value
from kitemj.tables import Cell, Table
from kitemj.thesis.forced import LAST, Swing, threshold
from kitemj.thesis.panels import panels
from kitemj.thesis.section import Answer, Drawing, Named, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LENGTHS = (80.0, 200.0)  # m
PARAFOIL, THESIS, VORTEX_LATTICE = -0.037, -0.1, -0.49
"""1/rad; C_lβ as section 2.2 quotes it from parafoils, that of Table 2, and of a vortex lattice."""
VALUES = (PARAFOIL, THESIS, -0.2, -0.3, -0.36, VORTEX_LATTICE)
SHOWN = (THESIS, -0.3, -0.36, VORTEX_LATTICE)
SLOW, FAST = Swing(0.1, 0.1), Swing(0.03, 0.6)
"""The most that |δ| < 0.1 rad and |δ̇| < 0.01 rad/s allow; near the kite's own swing."""
STILL = Swing(0.0, 0.1)
WIDTHS = (0.02, 0.05, 0.1)  # rad
OMEGAS = (0.1, 0.3, 0.6)  # rad/s
ASIDE = radians(5.0)
"""rad; φ at the start of a free flight."""
LONG, START = 600.0, 470.0
"""s; a flight, and from when on it is taken for what stays."""
EVERY = 0.1  # s
TOLERANCE = 1e-8
"""Of a step, in rad and rad/s; β is then known to 1e-5°."""
ALONE = 50.0
"""s; after which only the growing mode is left to see."""
ANSWERS: tuple[Answer, ...] = ()


def section(scratch: Path) -> Section:
    """Flights by Lagrange's equations; the set thesis with C_lβ and L₀ changed."""
    lost = {length: _lost(length) for length in LENGTHS}
    thresholds = threshold_table(lost)
    return Section(
        "No control, and δ = δ₀ sin ωt (section 3.2)",
        ANSWERS,
        thesis=[
            "Left alone, a kite can fly stably; whether it does depends on C_lβ. With "
            "δ = δ₀ sin ωt, C_lβ has a bigger effect on stability than with lines of constant "
            "length, “but stable trajectories can be achieved too”. Section 2.2 quotes C_lβ = "
            f"{PARAFOIL} from parafoils and {VORTEX_LATTICE} from a vortex lattice. There are no "
            "numbers or figures, and δ₀ and ω are not named.",
        ],
        here=[*_here_free(lost), *_here_steered(lost, thresholds)],
        why=[
            "The claim holds in one sense and not in another. It holds for how far the kite "
            "swings: without control nothing of C_lβ is seen until stability is lost, because "
            "the kite simply stands, while under steering every value of C_lβ shows at once. It "
            "does not hold for where stability is lost: slow hands move that by a few parts in a "
            "hundred, either way, and quick ones make the kite keep to their own rhythm, with "
            "more room for C_lβ and not less.",
            "The law δ = δ₀ sin ωt has a start of its own: at t = 0 the hands already move at "
            "δ₀ω while the kite is at rest. Lines do not stretch, so the kite is given ℓδ₀ω of "
            "sideways speed at once, and β = arctan(ℓδ₀ω/V_w) as the last column of the table of "
            "steered flights shows. That is the starting condition and not the kite's answer to "
            "steering; it dies out within seconds and is left out of all other columns.",
        ],
        drawings=[
            Drawing(
                "free_beta",
                f"β after a start {degrees(ASIDE):.0f}° to the side, lines held: stable flight "
                "above, cycles that the kite flies by itself below. Left 80 m, right 200 m.",
                _beta_figure(STILL),
            ),
            Drawing(
                "steered_beta",
                f"The same with δ = {SLOW.delta:g} rad · sin({SLOW.omega:g} rad/s · t). The "
                "first instant, when lines that move at once throw the kite, is off the scale.",
                _beta_figure(SLOW),
            ),
            Drawing(
                "free_cycles",
                "Cycles that the kite flies by itself beyond the loss of stability, as the pilot "
                "sees them.",
                _sky_figure(),
            ),
            Drawing(
                "beta_over_cl_beta",
                "What stays of |β| after the start, over C_lβ: nothing without control until "
                "stability is lost (dotted), some at every C_lβ with steering. Where a point "
                "lacks, the flight met the ground.",
                _amplitude_figure(lost),
            ),
            Drawing(
                "steered_thresholds",
                "Where the steered flight loses its stability, over the width of the hands' "
                "swing; at zero width it is where the free flight does.",
                _threshold_figure(thresholds, lost),
            ),
        ],
        tables=[
            Named("free_flight", free_table()),
            Named("growth", growth_table()),
            Named("steered_flight", steered_table()),
            Named("steered_thresholds", thresholds),
        ],
    )


def at(length: float, cl_beta: float) -> Parameters:
    """The set thesis with these lines [m] and this C_lβ [1/rad]."""
    lines = with_value(parameter_set("thesis"), "lines.length", length)
    return with_value(lines, "aero.Cl_beta", cl_beta)


@cache
def survey(
    length: float, cl_beta: float, swing: Swing, aside: float, tolerance: float = TOLERANCE
) -> Rows:
    """Rows of a survey every `EVERY` s; the start is the equilibrium turned by `aside` [rad]."""
    parameters = at(length, cl_beta)
    state = state_of(standing(parameters))
    state = state._replace(q=state.q._replace(phi=state.q.phi + aside))
    kite, programme = make_model("lagrange", parameters), swing.programme(parameters)
    kite.start(state, programme)
    times = np.arange(0.0, LONG + EVERY / 2, EVERY)
    return kite.survey(programme, times, TOUCH, tolerance)


def stays(length: float, cl_beta: float, swing: Swing) -> Rows:
    """A flight from `START` to `LONG` s; no rows where it met the ground before."""
    return survey(length, cl_beta, swing, 0.0 if swing.delta else ASIDE)[round(START / EVERY) :]


def _valid(parameters: Parameters, rows: Rows) -> bool:
    alpha, limits = rows[:, ALPHA], parameters.limits
    pulls = rows[:, TENSION_PLUS : TENSION_MINUS + 1].min() > 0
    inside = alpha.min() > 0 and alpha.max() < limits.alpha_stall
    return bool(pulls and inside and np.abs(rows[:, BETA]).max() < limits.beta_max)


def _lost(length: float) -> float:
    """C_lβ [1/rad] at which the free flight loses its stability."""
    [crossing] = crossings(at(length, THESIS), "aero.Cl_beta", -0.6, 0.0)
    return crossing.value


@cache
def _cycle(length: float, cl_beta: float) -> Cycle:
    return cycle(at(length, cl_beta))


def free_table() -> Table:
    """A row for each length and C_lβ: the swing's mode, and the cycle where it grows."""
    rows: list[tuple[Cell, ...]] = []
    for length in LENGTHS:
        for value in VALUES:
            found = stability(at(length, value))
            swing = next(m for m in found.modes if m.imag > 0 and "sway" in m.name)
            head = (length, value, swing.real, swing.imag, found.stable)
            if found.stable:
                rows.append((*head, "stands", *[float("nan")] * 4, True))
                continue
            flown = _cycle(length, value)
            orbit = flown.orbit
            spans = (degrees(orbit.beta.high), degrees(orbit.azimuth.high))
            least = min(orbit.tension_plus.low, orbit.tension_minus.low)
            what = "cycle" if flown.stable else "unstable cycle"
            tail = (float(flown.period), *spans, least, flown.departure is None)
            rows.append((*head, what, *tail))
    columns = ("length_m", "C_lβ", "growth_per_s", "omega_rad_per_s", "stable", "in_the_end")
    cycles = ("period_s", "beta_max_deg", "azimuth_max_deg", "tension_min_N", "within_limits")
    return Table("No control: the sideways swing, and what comes of it", (*columns, *cycles), rows)


def growth_table() -> Table:
    """The growth rate [1/s] of |β| in a flight from close by, against that of the mode."""
    rows: list[tuple[Cell, ...]] = []
    for length in LENGTHS:
        for value in (-0.36, -0.4, VORTEX_LATTICE):
            mode = stability(at(length, value)).modes[0]
            flown = measured_growth(length, value)
            rows.append((length, value, mode.real, flown, 100 * (flown / mode.real - 1)))
    columns = ("length_m", "C_lβ", "mode_per_s", "flown_per_s", "difference_percent")
    return Table("Growth of β where the kite cannot stand", columns, rows)


def measured_growth(length: float, cl_beta: float) -> float:
    """Growth [1/s] of the peaks of |β| in a flight that begins 1e-8 rad to the side.

    Between `ALONE`, when all other modes have died out, and 1e-3 rad, where the air is no
    longer felt as linear.
    """
    beta = np.abs(survey(length, cl_beta, STILL, 1e-8, 1e-13)[:, BETA])[round(ALONE / EVERY) :]
    beta = beta[: int(np.argmax(beta > 1e-3)) or None]
    top = 1 + np.flatnonzero((beta[1:-1] > beta[:-2]) & (beta[1:-1] >= beta[2:]))
    bend = beta[top - 1] - 2 * beta[top] + beta[top + 1]
    heights = beta[top] - (beta[top - 1] - beta[top + 1]) ** 2 / (8 * bend)  # of parabolas
    return float(np.polyfit(top * EVERY, np.log(heights), 1)[0])


def steered_table() -> Table:
    """A row for each swing, length and C_lβ: what stays, and what the start does."""
    rows: list[tuple[Cell, ...]] = []
    for swing in (SLOW, FAST):
        for length in LENGTHS:
            for value in VALUES:
                parameters, end = at(length, value), stays(length, value, swing)
                extremes = (
                    degrees(np.abs(end[:, BETA]).max()),
                    degrees(end[:, ALPHA].min()),
                    degrees(end[:, ALPHA].max()),
                    float(end[:, TENSION_PLUS : TENSION_MINUS + 1].min()),
                    float(end[:, TENSION_PLUS : TENSION_MINUS + 1].max()),
                )
                head = (swing.delta, swing.omega, length, value)
                tail = (_valid(parameters, end), start_beta(length, swing))
                rows.append((*head, *extremes, *tail))
    columns = ("δ₀_rad", "ω_rad_per_s", "length_m", "C_lβ", "beta_max_deg", "alpha_min_deg")
    more = ("alpha_max_deg", "tension_min_N", "tension_max_N", "within_limits", "start_beta_deg")
    title = f"δ = δ₀ sin ωt: extremes from {START:g} to {LONG:g} s, and β at the start"
    return Table(title, (*columns, *more), rows)


def start_beta(length: float, swing: Swing) -> float:
    """|β| [°] of the kite at t = 0: at rest in q, but with lines that move at once."""
    parameters = at(length, THESIS)
    sideways = rest_ell(length, parameters.kite.y_A) * swing.delta * swing.omega
    return degrees(atan2(sideways, parameters.wind.speed))


def threshold_table(lost: dict[float, float]) -> Table:
    """A row for each length and swing: where the steered flight loses its stability."""
    rows: list[tuple[Cell, ...]] = []
    for length in LENGTHS:
        for omega in OMEGAS:
            for width in WIDTHS:
                found = threshold(at(length, THESIS), Swing(width, omega))
                shift = 100 * (found.value / lost[length] - 1)
                rows.append(
                    (length, omega, width, lost[length], found.value, shift, found.followed)
                )
    columns = ("length_m", "ω_rad_per_s", "δ₀_rad", "free_C_lβ", "steered_C_lβ", "shift_percent")
    title = f"Where stability is lost, free and steered (looked for down to C_lβ = {LAST:g})"
    return Table(title, (*columns, "stable_at_least_to"), rows)


def _here_free(lost: dict[float, float]) -> list[str]:
    near, far = (_cycle(length, VORTEX_LATTICE) for length in LENGTHS)
    swings = (degrees(c.orbit.beta.high) for c in (near, far))
    return [
        f"Lines held, the kite of Table 2 (C_lβ = {THESIS}) is stable on both lengths, and so is "
        f"one with the parafoil's {PARAFOIL}. Stability is lost at C_lβ = {lost[80.0]:.4f} on 80 m "
        f"and at {lost[200.0]:.4f} on 200 m, where sway and yaw begin to swing together. Beyond, "
        "β grows as exp(σt) with σ the growth of that mode, as the table of growth shows, until "
        "it is caught in a cycle that the kite flies by itself: crosswind flight without any "
        f"control. With the vortex lattice's {VORTEX_LATTICE} its period is {near.period:.2f} s on "
        f"80 m and {far.period:.2f} s on 200 m, and |β| reaches {next(swings):.2f}° and "
        f"{next(swings):.2f}°, far below β_max = 15°.",
    ]


def _here_steered(lost: dict[float, float], thresholds: Table) -> list[str]:
    shifts = {(row[0], row[1], row[2]): float(row[5]) for row in thresholds.rows}
    known = [shift for shift in shifts.values() if not isnan(shift)]
    open_rows = [row for row in thresholds.rows if isnan(float(row[4]))]
    unknown = (
        f" For {len(open_rows)} of {len(shifts)} swings no flight that repeats with the hands was "
        "found to begin with."
        if open_rows
        else ""
    )
    return [
        "Under steering there is a flight that repeats itself with the hands. Whether the kite "
        "keeps to it is asked of the Floquet multipliers of that flight "
        "(kitemj/thesis/forced.py). With the slow swing of the thesis's limits, "
        f"{SLOW.delta:g} rad at {SLOW.omega:g} rad/s, stability is lost at a C_lβ that differs "
        f"from the free flight's by {shifts[80.0, 0.1, 0.1]:+.1f} % on 80 m and by "
        f"{shifts[200.0, 0.1, 0.1]:+.1f} % on 200 m. Over all swings tried the shift is "
        f"{min(known):+.1f} % to {max(known):+.1f} %, the larger the closer the hands are to the "
        f"kite's own {stability(at(80.0, lost[80.0])).modes[0].imag:.2f} rad/s.{unknown}",
    ]


def _beta_figure(swing: Swing) -> "Figure":
    figure, axes = panels(len(SHOWN), 2, (7.2, 6.4), sharex=True, sharey=True)
    for column, length in enumerate(LENGTHS):
        for ax, value in zip(axes[:, column], SHOWN, strict=True):
            rows = survey(length, value, swing, 0.0 if swing.delta else ASIDE)[:3001]
            ax.plot(np.arange(len(rows)) * EVERY, np.degrees(rows[:, BETA]), lw=0.9, color="black")
            ax.axhline(0.0, color="0.7", lw=0.6, zorder=0)
            ax.set_title(f"{length:g} m, $C_{{l\\beta}}$ = {value:g}", fontsize=9, loc="left")
            ax.tick_params(labelsize=8)
        axes[-1, column].set_xlabel("time [s]")
    for ax in axes[:, 0]:
        ax.set_ylabel("β [°]")
    axes[0, 0].set(xlim=(0.0, 300.0), ylim=(-3.2, 3.2))
    return figure


def _sky_figure() -> "Figure":
    figure, (axes,) = panels(1, 2, (7.2, 3.8), sharey=True)
    looks: Any = {-0.36: "-", -0.4: "--", VORTEX_LATTICE: "-."}
    for ax, length in zip(axes, LENGTHS, strict=True):
        for value, style in looks.items():
            flown = _cycle(length, value)
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


def _amplitude_figure(lost: dict[float, float]) -> "Figure":
    figure, (axes,) = panels(1, 2, (7.2, 3.4), sharey=True)
    values: NDArray[np.float64] = np.round(np.arange(-0.6, -0.01, 0.04), 3)
    looks = {
        "no control": (STILL, "o-", "black"),
        "slow hands": (SLOW, "s--", "#B8560A"),
        "fast hands": (FAST, "^-.", "#0B6FA4"),
    }
    for ax, length in zip(axes, LENGTHS, strict=True):
        for name, (swing, style, colour) in looks.items():
            label = name
            if swing.delta:
                label += f": {swing.delta:g} rad at {swing.omega:g} rad/s"
            beta = [_staying_beta(length, float(value), swing) for value in values]
            ax.plot(values, beta, style, color=colour, ms=3.5, lw=1.1, label=label)
        ax.axvline(lost[length], color="0.4", lw=0.9, ls=":")
        ax.set(xlabel=r"$C_{l\beta}$ [1/rad]", title=f"{length:g} m", ylim=(0.0, None))
        ax.grid(color="0.92")
    axes[0].set_ylabel("largest |β| [°]")
    axes[1].legend(fontsize=8, frameon=False)
    return figure


def _staying_beta(length: float, cl_beta: float, swing: Swing) -> float:
    """Largest |β| [°] of what stays; not a number where the flight ended early."""
    end = stays(length, cl_beta, swing)
    return degrees(np.abs(end[:, BETA]).max()) if len(end) else nan


def _threshold_figure(table: Table, lost: dict[float, float]) -> "Figure":
    figure, (axes,) = panels(1, 2, (7.2, 3.4), sharey=True)
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
