"""Lines and hands: triangles of whole numbers, and the motions of textbooks under limits."""

from math import cos, pi, radians, sin, sqrt

import pytest

from kitemj.controls.stick_mapping import Deflections, command_of, shaped_deflection
from kitemj.flight.live import TICK
from kitemj.physics.parameters import StickLimits
from kitemj.physics.shaping import StickLaw, asked, shaped
from kitemj.physics.steering import (
    Control,
    Segment,
    control,
    ell_delta,
    line_motion,
    rest_ell,
)
from tests.support import LAKSA

ROUNDING = 1e-12
"""Relative."""


def still(ell: float, delta: float) -> Control:
    return Control(ell, 0.0, 0.0, delta, 0.0, 0.0)


def test_lines_are_sides_of_triangles():
    """Y_A = 3, ℓ = 4: Pythagoras at δ = 0; in a line at 90°; the law of cosines at 30°."""
    for delta, plus, minus in ((0.0, 5.0, 5.0), (pi / 2, 7.0, 1.0), (pi / 6, sqrt(37), sqrt(13))):
        for side, length in ((1.0, plus), (-1.0, minus)):
            found = line_motion(3.0, still(4.0, delta), side)
            assert found == pytest.approx((length, 0.0, 0.0), rel=ROUNDING)
        assert ell_delta(plus, minus, 3.0) == pytest.approx((4.0, delta), abs=1e-7)
    assert rest_ell(5.0, 3.0) == pytest.approx(4.0, rel=ROUNDING)
    assert rest_ell(13.0, 5.0) == pytest.approx(12.0, rel=ROUNDING)


def test_lines_move_as_points_on_circles_do():
    """A₊ goes round O_2 at 5 rad/s: 12 m/s along its line at δ = 0, and from 7 m pulled inwards.

    L L̇ = Y_A ℓ δ̇ cos δ and L L̈ + L̇² = -Y_A ℓ δ̇² sin δ, from L² = ℓ² + Y_A² + 2 Y_A ℓ sin δ.
    """
    for side in (1.0, -1.0):
        across = line_motion(3.0, Control(4.0, 0.0, 0.0, 0.0, 5.0, 0.0), side)
        assert across == pytest.approx((5.0, side * 12.0, -144.0 / 5.0), rel=ROUNDING)
        along = line_motion(3.0, Control(4.0, 0.0, 0.0, side * pi / 2, 5.0, 0.0), side)
        assert along == pytest.approx((7.0, 0.0, -12.0 * 25.0 / 7.0), abs=1e-12)
    reeled = line_motion(3.0, Control(4.0, 2.0, 0.0, 0.0, 0.0, 0.0), 1.0)  # 5 L̇ = 4·2
    assert reeled == pytest.approx((5.0, 1.6, (4.0 - 1.6**2) / 5.0), rel=ROUNDING)
    pushed = line_motion(3.0, Control(4.0, 0.0, 6.0, 0.0, 0.0, 10.0), -1.0)
    assert pushed == pytest.approx((5.0, 0.0, (24.0 - 120.0) / 5.0), rel=ROUNDING)


def test_a_tick_is_a_throw():
    """s = v t + ½ a t²: 2 s at 3 m/s and 4 m/s² are 14 m, and 11 m/s at the end."""
    thrown = Segment(5.0, Control(100.0, 3.0, 4.0, 0.1, -0.3, 0.4))
    found = control(thrown, 7.0)
    assert found == pytest.approx((114.0, 11.0, 4.0, 0.1 - 0.6 + 0.8, 0.5, 0.4), rel=ROUNDING)


HANDS = StickLimits(delta=0.7, delta_dot=1.5, delta_ddot=6.0, ell=0.5, ell_dot=0.8, ell_ddot=3.2)
REST = 25.0


START = still(REST, 0.0)


def flown(ticks, now=START, law=StickLaw.ANGLE, stick=0.0, reach=REST):
    """The control at the end of each tick."""
    controls = []
    for k in range(ticks):
        wish, rate = asked(HANDS, law, stick, now, TICK)
        segment = shaped(HANDS, now, k * TICK, TICK, wish, reach, REST, rate)
        now = control(segment, (k + 1) * TICK)
        controls.append(now)
    return controls


