"""Sticks: raw signals are differences and sums, shaped ones stay within their limits."""

from itertools import pairwise

import pytest

from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.shaping import StickLaw
from thesis import sticks, sticks_flights
from thesis.answers import dangling
from thesis.sticks import section
from thesis.sticks_flights import DURATION, MOVES, SIGNALS, raw_signals, shaped_signals, stick_at

THESIS = parameter_set("thesis")
LIMITS = THESIS.stick
ELL = 80.0
TICKS = (0.1, 0.01)
ROUNDING = 1e-9
"""Of a limit: sums of thousands of ticks."""


@pytest.mark.parametrize("tick", TICKS)
def test_a_jump_of_delta_becomes_steeper_with_a_shorter_tick(tick):
    found = raw_signals(LIMITS, ELL, StickLaw.ANGLE, tick)
    jump = 2 * LIMITS.delta  # from one side to the other, at once
    assert found.peak("delta_dot") == pytest.approx(jump / tick)
    assert found.peak("delta_ddot") == pytest.approx(jump / tick**2)


@pytest.mark.parametrize("tick", TICKS)
def test_a_jump_of_the_rate_becomes_steeper_with_a_shorter_tick(tick):
    found = raw_signals(LIMITS, ELL, StickLaw.RATE, tick)
    assert found.peak("delta_ddot") == pytest.approx(LIMITS.delta_dot / tick)
    assert found.peak("delta_dot") == LIMITS.delta_dot


@pytest.mark.parametrize("law", [StickLaw.RATE, StickLaw.ACCELERATION])
def test_delta_raw_is_the_sum_of_its_rate_and_ends_at_its_limit(law):
    controls = raw_signals(LIMITS, ELL, law, 0.01).controls
    for before, after in pairwise(controls):
        whole = before.delta + 0.01 * before.delta_dot
        assert after.delta == max(-LIMITS.delta, min(LIMITS.delta, whole))
    ends = [
        c for c in controls if c.delta == LIMITS.delta and stick_at(0.01 * controls.index(c)) > 0
    ]
    assert len(ends) > 1
    assert all(c.delta_dot == 0.0 for c in ends)


def test_nothing_limits_the_rate_of_a_raw_acceleration():
    found = raw_signals(LIMITS, ELL, StickLaw.ACCELERATION, 0.01)
    assert found.peak("delta_dot") > 10 * LIMITS.delta_dot
    assert found.peak("delta_ddot") == LIMITS.delta_ddot


@pytest.mark.parametrize("law", StickLaw)
def test_shaped_signals_stay_within_their_limits_and_go_on_from_one_another(law):
    found = shaped_signals(LIMITS, ELL, law, 0.01)
    for name in SIGNALS:
        limit = getattr(LIMITS, name)
        assert 0.5 * limit < found.peak(name) <= limit * (1 + ROUNDING)
    for k, (before, after) in enumerate(pairwise(found.controls)):
        end = found.steering[k]((k + 1) * 0.01)
        assert after.delta == pytest.approx(end.delta, abs=ROUNDING * LIMITS.delta)
        assert after.delta_dot == pytest.approx(end.delta_dot, abs=ROUNDING * LIMITS.delta_dot)
        assert before.delta_ddot == end.delta_ddot


def test_a_stick_that_is_let_go_means_what_its_law_says():
    ends = {law: shaped_signals(LIMITS, ELL, law, 0.01).controls[-1] for law in StickLaw}
    assert ends[StickLaw.ANGLE].delta == pytest.approx(0.0, abs=1e-4 * LIMITS.delta)
    assert ends[StickLaw.RATE].delta_dot == pytest.approx(0.0, abs=1e-4 * LIMITS.delta_dot)
    assert ends[StickLaw.RATE].delta > 0.4 * LIMITS.delta
    assert ends[StickLaw.ACCELERATION].delta_dot == pytest.approx(-LIMITS.delta_dot)


def test_the_section_flies_both_kinds_and_says_what_came_of_it(tmp_path, monkeypatch):
    for module in (sticks, sticks_flights):
        monkeypatch.setattr(module, "DURATION", 3.0)
    monkeypatch.setattr(sticks, "TICKS", (0.1, 0.02))
    found = section(tmp_path)
    assert found.answers == sticks.ANSWERS
    assert not dangling(found)
    assert [answer.item for answer in found.answers] == [f"Figure {n}" for n in range(16, 23)]
    solver = next(n.table for n in found.tables if n.name == "sticks_solver").records()
    assert len(solver) == 12
    harder, calm = (
        next(r for r in solver if r["law"] == "δ" and r["stick"] == kind and r["tick_ms"] == 20.0)
        for kind in ("raw", "shaped")
    )
    assert harder["right_hand_sides"] > calm["right_hand_sides"]
    assert harder["tension_high_N"] > THESIS.limits.tension_max > calm["tension_high_N"] > 0
    assert harder["then"] != calm["then"] == "the end"
    hardest = max(solver, key=lambda r: r["rejected_steps"])
    assert hardest["stick"] == "raw"
    assert f"{hardest['right_hand_sides']:,} right-hand sides" in " ".join(found.here)


def test_the_moves_reach_every_limit():
    assert max(t for t, _ in MOVES) < DURATION
    assert {move for _, move in MOVES} == {-1.0, 0.0, 1.0}
