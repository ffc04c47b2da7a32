"""Limits at numbers of the sets' files, and heights of corners by trigonometry."""

from math import cos, radians, sin

import pytest

from kitemj.flight.limits import (
    GROUND,
    LIMITS,
    OVERLOAD,
    SIDESLIP,
    SLACK,
    STALL,
    TWIST,
    Numbers,
    departure_at,
    touches_ground,
)
from kitemj.physics.vectors import Vector
from tests.authorities.by_hand import LEVEL, motion, pitched, rolled
from tests.support import LAKSA

HIGH = Vector(-30.0, 0.0, -50.0)
TURN = 6.283185307179586
"""rad."""


def told(air=(10.0, 0.0, 9.0), tensions=(20.0, 20.0), twist=0.0):
    """Which limit of the set laksa (25°, 15°, 600 N, five turns) is left, and what is said."""
    now = motion(HIGH, air=air, tensions=tensions)
    departure = departure_at(LAKSA, now, LIMITS, twist)
    return (departure.limit, departure.reading) if departure else None


def test_each_limit_at_the_numbers_of_its_file():
    for air in ((24.9, 0.0, 9.0), (0.1, 14.9, 9.0), (10.0, -14.9, 0.5)):
        assert told(air) is None
    assert told((25.1, 0.0, 9.0)) == (STALL, "α = 25.10°, α_stall = 25°")
    assert told((-0.1, 0.0, 9.0)) == (STALL, "α = -0.10°, α_stall = 25°")
    assert told((10.0, 15.1, 9.0)) == (SIDESLIP, "β = 15.10°, β_max = 15°")
    assert told((10.0, -15.1, 9.0)) == (SIDESLIP, "β = -15.10°, β_max = 15°")
    assert told(tensions=(599.0, 0.1)) is None
    assert told(tensions=(601.0, 9.0)) == (OVERLOAD, "601 N of 600 N")
    assert told(tensions=(9.0, 601.0)) == (OVERLOAD, "601 N of 600 N")
    assert told(tensions=(9.0, -0.1)) == (SLACK, "left 9.00 N, right -0.10 N, at least 0 N")
    assert told(tensions=(-0.1, 9.0)) == (SLACK, "left -0.10 N, right 9.00 N, at least 0 N")
    assert told(twist=-4.9 * TURN) is None
    assert told(twist=-5.1 * TURN) == (TWIST, "5.1 turns of 5")
    assert told(twist=5.1 * TURN) == (TWIST, "5.1 turns of 5")


def test_how_much_of_each_limit_is_taken_up():
    now = Numbers((150.0, 450.0), radians(5.0), radians(-6.0), twist=-TURN)
    parts = {STALL: 0.2, SIDESLIP: 0.4, OVERLOAD: 0.75, TWIST: 0.2}
    for limit, part in parts.items():
        assert limit.ratio(LAKSA.limits, now) == pytest.approx(part)


def test_the_kite_touches_with_its_lowest_corner():
    """A box of 1.5 m x 5.8 m, 0.1 m thick, is on the ground 1 mm above it."""
    s, c = sin(radians(30.0)), cos(radians(30.0))
    heights = (
        (LEVEL, 0.05),
        (rolled(30.0), 2.9 * s + 0.05 * c),
        (rolled(-30.0), 2.9 * s + 0.05 * c),
        (rolled(90.0), 2.9),
        (pitched(30.0), 0.75 * s + 0.05 * c),
        (pitched(-90.0), 0.75),
    )
    for attitude, height in heights:
        for above, touches in ((0.0009, True), (0.0011, False)):
            now = motion(Vector(-40.0, 9.0, -height - above), attitude)
            assert touches_ground(LAKSA, now) == touches, (height, above)
    assert departure_at(LAKSA, now, (GROUND,)) is None
