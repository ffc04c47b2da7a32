"""The wind's law: a published table of the power law, and gusts and directions by hand."""

from math import atan2, log, pi

import pytest

from kitemj.physics.vectors import Vector
from kitemj.physics.wind import Wind, wind_speed, wind_velocity

HELLMANN = log(7 / 5) / log(50 / 10)
"""The exponent of a wind of 5 m/s at 10 m and 7 m/s at 50 m."""
TABLE = {10.0: 5.0, 50.0: 7.0, 100.0: 8.091554, 150.0: 8.807364, 200.0: 9.353322}
"""m: m/s; the example of `fWindSpeedExtrapolation` in the manual of the R package merra2ools."""
DIGITS = 5e-7
"""m/s; half of the table's last digit."""


def test_the_wind_at_every_height_of_a_published_table():
    """Whichever of its rows is the reference: above it and below it."""
    for reference, speed in TABLE.items():
        wind = Wind(speed, HELLMANN, reference)
        for height, expected in TABLE.items():
            assert wind_speed(wind, height, 0.0) == pytest.approx(expected, abs=2 * DIGITS)


def test_gusts_come_at_every_height_at_once():
    """sin 30° = ½: a gust of a tenth is then 5 %, at any height and in any wind."""
    wind = Wind(5.0, HELLMANN, 10.0, gust_amplitude=0.1, gust_frequency=0.6)
    period = 2 * pi / 0.6
    factors = ((0.0, 1.0), (1 / 12, 1.05), (1 / 4, 1.1), (1 / 2, 1.0), (7 / 12, 0.95), (3 / 4, 0.9))
    for part, factor in factors:
        for height, speed in TABLE.items():
            found = wind_speed(wind, height, (part + 3.0) * period)
            assert found == pytest.approx(factor * speed, abs=2 * DIGITS)


def test_the_wind_turns_as_phi_turns():
    """The triangle of 3, 4 and 5: x_E turned towards y_E by 36.87° is (0.8, 0.6, 0)."""
    wind = Wind(10.0, azimuth=atan2(3.0, 4.0))
    where = Vector(-30.0, 20.0, -40.0)
    assert wind_velocity(wind, where, 0.0) == pytest.approx((-8.0, -6.0, 0.0), abs=1e-14)


def test_the_height_is_that_above_ground():
    """z_E points down, and nothing but it counts."""
    wind = Wind(5.0, HELLMANN, 10.0)
    for x, y in ((0.0, 0.0), (-300.0, 80.0)):
        found = wind_velocity(wind, Vector(x, y, -50.0), 7.0)
        assert found == pytest.approx((-7.0, 0.0, 0.0), abs=DIGITS)
