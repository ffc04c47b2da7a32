"""Flights of a second or two that the tests of this room draw."""

import numpy as np

from kitemj.flight.scenario import scenario_of
from kitemj.flight.simulate import simulate
from kitemj.physics.parameter_files import parameter_set
from kitemj.plots.flight import Flight

TABLES = {
    "set": "sport",
    "duration": 2.0,
    "output_interval": 0.05,
    "steering": {"programme": "sine", "delta_amplitude": 0.1, "delta_frequency": 1.5},
    "start": {"at": "equilibrium", "phi_deg": 5.0, "eta_dot": -0.15},
}
TOML = """
set = "sport"
duration = 2.0
output_interval = 0.05
steering = { programme = "sine", delta_amplitude = 0.1, delta_frequency = 1.5 }
start = { at = "equilibrium", phi_deg = 5.0, eta_dot = -0.15 }
"""
QUIET = {"tension_plus_N": 60.0, "tension_minus_N": 60.0, "alpha_deg": 5.0, "beta_deg": 0.0}


def simulation():
    return simulate(scenario_of(TABLES, "test"), "lagrange")


def by_hand(rows=5, **columns):
    """A flight of the set `laksa`, one row a second; T_max 600 N, α_stall 25°, β_max 15°."""
    constant = {name: np.full(rows, value) for name, value in QUIET.items()}
    given = {name: np.array(values) for name, values in columns.items()}
    return Flight(
        "test", parameter_set("laksa"), {"t_s": np.arange(float(rows))} | constant | given
    )
