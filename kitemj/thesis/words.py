"""How numbers and columns of tables are written for people."""

from math import isfinite, isnan

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


def heading(column: str) -> str:
    """`beta_max_deg` as ``beta max [°]``."""
    for ending, unit in UNITS.items():
        if column.endswith(f"_{ending}"):
            return f"{column.removesuffix(f'_{ending}').replace('_', ' ')} [{unit}]"
    return column.replace("_", " ")


def shown(cell: Cell) -> str:
    """A number to five digits, with ten to some power where that is shorter."""
    if isinstance(cell, bool):
        return "yes" if cell else "no"
    if not isinstance(cell, (int, float)):
        return str(cell)
    if isnan(cell):
        return "–"
    text = f"{cell:.5g}" if isfinite(cell) else str(cell)
    mantissa, e, exponent = text.partition("e")
    text = f"{mantissa} · 10{_raised(int(exponent))}" if e else text
    return text.replace("-", "−")


def _raised(exponent: int) -> str:
    return str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
