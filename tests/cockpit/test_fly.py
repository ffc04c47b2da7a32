"""The real loop, flown by a virtual gamepad in a window that nobody sees."""

import pygame
import pytest

from kitemj.cockpit.fly import _grant, fly
from kitemj.cockpit.screens import (
    AROUND,
    RestingSize,
    Window,
    display_found,
    fitting,
    shaped,
)
from kitemj.controls.programmed import ProgrammedStick, Row
from kitemj.controls.settings import Settings
from kitemj.controls.stick import PersonStick
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.dynamics.motion import attachment_E
from kitemj.flight.scenario import scenario_of
from kitemj.realtime.messages import Rate
from kitemj.realtime.process import FlightProcess
from kitemj.recording.file import read_recording
from kitemj.recording.live import FlightSetup
from tests.controls.virtual_pad import VirtualPad

pytestmark = pytest.mark.alone
SIZE = (640, 360)
QUICK = {"delta": 0.4, "delta_dot": 0.5, "delta_ddot": 2.0, "mirrored": False}
SCENARIO = scenario_of({"set": "thesis", "duration": 60.0, "stick": QUICK}, "test")


class Script:
    """Does things at given times [s] of wall time, in place of a person."""

    def __init__(self, window, doings):
        self.window, self.doings, self.seen = window, list(doings), []

    def __getattr__(self, name):
        return getattr(self.window, name)

    def show(self, frame, wall):
        while self.doings and wall >= self.doings[0][0]:
            self.doings.pop(0)[1]()
        self.stick_name = self.window.stick.name
        self.window.show(frame, wall)


class Flown(FlightProcess):
    """The flight, which keeps all its `news`."""

    def __init__(self, scenario=SCENARIO, **options):
        super().__init__(FlightSetup(scenario, reference="lagrange", **options))
        self.news = []
        self.wait()

    def update(self):
        heard = super().update()
        self.news += heard
        return heard


@pytest.fixture
def window(monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    assert display_found()
    window = Window(*SIZE, "test", PersonStick(Settings(), SCENARIO.parameters))
    yield window
    pygame.display.quit()


@pytest.fixture
def picture():
    with Picture(SCENARIO.parameters, *SIZE) as picture:
        yield picture


def test_right_stick_pulls_the_line_that_the_pilot_sees_on_the_right(window, picture):
    """L₋ gets shorter, L₊ longer; A₋ is right of A₊ in the picture."""
    pad, physics = VirtualPad(), Flown()
    script = Script(window, [(0.1, lambda: pad.left_stick(1.0))])
    fly(physics, picture, script, duration=2.0)
    motion = physics.result.motion
    assert script.stick_name == "gamepad"
    assert motion.control.delta > 0.1
    left, right = motion.lengths
    assert right < 79.9 < 80.1 < left
    picture.paint(motion, None, Readings(), "pilot")
    left, _ = picture.pixel(attachment_E(SCENARIO.parameters, motion.body, 1.0))
    right, _ = picture.pixel(attachment_E(SCENARIO.parameters, motion.body, -1.0))
    assert right > left


def test_unplugged_pad_centres_and_comes_back(window, picture):
    pad, physics = VirtualPad(), Flown()
    pads = [pad]
    doings = [
        (0.1, lambda: pad.left_stick(1.0)),
        (0.6, pad.unplug),
        (1.2, lambda: pads.append(VirtualPad())),
        (1.4, lambda: pads[1].left_stick(-1.0)),
    ]
    fly(physics, picture, Script(window, doings), duration=2.2)
    ticks = [news.result.wish for news in physics.news]
    assert max(ticks) == pytest.approx(0.4)
    gone = ticks.index(max(ticks)) + 90
    assert ticks[gone] == 0.0
    assert ticks[-1] == pytest.approx(-0.4)


def test_escape_leaves_and_the_summary_adds_up(window, picture):
    escape = pygame.event.Event(pygame.KEYDOWN, key=pygame.K_ESCAPE)
    script = Script(window, [(0.5, lambda: pygame.event.post(escape))])
    summary = fly(Flown(), picture, script, duration=20.0)
    assert 0.4 < summary.wall < 5.0
    assert summary.flown == pytest.approx(summary.times.ticks * 0.01)
    assert abs(summary.flown + summary.times.lost - summary.wall) < 0.3
    assert summary.frames >= 1
    assert "missed" in str(summary)


def press(key):
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=key))


def test_full_screen_and_back_while_flying(window, picture):
    sizes = []
    doings = [
        (0.1, lambda: press(pygame.K_F11)),
        (0.5, lambda: sizes.append(pygame.display.get_window_size())),
        (0.6, lambda: press(pygame.K_F11)),
        (1.0, lambda: sizes.append(pygame.display.get_window_size())),
    ]
    summary = fly(Flown(), picture, Script(window, doings), duration=1.3)
    assert sizes[1] == SIZE
    assert summary.flown + summary.times.lost > 1.2


