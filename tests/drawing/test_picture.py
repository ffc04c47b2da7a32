"""The picture: what is painted stands where the projection says, left on the left."""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from numpy.typing import NDArray

from kitemj.controls.actions import VIEWS
from kitemj.drawing.flight_panels import length
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.vectors import Vector, plus, unrotated
from kitemj.scene.canopy import surface_point
from kitemj.scene.gl import NoGraphics
from kitemj.scene.lines import hanging
from kitemj.scene.scenery import ring_step
from tests.scene.motions import EQUILIBRIUM, LAKSA, SPORT, motion_at

QUIET = Readings()


@pytest.fixture(scope="module")
def picture() -> Iterator[Picture]:
    try:
        opened = Picture(LAKSA)
    except NoGraphics as reason:
        pytest.skip(str(reason))
    with opened:
        opened.depth = "engineer"
        yield opened


def on_canopy(motion: Motion, across: float, along: float = 0.3) -> Vector:
    point = surface_point(LAKSA.kite, across, along)
    return plus(motion.body.p_G_E, unrotated(motion.body.R_BE, point))


def redness(frame: NDArray[np.uint8], place: tuple[float, float]) -> float:
    """By how much it is more red than blue around a place."""
    column, row = (round(c) for c in place)
    around = frame[row - 8 : row + 9, column - 8 : column + 9].mean(axis=(0, 1))
    return float(around[0] - around[2])


def colour_at(frame: NDArray[np.uint8], place: tuple[float, float]) -> NDArray[np.uint8]:
    return np.asarray(frame[round(place[1]), round(place[0])])


def test_a_mirrored_motion_gives_the_mirrored_picture(picture: Picture) -> None:
    q = Angles(0.2, 0.5, 0.15, -0.2)
    one = motion_at(LAKSA, q, 0.03)
    other = motion_at(LAKSA, Angles(-q.phi, q.gamma, -q.eta, q.theta), -0.03)
    assert other.body.p_G_E.y == pytest.approx(-one.body.p_G_E.y)
    places = {}
    for motion in (one, other):
        frame = picture.paint(motion, None, QUIET, "chase")
        for across in (-0.6, 0.6):
            place = picture.pixel(on_canopy(motion, across))
            places[motion is one, across] = place
            assert redness(frame, place) * across > 20 * abs(across)
    for across in (-0.6, 0.6):
        a, b = places[True, across], places[False, -across]
        assert (a[0], a[1]) == pytest.approx((1279 - b[0], b[1]), abs=1e-6)


def test_what_is_left_of_the_kite_is_left_in_the_pilots_view(picture: Picture) -> None:
    motion = motion_at(LAKSA, Angles(-0.5, 0.6, 0.0, -0.25))
    picture.paint(motion, None, QUIET, "pilot")
    G = motion.body.p_G_E
    assert picture.pixel(plus(G, Vector(0.0, 5.0, 0.0)))[0] < picture.pixel(G)[0] - 10
    assert picture.pixel(plus(G, Vector(0.0, 0.0, 5.0)))[1] > picture.pixel(G)[1] + 10


def test_the_kite_left_of_the_pilot_is_left_from_above(picture: Picture) -> None:
    motion = motion_at(LAKSA, Angles(-0.5, 0.6, 0.0, -0.25))
    picture.paint(motion, None, QUIET, "top")
    kite, pilot = picture.pixel(motion.body.p_G_E), picture.pixel(Vector(0.0, 0.0, 0.0))
    assert np.sign(pilot[0] - kite[0]) == np.sign(motion.body.p_G_E.y)
    assert kite[1] < pilot[1]


def test_the_reference_is_seen_only_where_it_differs(picture: Picture) -> None:
    motion = motion_at(LAKSA, EQUILIBRIUM)
    alone = picture.paint(motion, None, QUIET)
    assert np.array_equal(alone, picture.paint(motion, motion, QUIET))
    reference = motion_at(LAKSA, EQUILIBRIUM._replace(phi=0.1))
    frame = picture.paint(motion, reference, QUIET)
    middle = picture.pixel(on_canopy(reference, 0.0))
    before, after = (colour_at(f, middle).astype(int) for f in (alone, frame))
    assert (after - before)[:2].min() > 20, "pale and yellow over the meadow"


def test_a_slack_line_hangs_and_says_so(picture: Picture) -> None:
    motion = motion_at(LAKSA, EQUILIBRIUM)
    slack = motion_at(LAKSA, EQUILIBRIUM, slack=5.0)
    taut_frame = picture.paint(motion, None, QUIET, "side").astype(int)
    slack_frame = picture.paint(slack, None, QUIET, "side").astype(int)
    points = hanging(Vector(-80.0, 2.9, -180.0), 200.0)
    column, row = picture.pixel(points[8])
    around = np.s_[round(row) - 60 : round(row) + 60, round(column) - 60 : round(column) + 60]
    assert np.abs(slack_frame - taut_frame)[around].max() > 100


@pytest.mark.parametrize("view", VIEWS)
def test_every_view_paints_ground_sky_and_inset(picture: Picture, view: str) -> None:
    low = motion_at(LAKSA, Angles(0.0, 1.3, 0.0, -0.3))
    frame = picture.paint(low, None, QUIET, view).astype(int)
    upper = np.median(frame[100:200, 320:600], axis=(0, 1))
    lower = np.median(frame[570:600, 500:900], axis=(0, 1))
    if view not in ("top", "orbit"):  # which look down
        assert upper[2] > upper[0] + 20, "blue"
    assert lower[0] + lower[1] > lower[2] + 20 or view == "chase", "grass; chase looks at the sea"
    assert np.abs(upper - lower).max() > 40 or view == "top", "the horizon between"
    edge = frame[11, 1000:1200]  # of the small view
    assert edge.min() > 225, "the frame of the small view"


