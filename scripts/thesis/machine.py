"""The machine and the versions of packages that a report was made with."""

import os
import platform
import re
from importlib.metadata import requires, version
from pathlib import Path


def machine() -> str:
    """Processor, cores that this process may use, system and Python, in one line."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return (
        f"{_processor()}, {cores} cores; {platform.system()} {platform.release()}; "
        f"Python {platform.python_version()}"
    )


def packages() -> str:
    """kitemj's own dependencies that are installed, with their versions."""
    names = {
        re.split(r"[^\w.-]", line)[0] for line in requires("kitemj") or [] if "extra" not in line
    }
    return ", ".join(f"{name} {found}" for name in sorted(names) if (found := _version(name)))


def _version(name: str) -> str:
    try:
        return version(name)
    except ModuleNotFoundError:  # pygame or pygame-ce: one of them
        return ""


def _processor() -> str:
    """The processor's name; Linux tells it in a file only."""
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        text = ""
    found = re.search(r"^model name\s*:\s*(.+)$", text, re.MULTILINE)
    return found[1] if found else platform.processor() or platform.machine()
