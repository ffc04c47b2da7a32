"""Every figure of a flight by its name."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from kitemj.registry import Registry

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FIGURES: Registry[Callable[[Any], Figure]] = Registry(
    "figure",
    "kitemj.figures",
    {
        "state": "kitemj.plots.series:state_figure",
        "rates": "kitemj.plots.series:rates_figure",
        "tensions": "kitemj.plots.series:tensions_figure",
        "angles": "kitemj.plots.series:angles_figure",
        "steering": "kitemj.plots.series:steering_figure",
        "path": "kitemj.plots.path:path_figure",
        "window": "kitemj.plots.window:window_figure",
        "guidance": "kitemj.plots.guidance:guidance_figure",
    },
)
"""Each takes a `Flight` and raises InputError where it lacks what would be drawn."""
