"""What a person reads: bearings, pictures, words and touches, by elementary geometry.

The pilot at the origin looks downwind, along -x_E; +y_E is on the left, z_E points down.
"""

from itertools import pairwise
from math import atan2, cos, degrees, pi, radians, sin, sqrt, tan
from types import SimpleNamespace
from typing import Any
from unittest.mock import patch

import numpy as np
import pygame
import pytest

from kitemj.drawing import instruments, knob, tensions
from kitemj.drawing.history import Rolling, Traces, twist_angle
from kitemj.drawing.readings import Readings
from kitemj.drawing.wind_window import FOOT, RADIUS, WindWindow, bearing
from kitemj.physics.steering import Control
from kitemj.physics.vectors import Rotation, Vector, cross, minus, norm, times
from kitemj.physics.wind import Wind
from kitemj.pilots.crash import touch_at
from kitemj.pilots.sight import sight
from kitemj.scene.lines import hanging
from kitemj.scene.scene import Scene
from kitemj.scene.views import CAMERAS, Orbit, downwind, looking, orbiting, pixel
from tests.authorities.by_hand import DOWN, LEFT, LEVEL, RIGHT, UP, UPWIND, ZERO, motion
from tests.support import LAKSA

ROUNDING = 1e-12
BESIDE = LAKSA._replace(wind=Wind(7.0, azimuth=atan2(3.0, 4.0)))
"""A wind along (-0.8, -0.6, 0); the left of who looks that way is (-0.6, 0.8, 0)."""
FRAME = (1280, 720)


def test_bearings_of_right_angled_triangles():
    """3-4-5 on the ground and 5-12-13 above it; left is positive."""
    for p, azimuth, elevation in (
        (Vector(-30.0, 0.0, -40.0), 0.0, degrees(atan2(4, 3))),
        (Vector(-3.0, 4.0, -12.0), degrees(atan2(4, 3)), degrees(atan2(12, 5))),
        (Vector(-3.0, -4.0, -12.0), -degrees(atan2(4, 3)), degrees(atan2(12, 5))),
        (Vector(9.0, 12.0, 36.0), 180.0 - degrees(atan2(4, 3)), -degrees(atan2(12, 5))),
    ):
        assert bearing(LAKSA, p) == pytest.approx((azimuth, elevation))
    assert downwind(BESIDE) == pytest.approx((-0.8, -0.6, 0.0))
    assert bearing(BESIDE, Vector(-8.0, -6.0, -10.0)) == pytest.approx((0.0, 45.0))
    assert bearing(BESIDE, Vector(-0.6, 0.8, 0.0)) == pytest.approx((90.0, 0.0))


def test_the_wind_window_is_a_protractor():
    """The distance from its foot is the angle from the wind, 90° at the rim; left is left."""
    x, y = FOOT
    seen = WindWindow(BESIDE)
    half = RADIUS / 2
    for p, place in (
        (Vector(-8.0, -6.0, 0.0), (x, y)),
        (Vector(-0.6, 0.8, 0.0), (x - RADIUS, y)),
        (Vector(0.6, -0.8, 0.0), (x + RADIUS, y)),
        (UP, (x, y - RADIUS)),
        (Vector(-0.8, -0.6, -1.0), (x, y - half)),
        (Vector(-0.8 - 0.6, -0.6 + 0.8, 0.0), (x - half, y)),
        (Vector(0.8, 0.6, -1.0), (x, y - 1.5 * RADIUS)),
    ):
        assert seen.place(p) == pytest.approx(place, abs=1e-6)
        assert seen.places(np.array([p]))[0] == pytest.approx(place, abs=1e-6)


def test_pixels_of_a_pinhole():
    """58° from top to bottom: at 10 m the frame is 2·10 tan 29° high, and 16/9 as wide."""
    width, height = FRAME
    camera = looking(Vector(5.0, 0.0, -2.0), Vector(-95.0, 0.0, -2.0))
    high = 10.0 * tan(radians(29.0))
    wide = high * 16 / 9
    for p, place in (
        (Vector(-5.0, 0.0, -2.0), (639.5, 359.5, 10.0)),
        (Vector(-5.0, 0.0, -2.0 - high), (639.5, -0.5, 10.0)),
        (Vector(-5.0, 0.0, -2.0 + high), (639.5, 719.5, 10.0)),
        (Vector(-5.0, wide, -2.0), (-0.5, 359.5, 10.0)),
        (Vector(-5.0, -wide, -2.0), (1279.5, 359.5, 10.0)),
        (Vector(-15.0, -wide, -2.0), (959.5, 359.5, 20.0)),
    ):
        assert pixel(camera, p, width, height) == pytest.approx(place, abs=1e-9)


def seen_at(view: str, p_E: Vector, parameters: Any = BESIDE) -> tuple[float, float]:
    """Column and row of a point in one of the views of a kite downwind."""
    kite = motion(Vector(-80.0, -60.0, -100.0))
    return pixel(CAMERAS[view](parameters, kite), p_E, *FRAME)[:2]


