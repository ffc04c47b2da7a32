"""Time and record: equilibrium, scenarios, simulation, comparison."""
