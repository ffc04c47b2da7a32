"""Where figures go: to files (all are written or none) or windows.

Several figures are the pages of a PDF, or a PNG or SVG of all and one of each.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kitemj.errors import InputError
from kitemj.files import check_new, new_file
from kitemj.plots.overview import save_overview

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMATS = (".png", ".pdf", ".svg")
SHARPNESS = 200
"""dots per inch of a PNG."""


def check_figures(path: Path, names: Sequence[str], overwrite: bool) -> list[Path]:
    """The files that figures of these `names` go to; InputError where one cannot be written.

    `path` is the first, and has all of them; that of a PNG or SVG is followed by one for each of
    several, called by its name, flight-state.png.
    """
    if path.suffix.lower() not in FORMATS:
        raise InputError(
            f"{path.name} must end in one of {', '.join(FORMATS)} to say which kind of figure it is"
        )
    together = len(names) == 1 or path.suffix.lower() == ".pdf"
    alone = [] if together else [path.with_stem(f"{path.stem}-{name}") for name in names]
    paths = [path, *alone]
    for each in paths:
        check_new(each, overwrite)
    return paths


def save_figures(figures: Mapping[str, Figure], path: Path, overwrite: bool = False) -> list[Path]:
    """Writes `figures` (by name) to the files that `check_figures` tells, and returns these."""
    paths = check_figures(path, list(figures), overwrite)
    kind = path.suffix[1:].lower()
    with ExitStack() as stack:
        parts = [stack.enter_context(new_file(each, overwrite)) for each in paths]
        if kind == "pdf":
            from matplotlib.backends.backend_pdf import PdfPages

            pages = stack.enter_context(PdfPages(parts[0]))
            for figure in figures.values():
                pages.savefig(figure)
        else:
            if len(figures) > 1:
                save_overview(list(figures.values()), parts.pop(0), kind)
            for figure, part in zip(figures.values(), parts, strict=True):
                figure.savefig(part, format=kind, dpi=SHARPNESS)
    return paths


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