def test_views_show_what_is_left_on_the_left():
    left, right = Vector(-86.0, -52.0, -100.0), Vector(-74.0, -68.0, -100.0)
    for view in ("pilot", "top", "chase"):
        assert seen_at(view, left)[0] < seen_at(view, right)[0], view
    upwind, ahead = Vector(8.0, 6.0, -40.0), Vector(-80.0, -60.0, -40.0)
    assert seen_at("side", upwind)[0] < seen_at("side", ahead)[0], "from left to right"
    assert seen_at("top", upwind)[1] > seen_at("top", ahead)[1], "up the picture"
    for view in ("pilot", "side", "chase"):
        low, high = Vector(-80.0, -60.0, -95.0), Vector(-80.0, -60.0, -105.0)
        assert seen_at(view, high)[1] < seen_at(view, low)[1], view


def test_the_arrow_of_the_wind_and_a_slack_line():
    """Along (-0.8, -0.6, 0); and 113 m of line to a kite that is 112 m away hang by that metre."""
    kite = motion(Vector(-80.0, -60.0, -100.0))
    painter: Any = SimpleNamespace(parameters=BESIDE)
    for close in (True, False):
        tail, tip = Scene.wind_arrow(painter, kite, close)
        along = minus(tip, tail)
        assert times(1 / norm(along), along) == pytest.approx((-0.8, -0.6, 0.0))
    points = hanging(Vector(-100.0, 0.0, -50.0), 113.0)
    shown = sum(norm(minus(b, a)) for a, b in pairwise(points))
    assert shown == pytest.approx(113.0, abs=0.1), "m: a parabola for a catenary"
    assert all(p.z >= -50.0 * share for p, share in zip(points, np.linspace(0, 1, 17), strict=True))


def test_an_orbit_is_a_sphere_about_the_kite():
    """From behind the kite as the pilot stands, turned 90° to the right, 30° up, at 20 m."""
    kite = motion(Vector(-80.0, -60.0, -100.0))
    eye = orbiting(BESIDE, kite, Orbit(pi / 2, pi / 6, 20.0)).position
    level = 20.0 * cos(pi / 6)
    assert eye == pytest.approx((-80.0 + 0.6 * level, -60.0 - 0.8 * level, -110.0))
    behind = orbiting(BESIDE, kite, Orbit(0.0, 0.0, 20.0)).position
    assert behind == pytest.approx((-64.0, -48.0, -100.0))


def facing(nose: Vector) -> Rotation:
    """The kite downwind of the pilot, its belly (z_B) towards them, the nose as given."""
    return Rotation(nose, cross(UPWIND, nose), UPWIND)


def test_the_nose_is_a_clock_s_hand():
    """0 up, 90° right, 180° down; clockwise is to the right, and turns about -z_B."""
    low = Vector(-50.0, 0.0, -1e-9)
    for nose, angle in ((UP, 0.0), (RIGHT, pi / 2), (DOWN, pi), (LEFT, -pi / 2)):
        seen = sight(motion(low, facing(nose), omega_B=Vector(0.0, 0.0, -2.0)))
        assert cos(seen.heading - angle) == pytest.approx(1.0), "but for whole turns"
        assert seen.turning == 2.0
    s = sqrt(0.5)
    seen = sight(motion(Vector(-3.0, -4.0, -12.0), facing(Vector(0.0, -s, -s))))
    assert seen.azimuth == pytest.approx(atan2(4, 3)), "right is positive here"
    assert seen.elevation == pytest.approx(atan2(12, 5))
    # the lines turn with the nose, seen from the pilot
    for nose, angle in ((UP, 0.0), (RIGHT, pi / 2), (LEFT, -pi / 2)):
        assert twist_angle(LAKSA, motion(low, facing(nose))) == pytest.approx(angle, abs=1e-9)


class Written(instruments.Panel):
    """A panel that remembers its words and bars."""

    words: list[str]
    bars: list[tuple[float, float]]

    def text(self, text: str, *where: Any, **how: Any) -> None:
        """Remembers the words in their order."""
        self.words.append(text)

    def bar(self, x: float, y: float, width: float, *rest: Any) -> None:
        """Remembers where it begins and how long it is."""
        self.bars.append((x, width))

    def line(self, *rest: Any) -> None:
        """Paints nothing."""

    def wide(self, text: str, *rest: Any) -> float:
        """About as wide as it is long."""
        return 9.0 * len(text)

    polygon = dot = ground = line


def words_of(now: Any, readings: Any, *shown: str) -> list[str]:
    Written.words, Written.bars = [], []
    with patch.object(instruments, "Panel", Written):
        painter = instruments.Instruments(LAKSA, *FRAME)
        depth = "engineer" if shown else "pilot"
        painter.paint(pygame.Surface(FRAME), now, readings, depth, set(shown))
    return Written.words


