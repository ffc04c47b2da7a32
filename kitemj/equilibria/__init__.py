"""Equilibria (trim), their stability, and the cycles that a kite flies by itself."""
