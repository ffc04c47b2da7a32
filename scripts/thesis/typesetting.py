"""Sentences, numbers and headings of tables as HTML."""

import re
from math import isfinite, isnan

from markupsafe import Markup, escape

from kitemj.tables import Cell

UNITS = {
    "deg_per_s": "°/s",
    "rad_per_s2": "rad/s²",
    "rad_per_s": "rad/s",
    "m_per_s": "m/s",
    "N_m": "N m",
    "per_s": "1/s",
    "deg": "°",
    "rad": "rad",
    "percent": "%",
    "Hz": "Hz",
    "ms": "ms",
    "us": "µs",
    "s": "s",
    "m": "m",
    "N": "N",
}
"""By the ending of a column's name."""


GREEK = {"alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "theta": "θ", "omega": "ω"}
GREEK |= {"phi": "φ", "eta": "η", "ell": "ℓ"}

INDEX = re.compile(r"(?<![\w_])([^\W\d_][\u0307\u0308]?)_(\w+)\b(?![_/]|\.\w)")
"""One letter, perhaps dotted, and what is written below it; not the names of files."""
DOTTED = re.compile(r"([^\W\d_])([\u0307\u0308])")
"""Dots over a tall letter vanish in it in many fonts: the page's style draws them higher."""
POWER = re.compile(r"(?<=\d)e([+-]?\d+)\b")
MINUS = re.compile(r"(?<![\w-])-(?=\d)")


def typeset(text: str) -> Markup:
    """Text as HTML: `C_lβ` with its index lowered, `3e-7` with its power raised, true minus."""
    html = MINUS.sub("−", str(escape(text)))
    html = POWER.sub(lambda found: f"\u00a0·\u00a010{_raised(int(found[1]))}", html)
    html = INDEX.sub(r"\1<sub>\2</sub>", html.replace(" %", "\u00a0%"))
    return Markup(DOTTED.sub(_dotted, html))


def _dotted(found: re.Match[str]) -> str:
    dots = "˙" if found[2] == "\u0307" else "¨"
    return f'<span class="dotted" data-dots="{dots}" aria-label="{found[0]}">{found[1]}</span>'


def typeset_heading(column: str) -> Markup:
    """`beta_max_deg` as ``β max [°]``, `C_lβ` with its index lowered."""
    for ending, unit in UNITS.items():
        if column.endswith(f"_{ending}"):
            return _words(column.removesuffix(f"_{ending}")) + f" [{unit}]"
    return _words(column)


def _words(column: str) -> Markup:
    if INDEX.fullmatch(column):
        return typeset(column)
    return escape(" ".join(GREEK.get(word, word) for word in column.split("_")))


def typeset_cell(cell: Cell) -> Markup:
    """A number to five digits, with ten to some power where that is shorter."""
    if isinstance(cell, bool):
        return Markup("yes" if cell else "no")
    if not isinstance(cell, (int, float)):
        return typeset(cell)
    if isnan(cell):
        return Markup("–")
    return typeset(f"{cell:.5g}" if isfinite(cell) else str(cell))


def _raised(exponent: int) -> str:
    return str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
