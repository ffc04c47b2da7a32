"""The first minute: a menu that keys, pads and the mouse use alike, and what is behind it."""

import os
from itertools import pairwise

import numpy as np
import pygame
import pytest

from kitemj.cli import main
from kitemj.cockpit.demonstration import MOST, Demonstration
from kitemj.cockpit.home import Doors, Home
from kitemj.cockpit.menu import Entry, Menu
from kitemj.cockpit.screens import Window, display_found
from kitemj.cockpit.title import Title
from kitemj.cockpit.title_page import _shade, paint_title
from kitemj.controls.settings import Settings
from kitemj.controls.stick import PersonStick
from kitemj.drawing.picture import Picture
from kitemj.flight.live import Command
from kitemj.flight.scenario import scenario_of
from kitemj.physics.parameter_files import set_names
from kitemj.recording.live import LiveFlight
from kitemj.recording.recorder import latest
from tests.cockpit.conftest import SIZE
from tests.controls.virtual_pad import VirtualPad

SPORT = scenario_of({"set": "sport", "duration": 60.0}, "test")


def menu():
    return Menu(
        [
            Entry("fly", "Fly"),
            Entry("replay", "Watch", open=False),
            Entry("kite", "Kite", "a kite", offers=("laksa", "sport", "thesis"), offer=1),
            Entry("leave", "Leave"),
        ]
    )


def asked(*actions):
    made = menu()
    for action in actions:
        made.ask(action)
    return made


def test_a_menu_goes_round_over_what_is_open():
    marks = [asked(*["down"] * n).entry.key for n in range(4)]
    assert marks == ["fly", "kite", "leave", "fly"]
    assert asked("up").entry.key == "leave"
    assert asked("left", "nonsense", "").chosen == ""


def test_choosing_takes_an_entry_or_turns_what_it_offers():
    assert asked("choose").chosen == "fly"
    for actions, offered in ((["choose"], "thesis"), (["left"], "laksa"), (["left"] * 2, "thesis")):
        made = asked("down", *actions)
        assert (made.chosen, made.entry.offered) == ("kite", offered)
    assert asked("leave").chosen == "leave"


def test_a_menu_never_marks_what_is_shut():
    assert Menu(menu().entries, 1).entry.key == "kite"


@pytest.fixture(scope="module")
def picture():
    with Picture(SPORT.parameters, *SIZE, quality="low") as picture:
        yield picture


@pytest.fixture
def title(window, picture):
    return Title(picture, window, menu(), Demonstration(SPORT))


def mouse(kind, at, **more):
    pygame.event.post(pygame.event.Event(kind, pos=at, **more))


def test_keys_mouse_and_pad_choose_alike(title):
    title.paint()
    leave = title._boxes[3].center
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_DOWN))
    title.poll()
    assert title._menu.entry.key == "kite"
    mouse(pygame.MOUSEMOTION, leave, rel=(0, 0), buttons=(0, 0, 0))
    title.poll()
    assert title._menu.entry.key == "leave"
    mouse(pygame.MOUSEBUTTONDOWN, title._boxes[1].center, button=1)
    title.poll()
    assert (title._menu.entry.key, title._menu.chosen) == ("leave", ""), "the shut one stays shut"
    pad = VirtualPad()
    title.poll()
    pad.axis(1, 1.0)
    for _ in range(3):
        title.poll()
    assert title._menu.entry.key == "fly", "one step for a push, however long"
    pad.button(0, True)
    title.poll()
    assert title._menu.chosen == "fly"
    pad.unplug()


def test_a_click_chooses_and_closing_the_window_leaves(title):
    title.paint()
    mouse(pygame.MOUSEBUTTONDOWN, title._boxes[0].center, button=1)
    assert title.run() == "fly"
    title._menu.chosen = ""
    pygame.event.post(pygame.event.Event(pygame.QUIT))
    assert title.run() == "leave"


@pytest.mark.parametrize("size", [(1920, 1080), (1280, 720), (640, 360), (320, 180)])
def test_entries_lie_in_the_frame_one_below_the_other(size):
    surface = pygame.Surface(size)
    surface.fill((160, 200, 250))
    boxes = paint_title(surface, menu(), "a sentence " * 8)
    for above, below in pairwise(boxes):
        assert above.bottom <= below.top + 1
    assert all(surface.get_rect().contains(box) for box in boxes)
    pixels = pygame.surfarray.array3d(surface)
    assert np.array_equal(pixels[-1, 0], (160, 200, 250)), "the kite's side is as it was"


def test_the_demonstration_flies_and_begins_anew_after_the_ground(monkeypatch):
    show = Demonstration(SPORT)
    show.advance(0.05)
    assert show.motion.t == pytest.approx(0.05)
    show.advance(3.0)
    assert show.motion.t == pytest.approx(0.15), "a long frame is not caught up with"
    monkeypatch.setattr("kitemj.cockpit.demonstration.touches_ground", lambda *_: True)
    show.advance(0.01)
    assert show.motion.t == 0.0


@pytest.mark.parametrize("kite", set_names())
def test_every_kite_has_a_show_that_stays_in_the_air(kite):
    show = Demonstration(scenario_of({"set": kite, "duration": 60.0}, "test"))
    for _ in range(150):
        show.advance(MOST)
    assert show.motion.t == pytest.approx(15.0)


