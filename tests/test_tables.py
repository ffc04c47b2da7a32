"""Tables for people: every number whole, whatever the terminal."""

import re
from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitemj.tables import Table, lines_of

numbers = st.floats(allow_nan=False, allow_infinity=False) | st.floats(-1e3, 1e3)


@st.composite
def tables(draw):
    columns = draw(st.integers(1, 12))
    rows = draw(st.lists(st.tuples(*[numbers] * columns), min_size=1, max_size=6))
    names = tuple(f"{'a_long_name_of_' * (i % 3)}column_{i}_N" for i in range(columns))
    return Table(draw(st.sampled_from(["", "limits: steer_80m.toml, lagrange"])), names, rows)


@settings(max_examples=40)
@given(tables(), st.integers(20, 200), st.integers(1, 12))
def test_every_number_is_whole_and_every_line_fits(table: Table, width: int, most: int) -> None:
    lines = lines_of(table, width, most)
    words = Counter(re.split(r"\s+", "\n".join(lines)))
    wanted = Counter(f"{cell:.7g}" for row in table.rows for cell in row)
    assert wanted - words == Counter()
    assert all(len(line) <= width or " " not in line.strip() for line in lines)


def test_a_table_turns_on_its_side_and_then_shows_a_value_a_line() -> None:
    table = Table("t", tuple(f"column_{i}" for i in range(6)), [(1.25,) * 6])
    shapes = [len(lines_of(table, width)) for width in (90, 40, 15)]
    upright, side, values = shapes
    assert upright < side
    assert "column_0: 1.25" in lines_of(table, 15)
    assert values == 2 + 6  # the title, an empty line, the values


@pytest.mark.parametrize(
    ("column", "cell", "shown"),
    [
        ("phi_rad", -1e-28, "0"),
        ("alpha_deg", 1e-14, "0"),
        ("share_yaw", 1e-27, "0"),
        ("eta_rad", 1e-9, "1e-09"),
        ("residual", 2e-16, "2e-16"),
        ("tension_N", 1e-20, "1e-20"),
    ],
)
def test_rounding_noise_of_an_angle_is_0(column: str, cell: float, shown: str) -> None:
    assert Table("", (column,), [(cell,)]).texts() == [[shown]]
