"""A table of motions: its columns, and a row for each motion."""

import csv
from math import degrees
from pathlib import Path
from typing import Any

from kitemj.dynamics.motion import Motion
from kitemj.flight.guided_table import NUMBERS, PHASE, guided_numbers, phase_code
from kitemj.flight.pilot_settings import PHASES
from kitemj.flight.scenario import Scenario
from kitemj.flight.simulate import Simulation
from kitemj.metadata import new_csv
from kitemj.physics.parameter_files import parameter_tables
from kitemj.physics.rig import TWO_LINES, Rig, rig_of


def columns_of(rig: Rig) -> tuple[str, ...]:
    """Names of the columns; angles of the state in rad, α and β in degrees, axes E."""
    return (
        "t_s",
        *(f"{name}_rad" for name in rig.coordinates),
        *("x_E_m", "y_E_m", "z_E_m", "alpha_deg", "beta_deg"),
        *(f"tension_{name}_N" for name in rig.lines),
        *(f"length_{name}_m" for name in rig.lines),
    )


COLUMNS = columns_of(TWO_LINES)


def write_csv(path: Path, flight: Simulation, overwrite: bool = False) -> None:
    """A row for each motion, in the columns of its rig, all digits kept; beside it, what flew."""
    about = about_flight(flight.scenario, flight.model)
    with (
        new_csv(path, about, overwrite) as part,
        part.open("w", newline="", encoding="utf-8") as file,
    ):
        writer = csv.writer(file, lineterminator="\n")
        names, rows = columns_of(rig_of(flight.scenario.parameters)), map(row, flight.motions)
        if flight.guided:
            names = (*names, PHASE, *NUMBERS)
            told = ([phase_code(each), *guided_numbers(each)] for each in flight.guided)
            rows = map(list.__add__, rows, told)
        writer.writerow(names)
        writer.writerows(rows)


def about_flight(scenario: Scenario, model: str = "") -> dict[str, Any]:
    """What a table says of the flights in it: from which scenario, with which kite and wind."""
    parameters = parameter_tables(scenario.parameters)
    phases = list(PHASES) if scenario.pilot else []
    about = {"scenario": scenario.source, "model": model, "parameters": parameters, PHASE: phases}
    return {name: what for name, what in about.items() if what}


def row(motion: Motion) -> list[float]:
    """One motion in the order of its rig's columns."""
    angles = [degrees(motion.air.alpha), degrees(motion.air.beta)]
    position = motion.body.p_G_E
    q = motion.q or ()
    return [motion.t, *q, *position, *angles, *motion.tensions, *motion.lengths]
