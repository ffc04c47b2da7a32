"""The strip chart of punctuality: how late ticks were, how long frames took, missed ticks.

Time runs to the right, the last 20 s of it; the height is logarithmic, 0.1 ms to 200 ms. A
missed tick is a red column from top to bottom.
"""

from math import log10
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kitemj.drawing.colours import ALARM, CALL, GOOD, INK, WHITE, Colour
from kitemj.drawing.history import CHART_COLUMNS, Traces
from kitemj.drawing.panel import NAME, Panel
from kitemj.flight.live import TICK

WIDTH, HEIGHT = 292, 166
LEFT, TOP, BOTTOM = 14, 36, 104  # of the plot
WIDE = WIDTH - 28
LEAST, MOST = 1e-4, 0.2  # s
FRAME: Colour = (158, 214, 255)
LINE: Colour = (150, 160, 172)


def paint_chart(panel: Panel, traces: Traces | None, missed_ticks: int, lateness: float) -> None:
    """Paints the chart; `lateness` [s] of the last tick, `missed_ticks` since the start."""
    panel.row("ticks missed", f"{missed_ticks}", 20, colour=CALL if missed_ticks else WHITE)
    panel.bar(LEFT, TOP, WIDE, BOTTOM - TOP, INK)
    late = traces.lateness if traces else np.full(CHART_COLUMNS, np.nan)
    frames = traces.frame_time if traces else np.full(CHART_COLUMNS, np.nan)
    edges = np.flatnonzero(np.diff(late > TICK, prepend=False, append=False))
    for start, end in edges.reshape(-1, 2).tolist():
        panel.bar(_x(start), TOP, max(_x(end) - _x(start), 3), BOTTOM - TOP, ALARM)
    limit = float(_y(TICK))
    panel.line([(LEFT, limit), (LEFT + WIDE, limit)], LINE, 1)
    for values, colour in ((late, GOOD), (frames, FRAME)):
        for run in _lines(values):
            panel.line(run, colour, 2)
    late_by, most = f"{1e3 * lateness:.1f} ms", f"late, max {1e3 * TICK:.0f} ms"
    panel.row(most, late_by, BOTTOM + 20, NAME, WHITE, GOOD)
    known = frames[np.isfinite(frames)]
    newest = f"{1e3 * known[-1]:.0f} ms" if len(known) else "-"
    panel.row("frame", newest, BOTTOM + 44, NAME, WHITE, FRAME)


def _x(column: Any) -> Any:
    return LEFT + WIDE * column / CHART_COLUMNS


def _y(seconds: Any) -> Any:
    share = np.log10(np.clip(seconds, LEAST, MOST) / LEAST) / log10(MOST / LEAST)
    return BOTTOM - share * (BOTTOM - TOP)


def _lines(values: NDArray[np.float64]) -> list[list[tuple[float, float]]]:
    """Points of the lines through the columns that have a value; a gap of one is bridged."""
    known = np.flatnonzero(np.isfinite(values))
    points = np.stack([_x(known + 0.5), _y(values[known])], axis=1)
    runs = np.split(points, np.flatnonzero(np.diff(known) > 2) + 1)
    return [[(x, y) for x, y in run.tolist()] for run in runs if len(run) > 1]
