"""Section 4.6: the flights of the cases of Table 3, under any schedule of the stick."""

from functools import cache
from math import degrees
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.batch import BETA
from kitemj.dynamics.motion import Motion
from kitemj.equilibria.trim import equilibria
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import StickLimits
from kitemj.plots.flight import Flight, flight_of_motions
from thesis.programmed_steering import Schedule, lagrange_rows, scenario

LENGTHS = (80.0, 200.0)  # m
PRINTED_DELTA = 0.1
"""rad; the δ that the thesis computes from the reach of an arm."""


class Case(NamedTuple):
    """A column of Table 3: largest |δ| [rad], |δ̇| [rad/s], |δ̈| [rad/s²]."""

    delta: float
    delta_dot: float
    delta_ddot: float

    def stick(self) -> StickLimits:
        """The limits of the set thesis with these in place of its own."""
        return scenario(LENGTHS[0]).parameters.stick._replace(**self._asdict())


CASES = {1: Case(0.1, 0.005, 0.05), 2: Case(0.1, 0.05, 0.05), 3: Case(0.1, 0.01, 0.05)}
CASES[4] = Case(0.1, 0.01, 0.5)

Flights = dict[int, dict[str, list[Motion]]]
"""The motions at every tick, by case and model."""


@cache
def case_rows(length: float, case: Case, schedule: Schedule) -> Array:
    """The flight of `schedule` by Lagrange's equations, as rows of a batch."""
    return lagrange_rows(length, case.stick(), schedule)


def peak_beta(rows: Array) -> float:
    """Largest |β| [°] in the rows of a batch."""
    return degrees(np.abs(rows[:, BETA]).max())


def largest_beta(length: float, case: Case, schedule: Schedule) -> float:
    """Largest |β| [°] of a flight by Lagrange's equations."""
    return peak_beta(case_rows(length, case, schedule))


def held_beta(length: float) -> float:
    """|β| [°] of the kite that stands with δ held at what the thesis allows."""
    [found] = equilibria(scenario(length).parameters, delta=PRINTED_DELTA)
    return abs(degrees(found.beta))


def case_flight(case: int, motions: list[Motion]) -> Flight:
    """A case of `CASES` as the plots take it."""
    return flight_of_motions(f"case {case}", scenario(LENGTHS[0]).parameters, motions)
