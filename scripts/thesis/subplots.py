"""A matplotlib figure with a grid of equal axes, without a screen."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def subplots(
    rows: int, columns: int, size: tuple[float, float], **shared: Any
) -> "tuple[Figure, Any]":
    """A figure of `size` [inch] and its axes, shape (rows, columns)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, layout="constrained")
    return figure, figure.subplots(rows, columns, squeeze=False, **shared)
