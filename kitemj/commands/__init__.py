"""The subcommands of `kitemj`: each reads its words and calls one room.

A file `x.py` is `kitemj x`: `HELP`, `EXAMPLE`, `NOTES` if any, `add` its arguments, and `run`,
which returns the exit status, or nothing for 0.
"""