def test_the_quickest_way_has_the_times_of_the_textbook():
    """From rest to rest D/v + v/a with a coast, 2 √(D/a) without; half of the way at half time."""
    late = 2  # ticks, of the mean acceleration in those where the push changes
    past = HANDS.delta_ddot * TICK**2 / 4  # rad, of the same
    for way, seconds in ((0.7, 0.7 / 1.5 + 0.25), (-0.7, 0.7 / 1.5 + 0.25), (0.06, 0.2)):
        controls = flown(150, stick=way / 0.7)
        there = next(k for k, c in enumerate(controls, 1) if abs(c.delta - way) < 2e-4)
        assert abs(there - seconds / TICK) <= late
        before, after = (controls[int(seconds / TICK / 2) - i].delta for i in (1, 0))
        assert min(before, after) - past <= way / 2 <= max(before, after) + past
    for way, seconds in ((0.5, 0.5 / 0.8 + 0.25), (-0.2, 0.5)):
        controls = flown(150, reach=REST + way)
        there = next(k for k, c in enumerate(controls, 1) if abs(c.ell - REST - way) < 1e-4)
        assert abs(there - seconds / TICK) <= late
    beyond = flown(300, stick=1.0, reach=REST + 9.0)[-1]
    assert (beyond.delta, beyond.ell) == pytest.approx((0.7, REST + 0.5), abs=2e-4)


def test_each_law_is_a_motion_of_the_textbook():
    """δ̇ = s δ̇_max after v/a; δ = ½ s δ̈_max t² from rest; v²/2a to stop."""
    rate = flown(60, law=StickLaw.RATE, stick=0.4)
    assert rate[-1].delta_dot == pytest.approx(0.6, rel=ROUNDING)
    assert rate[-1].delta == pytest.approx(0.6 * (0.6 - 0.05), rel=1e-6)  # half a ramp of 0.1 s
    pushed = flown(20, law=StickLaw.ACCELERATION, stick=-0.5)
    assert pushed[-1].delta_dot == pytest.approx(-0.5 * 6.0 * 0.2, rel=ROUNDING)
    assert pushed[-1].delta == pytest.approx(-0.5 * 6.0 * 0.2**2 / 2, rel=ROUNDING)
    stopped = flown(40, rate[-1], StickLaw.RATE, 0.0)[-1]
    assert stopped.delta_dot == pytest.approx(0.0, abs=1e-12)
    assert stopped.delta - rate[-1].delta == pytest.approx(0.6**2 / (2 * 6.0), rel=1e-6)


def test_hands_pull_their_own_lines():
    """Arms of 0.25 m at 200 m: the right hand's pull makes L₋ shorter, and δ = +0.0863 (thesis)."""
    far = LAKSA._replace(stick=LAKSA.stick._replace(mirrored=False))
    both = command_of(Deflections(left=-1.0, right=1.0), far, StickLaw.RATE, True)
    assert both.delta * far.stick.delta == pytest.approx(0.0863, abs=5e-5)
    assert both.law is StickLaw.ANGLE
    pulled = command_of(Deflections(left=1.0, right=1.0), far, StickLaw.ANGLE, True)
    assert pulled.ell * far.stick.ell == pytest.approx(-0.25, abs=1e-4)
    assert command_of(Deflections(steer=0.5), far, StickLaw.RATE, False) == (0.5, 0.0, 1)
    assert command_of(Deflections(steer=0.5), LAKSA, StickLaw.RATE, False).delta == -0.5


def test_dead_zone_and_curve_by_hand():
    """A dead zone of 0.2 leaves 0.8: 0.6 is half of it; half of ½, and half of ½³."""
    assert shaped_deflection(0.15, 0.2, 0.0) == 0.0
    assert shaped_deflection(-0.6, 0.2, 0.0) == pytest.approx(-0.5)
    assert shaped_deflection(0.6, 0.2, 0.5) == pytest.approx(0.25 + 0.0625)
    assert shaped_deflection(-1.0, 0.2, 0.5) == pytest.approx(-1.0)


def test_a_tilted_kite_reaches_as_far_as_its_shadow():
    """O_E at the origin: A± stand Y_A cos δ aside and ℓ ± Y_A sin δ ahead."""
    for degrees in (-40.0, 10.0, 75.0):
        d = radians(degrees)
        for side in (1.0, -1.0):
            length = sqrt((2.9 * cos(d)) ** 2 + (80.0 + side * 2.9 * sin(d)) ** 2)
            assert line_motion(2.9, still(80.0, d), side).length == pytest.approx(length)
