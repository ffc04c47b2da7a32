"""Section 3.2: stability without control and under δ = δ₀ sin ωt, on both lengths, over C_lβ."""

from math import degrees, isnan
from pathlib import Path

import numpy as np

from kitemj.dynamics.batch import ALPHA, BETA, TENSIONS
from kitemj.equilibria.modes import stability
from kitemj.flight.limits import batch_numbers, departure_in
from kitemj.physics.compiled import Array as Rows
from kitemj.physics.parameters import Parameters
from kitemj.tables import Cell, Table
from thesis.forced_response import LAST, SineSteering, stability_threshold
from thesis.free_and_steered_figures import (
    amplitude_figure,
    beta_figure,
    sky_figure,
    threshold_figure,
)
from thesis.free_and_steered_flights import (
    AMPLITUDES,
    DURATION,
    FAST,
    LENGTHS,
    NO_STEERING,
    OMEGAS,
    PARAFOIL,
    SLOW,
    START_PHI,
    THESIS,
    TRANSIENT_END,
    VORTEX_LATTICE,
    cycle_at,
    loss_of_stability,
    measured_growth,
    parameters_at,
    start_beta,
    steady_rows,
)
from thesis.section import Answer, Drawing, NamedTable, Section

CL_BETAS = (PARAFOIL, THESIS, -0.2, -0.3, -0.36, VORTEX_LATTICE)
ANSWERS: tuple[Answer, ...] = ()


def section(scratch: Path) -> Section:
    """Flights by Lagrange's equations; the set thesis with C_lβ and L₀ changed."""
    lost = {length: loss_of_stability(length) for length in LENGTHS}
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
                f"β after a start {degrees(START_PHI):.0f}° to the side, lines held: stable flight "
                "above, cycles that the kite flies by itself below. Left 80 m, right 200 m.",
                beta_figure(NO_STEERING),
            ),
            Drawing(
                "steered_beta",
                f"The same with δ = {SLOW.delta:g} rad · sin({SLOW.omega:g} rad/s · t). The "
                "first instant, when lines that move at once throw the kite, is off the scale.",
                beta_figure(SLOW),
            ),
            Drawing(
                "free_cycles",
                "Cycles that the kite flies by itself beyond the loss of stability, as the pilot "
                "sees them.",
                sky_figure(),
            ),
            Drawing(
                "beta_over_cl_beta",
                "What stays of |β| after the start, over C_lβ: nothing without control until "
                "stability is lost (dotted), some at every C_lβ with steering. Where a point "
                "lacks, the flight met the ground.",
                amplitude_figure(lost),
            ),
            Drawing(
                "steered_thresholds",
                "Where the steered flight loses its stability, over the width of the hands' "
                "swing; at zero width it is where the free flight does.",
                threshold_figure(thresholds, lost),
            ),
        ],
        tables=[
            NamedTable("free_flight", free_table()),
            NamedTable("growth", growth_table()),
            NamedTable("steered_flight", steered_table()),
            NamedTable("steered_thresholds", thresholds),
        ],
    )


def free_table() -> Table:
    """A row for each length and C_lβ: the swing's mode, and the cycle where it grows."""
    rows: list[tuple[Cell, ...]] = []
    for length in LENGTHS:
        for value in CL_BETAS:
            found = stability(parameters_at(length, value))
            sway = next(m for m in found.modes if m.imag > 0 and "sway" in m.name)
            head = (length, value, sway.real, sway.imag, found.stable)
            if found.stable:
                rows.append((*head, "stands", *[float("nan")] * 4, True))
                continue
            flown = cycle_at(length, value)
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
            mode = stability(parameters_at(length, value)).modes[0]
            flown = measured_growth(length, value)
            rows.append((length, value, mode.real, flown, 100 * (flown / mode.real - 1)))
    columns = ("length_m", "C_lβ", "mode_per_s", "flown_per_s", "difference_percent")
    return Table("Growth of β where the kite cannot stand", columns, rows)


def steered_table() -> Table:
    """A row for each swing, length and C_lβ: what stays, and what the start does."""
    rows: list[tuple[Cell, ...]] = []
    for steering in (SLOW, FAST):
        for length in LENGTHS:
            for value in CL_BETAS:
                parameters, end = parameters_at(length, value), steady_rows(length, value, steering)
                extremes = (
                    degrees(np.abs(end[:, BETA]).max()),
                    degrees(end[:, ALPHA].min()),
                    degrees(end[:, ALPHA].max()),
                    float(end[:, TENSIONS:].min()),
                    float(end[:, TENSIONS:].max()),
                )
                head = (steering.delta, steering.omega, length, value)
                tail = (_valid(parameters, end), start_beta(length, steering))
                rows.append((*head, *extremes, *tail))
    columns = ("δ₀_rad", "ω_rad_per_s", "length_m", "C_lβ", "beta_max_deg", "alpha_min_deg")
    more = ("alpha_max_deg", "tension_min_N", "tension_max_N", "within_limits", "start_beta_deg")
    title = f"δ = δ₀ sin ωt: extremes from {TRANSIENT_END:g} to {DURATION:g} s, and β at the start"
    return Table(title, (*columns, *more), rows)


def _valid(parameters: Parameters, rows: Rows) -> bool:
    return departure_in(parameters.limits, range(len(rows)), batch_numbers(rows)) is None


def threshold_table(lost: dict[float, float]) -> Table:
    """A row for each length and swing: where the steered flight loses its stability."""
    rows: list[tuple[Cell, ...]] = []
    for length in LENGTHS:
        for omega in OMEGAS:
            for width in AMPLITUDES:
                found = stability_threshold(
                    parameters_at(length, THESIS), SineSteering(width, omega)
                )
                shift = 100 * (found.value / lost[length] - 1)
                rows.append(
                    (length, omega, width, lost[length], found.value, shift, found.stable_to)
                )
    columns = ("length_m", "ω_rad_per_s", "δ₀_rad", "free_C_lβ", "steered_C_lβ", "shift_percent")
    title = f"Where stability is lost, free and steered (looked for down to C_lβ = {LAST:g})"
    return Table(title, (*columns, "stable_at_least_to"), rows)


def _here_free(lost: dict[float, float]) -> list[str]:
    near, far = (cycle_at(length, VORTEX_LATTICE) for length in LENGTHS)
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
    own = stability(parameters_at(80.0, lost[80.0])).modes[0]
    return [
        "Under steering there is a flight that repeats itself with the hands. Whether the kite "
        "keeps to it is asked of the Floquet multipliers of that flight "
        "(scripts/thesis/forced_response.py). With the slow swing of the thesis's limits, "
        f"{SLOW.delta:g} rad at {SLOW.omega:g} rad/s, stability is lost at a C_lβ that differs "
        f"from the free flight's by {shifts[80.0, 0.1, 0.1]:+.1f} % on 80 m and by "
        f"{shifts[200.0, 0.1, 0.1]:+.1f} % on 200 m. Over all swings tried the shift is "
        f"{min(known):+.1f} % to {max(known):+.1f} %, the larger the closer the hands are to the "
        f"kite's own {own.imag:.2f} rad/s.{unknown}",
    ]
