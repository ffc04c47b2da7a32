"""The report: computes every section and writes one page with its figures and tables.

::

    DIR/index.html     the page
    DIR/figures/       a drawing each, SVG (frames of the cockpit: PNG)
    DIR/tables/        a table each, CSV and Parquet, all digits
"""

from collections.abc import Callable, Sequence
from datetime import datetime
from importlib.metadata import version
from pathlib import Path
from shutil import copyfile

from jinja2 import Environment, PackageLoader, StrictUndefined

from kitemj.tables import write
from kitemj.temporary import temporary_folder
from thesis import (
    answers,
    coordinate_frames,
    display,
    equilibrium,
    free_and_steered,
    limits_of_steering,
    parameters,
    post_processing,
    real_time,
    sticks,
    verification,
    wishes,
)
from thesis.folder import new_folder
from thesis.machine import machine, packages
from thesis.section import Drawing, NamedTable, Section, SectionModule
from thesis.typesetting import typeset, typeset_cell, typeset_heading

SECTIONS: tuple[SectionModule, ...] = (
    parameters,
    coordinate_frames,
    equilibrium,
    free_and_steered,
    sticks,
    verification,
    display,
    limits_of_steering,
    real_time,
    wishes,
    post_processing,
)
"""The sections in the order of the thesis."""


def write_report(
    folder: Path,
    overwrite: bool,
    modules: Sequence[SectionModule],
    progress: Callable[[str, int], None],
) -> list[Section]:
    """Computes the sections of `modules` and writes the report into `folder`.

    `progress` is called before each section with its name and how many are done. Raises InputError
    for a folder with content (unless `overwrite`), and whatever makes a section fail; nothing
    is written then.
    """
    with new_folder(folder, overwrite) as part, temporary_folder() as scratch:
        sections = []
        for done, module in enumerate(modules):
            name = module.__name__.rsplit(".", 1)[-1]
            progress(name.replace("_", " "), done)
            own = scratch / name
            own.mkdir()
            sections.append(module.section(own))
        _check_sections(sections)
        for name in ("figures", "tables"):
            (part / name).mkdir()
        for section in sections:
            for drawing in section.drawings:
                _save_drawing(drawing, part / "figures")
            for named in (*section.tables, *section.timed):
                _save_table(named, part / "tables")
        (part / "index.html").write_text(_page(sections), encoding="utf-8")
    return sections


def _check_sections(sections: Sequence[Section]) -> None:
    """Two files of one name, or an answer that points nowhere, are mistakes in the sections."""
    for kind in ("drawings", "tables"):
        names = [part.name for section in sections for part in getattr(section, kind)]
        names += [n.name for section in sections for n in section.timed if kind == "tables"]
        twice = {name for name in names if names.count(name) > 1}
        if twice:
            raise ValueError(f"two {kind} are called {', '.join(sorted(twice))}")
    missing = [fault for section in sections for fault in answers.dangling(section)]
    if missing:
        raise ValueError("; ".join(missing))


def file_of(drawing: Drawing) -> str:
    """The name of a drawing's file in the folder of figures."""
    suffix = drawing.figure.suffix if isinstance(drawing.figure, Path) else ".svg"
    return drawing.name + suffix


def _save_drawing(drawing: Drawing, folder: Path) -> None:
    path = folder / file_of(drawing)
    if isinstance(drawing.figure, Path):
        copyfile(drawing.figure, path)
        return
    import matplotlib

    with matplotlib.rc_context({"svg.hashsalt": drawing.name}):  # the same file each time
        drawing.figure.savefig(path, metadata={"Date": None})


def _save_table(named: NamedTable, folder: Path) -> None:
    for suffix in (".csv", ".parquet"):
        write(folder / f"{named.name}{suffix}", [named.table], {}, overwrite=False)


def _page(sections: Sequence[Section]) -> str:
    environment = Environment(
        loader=PackageLoader("thesis", ""),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    drawings = {drawing.name for section in sections for drawing in section.drawings}

    def anchor(row: answers.Row) -> str:
        name = row.answer.shown_by
        return f"figure-{name}" if name in drawings else f"table-{name}"

    environment.filters |= {f.__name__: f for f in (typeset, typeset_cell, typeset_heading)}
    environment.filters |= dict[str, Callable[..., str]](file_of=file_of, anchor=anchor)
    return environment.get_template("report.html.j2").render(
        sections=sections,
        rows=answers.rows(sections),
        version=version("kitemj"),
        date=datetime.now().astimezone().strftime("%Y-%m-%d %H:%M %Z"),
        machine=machine(),
        packages=packages(),
    )
