"""What hands ask of the lines: one stick, a stick for each line, keys, mouse, programmes."""

from pathlib import Path

import pygame
import pytest

from kitemj.cockpit.hands import Hands, command_of, one_line_each
from kitemj.cockpit.pads import events
from kitemj.cockpit.programmed import (
    ProgrammedStick,
    Row,
    read_programmed_stick,
    show,
)
from kitemj.cockpit.settings import Feel, Settings
from kitemj.cockpit.stick import GENTLE, PersonStick, PilotStick
from kitemj.errors import InputError
from kitemj.flight.live import TICK, Command, LiveFlight
from kitemj.flight.pilots import Hold
from kitemj.flight.scenario import scenario_of
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.shaping import StickLaw
from kitemj.physics.steering import line_motion
from tests.cockpit.virtual_pad import VirtualPad

SPORT, THESIS = parameter_set("sport"), parameter_set("thesis")
ROUNDING = 1e-9
"""m; of a line's length."""


class At:
    """As much of a motion as a programme looks at."""

    def __init__(self, t):
        self.t = t


@pytest.fixture
def desk(monkeypatch):
    """Keys that are held, by a set that the test fills; a window 200 px wide."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    pygame.display.init()
    pygame.display.set_mode((200, 100))
    held = set()

    class Pressed:
        def __getitem__(self, key):
            return key in held

    monkeypatch.setattr(pygame.key, "get_pressed", Pressed)
    shift = lambda: pygame.KMOD_LSHIFT if pygame.K_LSHIFT in held else 0  # noqa: E731
    monkeypatch.setattr(pygame.key, "get_mods", shift)
    yield held
    pygame.joystick.quit()
    pygame.display.quit()


@pytest.fixture
def person(desk):
    person = PersonStick(Settings(), SPORT)
    yield person
    person.close()


def test_keys_steer_while_they_are_held(person, desk):
    desk.update({pygame.K_d, pygame.K_DOWN})
    assert person.command(None) == Command(1.0, -1.0)
    assert person.name == "keys"
    desk.add(pygame.K_LSHIFT)
    assert person.command(None) == Command(GENTLE, -GENTLE)
    desk.clear()
    assert person.command(None) == Command(0.0, 0.0)


def test_held_keys_go_before_the_pad_and_give_the_kite_back(person, desk):
    pad = VirtualPad()
    pad.left_stick(-1.0)
    for event in events():
        person.handle(event)
    desk.add(pygame.K_RIGHT)
    assert person.command(None).delta == 1.0
    desk.clear()
    assert person.command(None).delta == -1.0


def mouse(kind, x, **more):
    return pygame.event.Event(kind, pos=(x, 50), **more)


def test_the_mouse_steers_while_its_button_is_held(person):
    """All the way is half the way to the edge of the window."""
    person.handle(mouse(pygame.MOUSEMOTION, 180, buttons=(0, 0, 0)))
    assert person.command(None).delta == 0.0
    person.handle(mouse(pygame.MOUSEBUTTONDOWN, 110, button=1))
    assert person.command(None).delta == pytest.approx(0.2)
    assert person.name == "mouse"
    person.handle(mouse(pygame.MOUSEMOTION, 10, buttons=(1, 0, 0)))
    assert person.command(None).delta == -1.0
    person.handle(mouse(pygame.MOUSEBUTTONUP, 10, button=3))
    assert person.command(None).delta == -1.0
    person.handle(mouse(pygame.MOUSEBUTTONUP, 10, button=1))
    assert person.command(None).delta == 0.0


def test_a_window_that_loses_focus_lets_go_of_the_mouse(person):
    person.handle(mouse(pygame.MOUSEBUTTONDOWN, 190, button=1))
    person.handle(pygame.event.Event(pygame.WINDOWFOCUSLOST))
    assert person.command(None).delta == 0.0


def test_the_law_may_change_in_flight(person, desk):
    desk.add(pygame.K_RIGHT)
    person.law = StickLaw.ACCELERATION
    assert person.command(None) == Command(1.0, 0.0, StickLaw.ACCELERATION)


def test_settings_say_how_a_flight_begins(desk):
    person = PersonStick(Settings(Feel(two_sticks=True), StickLaw.RATE), SPORT)
    assert (person.law, person.two_sticks) == (StickLaw.RATE, True)
    person.close()


def test_keys_of_each_hand_pull_a_line(person, desk):
    person.two_sticks, person.law = True, StickLaw.RATE
    desk.add(pygame.K_s)  # the left hand pulls: A₊ comes nearer
    assert person.command(None) == one_line_each(SPORT, 1.0, 0.0)
    desk.clear()
    desk.add(pygame.K_UP)  # the right hand gives line
    assert person.command(None) == one_line_each(SPORT, 0.0, -1.0)
    assert person.command(None).law is StickLaw.ANGLE


@pytest.mark.parametrize("parameters", [SPORT, THESIS], ids=["sport", "thesis"])
@pytest.mark.parametrize(("left", "right"), [(0.0, 0.6), (1.0, -1.0), (0.3, 0.7), (-1.0, -1.0)])
def test_each_stick_moves_its_own_line(parameters, left, right):
    """By the arm, once the limits on how fast lines move have had their time."""
    scenario = scenario_of({"set": "sport", "duration": 60.0}, "test")
    flight = LiveFlight.__new__(LiveFlight)
    del flight
    lengths = settled(parameters, one_line_each(parameters, left, right))
    length, arm = parameters.lines.length, parameters.stick.arm
    assert lengths == pytest.approx((length - arm * left, length - arm * right), abs=ROUNDING)