def test_panels_say_the_numbers_in_the_units_that_they_name():
    pygame.font.init()
    hands = Control(200.0, 0.0, 0.0, radians(-3.5), 0.0, 0.0)
    now = motion(
        Vector(-30.0, -40.0, -120.0),
        air=(12.5, -7.5, 9.0),
        tensions=(25.5, 250.0),
        control=hands,
        t=61.0,
    )
    words = words_of(now, Readings(delta_command=radians(2.0)), "flight")
    told = dict(zip(words[2::2], words[3::2], strict=True))
    assert words[:2] == ["time ×1", "61.0 s"]
    assert (told["elevation"], told["azimuth"]) == ("67.4°", "53° right")
    assert (told["height, min 0"], told["airspeed"]) == ("120.0 m", "9.0 m/s")
    words = words_of(now, Readings(), "air")
    attack, sideslip = ["12.5°", "α, 0° to 25°"], ["-7.5°", "β, at most ±15°"]
    assert words == ["angle of attack", *attack, "sideslip", *sideslip]
    (_, a), (_, b) = (Written.bars[i] for i in (1, 4))  # half of either side of the troughs
    (_, trough) = Written.bars[0]
    assert (a, b) == pytest.approx((trough / 4, trough / 4))
    words = words_of(now, Readings(delta_command=radians(2.0)), "knob")
    assert words[2:5] == ["LEFT hand pulls", "δ -3.50°", "asked +2.0°"]
    words = words_of(now, Readings(gap=2.5e-6), "model")
    assert words[5] == "2.5 µm"
    traces = Traces(np.empty((0, 3)), -4 * pi, np.full(250, np.nan), np.full(250, np.nan))
    assert words_of(now, Readings(traces=traces), "model")[-1] == "2 left"
    words = words_of(now, Readings(missed_ticks=3, lateness=0.0125), "chart")
    assert {"3", "12.5 ms", "late, max 10 ms"} <= set(words)
    words = words_of(now, Readings(), "lines")
    assert {"25.5 N", "250 N", "left", "right"} <= set(words)
    assert words.index("25.5 N") < words.index("right"), "the first line is the left one"
    assert words_of(now, Readings()) == ["9.0", "m/s", "1:01", "L", "26 N", "R", "250 N"]
    assert [x for x, _ in Written.bars[:1]] < [x for x, _ in Written.bars[-1:]]


def test_the_knob_is_a_dial():
    """135° from the top to a limit: half of it to the right is 67.5° clockwise."""
    x, y = knob.HUB
    found = knob._at(0.5, 10.0)
    turn = radians(67.5)
    assert found == pytest.approx((x + 10.0 * sin(turn), y - 10.0 * cos(turn)))


def test_the_chart_s_columns_are_parts_of_twenty_seconds():
    late = Rolling()
    late.add(0.0, 0.5)
    late.add(10.0, 0.25)
    values = late.values(10.0)
    assert len(values) == 250
    assert (values[-1], values[-126]) == (0.25, 0.5)
    assert np.isfinite(values).sum() == 2


def test_a_touch_is_a_thrown_body():
    """4 kg at 3 and 4 m/s, turning at 1 rad/s about y_B: ½·4·25 J + ½·4.66 J, and no weight."""
    now = motion(
        Vector(-30.0, -40.0, -0.0501), LEVEL, Vector(-3.0, 0.0, 4.0), Vector(0.0, 1.0, 0.0)
    )
    touch = touch_at(LAKSA, now)
    assert touch
    assert touch.energy == pytest.approx(50.0 + 2.33)
    assert touch.hardness == pytest.approx(sqrt(2 * 52.33 / 4.0))
    # every corner is as low: the first is 0.75 m ahead, 2.9 m to the left, 0.05 m below
    ahead, left = 30.0 - 0.75, -40.0 + 2.9
    assert touch.azimuth == pytest.approx(atan2(-left, ahead), abs=1e-9), "right is positive"
    assert touch.distance == pytest.approx(sqrt(ahead**2 + left**2))
    # v + ω x r of r = (0.75, 2.9, 0.05): (-3 + 0.05, 0, 4 - 0.75)
    assert touch.speed == pytest.approx(sqrt(2.95**2 + 3.25**2))
    assert touch.sinking == pytest.approx(3.25)
    assert touch.place == "47 m away, 52° to the right"
    aside = touch_at(BESIDE, now._replace(body=now.body._replace(v_G_E=ZERO, omega_B=ZERO)))
    place = (-30.75 + 1.5, -37.1)  # of the corner, as above
    right, forth = 0.6 * place[0] - 0.8 * place[1], -0.8 * place[0] - 0.6 * place[1]
    assert aside
    assert aside.azimuth == pytest.approx(atan2(right, forth))
    assert (aside.energy, aside.sinking) == (0.0, 0.0)


def test_bars_of_tensions_show_half_at_a_quarter():
    """As the square root; the paper's kite rests at 43.7845 N a line, and may pull 600 N."""
    scale = tensions.scale_of(LAKSA)
    assert scale == pytest.approx((43.7845, 600.0), abs=5e-5)
    shares = [scale.share(pull) for pull in (150.0, 600.0, 0.0, 601.0, -9.0)]
    assert shares == [0.5, 1.0, 0.0, 1.0, 0.0]
    light = LAKSA._replace(limits=LAKSA.limits._replace(tension_max=1e6))
    assert tensions.scale_of(light).full == pytest.approx(25 * 43.7845, abs=25 * 5e-5)
