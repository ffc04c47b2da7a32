"""The parts of a section of the report: sentences, figures, tables, answers.

A section is a module with `ANSWERS`, which figures and tables of the thesis it answers (at
its top, so that the list of all can be checked without computing anything), and the function
`section`, whose result has the same `answers`. A long one has its flights, tables and figures
beside it, in files whose names end in _flights, _tables and _figures.
"""

from collections.abc import Sequence
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, Protocol

from kitemj.tables import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Verdict(Enum):
    """What became of a figure or table of the thesis."""

    REPRODUCED = "reproduced"
    DIFFERS = "differs"
    NOT_APPLICABLE = "not applicable"


class Answer(NamedTuple):
    """One row of the list at the end: `item` as the thesis names it ("Figure 33", "Table 3").

    `reason` is empty only where the verdict is REPRODUCED and nothing is to be added.
    `shown_by` names the drawing or table of the section that shows it, and is empty only where
    the verdict is NOT_APPLICABLE.
    """

    item: str
    verdict: Verdict
    reason: str = ""
    shown_by: str = ""


class Drawing(NamedTuple):
    """A figure under a name that its file gets; drawn with matplotlib, or a frame (RGB)."""

    name: str
    caption: str
    figure: "Figure | Path"


class NamedTable(NamedTuple):
    """A table under a name that its file gets; `show` false: only in the file."""

    name: str
    table: Table
    show: bool = True


class Section(NamedTuple):
    """`thesis` is what the thesis found, `here` what is found now, `why` they differ.

    Sentences are plain text, one paragraph each. `timed` tables hold measured times and
    differ from run to run; all others are the same each time.
    """

    title: str
    answers: Sequence[Answer]
    thesis: Sequence[str]
    here: Sequence[str]
    why: Sequence[str] = ()
    drawings: Sequence[Drawing] = ()
    tables: Sequence[NamedTable] = ()
    timed: Sequence[NamedTable] = ()


class SectionModule(Protocol):
    """A module that is a section; `scratch` is a folder for files that pass through it."""

    __name__: str

    @property
    def ANSWERS(self) -> Sequence[Answer]:
        """What of the thesis it answers."""

    def section(self, scratch: Path) -> Section:
        """Computes everything anew."""
