"""What an autopilot told of itself, as columns of tables and recordings."""

from collections.abc import Mapping, Sequence
from math import degrees, nan, radians, tau
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kitemj.flight.pilot_settings import PHASES, Guided

PHASE = "pilot_phase"
"""A whole number: which of `PHASES`, from 0; -1 where no autopilot flew."""
NOBODY = -1
NUMBERS = (
    "path_error_deg",
    "path_laps",
    "attractor_azimuth_deg",
    "attractor_elevation_deg",
    "twist_turns",
    "pilot_since_s",
)
"""Off the path, positive to its right; laps flown; the place that is flown to, azimuth positive to
the right; turns of the lines; when the scenario's autopilot was handed the kite. Not a number where
there is no such thing."""


def phase_code(guided: Guided | None) -> int:
    """The number of its phase."""
    return PHASES.index(guided.phase) if guided else NOBODY


def guided_numbers(guided: Guided | None) -> list[float]:
    """In the order of `NUMBERS`."""
    if guided is None:
        return [nan] * len(NUMBERS)
    _, error, laps, azimuth, elevation, twist, since = guided
    return [degrees(error), laps, degrees(azimuth), degrees(elevation), twist / tau, since]


def guided_at(columns: Mapping[str, NDArray[Any]], row: int) -> Guided | None:
    """What was told in a `row` of a recording; None where no autopilot flew."""
    code = int(columns[PHASE][row])
    if code == NOBODY:
        return None
    numbers = (float(columns[name][row]) for name in NUMBERS)
    error, laps, azimuth, elevation, twist, since = numbers
    at = radians(azimuth), radians(elevation)
    return Guided(PHASES[code], radians(error), laps, *at, tau * twist, since)


def guided_columns(told: Sequence[Guided | None]) -> dict[str, NDArray[np.generic]]:
    """A column for each of `PHASE` and `NUMBERS`, shape (rows,)."""
    rows = np.array([guided_numbers(each) for each in told], np.float64)
    rows = rows.reshape(len(told), len(NUMBERS))
    phases = np.array([phase_code(each) for each in told], np.int32)
    return {PHASE: phases, **{name: rows[:, i].copy() for i, name in enumerate(NUMBERS)}}
