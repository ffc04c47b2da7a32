"""Several figures on one sheet, side by side, each as it is alone: a PNG or an SVG."""

from __future__ import annotations

import re
from collections.abc import Sequence
from io import BytesIO, StringIO
from math import ceil, sqrt
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SHARPNESS = 100
"""dots per inch of a PNG; the figures themselves are for print."""
POINTS = 72.0
"""An inch, as SVG files of matplotlib count."""
NAMESPACES = (
    'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" version="1.1"'
)


def overview(figures: Sequence[Figure], kind: str) -> bytes:
    """A sheet of all `figures`, as the file that holds it; `kind` is "png" or "svg"."""
    if kind == "svg":
        return _drawing(figures).encode()
    from matplotlib.image import imsave

    placed, width, height = _places(figures, SHARPNESS)
    sheet, file = np.ones((height, width, 4)), BytesIO()
    for figure, (x, y) in zip(figures, placed, strict=True):
        image = _pixels(figure)
        sheet[y : y + image.shape[0], x : x + image.shape[1]] = image
    imsave(file, sheet, format="png", dpi=SHARPNESS)
    return file.getvalue()


def _places(figures: Sequence[Figure], scale: float) -> tuple[list[tuple[int, int]], int, int]:
    """Where each begins, from above, and the sheet's width and height; `scale` is an inch."""
    across = ceil(sqrt(1.5 * len(figures)))  # screens are wide
    sizes = [(ceil(w * scale), ceil(h * scale)) for w, h in (f.get_size_inches() for f in figures)]
    width, top, places = max(w for w, _ in sizes), 0, list[tuple[int, int]]()
    for first in range(0, len(sizes), across):
        row = sizes[first : first + across]
        places += [(width * i, top) for i in range(len(row))]
        top += max(h for _, h in row)
    return places, width * min(across, len(sizes)), top


def _pixels(figure: Figure) -> Any:
    from matplotlib.image import imread

    file = BytesIO()
    figure.savefig(file, format="png", dpi=SHARPNESS)
    file.seek(0)
    return imread(file)


def _drawing(figures: Sequence[Figure]) -> str:
    """An SVG that holds those of all figures; the names inside each are made its own."""
    placed, width, height = _places(figures, POINTS)
    parts = []
    for i, (figure, (x, y)) in enumerate(zip(figures, placed, strict=True)):
        file = StringIO()
        figure.savefig(file, format="svg")
        inner = re.sub(r"^.*?<svg[^>]*>|</svg>\s*$", "", file.getvalue(), flags=re.DOTALL)
        inner = re.sub(r'( id="|href="#|url\(#)', rf"\g<1>f{i}-", inner)
        parts.append(f'<g transform="translate({x} {y})">{inner}</g>\n')
    size = f'width="{width}pt" height="{height}pt" viewBox="0 0 {width} {height}"'
    return f"<svg {NAMESPACES} {size}>\n{''.join(parts)}</svg>\n"
