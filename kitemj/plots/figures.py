"""Every figure of a flight by its name."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from kitemj.errors import InputError
from kitemj.plots.flight import Flight
from kitemj.plots.path import path_figure
from kitemj.plots.series import (
    angles_figure,
    rates_figure,
    state_figure,
    steering_figure,
    tensions_figure,
)
from kitemj.plots.window import window_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FIGURES: dict[str, Callable[[Flight], Figure]] = {
    "state": state_figure,
    "rates": rates_figure,
    "tensions": tensions_figure,
    "angles": angles_figure,
    "steering": steering_figure,
    "path": path_figure,
    "window": window_figure,
}


def drawn(flight: Flight, names: list[str]) -> tuple[dict[str, Figure], list[str]]:
    """The figures called `names`; none of them: all that can be drawn, and why others cannot.

    Raises InputError for a figure that was named and cannot be drawn.
    """
    figures, lacking = {}, []
    for name in names or FIGURES:
        try:
            figures[name] = FIGURES[name](flight)
        except InputError as error:
            if names:
                raise
            lacking.append(f"without {name}: {error}")
    if not figures:
        raise InputError(lacking[0])
    return figures, lacking
