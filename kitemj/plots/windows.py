"""Figures in windows, where there is a display."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from kitemj.errors import InputError

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def check_windows() -> None:
    """Raises InputError where matplotlib can open no window."""
    from matplotlib import pyplot
    from matplotlib.backends.registry import BackendFilter, backend_registry

    registry: Any = backend_registry
    if pyplot.get_backend().lower() not in registry.list_builtin(BackendFilter.INTERACTIVE):
        raise InputError(
            "there is no display to show figures on (or no toolkit to open a window with, such as "
            "tkinter or PySide6): give `save` a name such as flight.png"
        )


def show(figures: Mapping[str, Figure]) -> None:
    """Shows a window for each figure; returns when all are closed."""
    from matplotlib import pyplot

    for figure in figures.values():
        pyplot.figure(figure)
    pyplot.show()
