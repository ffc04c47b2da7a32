"""Smooth lines on a surface, each pixel covered by as much as the line covers of it.

pygame's own (`draw.aalines`, 2.6.1) writes outside the surface's memory for some lines.
"""

import numpy as np
import pygame
from numpy.typing import NDArray


def smooth_lines(
    surface: pygame.Surface,
    places: NDArray[np.float64],
    colours: NDArray[np.float64],
    width: float | NDArray[np.float64],
    box: pygame.Rect,
    usable: NDArray[np.bool_] | None = None,
) -> None:
    """Paints a line of straight pieces; one that is longer than the box is wide is left out.

    surface: the frame
    places: (n, 2) px, the points it leads through
    colours: (n-1, 4) red, green, blue (0..255) and opacity (0..1) of each piece
    width: px, of all pieces or (n-1,) of each
    box: px; nothing is painted outside
    usable: (n,) pieces with an end that is not usable are left out; None: all are
    """
    box = box.clip(surface.get_rect())
    start, step = places[:-1], np.diff(places, axis=0)
    steep = np.abs(step[:, 1]) > np.abs(step[:, 0])
    low, high = np.minimum(start, start + step), np.maximum(start, start + step)
    kept = (high >= (box.left - 2, box.top - 2)).all(1)
    kept &= (low <= (box.right + 2, box.bottom + 2)).all(1)
    kept &= np.abs(step).max(axis=1, initial=0.0) < 2 * (box.width + box.height)
    if usable is not None:
        kept &= usable[:-1] & usable[1:]
    if not kept.any():
        return
    # along the longer side of a piece one sample in each column (or row, where it is steep)
    a = np.where(steep[:, None], start[:, ::-1], start)[kept]
    d = np.where(steep[:, None], step[:, ::-1], step)[kept]
    d[:, 0] = np.where(np.abs(d[:, 0]) < 1e-9, 1e-9, d[:, 0])
    first = np.floor(np.minimum(a[:, 0], a[:, 0] + d[:, 0]) + 0.5).astype(int)
    last = np.floor(np.maximum(a[:, 0], a[:, 0] + d[:, 0]) + 0.5).astype(int)
    counts = last - first + 1
    piece = np.repeat(np.arange(len(counts)), counts)
    along = np.arange(len(piece)) - np.repeat(np.cumsum(counts) - counts, counts) + first[piece]
    slope = d[:, 1] / d[:, 0]
    across = a[piece, 1] + slope[piece] * (along - a[piece, 0])
    wide = np.broadcast_to(width, kept.shape)[kept]
    half = (wide / 2 * np.sqrt(1 + slope**2))[piece]
    reach = int(np.ceil(wide.max() / 2 * 1.4143 + 0.5))
    rows = np.floor(across + 0.5).astype(int)[:, None] + np.arange(-reach, reach + 1)
    cover = np.clip(half[:, None] + 0.5 - np.abs(rows - across[:, None]), 0.0, 1.0)
    columns = np.broadcast_to(along[:, None], rows.shape)
    swap = steep[kept][piece][:, None]
    x, y = np.where(swap, rows, columns), np.where(swap, columns, rows)
    on = (cover > 0) & (x >= box.left) & (x < box.right) & (y >= box.top) & (y < box.bottom)
    paint = colours[kept][np.broadcast_to(piece[:, None], rows.shape)[on]]
    x, y, opacity = x[on], y[on], (cover[on] * paint[:, 3])[:, None]
    pixels = pygame.surfarray.pixels3d(surface)
    pixels[x, y] = pixels[x, y] * (1 - opacity) + paint[:, :3] * opacity
