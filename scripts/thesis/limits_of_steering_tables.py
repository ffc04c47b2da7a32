"""Section 4.6: tables of the cases of Table 3, of the values around them and beyond."""

from math import degrees, log, sin

import numpy as np

from kitemj.dynamics.batch import TENSIONS
from kitemj.physics.steering import ell_delta, rest_ell
from kitemj.plots.limits import extremes
from kitemj.tables import Cell, Table
from thesis.limits_of_steering_flights import (
    CASES,
    LENGTHS,
    PRINTED_DELTA,
    Case,
    Flights,
    case_flight,
    case_rows,
    held_beta,
    largest_beta,
    peak_beta,
)
from thesis.programmed_steering import FULL_DEFLECTION, scenario, square_wave

HALF_PERIODS = (2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 15.0, 20.0, 30.0, 40.0)  # s
SENSITIVITY_STEP = 0.1
"""Of a limit; by which it is raised and lowered for its sensitivity."""
RATES = (0.0025, 0.005, 0.0075, 0.01, 0.015, 0.025, 0.05, 0.075, 0.1, 0.2, 0.5, 1.0)  # rad/s
ACCELERATIONS = (0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)  # rad/s²
ARM = 0.25
"""m; its reach, either way."""


def case_table(flights: Flights) -> Table:
    """A row for each case: its limits, the largest |β|, and how far the models are apart."""
    rows: list[tuple[Cell, ...]] = []
    for case, limits in CASES.items():
        beta = {m: np.degrees([x.air.beta for x in flown]) for m, flown in flights[case].items()}
        largest = {model: float(np.abs(values).max()) for model, values in beta.items()}
        spread = max(float(np.abs(b - beta["lagrange"]).max()) for b in beta.values())
        rows.append((case, *limits, *largest.values(), spread))
    columns = ("case", "δ_max_rad", "δ̇_max_rad_per_s", "δ̈_max_rad_per_s2")
    betas = [f"beta_{model.replace('-', '_')}_deg" for model in flights[1]]
    title = f"Table 3 flown on {LENGTHS[0]:g} m lines: largest |β| by each model"
    return Table(title, (*columns, *betas, "models_apart_deg"), rows)


def ratio_table(flights: Flights) -> Table:
    """A row for each case and limit: how much of it is taken up."""
    rows: list[tuple[Cell, ...]] = [
        (case, e.ratio, e.smallest, e.largest, e.largest - e.smallest, e.largest_at_s, not e.reason)
        for case in CASES
        for e in extremes(case_flight(case, flights[case]["mujoco"]))
    ]
    columns = ("case", "ratio", "smallest", "largest", "change", "largest_at_s", "within")
    return Table("How much of each limit is taken up (mujoco)", columns, rows)


def lengths_table() -> Table:
    """A row for each length: the largest |β| [°] of each case, and that of δ held."""
    rows: list[tuple[Cell, ...]] = []
    for length in LENGTHS:
        found = [largest_beta(length, case, FULL_DEFLECTION) for case in CASES.values()]
        rows.append((length, *found, held_beta(length)))
    columns = ("length_m", *(f"case_{case}_deg" for case in CASES), "held_at_δ_max_deg")
    return Table("Largest |β| by the length of the lines", columns, rows)


def square_wave_table() -> Table:
    """A row for each half period of full right and full left in turn."""
    rows: list[tuple[Cell, ...]] = [
        (half, *(largest_beta(LENGTHS[0], case, square_wave(half)) for case in CASES.values()))
        for half in HALF_PERIODS
    ]
    columns = ("held_for_s", *(f"case_{case}_deg" for case in CASES))
    return Table("Largest |β| under full right and full left in turn", columns, rows)


def sensitivity_table() -> Table:
    """Around case 3: by how many percent |β| rises when a limit rises by one."""
    rows: list[tuple[Cell, ...]] = []
    for name in Case._fields:
        value = getattr(CASES[3], name)
        high, low = (
            largest_beta(LENGTHS[0], CASES[3]._replace(**{name: value * factor}), FULL_DEFLECTION)
            for factor in (1 + SENSITIVITY_STEP, 1 - SENSITIVITY_STEP)
        )
        percent = log(high / low) / log((1 + SENSITIVITY_STEP) / (1 - SENSITIVITY_STEP))
        rows.append((_SYMBOLS[name], value, low, high, percent))
    columns = ("limit", "value", "beta_10_percent_less_deg", "beta_10_percent_more_deg")
    title = "Around case 3: percent of |β| for one percent of each limit"
    return Table(title, (*columns, "percent_for_percent"), rows)


_SYMBOLS = {"delta": "δ_max [rad]", "delta_dot": "δ̇_max [rad/s]", "delta_ddot": "δ̈_max [rad/s²]"}


def reach_table() -> Table:
    """δ that arms of ±`ARM` make, by equations 8 and 9, and the way that 0.1 rad take."""
    rows: list[tuple[Cell, ...]] = []
    y_A = scenario(LENGTHS[0]).parameters.kite.y_A
    for length in LENGTHS:
        ell, delta = ell_delta(length + ARM, length - ARM, y_A)
        way = rest_ell(length, y_A) * y_A * sin(PRINTED_DELTA) / length
        rows.append((length, ARM, ell, delta, degrees(delta), PRINTED_DELTA, way))
    columns = ("length_m", "arm_m", "ell_m", "δ_rad", "δ_deg", "printed_δ_rad")
    return Table("The reach of an arm", (*columns, "arm_for_printed_δ_m"), rows)


def map_table() -> Table:
    """Largest |β| and least tension over the limits of δ̇ and δ̈, with δ_max = 0.1 rad."""
    rows: list[tuple[Cell, ...]] = []
    for acceleration in ACCELERATIONS:
        for rate in RATES:
            flown = case_rows(LENGTHS[0], Case(PRINTED_DELTA, rate, acceleration), FULL_DEFLECTION)
            least = float(flown[:, TENSIONS:].min())
            rows.append((rate, acceleration, peak_beta(flown), least))
    columns = ("δ̇_max_rad_per_s", "δ̈_max_rad_per_s2", "beta_max_deg", "tension_min_N")
    return Table("Largest |β| over the limits of δ̇ and δ̈, 80 m lines", columns, rows)
