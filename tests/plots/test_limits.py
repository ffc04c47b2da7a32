"""Parts of the limits, held against numbers worked out by hand."""

from dataclasses import replace
from math import isnan

import numpy as np
import pytest

from kitemj.errors import InputError
from kitemj.flight.limits import OVERLOAD, SIDESLIP, SLACK, STALL, Departure
from kitemj.physics.parameter_files import parameter_set
from kitemj.plots.limits import beside_rest, extremes, headroom, limit_ratios, limits_figure
from tests.plots.flights import by_hand

ROUNDING = 1e-12
"""Of a ratio: degrees become radians on both sides of it."""


def test_ratios_are_parts_of_each_limit():
    flight = by_hand(
        2,
        tension_plus_N=[300.0, -6.0],
        tension_minus_N=[60.0, 900.0],
        alpha_deg=[12.5, -5.0],
        beta_deg=[-7.5, 30.0],
    )
    ratios = limit_ratios(flight)
    assert list(ratios) == ["T₊/T_max", "T₋/T_max", "α/α_stall", "|β|/β_max"]
    expected = [[0.5, -0.01], [0.1, 1.5], [0.5, -0.2], [0.5, 2.0]]
    assert np.allclose(list(ratios.values()), expected, rtol=0, atol=ROUNDING)


def test_extremes_say_when_and_why():
    flight = by_hand(
        tension_plus_N=[60.0, 0.0, -6.0, 60.0, 90.0],
        tension_minus_N=[60.0, 660.0, 600.0, 720.0, 60.0],
        beta_deg=[0.0, -3.0, -15.0, 6.0, 0.0],
    )
    plus, minus, alpha, beta = extremes(flight)
    assert plus[1:6] == pytest.approx((-0.01, 2.0, 0.15, 4.0, 1.0))
    assert plus.reason == SLACK.sentence
    assert minus[1:6] == pytest.approx((0.1, 0.0, 1.2, 3.0, 1.0))
    assert minus.reason == OVERLOAD.sentence
    assert isnan(alpha.outside_from_s)
    assert alpha.reason == ""
    assert beta[1:6] == pytest.approx((0.0, 0.0, 1.0, 2.0, 2.0))
    assert beta.reason == SIDESLIP.sentence


def test_a_line_may_carry_its_ceiling_but_not_be_slack():
    full, slack = extremes(by_hand(1, tension_plus_N=[600.0], tension_minus_N=[0.0]))[:2]
    assert isnan(full.outside_from_s)
    assert slack.outside_from_s == 0.0


def test_extremes_and_departure_tell_the_same_first_moment():
    flight = by_hand(alpha_deg=[5.0, 5.0, 26.0, 5.0, 5.0], beta_deg=[0.0, 0.0, 0.0, 16.0, 0.0])
    assert flight.departure == Departure(2.0, STALL, "α = 26.00°, α_stall = 25°")
    assert np.nanmin([each.outside_from_s for each in extremes(flight)]) == 2.0
    assert flight.parts == (slice(0, 3), slice(2, None))
    assert by_hand().departure is None
    assert by_hand().parts == (slice(0, 6), slice(5, None))


def test_figure_draws_the_ratios_and_shades_what_is_outside():
    flight = by_hand(beta_deg=[0.0, 15.0, 18.0, 0.0, 0.0])
    ax, closer = limits_figure(flight).axes
    drawn = [line.get_ydata() for line in ax.get_lines()]
    ratios = limit_ratios(flight)
    for ratio in ratios.values():
        assert any(np.array_equal(ratio, each) for each in drawn)
    (grey,) = (each for each in ax.collections if len(each.get_paths()))
    assert grey.get_paths()[0].get_extents().intervalx.tolist() == [1.0, 3.0]
    bottom, top = ax.get_ylim()
    assert bottom < 0.0 < 1.2 < top
    bottom, top = closer.get_ylim()
    pulls = np.concatenate([flight["tension_plus_N"], flight["tension_minus_N"]])
    assert top - bottom < 1.5 * max(np.ptp(pulls), 10.0), "N, of a few"


def test_missing_column_is_named():
    flight = by_hand()
    columns = {name: column for name, column in flight.columns.items() if name != "beta_deg"}
    with pytest.raises(InputError, match="lacks the column beta_deg, needed for the limits; the"):
        extremes(replace(flight, columns=columns))
    with pytest.raises(InputError, match="no number in the column beta_deg, row 3"):
        extremes(by_hand(beta_deg=[0.0, 0.0, np.nan, 0.0, 0.0]))


def test_the_table_tells_newtons_and_degrees_and_what_is_left():
    """Of limits of 600 N, 25° and 15°, by hand."""
    flight = by_hand(
        3,
        tension_plus_N=[5.0, 8.0, 60.0],
        tension_minus_N=[4.0, 9.0, 8.0],
        alpha_deg=[5.0, 10.0, 5.0],
        beta_deg=[0.0, -3.0, 18.0],
    )
    left, right, alpha, beta = headroom(flight).rows
    assert left[1:6] == ("5 N at 0 s", "60 N at 2 s", "600 N", "10 %", "540 N")
    assert right[4:] == ("1.5 %", "591 N", "never")
    assert alpha[1:6] == ("5° at 0 s", "10° at 1 s", "25°", "40 %", "15°")
    assert beta[4:] == ("120 %", "-3°", f"from 2 s: {SIDESLIP.sentence}")


def test_the_hardest_pull_stands_beside_the_pull_at_rest():
    """The sport kite at rest pulls 5.0 N a line, as its file says."""
    flight = replace(by_hand(1, tension_plus_N=[75.2]), parameters=parameter_set("sport"))
    assert "each line pulls 5.01 N" in beside_rest(flight)
    assert "75.2 N, is 15 times that" in beside_rest(flight)
    calm = parameter_set("sport", {"wind": {"speed": 1.0}})
    assert beside_rest(replace(flight, parameters=calm)) == ""
