"""What became of every figure and table of the thesis: the list at the end of the report.

Captions and the items that belong to no section are in ``items.toml``.
"""

from collections import Counter
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from kitemj.physics.parameter_files import read_toml
from thesis.section import Answer, Section, Verdict


class Row(NamedTuple):
    """One row of the list; `section` is the number of the section that answers, 0: none."""

    caption: str
    answer: Answer
    section: int


@cache
def _items() -> dict[str, Any]:
    return read_toml(Path(__file__).with_name("items.toml"))


def captions() -> dict[str, str]:
    """Every figure and table of the thesis in its order, with its caption."""
    return dict(_items()["captions"])


def background() -> list[Answer]:
    """Answers to what belongs to no section."""
    reasons = _items()["background"].items()
    return [Answer(item, Verdict.NOT_APPLICABLE, reason) for item, reason in reasons]


def rows(sections: Sequence[Section]) -> list[Row]:
    """The list in the thesis's order: what the sections answer, numbered from 1, and the rest."""
    known = captions()
    answered = [(0, background()), *enumerate((s.answers for s in sections), start=1)]
    found = [Row(known[a.item], a, number) for number, answers in answered for a in answers]
    order = list(known)
    return sorted(found, key=lambda row: order.index(row.answer.item))


def mistakes(answers: Iterable[Answer]) -> list[str]:
    """What is wrong with the answers to the thesis (without `background`): a sentence each."""
    given = [*background(), *answers]
    counts, known = Counter(answer.item for answer in given), captions()
    return [
        *(f"{item} is not answered" for item in known if item not in counts),
        *(f"{item} is answered {n} times" for item, n in counts.items() if n > 1),
        *(f"the thesis has no {item}" for item in counts if item not in known),
        *(
            f"{a.item} is {a.verdict.value} and no reason is given"
            for a in given
            if a.verdict is not Verdict.REPRODUCED and not a.reason
        ),
        *(
            f"{a.item} is {a.verdict.value} and nothing is shown"
            for a in given
            if a.verdict is not Verdict.NOT_APPLICABLE and not a.shown_by
        ),
    ]


def dangling(section: Section) -> list[str]:
    """Answers of `section` that point to a drawing or table which it does not have."""
    there = {drawing.name for drawing in section.drawings}
    there |= {named.name for named in (*section.tables, *section.timed)}
    return [
        f"{answer.item}: there is no drawing or table {answer.shown_by} in {section.title!r}"
        for answer in section.answers
        if answer.shown_by and answer.shown_by not in there
    ]
