"""Section 3: the parameters, with and without dimensions, compared with those printed."""

from decimal import Decimal
from functools import cache
from math import degrees, sqrt
from pathlib import Path
from typing import Any

from kitemj.equilibria.vary import with_value
from kitemj.physics.parameter_files import parameter_set, read_toml
from kitemj.physics.parameters import Parameters
from kitemj.tables import Cell, Table
from thesis.misprints import misprint_table, rotation_table
from thesis.section import Answer, NamedTable, Section, Verdict

LENGTHS = (200.0, 80.0)
"""m; L₀ of Tables 9, 10 and section 4.6, and of Table 2."""

_MIXED = (
    "y_A repeats x_A, ν_W belongs to 80 m lines where all else belongs to 200 m, μ and i_y do "
    "not follow from the table's own numbers"
)
ANSWERS = (
    Answer("Table 1", Verdict.DIFFERS, _MIXED, "parameters_dimensionless"),
    Answer(
        "Table 2",
        Verdict.DIFFERS,
        "inertia is printed in kg/m² and can only be kg m²; the numbers are the same",
        "parameters_dimensional",
    ),
    Answer(
        "Table 7",
        Verdict.DIFFERS,
        "inertia is printed in kg/m² and can only be kg m²; the numbers are the same",
        "parameters_dimensional",
    ),
    Answer(
        "Table 8",
        Verdict.DIFFERS,
        "C_ηβ and C_ηr are the yawing coefficients C_nβ and C_nr, m_q is C_mq; the numbers are "
        "the same",
        "parameters_dimensional",
    ),
    Answer(
        "Table 9",
        Verdict.REPRODUCED,
        "with L₀ = 200 m, where Table 2 has 80 m",
        "parameters_dimensional",
    ),
    Answer(
        "Table 10",
        Verdict.REPRODUCED,
        "with L₀ = 200 m, where Table 2 has 80 m",
        "parameters_dimensional",
    ),
    Answer("Table 11", Verdict.DIFFERS, _MIXED, "parameters_dimensionless"),
)


def section(scratch: Path) -> Section:
    """Everything follows from the sets `thesis` and `laksa`."""
    kite, g = parameter_set("thesis").kite, parameter_set("thesis").environment.gravity
    near, far = 0.0037 * LENGTHS[0], kite.y_A
    return Section(
        "Parameters (section 3, appendix A)",
        ANSWERS,
        thesis=[
            "Table 2 lists the kite and 80 m lines, Tables 7 to 10 the same kite and 200 m "
            "lines; Tables 1 and 11 list it without dimensions, lengths in L₀ = 200 m, masses in "
            "m, accelerations in g.",
        ],
        here=[
            "The set thesis holds the numbers of Tables 2, 7, 8 and 10 with 80 m lines, the set "
            "laksa those of the program LAKSA, rounded to two digits in four places, with 200 m. "
            "Every number of the first table is read from the sets, every number of the second "
            "calculated from the set thesis at both lengths. A number agrees where it rounds to "
            "the printed digits; “last digit” where it is off by less than one unit of them.",
            "C_xα, C_m0, C_mα and C_mq are all in which the two sets differ besides the length.",
        ],
        why=[
            "The dimensionless table mixes two lengths: ν_W is that of 80 m lines, the rest that "
            "of 200 m. A kite computed from this table as it stands would fly in a wind of "
            f"{0.25 * sqrt(g * LENGTHS[0]):.1f} m/s. y_A repeats the value of x_A, which would put "
            f"the attachments {2 * near:.2f} m apart in place of {2 * far:.1f} m, so that the same "
            f"hands would turn δ by {far / near:.1f} times as much.",
            "Formulas have their misprints too; the third table shows by calculation what each "
            "of them would do, and the fourth that R_1E as printed is no rotation.",
        ],
        tables=[
            NamedTable("parameters_dimensional", dimensional_table()),
            NamedTable("parameters_dimensionless", dimensionless_table()),
            NamedTable("misprints", misprint_table()),
            NamedTable("rotation_readings", rotation_table()),
        ],
    )


def dimensional_table() -> Table:
    """A row for each printed parameter."""
    sets = [parameter_set(name) for name in ("thesis", "laksa")]
    rows: list[tuple[Cell, ...]] = []
    for entry in _printed()["dimensional"]:
        values = [_field(each, entry["field"], entry["unit"]) for each in sets]
        names = [
            name
            for name, value in zip(("thesis", "laksa"), values, strict=True)
            if agreement(entry["printed"], value) == "agrees"
        ]
        agrees = "both" if len(names) == 2 else names[0] if names else "neither"
        named = (entry["symbol"], entry["meaning"], entry["unit"], entry["tables"])
        rows.append((*named, entry["printed"], *values, agrees))
    columns = ("symbol", "meaning", "unit", "tables", "printed", "thesis", "laksa", "agrees_with")
    return Table("Parameters with dimensions (Tables 2, 7, 8, 9, 10)", columns, rows)


def dimensionless_table() -> Table:
    """A row for each dimensionless number of Tables 1 and 11, at both lengths."""
    rows: list[tuple[Cell, ...]] = []
    for entry in _printed()["dimensionless"]:
        values = [dimensionless(entry["symbol"], length) for length in LENGTHS]
        said = [agreement(entry["printed"], value) for value in values]
        rows.append((entry["symbol"], entry["formula"], entry["printed"], *values, *said))
    columns = ("symbol", "formula", "printed", "at_200_m", "at_80_m", "with_200_m", "with_80_m")
    title = "Parameters without dimensions (Tables 1 and 11; the coefficients are above)"
    return Table(title, columns, rows)


def agreement(printed: str, value: float) -> str:
    """``agrees`` to the digits of `printed`; ``last digit``: within one unit of them; ``no``."""
    exponent = Decimal(printed).as_tuple().exponent
    assert isinstance(exponent, int)  # printed numbers are finite
    off = abs(Decimal(value) - Decimal(printed)) / Decimal(1).scaleb(exponent)
    return "agrees" if off <= HALF else "last digit" if off < 1 else "no"


HALF = Decimal("0.5") + Decimal("1e-9")
"""Of the last digit; a half rounds either way, and binary numbers miss it by rounding."""


def dimensionless(symbol: str, length: float) -> float:
    """The number called `symbol` of the set thesis with lines of `length` [m]."""
    p = with_value(parameter_set("thesis"), "lines.length", length)
    kite, g = p.kite, p.environment.gravity
    inertia = kite.mass * length**2
    return {
        "ε_c": kite.chord / length,
        "ε_b": kite.span / length,
        "ν_W": p.wind.speed / sqrt(g * length),
        "x_A": kite.x_A / length,
        "y_A": kite.y_A / length,
        "z_A": kite.z_A / length,
        "i_x": kite.inertia_x / inertia,
        "i_y": kite.inertia_y / inertia,
        "i_z": kite.inertia_z / inertia,
        "μ": p.environment.air_density * kite.area * length / (2 * kite.mass),
    }[symbol]


@cache
def _printed() -> dict[str, Any]:
    return read_toml(Path(__file__).with_name("printed.toml"))


def _field(parameters: Parameters, field: str, unit: str) -> float:
    section, name = field.split(".")
    value = float(getattr(getattr(parameters, section), name))
    return degrees(value) if unit == "°" else value
