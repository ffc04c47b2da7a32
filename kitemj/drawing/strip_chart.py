"""The strip chart of punctuality: how late ticks were, how long frames took, missed ticks.

Time runs to the right, the last 20 s of it; the height is logarithmic, 0.1 ms to 200 ms. A
missed tick is a red column from top to bottom.
"""

from math import log10
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kitemj.drawing.colours import ALARM, BAD, GOOD, TROUGH, WHITE, Colour
from kitemj.drawing.history import CHART_COLUMNS, Traces
from kitemj.drawing.panel import Panel
from kitemj.flight.live import TICK

WIDTH, HEIGHT = 292, 166
LEFT, TOP, BOTTOM = 12, 60, 132  # of the plot
WIDE = WIDTH - 24
LEAST, MOST = 1e-4, 0.2  # s
FRAME: Colour = (120, 196, 255)
LINE: Colour = (120, 128, 140)


def paint_chart(panel: Panel, traces: Traces | None, missed_ticks: int, lateness: float) -> None:
    """Paints the chart; `lateness` [s] of the last tick, `missed_ticks` since the start."""
    panel.text("missed ticks", LEFT, 20)
    panel.text(f"{missed_ticks}", WIDTH - 12, 20, 23, BAD if missed_ticks else WHITE, 1)
    panel.bar(LEFT, TOP - 20, WIDE, BOTTOM - TOP + 20, TROUGH)
    late = traces.lateness if traces else np.full(CHART_COLUMNS, np.nan)
    frames = traces.frame_time if traces else np.full(CHART_COLUMNS, np.nan)
    edges = np.flatnonzero(np.diff(late > TICK, prepend=False, append=False))
    for start, end in edges.reshape(-1, 2).tolist():
        panel.bar(_x(start), TOP - 20, max(_x(end) - _x(start), 3), BOTTOM - TOP + 20, ALARM)
    limit = float(_y(TICK))
    panel.line([(LEFT, limit), (LEFT + WIDE, limit)], LINE, 1)
    panel.text(f"{1e3 * TICK:.0f} ms", LEFT + 4, limit + 13, 18, LINE)
    for values, colour in ((late, GOOD), (frames, FRAME)):
        for run in _lines(values):
            panel.line(run, colour, 2)
    known = frames[np.isfinite(frames)]
    newest = f"frame {1e3 * known[-1]:.0f} ms" if len(known) else "ms"
    panel.text(f"late {1e3 * lateness:.1f}", LEFT, BOTTOM + 18, colour=GOOD)
    panel.text(newest, WIDTH - 12, BOTTOM + 18, colour=FRAME, align=1)


def _x(column: Any) -> Any:
    return LEFT + WIDE * column / CHART_COLUMNS


def _y(seconds: Any) -> Any:
    share = np.log10(np.clip(seconds, LEAST, MOST) / LEAST) / log10(MOST / LEAST)
    return BOTTOM - share * (BOTTOM - TOP + 20)


def _lines(values: NDArray[np.float64]) -> list[list[tuple[float, float]]]:
    """Points of the lines through the columns that have a value; a gap of one is bridged."""
    known = np.flatnonzero(np.isfinite(values))
    points = np.stack([_x(known + 0.5), _y(values[known])], axis=1)
    runs = np.split(points, np.flatnonzero(np.diff(known) > 2) + 1)
    return [[(x, y) for x, y in run.tolist()] for run in runs if len(run) > 1]
