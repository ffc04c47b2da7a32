"""Imported once by the process that all victims are forked from, so that each starts at once."""

import kitemj.cli  # noqa: F401
from kitemj.dynamics.formulation import MODELS
from kitemj.flight.scenario import scenario_of
from kitemj.flight.simulate import simulate

SHORT = {"set": "sport", "duration": 0.1}
for model in MODELS.shipped:  # loads the machine code, which every victim then has
    simulate(scenario_of(SHORT, "warm"), model)
