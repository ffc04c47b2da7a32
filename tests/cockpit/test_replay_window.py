"""A recording looked at again: the mouse turns the eye, buttons play, a flight goes on after."""

import time

import pygame
import pytest

from kitemj.cockpit.fly import fly
from kitemj.cockpit.replay_slider import HEIGHT
from kitemj.cockpit.replay_window import ReplayWindow
from kitemj.cockpit.screens import Window
from kitemj.controls.settings import Settings
from kitemj.controls.stick import PersonStick
from kitemj.drawing.picture import Picture
from kitemj.flight.live import Command
from kitemj.flight.scenario import scenario_of
from kitemj.realtime.process import FlightProcess
from kitemj.recording.file import read_recording
from kitemj.recording.live import FlightSetup, LiveFlight
from tests.cockpit.conftest import SIZE
from tests.controls.virtual_pad import VirtualPad

SPORT = scenario_of({"set": "sport", "duration": 60.0}, "test")


@pytest.fixture(scope="module")
def picture():
    with Picture(SPORT.parameters, *SIZE, quality="low") as picture:
        yield picture


@pytest.fixture(scope="module")
def recording(tmp_path_factory):
    path = tmp_path_factory.mktemp("flights") / "kitemj-1.arrows"
    with LiveFlight(SPORT, record=path) as flight:
        for _ in range(300):
            flight.tick(Command(0.2))
    return read_recording(path)


@pytest.fixture
def replay(recording, picture, window):
    replay = ReplayWindow(recording, None, picture, window)
    replay.paint()
    return replay


def press(key):
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=key, mod=0))


def drag(start, *way):
    pygame.event.post(pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=start, button=1))
    x, y = start
    for rel in way:
        x, y = x + rel[0], y + rel[1]
        moved = {"pos": (x, y), "rel": rel, "buttons": (1, 0, 0)}
        pygame.event.post(pygame.event.Event(pygame.MOUSEMOTION, **moved))
    pygame.event.post(pygame.event.Event(pygame.MOUSEBUTTONUP, pos=(x, y), button=1))


def test_dragging_the_picture_turns_the_eye_and_the_wheel_comes_nearer(replay, picture):
    before = picture.eye._orbit
    drag((300, 100), (40, 0), (10, 20))
    replay.poll()
    assert replay.view == "orbit"
    turned = picture.eye._orbit
    assert turned.azimuth == pytest.approx(before.azimuth - 0.25)
    assert turned.elevation == pytest.approx(before.elevation + 0.1)
    pygame.event.post(pygame.event.Event(pygame.MOUSEWHEEL, y=2, x=0))
    replay.poll()
    assert picture.eye._orbit.distance < turned.distance
    assert replay.player.t == 0.0


def test_dragging_the_slider_moves_time_and_no_eye(replay, picture):
    before, scale = picture.eye._orbit, replay._place.width / SIZE[0]
    strip = replay._place.top + (SIZE[1] + 20) * scale
    drag((replay._place.left + 100 * scale, strip), (100, 0), (0, -200))
    replay.poll()
    assert replay.player.t > 0.0
    assert picture.eye._orbit == before
    assert not replay._slider.pressed


def test_a_pad_plays_and_goes_on_and_back(replay):
    pad = VirtualPad()
    replay.poll()
    pad.button(0, True)
    replay.poll()
    assert not replay.player.playing
    pad.button(14, True)
    replay.poll()
    assert replay.player.t == pytest.approx(1.0)
    pad.button(13, True)
    replay.poll()
    assert replay.player.t == pytest.approx(0.0)
    pad.button(1, True)
    replay.poll()
    assert replay.leaving
    pad.unplug()


def test_picture_and_strip_share_the_window_and_the_picture_has_it_back(replay, picture):
    sizes = []
    press(pygame.K_ESCAPE)
    replay.run(meanwhile=lambda: sizes.append((picture.width, picture.height)))
    assert sizes[0] == (SIZE[0], SIZE[1] - HEIGHT)
    assert (picture.width, picture.height) == pygame.display.get_window_size() == SIZE


class Watcher(Window):
    """Watches again after a second, goes on, and leaves."""

    watched = False

    def show(self, frame, wall):
        super().show(frame, wall)
        if not self.watched and wall > 1.0:
            press(pygame.K_g)
            self.watched = True
        elif self.watched and wall > 3.0:
            press(pygame.K_ESCAPE)


@pytest.mark.alone
def test_a_flight_is_watched_again_and_goes_on(window, picture, tmp_path, monkeypatch):
    seen = []
    run = ReplayWindow.run

    def watching(replay, meanwhile):
        seen.append(replay.player.duration)
        time.sleep(1.0)
        press(pygame.K_ESCAPE)
        run(replay, meanwhile)

    monkeypatch.setattr(ReplayWindow, "run", watching)
    window.close()
    window = Watcher(*SIZE, "test", PersonStick(Settings(), SPORT.parameters))
    physics = FlightProcess(FlightSetup(SPORT, record=tmp_path / "x.arrows"))
    physics.wait()
    summary = fly(physics, picture, window, duration=20.0)
    assert seen[0] > 0.5, "what was flown until then"
    assert seen[0] < summary.flown, "it went on"
    assert abs(summary.flown + summary.times.lost - summary.wall) < 0.4, "it stood meanwhile"
