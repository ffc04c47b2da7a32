"""What is seen of kite and pilot, by elementary geometry and the conventions of sailors.

The pilot at the origin looks downwind, along -x_E; +y_E is on the left, z_E points down. Of the
kite, y_B > 0 is on the pilot's left, z_B points to the pilot.
"""

from math import atan2, exp

import numpy as np
import pytest

from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.vectors import Vector
from kitemj.physics.wind import Wind
from kitemj.scene.airflow import Airflow
from kitemj.scene.canopy import canopy
from kitemj.scene.cloth import Fill
from kitemj.scene.eye import damped
from kitemj.scene.figure import hands
from kitemj.scene.gusts_and_grass import gust
from kitemj.scene.shadow import outline
from kitemj.scene.sun import sun
from kitemj.scene.views import CAMERAS, pixel
from kitemj.scene.wind_signs import ribbon, sock
from tests.authorities.by_hand import motion
from tests.support import LAKSA

STUNT = parameter_set("sport")
BESIDE = LAKSA._replace(wind=Wind(7.0, azimuth=atan2(3.0, 4.0)))
"""A wind along (-0.8, -0.6, 0); the left of who looks that way is (-0.6, 0.8, 0)."""
MIDDLE = 1279 / 2


def test_eyes_turn_to_a_kite_aside():
    """10 m ahead, 10 m aside, 5 m up: whether left or right, an eye has it in the middle."""
    for side in (1.0, -1.0):
        kite = motion(Vector(-8.0 - 6.0 * side, -6.0 + 8.0 * side, -5.0))
        for view in ("pilot", "chase"):
            seen = pixel(CAMERAS[view](BESIDE, kite), kite.body.p_G_E, 1280, 720)
            assert seen.depth > 0
            assert abs(seen.column - MIDDLE) < 200


def test_an_eye_is_the_oscillator_of_the_textbook():
    """Critically damped: 1 - (1 + wt) e^-wt after a step; 2/w behind a ramp it does not feel."""
    for w, t in ((3.0, 0.7), (0.5, 1.5)):
        place, _ = damped(0.0, 0.0, 1.0, 0.0, w, 1.0, t)
        assert place == pytest.approx(1 - (1 + w * t) * exp(-w * t))
    assert damped(0.0, 0.0, 0.0, 2.0, 3.0, 0.0, 30.0) == pytest.approx((60.0 - 4 / 3, 2.0))
    assert damped(0.0, 0.0, 0.0, 2.0, 3.0, 1.0, 30.0) == pytest.approx((60.0, 2.0))


def test_the_hand_whose_line_is_short_is_back():
    """A kite straight ahead; what is back is upwind, +x_E. The left line is first."""
    L = LAKSA.lines.length
    kite = motion(Vector(-150.0, 0.0, -120.0), lengths=(L + 0.1, L - 0.1))
    left, right = hands(LAKSA, kite)
    assert right.x - left.x == pytest.approx(0.2, rel=0.05)
    assert left.y > 0.1 > -0.1 > right.y
    assert -1.8 < left.z < -1.0, "m, between hip and head"


def test_port_is_red():
    """Ships carry red to port; the pilot's left is port, +y_B."""
    for parameters in (STUNT, LAKSA):
        cloth = canopy(parameters.kite)
        rows, columns, _ = cloth.image.shape
        y = cloth.shape(Fill(1.0, 1.0, 0.0))[:, 1]
        s, t = (cloth.places * [columns, rows]).T.astype(int) % [[columns], [rows]]
        for side, strong, weak in ((1, 0, 2), (-1, 2, 0)):
            mean = cloth.image[t, s][side * y > 0.1 * parameters.kite.span].mean(axis=0)
            assert mean[strong] > 1.3 * mean[weak]


def test_a_sail_bellies_to_leeward():
    """Away from the pilot, -z_B, where it is full, and not at spine and leading edges."""
    shape = canopy(STUNT.kite).shape
    full, slack = shape(Fill(1.0, 1.0, 0.0)), shape(Fill(0.0, 0.0, 0.0))
    moved = (full - slack)[:, 2]
    assert moved.min() < -0.02 * STUNT.kite.span
    spine = np.abs(full[:, 1]) < 1e-9
    assert np.abs(moved[spine]).max() < 1e-9


def test_a_shadow_is_that_of_a_gnomon():
    """The sun is behind the left shoulder at a tangent of 0.86 to 0.36 each way: of a tip 86 m up,
    36 m ahead of it and 36 m to its right, in a wind along (-0.8, -0.6).
    """
    tip = motion(Vector(-40.0, -30.0, -86.0))
    small = 1e-3 * np.array([(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (-1.0, -1.0, 0.0)])
    place = outline(small, tip.body, sun(BESIDE)).mean(axis=0)
    ahead, right = (-0.8, -0.6), (0.6, -0.8)
    fallen = np.subtract(place, (-40.0, -30.0))
    assert (fallen @ ahead, fallen @ right) == pytest.approx((36.0, 36.0), abs=1e-3)


def test_what_the_wind_moves_goes_to_leeward():
    """Socks and ribbons stream along (-0.8, -0.6); a gust is 7 m farther after 1 s of 7 m/s."""
    v, top = Vector(-5.6, -4.2, 0.0), Vector(0.0, 0.0, -4.0)
    for points in (sock(top, v, 7.0, 2.0), ribbon(top, v, 7.0, 2.0)):
        end = np.subtract(points[-1], top)
        assert end @ (-0.8, -0.6, 0.0) > 0.7 * np.linalg.norm(end)
    air = Airflow(BESIDE)
    assert air.drift(9.0) - air.drift(8.0) == pytest.approx(7.0)
    ways = [gust(BESIDE, 0, air.drift(t), 1.0)[0] for t in (8.0, 9.0)]
    assert ways[1] - ways[0] == pytest.approx(7.0)
