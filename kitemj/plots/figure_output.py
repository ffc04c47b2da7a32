"""Where figures go: to files (all are written or none) or windows.

Several figures are the pages of a PDF, or a PNG or SVG of all and one of each.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kitemj.errors import InputError
from kitemj.files import NewFile, check_new
from kitemj.plots.overview import overview

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
    # drawn in memory first: not all that draws says clearly that a disk is full
    pictures = [_pdf(figures)] if kind == "pdf" else _pictures(list(figures.values()), kind)
    with ExitStack() as stack:
        files = [NewFile(each, overwrite) for each in paths]
        for file in files:
            stack.callback(file.discard)
        for file, picture in zip(files, pictures, strict=True):
            with file.naming():
                file.part.write_bytes(picture)
        for file in files:
            file.keep()
    return paths


def _pdf(figures: Mapping[str, Figure]) -> bytes:
    from matplotlib.backends.backend_pdf import PdfPages

    drawn = BytesIO()
    with PdfPages(drawn) as pages:
        for figure in figures.values():
            pages.savefig(figure)
    return drawn.getvalue()


def _pictures(figures: Sequence[Figure], kind: str) -> list[bytes]:
    """A sheet of several, then each alone."""
    together = [overview(figures, kind)] if len(figures) > 1 else []
    return [*together, *(_picture(figure, kind) for figure in figures)]


def _picture(figure: Figure, kind: str) -> bytes:
    drawn = BytesIO()
    figure.savefig(drawn, format=kind, dpi=SHARPNESS)
    return drawn.getvalue()


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
