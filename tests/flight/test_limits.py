"""The list of limits: decided alike of an instant and of columns, and asked by all who watch."""

import pickle
from math import inf, nextafter, pi, radians

import numpy as np
import pytest

from kitemj.drawing.alarms import INSTRUMENT
from kitemj.dynamics.ground import TOUCH
from kitemj.dynamics.lagrange_kite import motion_at
from kitemj.dynamics.motion import hull_corners_B
from kitemj.flight import limits
from kitemj.flight.limits import (
    GROUND,
    LIMITS,
    OVERLOAD,
    RECORDED,
    SIDESLIP,
    SLACK,
    STALL,
    TWIST,
    VALIDITY,
    Ending,
    Numbers,
    departure_at,
    departure_in,
    first_departure,
    touches_ground,
)
from kitemj.physics.vectors import Vector
from kitemj.recording import table
from tests.support import LAKSA, pulling, random_cases

ALPHA, BETA = radians(25.0), radians(15.0)  # of the set laksa; its lines carry 600 N
EDGES = {
    "a line that pulls": (SLACK, Numbers((300.0, 5e-324))),
    "a line without tension": (SLACK, Numbers((300.0, 0.0))),
    "a line that pushes": (SLACK, Numbers((-1.0, 300.0))),
    "the air from just below": (STALL, Numbers(alpha=5e-324)),
    "the air from ahead": (STALL, Numbers(alpha=0.0)),
    "just below stall": (STALL, Numbers(alpha=nextafter(ALPHA, 0.0))),
    "at stall": (STALL, Numbers(alpha=ALPHA)),
    "α is no number": (STALL, Numbers()),
    "just below β_max": (SIDESLIP, Numbers(beta=-nextafter(BETA, 0.0))),
    "at β_max": (SIDESLIP, Numbers(beta=BETA)),
    "at -β_max": (SIDESLIP, Numbers(beta=-BETA)),
    "a line at its most": (OVERLOAD, Numbers((600.0, 1.0))),
    "a line above": (OVERLOAD, Numbers((1.0, nextafter(600.0, inf)))),
    "1 mm above ground": (GROUND, Numbers(clearance=1e-3)),
    "less than 1 mm": (GROUND, Numbers(clearance=nextafter(1e-3, 0.0))),
    "five turns": (TWIST, Numbers(twist=-10 * pi)),
    "more": (TWIST, Numbers(twist=-10.001 * pi)),
}
KEPT = {
    *("a line that pulls", "the air from just below", "just below stall", "just below β_max"),
    *("a line at its most", "1 mm above ground", "five turns"),
}
HALF = {
    SLACK: None,
    STALL: Numbers(alpha=ALPHA / 2),
    SIDESLIP: Numbers(beta=-BETA / 2),
    OVERLOAD: Numbers((300.0, 200.0)),
    GROUND: None,
    TWIST: Numbers(twist=-5 * pi),
}
REACH = 3.0
"""m; how far from the centre of mass corners of these kites can be: half the span is 2.9 m."""


@pytest.mark.parametrize("edge", EDGES)
def test_edges(edge):
    limit, now = EDGES[edge]
    assert bool(limit.kept(LAKSA.limits, now)) == (edge in KEPT)


@pytest.mark.parametrize("limit", [limit for limit in LIMITS if HALF[limit]], ids=lambda x: x.name)
def test_half_of_a_limit(limit):
    assert limit.ratio(LAKSA.limits, HALF[limit]) == pytest.approx(0.5)


def wild():
    """Motions of random kites that are beyond every limit now and then, and a twist for each."""
    rng = np.random.default_rng(3)
    for case in random_cases(300):
        motion = motion_at(case.parameters, case.segment, 0.0, case.state)
        alpha, beta = rng.uniform((-0.1, -0.4), (0.6, 0.4)).tolist()
        motion = pulling(motion, rng.uniform(-100, 800), rng.uniform(0, 700))
        air = motion.air._replace(alpha=alpha, beta=beta)
        lowered = motion.body.p_G_E._replace(z=rng.uniform(-9.0, 0.0))
        body = motion.body._replace(p_G_E=lowered)
        yield case.parameters, motion._replace(air=air, body=body)


def lowest_corner(parameters, motion):
    """Height [m], by matrices."""
    corners = np.array(hull_corners_B(parameters.kite)) @ np.array(motion.body.R_BE)
    return float(-(corners[:, 2] + motion.body.p_G_E.z).max())


def test_an_instant_and_columns_are_decided_alike():
    seen, motions = list(wild()), [motion for _, motion in wild()]
    twists = np.random.default_rng(4).uniform(-12 * pi, 12 * pi, len(seen))
    columns = Numbers(
        tuple(np.array([motion.tensions for motion in motions]).T),
        *np.array([motion.air for motion in motions]).T,
        np.array([lowest_corner(*each) for each in seen]),
        twists,
    )
    for limit in LIMITS:
        beyond = ~limit.kept(LAKSA.limits, columns)
        assert 0.05 < beyond.mean() < 0.95, f"{limit.name}: the cases are wild enough"
        for (own, motion), twist, told in zip(seen, twists, beyond, strict=True):
            parameters = own._replace(limits=LAKSA.limits)
            found = departure_at(parameters, motion, (limit,), twist)
            assert (found is not None) == told, limit.name


def test_columns_and_motions_have_the_same_first_departure():
    motions = [motion._replace(t=0.1 * i) for i, (_, motion) in enumerate(wild())]
    for start in range(len(motions) - 2):
        some = motions[start : start + 3]
        air = np.array([motion.air for motion in some]).T
        tensions = tuple(np.array([motion.tensions for motion in some]).T)
        times = [motion.t for motion in some]
        found = departure_in(LAKSA.limits, times, Numbers(tensions, *air))
        assert found == first_departure(LAKSA, some)


def test_what_is_told_first():
    still = next(motion for _, motion in wild())
    all_at_once = pulling(still, -1.0, 700.0)._replace(
        air=still.air._replace(alpha=-0.1, beta=0.5),
        body=still.body._replace(p_G_E=Vector(0.0, 0.0, 0.0)),
    )
    assert departure_at(LAKSA, all_at_once).limit is SLACK
    assert departure_at(LAKSA, all_at_once, VALIDITY[1:]).limit is STALL
    assert departure_at(LAKSA, all_at_once, LIMITS, 99.0).limit is GROUND


def test_the_ground_is_where_the_lowest_corner_is():
    for parameters, motion in wild():
        height, p = lowest_corner(parameters, motion), motion.body.p_G_E
        for above in (-1.0, -1e-9, 1e-9, 1.0, REACH):  # m
            moved = p._replace(z=p.z + height - TOUCH - above)
            lower = motion._replace(body=motion.body._replace(p_G_E=moved))
            assert touches_ground(parameters, lower) == (above < 0.0)


def test_who_watches_has_the_names_of_the_list():
    assert [limit.name for limit in VALIDITY] == ["slack", "stall", "sideslip"]
    assert table.LIMITS == ("slack", "stall", "sideslip", "overload", "ground"), "of the files"
    assert set(LIMITS) == {*RECORDED, TWIST}
    assert list(INSTRUMENT) == [limit.name for limit in LIMITS]
    assert Ending.GROUND.value == GROUND.sentence
    for limit in LIMITS:
        assert getattr(limits, limit.name.upper()) is limit
        assert pickle.loads(pickle.dumps(limit)) is limit