@pytest.mark.parametrize("view", VIEWS)
def test_the_kite_is_in_every_view_and_left_is_left(picture: Picture, view: str) -> None:
    if view == "side":
        pytest.skip("from the side one tip hides the other")
    motion = motion_at(LAKSA, EQUILIBRIUM)
    picture.paint(motion, None, QUIET, view)
    left, right = (picture.pixel(on_canopy(motion, a)) for a in (0.9, -0.9))
    assert 310 < left[0] < right[0] < 960
    assert 0 < left[1] < 600


def test_from_above_the_wind_blows_up_the_picture(picture: Picture) -> None:
    picture.paint(motion_at(LAKSA, EQUILIBRIUM), None, QUIET, "top")
    pilot, downwind = picture.pixel(Vector(0.0, 0.0, 0.0)), picture.pixel(Vector(-100.0, 0.0, 0.0))
    assert downwind[1] < pilot[1] - 50
    assert downwind[0] == pytest.approx(pilot[0])


def test_the_mouse_moves_the_orbit_of_the_picture(picture: Picture) -> None:
    motion = motion_at(LAKSA, EQUILIBRIUM)
    places = []
    for _ in range(2):
        picture.paint(motion, None, QUIET, "orbit")
        places.append(picture.pixel(on_canopy(motion, 0.9)))
        picture.eye.zoom(1.5)
    picture.eye.zoom(1 / 1.5**2)
    middle = picture.pixel(motion.body.p_G_E)
    assert abs(places[1][0] - middle[0]) > 1.3 * abs(places[0][0] - middle[0])
    with pytest.raises(InputError, match="factor > 0"):
        picture.eye.zoom(0.0)


def test_the_same_motion_gives_the_same_frame(picture: Picture) -> None:
    motion = motion_at(LAKSA, EQUILIBRIUM)
    first = picture.paint(motion, None, QUIET)
    kept = first.copy()
    picture.paint(motion_at(LAKSA, EQUILIBRIUM._replace(phi=0.3)), None, QUIET)
    assert np.array_equal(first, kept), "a frame is the caller's"
    assert np.array_equal(picture.paint(motion, None, QUIET), kept)


def test_another_thread_may_paint(picture: Picture) -> None:
    motion = motion_at(LAKSA, EQUILIBRIUM)
    here = picture.paint(motion, None, QUIET)
    with ThreadPoolExecutor(1) as other:
        there = other.submit(picture.paint, motion, None, QUIET).result()
    assert np.array_equal(here, there)


def test_readings_are_seen(picture: Picture) -> None:
    motion = motion_at(LAKSA, EQUILIBRIUM)
    plain = picture.paint(motion, None, QUIET)
    for readings in (
        QUIET._replace(model="lagrange"),
        QUIET._replace(gap=3e-7),
        QUIET._replace(delta_command=0.05),
        QUIET._replace(missed_ticks=2),
        QUIET._replace(stick="gamepad"),
        QUIET._replace(speed=4.0),
        QUIET._replace(message="the gamepad is gone: hands level"),
    ):
        changed = (picture.paint(motion, None, readings) != plain).any(axis=2).sum()
        assert changed > 50, readings


@pytest.mark.parametrize(
    ("metres", "text"),
    [
        (0.0, "0 nm"),
        (1.4e-14, "< 0.1 nm"),
        (5.4e-9, "5.4 nm"),
        (3.42e-7, "342 nm"),
        (1.3e-5, "13 µm"),
        (0.0123, "12.3 mm"),
        (2.5, "2.5 m"),
        (1234.5, "1234 m"),
        (float("nan"), "no number"),
    ],
)
def test_the_gap_is_shown_in_a_unit_that_suits_it(metres: float, text: str) -> None:
    assert length(metres) == text


def test_rings_are_round_numbers_apart() -> None:
    assert [ring_step(length) for length in (20.0, 80.0, 200.0, 150.0)] == [5, 20, 50, 20]


def test_wrong_wishes_are_sentences(picture: Picture) -> None:
    with pytest.raises(InputError, match=r"no view 'cockpit'; there are: pilot, chase, side"):
        picture.paint(motion_at(LAKSA, EQUILIBRIUM), None, QUIET, "cockpit")
    with pytest.raises(InputError, match="too small"):
        Picture(LAKSA, 100, 100)
    picture.depth = "all"
    with pytest.raises(InputError, match="no instruments 'all'; there are: pilot, engineer, none"):
        picture.paint(motion_at(LAKSA, EQUILIBRIUM), None, QUIET)
    picture.depth = "engineer"


def test_a_picture_that_is_resized_is_as_one_of_that_size(picture: Picture) -> None:
    motion = motion_at(LAKSA, EQUILIBRIUM)
    before = picture.paint(motion, None, QUIET)
    with Picture(LAKSA, 1600, 900) as other:
        other.depth = "engineer"
        fresh = other.paint(motion, None, QUIET)
    picture.resize(1600, 900)
    assert np.array_equal(picture.paint(motion, None, QUIET), fresh)
    with pytest.raises(InputError, match="too small"):
        picture.resize(100, 100)
    picture.resize(1280, 720)
    assert np.array_equal(picture.paint(motion, None, QUIET), before)


def test_another_size_and_a_second_close() -> None:
    try:
        with Picture(parameter_set("laksa", SPORT), 640, 360) as small:
            motion = motion_at(small.parameters, Angles(0.4, 1.4, 0.8, 2.0))
            assert small.paint(motion, None, QUIET).shape == (360, 640, 3)
    except NoGraphics as reason:
        pytest.skip(str(reason))
    small.close()