def test_latest_is_the_flight_last_written_here(tmp_path):
    assert latest(tmp_path) is None
    for age, name in enumerate(("kitemj-2.arrows", "kitemj-1.arrows", "mine.arrows")):
        (tmp_path / name).touch()
        os.utime(tmp_path / name, (1000 + age, 1000 + age))
    assert latest(tmp_path) == tmp_path / "kitemj-1.arrows"


class Idle:
    """A process, or a picture, that does nothing."""

    width, height = SIZE

    def __init__(self, parameters=None, *_):
        self.parameters = parameters

    def close(self):
        pass

    kill = close


def test_home_flies_what_is_chosen_and_keeps_window_picture_and_silence(monkeypatch, tmp_path):
    """Be silent, fly, another kite, lessons, fly that one twice and close the window."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("kitemj.cockpit.home.launch", Idle)
    monkeypatch.setattr("kitemj.cockpit.home.Picture", Idle)
    monkeypatch.setattr("kitemj.cockpit.home.Demonstration", Idle)
    assert display_found()
    flown, surfaces = [], set()
    wanted = iter(["fly", "kite", "lessons", "fly", "fly"])

    def scenario(kite):
        return scenario_of({"set": kite, "duration": 60.0}, kite)

    def window(flying):
        return Window(*SIZE, "test", PersonStick(Settings(), flying.parameters))

    def fly(kite, lessons, child, kept):
        assert kept.picture.parameters == scenario(kite).parameters
        flown.append((kite, lessons, kept.sound))
        kept.closed = len(flown) == 4
        return len(flown)

    def run(title):
        if not surfaces:
            title._window.wishes.ask(["sound"])
        surfaces.add(pygame.display.get_surface())
        key = next(wanted)
        title._menu.marked = [entry.key for entry in title._menu.entries].index(key)
        title._menu.ask("choose")
        return title._menu.chosen

    monkeypatch.setattr(Title, "run", run)
    doors = Doors(scenario, window, fly, lambda: (2, 7))
    home = Home(doors, "sport", SIZE, sound=True, quality="low")
    assert home.run(Idle()) == 4
    thesis = ("thesis", False, False)
    assert flown == [("sport", False, False), ("sport", True, False), thesis, thesis]
    assert len(surfaces) == 1
    pygame.display.quit()


def luminance(pixels):
    """Relative luminance of sRGB colours (n, 3) in 0..255; WCAG 2.1."""
    share = np.asarray(pixels, float) / 255
    linear = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
    return linear @ (0.2126, 0.7152, 0.0722)


@pytest.mark.parametrize("size", [(1920, 1080), (1280, 720), (640, 360)])
def test_what_is_written_is_legible_before_a_white_cloud(size):
    """A contrast of 4.5 : 1 (WCAG 2.1, 1.4.3) where the page differs from its bare shade."""
    made, white = menu(), pygame.Surface(size)
    made.entries[3].says = "a sentence that is rather long, so that it fills its room"
    made.marked = 3
    white.fill((255, 255, 255))
    paint_title(white, made)
    bare = pygame.Surface(size)
    bare.fill((255, 255, 255))
    bare.blit(_shade(size), (0, 0))
    written, ground = (pygame.surfarray.array3d(each).astype(int) for each in (white, bare))
    changed = np.argwhere(np.abs(written - ground).max(axis=2) > 0)
    assert changed[:, 0].max() < 0.45 * size[0], "nothing is written on the kite's side"
    text = luminance(written[tuple(changed.T)])
    behind = luminance(ground[tuple(changed.T)])
    strokes = text >= np.quantile(text, 0.7)  # the rest are their soft edges
    contrast = (text[strokes] + 0.05) / (behind[strokes] + 0.05)
    assert contrast.min() >= 4.5


@pytest.mark.parametrize(
    ("words", "what"),
    [
        ((), "title"),
        (("--size", "640x360", "--view", "chase", "--no-record"), "title"),
        (("--no-title",), "flight"),
        (("--duration", "3"), "flight"),
        (("--kite", "thesis"), "flight"),
        (("--lessons",), "flight"),
        (("--pilot", "eight"), "flight"),
        (("steer_80m",), "flight"),
    ],
)
def test_who_asks_for_a_certain_flight_sees_no_title(monkeypatch, words, what):
    seen = []
    monkeypatch.setattr("kitemj.realtime.launch.launch", lambda: None)
    monkeypatch.setattr("kitemj.cockpit.screens.display_found", lambda: True)
    monkeypatch.setattr("kitemj.commands.fly._fly", lambda *_: seen.append("flight"))
    monkeypatch.setattr("kitemj.commands.fly._from_title", lambda *_: seen.append("title"))
    assert main(["fly", *words]) == 0
    assert seen == [what]


def test_replay_of_nothing_is_the_last_flight_or_a_sentence(monkeypatch, tmp_path, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["replay", "--headless"]) == 1
    assert "there is no kitemj-*.arrows in this folder" in capsys.readouterr().err
    with LiveFlight(SPORT, record=tmp_path / "kitemj-1.arrows") as flight:
        for _ in range(60):
            flight.tick(Command())
    assert main(["replay", "--export", "csv"]) == 0
    assert (tmp_path / "kitemj-1.csv").exists()
