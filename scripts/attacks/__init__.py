"""Attacks on the program, a file for each kind; `scripts/attack.py` runs them."""
