"""Instruments: each shows what it is given, where it is, and nothing when it is hidden."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import atan2, cos, degrees, pi, radians, sin

import numpy as np
import pygame
import pytest
from numpy.typing import NDArray

from kitemj.controls.actions import INSTRUMENTS, PANELS
from kitemj.drawing.alarms import HELD, alarm_at
from kitemj.drawing.colours import ALARM, CALL, LEFT, RIGHT
from kitemj.drawing.history import CHART_COLUMNS, CHART_SPAN, TRAIL_POINTS, History, twist_angle
from kitemj.drawing.instruments import WINDOW_TOP, Instruments
from kitemj.drawing.knob import HUB, OUTER, paint_knob
from kitemj.drawing.panel import Panel
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.drawing.smooth import smooth_lines
from kitemj.drawing.wind_window import FOOT, RADIUS, WindWindow, bearing
from kitemj.dynamics.motion import Motion
from kitemj.flight.limits import GROUND, OVERLOAD, SIDESLIP, SLACK, STALL, TWIST, Limit
from kitemj.flight.live import TICK
from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.vectors import Vector
from kitemj.pilots.crash import Touch
from kitemj.scene.gl import NoGraphics
from tests.scene.motions import EQUILIBRIUM, LAKSA, motion_at
from tests.support import pulling

CALM = motion_at(LAKSA, EQUILIBRIUM)
STALLED = CALM._replace(air=CALM.air._replace(alpha=radians(31)))
SLIDING = CALM._replace(air=CALM.air._replace(beta=radians(-17)))
HANGING = motion_at(LAKSA, EQUILIBRIUM, slack=1.0)
OVER = pulling(CALM, 700.0, 300.0)
CRASHED = motion_at(LAKSA, Angles(0.0, pi / 2, 0.0, -0.3))


@dataclass
class Painted:
    """Instruments alone, over a grey field: no OpenGL."""

    instruments: Instruments
    frame: NDArray[np.uint8]

    def paint(
        self, motion: Motion, readings: Readings | None = None, shown: set[str] | None = None
    ) -> NDArray[np.uint8]:
        self.frame[:] = 128
        size = self.frame.shape[1], self.frame.shape[0]
        surface = pygame.image.frombuffer(self.frame.data, size, "RGB")
        known = set(PANELS) if shown is None else shown
        self.instruments.paint(surface, motion, readings or Readings(), "engineer", known)
        return self.frame.copy()

    def box(self, name: str) -> tuple[slice, slice]:
        """Rows and columns of a panel."""
        box = self.instruments.box(name)
        return slice(box.top, box.bottom), slice(box.left, box.right)


@pytest.fixture
def painted() -> Painted:
    return Painted(Instruments(LAKSA, 1280, 720), np.zeros((720, 1280, 3), np.uint8))


def share(image: NDArray[np.uint8], colour: tuple[int, int, int]) -> float:
    return float((image == colour).all(axis=2).mean())


# the wind window


@pytest.mark.parametrize("azimuth", [-80, -30, 0, 45, 90])
@pytest.mark.parametrize("elevation", [0, 20, 60, 85])
def test_the_windows_kite_is_as_far_from_the_wind_as_the_angle_says(
    azimuth: float, elevation: float
) -> None:
    a, e = radians(azimuth), radians(elevation)
    p_E = Vector(-50 * cos(e) * cos(a), 50 * cos(e) * sin(a), -50 * sin(e))
    assert bearing(LAKSA, p_E) == pytest.approx((azimuth, elevation))
    x, y = WindWindow(LAKSA).place(p_E)
    away = degrees(np.arccos(cos(e) * cos(a)))
    assert np.hypot(x - FOOT[0], y - FOOT[1]) == pytest.approx(RADIUS * away / 90, abs=1e-9)
    if away > 1:
        # straight above the pilot is up, the pilot's left is left
        turn = degrees(atan2(sin(e), -cos(e) * sin(a)))
        assert degrees(atan2(FOOT[1] - y, x - FOOT[0])) == pytest.approx(turn, abs=1e-6)


def test_many_places_are_the_same_as_one_by_one() -> None:
    window = WindWindow(parameter_set("laksa", {"wind": {"azimuth": 0.4}}))
    points = np.random.default_rng(3).normal(size=(20, 3))
    expected = [window.place(Vector(*p)) for p in points.tolist()]
    assert window.places(points) == pytest.approx(np.array(expected))


def test_the_mark_is_where_the_kite_is_and_the_trail_where_it_was(painted: Painted) -> None:
    rows, columns = painted.box("window")
    history, window = History(LAKSA), WindWindow(LAKSA)
    for i in range(30):
        there = motion_at(LAKSA, Angles(0.02 * i, 0.9, 0.0, -0.2))._replace(t=0.03 * i)
        history.add(there.t, there)
    for motion in (CALM, there):
        image = painted.paint(motion)[rows, columns].astype(int)
        x, y = window.place(motion.body.p_G_E)
        wings = [np.argwhere((image == colour).all(axis=2)) for colour in (LEFT, RIGHT)]
        middle = np.concatenate(wings).mean(axis=0)
        assert middle == pytest.approx((y + WINDOW_TOP, x), abs=4)
    plain = painted.paint(CALM)[rows, columns].astype(int)
    traces = history.traces(1.0)._replace(alarm=None)
    image = painted.paint(CALM, Readings(traces=traces))[rows, columns].astype(int)
    for x, y in window.places(traces.trail[15:]):
        changed = np.abs(image - plain)[round(y + WINDOW_TOP), round(x)].max()
        assert changed > 15
    far = np.abs(image - plain).max(axis=2)
    far[round(y + WINDOW_TOP) - 12 : round(y + WINDOW_TOP) + 12] = 0
    assert np.count_nonzero(far) < 400, "and nowhere else"


@pytest.mark.parametrize("turn", [0.0, pi / 2, pi, -pi / 2])
def test_the_mark_flies_nose_first_its_left_wing_on_its_left(painted: Painted, turn: float) -> None:
    """Clockwise about the lines, seen from the pilot: 0 is up, a quarter is right."""
    motion = circling(turn)
    image = painted.paint(motion)[painted.box("window")]
    wings = [np.argwhere((image == c).all(axis=2)).mean(axis=0)[::-1] for c in (LEFT, RIGHT)]
    side = wings[1] - wings[0]  # from the left wing to the right one, rows downwards
    assert np.degrees(np.arctan2(side[1], side[0])) == pytest.approx(degrees(turn), abs=25)


# the trail in the picture


@pytest.fixture(scope="module")
def picture() -> Iterator[Picture]:
    try:
        opened = Picture(LAKSA)
    except NoGraphics as reason:
        pytest.skip(str(reason))
    with opened:
        opened.depth = "engineer"
        yield opened


@pytest.mark.parametrize("view", ["side", "top", "orbit"])
def test_the_trail_is_where_the_kite_was(picture: Picture, view: str) -> None:
    history = History(LAKSA)
    for i in range(60):
        was = motion_at(LAKSA, Angles(-0.02 * i, 0.7, 0.0, -0.2))._replace(t=0.05 * i)
        history.add(was.t, was)
    motion, traces = CALM._replace(t=3.0), history.traces(3.0)._replace(alarm=None)
    picture.shown = set(INSTRUMENTS) - {"labels"}
    picture.eye.zoom(0.02)  # the orbit, as far as it goes
    plain = picture.paint(motion, None, Readings(), view).astype(int)
    changed = np.abs(picture.paint(motion, None, Readings(traces=traces), view) - plain).max(axis=2)
    free = []
    for p in traces.trail[40:]:
        column, row = (round(c) for c in picture.pixel(Vector(*p)))
        if 310 < column < 960 and 5 < row < 575:
            free.append(changed[row, column])
    assert len(free) > 5
    assert min(free) > 15
    picture.shown.discard("trail")
    hidden = picture.paint(motion, None, Readings(traces=traces), view)
    assert np.array_equal(hidden[:575, 310:960], plain[:575, 310:960])
    picture.shown = set(INSTRUMENTS)
    picture.eye.zoom(1e6)


def test_what_is_hidden_is_not_painted_in_the_picture(picture: Picture) -> None:
    for name, view in (("inset", "top"), ("forces", "chase"), ("labels", "top"), ("air", "top")):
        picture.shown = set(INSTRUMENTS)
        everything = picture.paint(CALM, None, Readings(), view).astype(int)
        picture.shown = set(INSTRUMENTS) - {name}
        changed = np.abs(picture.paint(CALM, None, Readings(), view) - everything).max(axis=2)
        assert np.count_nonzero(changed > 20) > 100, name
    picture.shown, picture.depth = set(INSTRUMENTS), "none"
    bare = picture.paint(CALM, None, Readings(message="the gamepad is gone"))
    assert np.array_equal(bare, picture._renderer.frame()), "the world, and nothing else"
    helped = picture.paint(CALM, None, Readings(help=("keys", "V\tview"))).astype(int)
    assert (np.abs(helped - bare) > 20).mean() > 0.5, "but help is asked for"
    picture.depth = "engineer"


def test_lines_are_written_where_they_cover_and_never_outside() -> None:
    memory = np.full((64, 50, 3), 9, np.uint8)
    surface = pygame.image.frombuffer(memory[2:-2].data, (50, 60), "RGB")
    rng = np.random.default_rng(1)
    box = pygame.Rect(10, 5, 30, 40)
    for _ in range(300):
        places = rng.uniform(-90, 140, (6, 2))
        smooth_lines(surface, places, np.tile([255.0, 255, 255, 1], (5, 1)), 3.0, box)
    inside = np.zeros((64, 50), bool)
    inside[7:47, 10:40] = True
    assert (memory[~inside] == 9).all()
    memory[:] = 0
    smooth_lines(
        surface,
        np.array([[12.0, 20.0], [36.0, 20.0]]),
        np.array([[200.0, 100, 50, 1]]),
        2.0,
        box,
    )
    assert memory[2 + 20, 20].tolist() == [200, 100, 50]
    assert memory[2 + 19, 20].tolist() == [100, 50, 25], "half of this pixel is covered"
    assert not memory[2 + 22, 20].any()


# panels shown and hidden, alarms


@pytest.mark.parametrize("name", PANELS)
def test_a_panel_that_is_hidden_leaves_its_place_alone(painted: Painted, name: str) -> None:
    readings = Readings(missed_ticks=1)
    rows, columns = painted.box(name)
    assert (painted.paint(CALM, readings)[rows, columns] != 128).mean() > 0.5
    hidden = painted.paint(CALM, readings, set(PANELS) - {name})
    assert (hidden[rows, columns] == 128).all()


def test_nothing_overlaps(painted: Painted) -> None:
    for width, height in ((1280, 720), (640, 360), (640, 720), (1920, 1080), (320, 180)):
        instruments = Instruments(LAKSA, width, height)
        boxes = [instruments.box(name) for name in (*PANELS, "inset", "arrows")]
        frame = pygame.Rect(0, 0, width, height)
        for i, box in enumerate(boxes):
            assert frame.contains(box.inflate(-2, -2))
            others = [b.inflate(-2, -2) for b in boxes[:i] + boxes[i + 1 :]]
            assert box.collidelist(others) == -1


@pytest.mark.parametrize(
    ("motion", "limit", "panel"),
    [
        (STALLED, STALL, "air"),
        (SLIDING, SIDESLIP, "air"),
        (HANGING, SLACK, "lines"),
        (OVER, OVERLOAD, "lines"),
        (CRASHED, GROUND, "flight"),
    ],
)
def test_an_alarm_is_seen_on_the_panel_that_says_why(
    painted: Painted, motion: Motion, limit: Limit, panel: str
) -> None:
    alarm = alarm_at(LAKSA, motion)
    assert alarm is not None
    assert alarm.departure.limit is limit
    image = painted.paint(motion)
    for name in ("flight", "air", "lines", "knob", "model", "window"):
        red = share(image[painted.box(name)], ALARM)
        assert red > 0.3 if name == panel else red < 0.01, name
    quiet = painted.paint(CALM)
    assert share(quiet, ALARM) == 0.0


def test_lines_twisted_too_often_are_an_alarm(painted: Painted) -> None:
    calm = History(LAKSA).traces(0.0)
    for turns, loud in ((4.9, False), (5.1, True), (-5.1, True)):
        alarm = alarm_at(LAKSA, CALM, turns * 2 * pi)
        assert (alarm is not None and alarm.departure.limit is TWIST) == loud
        image = painted.paint(CALM, Readings(traces=calm._replace(twist=turns * 2 * pi)))
        assert (share(image[painted.box("model")], ALARM) > 0.3) == loud


def test_what_is_remembered_has_the_alarm_of_a_twist() -> None:
    history = History(LAKSA._replace(limits=LAKSA.limits._replace(twist_max=radians(300))))
    for i in range(100):
        turned = circling(2 * pi * i / 100)
        history.add(0.03 * i, CALM._replace(t=0.03 * i, body=turned.body))
        alarm = history.traces(0.03 * i).alarm
        assert (alarm is not None) == (3.6 * i > 300), i


def test_the_reason_stays_readable_for_some_seconds(painted: Painted) -> None:
    history = History(LAKSA)
    history.add(10.0, STALLED)
    history.add(10.01, CALM._replace(t=0.01))
    seen = {}
    for wait in (1.0, HELD - 0.5, HELD + 0.5):
        image = painted.paint(CALM, Readings(traces=history.traces(10.0 + wait)))
        rows, columns = painted.box("air")
        seen[wait] = share(image[12:140, 330:960], CALL), share(image[rows, columns], CALL)
    assert seen[1.0][0] > 0.02
    assert seen[HELD - 0.5] == pytest.approx(seen[1.0], rel=0.5)
    assert seen[HELD + 0.5] == (0.0, 0.0)


def test_a_limit_that_is_crossed_every_other_tick_does_not_flash(painted: Painted) -> None:
    history = History(LAKSA)
    for i in range(20):
        history.add(0.03 * i, (STALLED if i % 2 else CALM)._replace(t=0.03 * i))
        traces = history.traces(0.03 * i)
        if i > 1:
            image = painted.paint((STALLED if i % 2 else CALM), Readings(traces=traces))
            assert share(image[painted.box("air")], ALARM) > 0.3, i


def test_a_message_and_an_alarm_are_both_seen_the_same_words_once(painted: Painted) -> None:
    alarm = alarm_at(LAKSA, STALLED)
    assert alarm is not None
    counts = []
    for message in ("", "the gamepad is gone", alarm.departure.limit.sentence):
        painted.paint(STALLED, Readings(message=message))
        counts.append(len(painted.instruments.taken))
    assert counts == [counts[0], counts[0] + 1, counts[0]]


# the knob


def dial(delta: float, wish: float) -> NDArray[np.int64]:
    surface = pygame.Surface((427, 124))
    paint_knob(Panel(surface, (0, 0, 427, 124), 1.0), delta, wish, 0.1)
    x, y = (round(c) for c in HUB)
    around = pygame.surfarray.array3d(surface)[x - 60 : x + 60, y - 60 : y + 58]
    return np.asarray(around, np.int64)


def test_the_knob_turns_to_the_hand_that_pulls() -> None:
    for delta, colour, other in ((0.05, RIGHT, LEFT), (-0.05, LEFT, RIGHT)):
        image = dial(delta, 0.0)
        columns = np.flatnonzero((image == colour).all(axis=2).any(axis=1)) - 60
        assert not (image == other).all(axis=2).any()
        assert np.sign(columns.mean()) == np.sign(delta)
        reach = np.abs(columns).max()
        assert reach == pytest.approx(OUTER * sin(radians(67.5)), abs=3)


def test_the_wish_is_a_mark_of_its_own_and_stays_at_the_limit() -> None:
    marks = {}
    for wish in (-0.06, 0.06, 0.1, 0.5):
        on = (dial(0.0, wish) == CALL).all(axis=2)
        marks[wish] = np.argwhere(on).mean(axis=0) - 60
    assert marks[-0.06][0] < -20
    assert marks[0.06][0] > 20
    assert marks[0.5] == pytest.approx(marks[0.1])


# what is remembered


def test_twist_counts_a_loop_each_way() -> None:
    for direction in (1, -1):
        history = History(LAKSA)
        for i in range(101):
            turn = direction * 2 * pi * i / 100
            # the kite's heading turns with its way round a small circle in the window
            motion = circling(turn)._replace(t=0.03 * i)
            history.add(motion.t, motion)
        assert history.traces(3.0).twist == pytest.approx(direction * 2 * pi, abs=1e-6)
        assert twist_angle(LAKSA, motion) == pytest.approx(0.0, abs=1e-6)


def circling(turn: float) -> Motion:
    """A kite below the middle of its window, turned about its lines, clockwise for the pilot."""
    motion = motion_at(LAKSA, Angles(0.0, 1.2, 0.0, -0.2))
    G = np.array(motion.body.p_G_E)
    u = G / np.linalg.norm(G)
    K = np.array([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])
    about = np.eye(3) + sin(turn) * K + (1 - cos(turn)) * K @ K
    axes = [Vector(*(about @ np.array(axis))) for axis in motion.body.R_BE]
    return motion._replace(body=motion.body._replace(R_BE=type(motion.body.R_BE)(*axes)))


def test_clockwise_is_a_loop_to_the_right() -> None:
    """Turned a quarter clockwise, the left tip (A₊) is up, as at the start of a right turn."""
    quarter = circling(pi / 2)
    assert quarter.body.R_BE.y.z < -0.5, "y_B points up"
    assert twist_angle(LAKSA, quarter) == pytest.approx(pi / 2)


def test_the_trail_is_bounded_ordered_and_forgotten_at_a_restart() -> None:
    history = History(LAKSA)
    for i in range(3 * TRAIL_POINTS):
        height = Vector(-1.0, 0.0, -50.0 - i)
        body = CALM.body._replace(p_G_E=height)
        history.add(0.03 * i, CALM._replace(t=0.03 * i, body=body))
    trail, pull = history.traces(1e3).trail, history.traces(1e3).pull
    assert trail.shape == (TRAIL_POINTS, 3)
    assert pull is not None
    assert pull == pytest.approx(np.full(TRAIL_POINTS, 43.8)), "N, of each line"
    assert (np.diff(trail[:, 2]) == -1).all()
    assert trail[-1, 2] == -50.0 - 3 * TRAIL_POINTS + 1
    history.add(1e3, CALM._replace(t=0.0))
    assert len(history.traces(1e3).trail) == 1


def test_the_strip_keeps_the_worst_and_forgets_the_old() -> None:
    history, part = History(LAKSA), CHART_SPAN / CHART_COLUMNS
    for i in range(1000):
        history.add(100 + 0.01 * i, CALM._replace(t=0.01 * i), 0.05 if i == 500 else 1e-4)
    late = history.traces(110.0).lateness
    assert late.shape == (CHART_COLUMNS,)
    assert np.nanmax(late) == 0.05
    assert np.flatnonzero(late == 0.05) == pytest.approx(CHART_COLUMNS - 5.0 / part, abs=2)
    assert np.isnan(late[: CHART_COLUMNS // 2 - 2]).all(), "before the flight there is nothing"
    assert np.isnan(history.traces(100 + 3 * CHART_SPAN).lateness).all()
    assert np.isnan(history.traces(110.0).frame_time).all()
    history.add_frame(110.0, 0.03)
    assert history.traces(110.0).frame_time[-1] == 0.03


def test_a_missed_tick_is_a_red_column_at_its_time(painted: Painted) -> None:
    history = History(LAKSA)
    for i in range(1500):
        late = 1.5 * TICK if i == 1000 else 1e-4
        history.add(0.01 * i, CALM._replace(t=0.01 * i), late)
    image = painted.paint(CALM, Readings(traces=history.traces(15.0)))[painted.box("chart")]
    columns = np.flatnonzero((image == ALARM).all(axis=2).sum(axis=0) > 20)
    expected = 14 + 264 * (1 - 5.0 / CHART_SPAN)
    assert len(columns) <= 6
    assert columns.mean() == pytest.approx(expected, abs=4)


def test_without_a_clock_there_is_no_chart(painted: Painted) -> None:
    history = History(LAKSA)
    history.add(0.0, CALM)
    image = painted.paint(CALM, Readings(traces=history.traces(0.0)))
    assert (image[painted.box("chart")] == 128).all()


@pytest.mark.parametrize("back_to", [0.0, 3.0])
def test_a_fresh_flight_has_no_alarm_of_the_last(back_to: float) -> None:
    history = History(LAKSA)
    history.add(10.0, CRASHED._replace(t=5.0))
    history.add(10.1, CALM._replace(t=back_to))
    assert history.traces(14.0).alarm is None
    history.add(10.2, STALLED._replace(t=back_to + 0.1))
    history.add(10.3, CALM._replace(t=back_to + 0.2))
    alarm = history.traces(10.3).alarm
    assert alarm is not None
    assert alarm.departure.limit is STALL


def test_a_kite_that_was_landed_alarms_nobody(painted: Painted) -> None:
    """The traces still have the alarm of the touch, as in flight."""
    history = History(LAKSA)
    history.add(0.0, CRASHED)
    soft = Touch(9.0, "left tip", 1.2, 1.1, 1.2, 25.0, 0.2, 1.4)
    for touch, loud in ((soft, False), (replace(soft, speed=20.0), True)):
        for motion in (CRASHED, CALM):
            readings = Readings(touch=touch, traces=history.traces(0.1))
            image = painted.paint(motion, readings)[painted.box("flight")]
            seen = share(image, ALARM) > 0.3 or share(image, CALL) > 0.01
            assert seen == loud