def test_frames_follow_the_window_once_it_rests(window, picture):
    """Full screen is larger; frames are painted in its size, and in the old one afterwards."""
    shapes = []
    doings = [(0.2, lambda: press(pygame.K_F11)), (1.2, lambda: press(pygame.K_F11))]

    class Shapes(Script):
        def show(self, frame, wall):
            shapes.append(frame.shape[1::-1])
            super().show(frame, wall)

    full = shaped(pygame.display.get_desktop_sizes()[0])
    assert full != SIZE
    fly(Flown(), picture, Shapes(window, doings), duration=2.2)
    assert [*dict.fromkeys(shapes)] == [SIZE, full]
    assert shapes[-1] == SIZE


def test_a_size_is_taken_when_it_has_rested():
    now = [0.0]
    resting = RestingSize((640, 360), lambda: now[0])
    for t, size, expected in (
        (0.4, (640, 360), (640, 360)),
        (0.5, (700, 400), None),
        (0.7, (801, 601), None),
        (0.9, (801, 601), None),
        (1.1, (801, 601), (800, 600)),
    ):
        now[0] = t
        assert resting.rested(size) == expected, t


@pytest.mark.parametrize(
    ("window_size", "picture_size"),
    [
        ((1280, 720), (1280, 720)),
        ((1024, 768), (1024, 768)),
        ((2520, 1080), (2520, 1080)),
        ((3000, 1000), (2332, 1000)),
        ((800, 1200), (800, 600)),
        ((100, 80), (320, 180)),
    ],
)
def test_pictures_have_shapes_from_four_by_three_to_twenty_one_by_nine(window_size, picture_size):
    assert shaped(window_size) == picture_size


class Asked:
    """A flight that only remembers what it was asked for."""

    parameters = SCENARIO.parameters

    def __init__(self):
        self.wishes = []

    def ask(self, wish):
        self.wishes.append(wish)


def test_a_kite_that_waits_is_silent(window, picture, monkeypatch):
    heard = []
    monkeypatch.setattr(window, "sense", lambda *seen: heard.append(seen[3]))
    fly(Flown(), picture, Script(window, [(0.3, lambda: press(pygame.K_SPACE))]), 0.8)
    assert heard[0]
    assert not heard[-1]


def test_f1_holds_the_flight(window, picture):
    physics = Asked()
    for expected in (0.0, 1.0):
        press(pygame.K_F1)
        window.poll()
        _grant(window.wishes, physics, picture, None)
        assert [wish for wish in physics.wishes if isinstance(wish, Rate)][-1] == Rate(expected)


@pytest.mark.parametrize("desktop", [(1280, 720), (1366, 768), (1024, 768), (1920, 1080)])
def test_a_picture_and_what_is_around_it_fit_the_desktop(monkeypatch, desktop):
    monkeypatch.setattr(pygame.display, "get_desktop_sizes", lambda: [desktop])
    for below in (0, 72):
        wide, tall = fitting((1280, 720), below)
        assert wide <= desktop[0]
        assert tall + below + AROUND <= desktop[1]
        assert wide / tall == pytest.approx(16 / 9, rel=0.01)
    assert (fitting((1280, 720)) == (1280, 720)) == (desktop == (1920, 1080))


def test_closed_by_the_window_manager_is_leaving(window, picture, tmp_path):
    quit_event = pygame.event.Event(pygame.QUIT)
    physics = Flown(record=tmp_path / "x.arrows")
    script = Script(window, [(0.4, lambda: pygame.event.post(quit_event))])
    summary = fly(physics, picture, script, duration=20.0)
    assert summary.wall < 10.0
    assert read_recording(tmp_path / "x.arrows").ending == "left by the pilot"


def test_a_kite_on_the_ground_waits_until_somebody_starts_again(window):
    """Full left for 6 s flies the sport kite into the ground, here at four times the speed."""
    scenario = scenario_of({"set": "sport", "duration": 60.0}, "test")
    physics, seen = Flown(scenario), []
    window.wishes.rate = 4.0
    window.stick = ProgrammedStick([Row(0.0, steer=-1.0)], scenario.parameters)

    class Patient(Script):
        """Looks ten times at a kite on the ground, starts again, looks, leaves."""

        def show(self, frame, wall):
            self.window.show(frame, wall)
            if physics.touch and len(seen) < 10:
                seen.append((physics.touch, physics.result.motion.t))
                if len(seen) == 10:
                    press(pygame.K_r)
            elif seen and not physics.touch:
                seen.append((None, physics.result.motion.t))
                press(pygame.K_ESCAPE)

    with Picture(scenario.parameters, *SIZE) as picture:
        fly(physics, picture, Patient(window, []), duration=60.0)
    assert seen[0][0] is not None
    assert not seen[0][0].gentle
    assert set(seen[:10]) == {seen[0]}
    assert seen[10][0] is None
    assert seen[10][1] < seen[0][1]
