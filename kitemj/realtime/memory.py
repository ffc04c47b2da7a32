"""How much memory a process has had."""

import sys


def peak_memory() -> float:
    """The largest memory [MB] that this process has had so far; not a number on Windows."""
    if sys.platform == "win32":
        return float("nan")
    import resource

    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (1e6 if sys.platform == "darwin" else 1e3)
