"""Wishes: what is said to be done was flown."""

import pytest

from kitemj.flight.limits import GROUND
from kitemj.physics.aerodynamics import coefficients
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.vectors import Vector
from kitemj.pilots.manoeuvres import Land
from thesis import wishes
from thesis.wishes import (
    REEL_STICK,
    ReelOut,
    as_coefficient_table,
    ell_at_rest,
    fly,
    section,
    table_gap,
)

THESIS = parameter_set("thesis")
SAME = 1e-12
"""rad; the equilibrium is found to rounding."""


def test_every_wish_is_done_or_says_what_is_open(tmp_path):
    found = section(tmp_path)
    rows = found.tables[0].table.records()
    assert {row["state"] for row in rows} == {"done", "in part", "open"}
    for row in rows:
        assert row["here"]
        assert (row["state"] == "done") == (row["open"] == "")
    assert found.here[0].startswith(f"Of {len(rows)} wishes")


def test_the_stick_moves_the_length_of_the_lines():
    outcome = fly("thesis", ReelOut(), 12.0)
    moved = outcome.last.motion.control.ell - ell_at_rest("thesis")
    assert abs(moved - REEL_STICK * THESIS.stick.ell) < 1e-3
    assert outcome.departure is None


def test_a_flight_ends_on_the_ground():
    outcome = fly("sport", Land(), 30.0)
    assert outcome.last.departure.limit is GROUND
    assert outcome.t < 30.0


def test_the_table_is_the_linear_law_at_its_own_speed():
    law, kite = THESIS.aero, THESIS.kite
    tables = {
        "set": "thesis",
        "duration": 1.0,
        "aero": {"law": "table", "table": as_coefficient_table(law)},
    }
    table = wishes.scenario_of(tables, "test").parameters.aero
    state = (0.2, -0.1, Vector(0.3, -0.4, 0.5), law.V_ref)
    assert coefficients(table, kite, *state) == pytest.approx(coefficients(law, kite, *state))


def test_the_table_stands_where_the_linear_law_does_and_notices_a_change(monkeypatch):
    assert table_gap() < SAME

    def nose_up(aero):
        return as_coefficient_table(aero._replace(Cm_0=1.01 * aero.Cm_0))

    monkeypatch.setattr(wishes, "as_coefficient_table", nose_up)
    assert table_gap() > 1e-4
