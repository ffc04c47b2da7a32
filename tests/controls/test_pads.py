"""Pads as SDL sees them: who steers, what a button asks for, what happens when one goes."""

import pygame
import pytest

from kitemj.controls.pad_layout import Layout, PadSource, layout_of
from kitemj.controls.pads import STANDARD, events
from kitemj.controls.settings import Feel, Invert, Settings
from kitemj.controls.stick import PersonStick
from kitemj.errors import InputError
from kitemj.physics.parameter_files import parameter_set
from tests.controls.virtual_pad import OddPad, VirtualPad

SPORT = parameter_set("sport")
STRAIGHT = Settings(Feel(dead_zone=0.0))
CELL = 1 / 32767
"""Of full deflection: what a stick of 16 bits can tell apart."""


SEATS = []


class Seat:
    """A person with pads; `look` sees all events and returns the actions asked for."""

    def __init__(self, settings=STRAIGHT, parameters=SPORT):
        self.stick = PersonStick(settings, parameters)
        SEATS.append(self)

    def look(self):
        return tuple(name for event in events() for name in self.stick.handle(event))

    @property
    def delta(self):
        self.look()
        return self.stick.command(None).delta

    @property
    def message(self):
        self.look()
        return self.stick.message


@pytest.fixture(autouse=True)
def screen(monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    monkeypatch.setenv("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1")
    pygame.display.init()
    pygame.display.set_mode((200, 100))
    yield
    while SEATS:
        SEATS.pop().stick.close()
    pygame.joystick.quit()
    pygame.display.quit()


@pytest.fixture
def seat():
    return Seat()


def guid(pad):
    pygame.event.pump()
    joysticks = [pygame.joystick.Joystick(i) for i in range(pygame.joystick.get_count())]
    return next(each.get_guid() for each in joysticks if each.get_instance_id() == pad._instance)


def test_left_stick_steers_and_right_stick_reels(seat):
    pad = VirtualPad()
    pad.axis(0, -0.25)
    pad.axis(3, -0.5)  # SDL: up is negative
    seat.look()
    command = seat.stick.command(None)
    assert command.delta == pytest.approx(-0.25, abs=CELL)
    assert command.ell == pytest.approx(0.5, abs=CELL)
    assert seat.stick.name == "gamepad"


def test_every_standard_button_asks_once(seat):
    pad = VirtualPad()
    seat.look()
    for button, action in STANDARD.items():
        pad.button(button, True)
        assert seat.look() == (action,)
        assert seat.look() == ()
        pad.button(button, False)
        assert seat.look() == ()


def test_a_pad_that_goes_mid_turn_leaves_the_stick_centred(seat):
    pad = VirtualPad()
    pad.left_stick(1.0)
    assert seat.delta == 1.0
    pad.unplug()
    assert seat.delta == 0.0
    assert seat.message == (
        "the pad virtual pad is gone: the stick returns to its centre; keys and mouse fly"
    )
    assert seat.stick.name == "keys"


def test_of_two_pads_the_one_moved_last_steers(seat):
    first, second = VirtualPad("first"), VirtualPad("second")
    seat.look()
    assert seat.message == "another pad, second: the one moved last steers"
    first.left_stick(0.5)
    assert seat.delta == pytest.approx(0.5, abs=CELL)
    second.left_stick(0.05)  # a worn stick claims nothing
    assert seat.delta == pytest.approx(0.5, abs=CELL)
    second.left_stick(-1.0)
    assert seat.delta == pytest.approx(-1.0, abs=CELL)
    assert seat.message == "the pad second steers"
    first.left_stick(0.6)  # held all the while: it does not come back by trembling
    assert seat.delta == pytest.approx(-1.0, abs=CELL)
    first.button(10, True)
    assert seat.delta == pytest.approx(0.6, abs=CELL)
    assert seat.message == "the pad first steers"


def test_the_other_pad_takes_over(seat):
    first, second = VirtualPad("first"), VirtualPad("second")
    second.left_stick(1.0)
    assert seat.delta == 1.0
    second.unplug()
    assert seat.delta == 0.0
    assert seat.message == "the pad second is gone: the pad first steers"
    first.left_stick(-0.5)
    assert seat.delta == pytest.approx(-0.5, abs=CELL)


def test_a_pad_that_was_exchanged_between_two_looks_steers(seat):
    """The first event's number is another pad's by then."""
    VirtualPad("first").unplug()
    second = VirtualPad("second")
    second.left_stick(1.0)
    assert seat.delta == 1.0
    assert seat.message == "the pad second steers"


def test_pads_of_one_name_can_be_told_apart(seat):
    _, second = VirtualPad(), VirtualPad()
    seat.look()
    second.left_stick(1.0)
    assert seat.message == "the pad virtual pad (2) steers"


def test_a_pad_that_nobody_knows_does_not_steer(seat):
    pad = OddPad()
    for axis in range(OddPad.axes):
        pad.axis(axis, 1.0)
    assert seat.delta == 0.0
    assert seat.stick.command(None).ell == 0.0
    assert seat.message == (
        "the pad odd pad has no known layout: run kitemj pad; keys and mouse fly"
    )


def laid_out(layout, kind=OddPad, feel=STRAIGHT.feel):
    pygame.joystick.init()
    pad = kind()
    seat = Seat(Settings(feel, pads={guid(pad): layout}))
    seat.look()
    return seat, pad


def test_a_layout_of_the_settings_steers_an_odd_pad():
    layout = Layout(
        "odd pad",
        steer=PadSource("axis", 1, sign=-1),
        reel=PadSource("hat", 0, 1),
        buttons={"law": PadSource("axis", 2)},
    )
    seat, pad = laid_out(layout)
    pad.axis(1, -0.5)
    pad.hat(0, 0, -1)
    seat.look()
    command = seat.stick.command(None)
    assert command.delta == pytest.approx(0.5, abs=CELL)
    assert command.ell == -1.0
    pad.axis(2, 1.0)  # a trigger as a button
    assert seat.look() == ("law",)
    pad.axis(2, 0.9)
    assert seat.look() == ()


def test_a_press_between_two_looks_is_not_lost():
    buttons = {"restart": PadSource("button", 3), "view": PadSource("hat", 0, 1)}
    seat, pad = laid_out(Layout("odd pad", buttons=buttons))
    for down in (True, False):
        pad.button(3, down)
        pad.hat(0, 0, down)
        pygame.event.pump()
    assert seat.look() == ("restart", "view")
    assert seat.look() == ()


def test_two_buttons_are_an_axis():
    seat, pad = laid_out(Layout("odd pad", steer=PadSource("buttons", 4, 5)))
    pad.button(4, True)
    assert seat.delta == -1.0
    pad.button(5, True)
    assert seat.delta == 0.0
    pad.button(4, False)
    assert seat.delta == 1.0


def test_a_layout_goes_before_what_sdl_knows():
    seat, pad = laid_out(Layout("mine", steer=PadSource("axis", 3)), VirtualPad)
    pad.left_stick(1.0)
    assert seat.delta == 0.0
    pad.axis(3, 1.0)
    assert seat.delta == 1.0


def test_a_layout_of_another_pad_is_a_sentence():
    seat, _ = laid_out(Layout("odd pad", steer=PadSource("axis", 9)))
    assert seat.message == (
        "the pad odd pad has no axis 9, which its layout names: run kitemj pad; keys and mouse fly"
    )
    assert seat.delta == 0.0


@pytest.mark.parametrize(
    ("feel", "pushed", "meant"),
    [
        (Feel(0.2, 0.0), 0.2, 0.0),
        (Feel(0.2, 0.0), 0.6, 0.5),
        (Feel(0.2, 0.0), -0.6, -0.5),
        (Feel(0.2, 0.0), 1.0, 1.0),
        (Feel(0.0, 1.0), 0.5, 0.125),
        (Feel(0.0, 0.4), -0.5, -(0.6 * 0.5 + 0.4 * 0.125)),
        (Feel(0.2, 0.4), -1.0, -1.0),
    ],
)
def test_dead_zone_and_expo(feel, pushed, meant):
    seat, pad = Seat(Settings(feel)), VirtualPad()
    pad.left_stick(pushed)
    assert seat.delta == pytest.approx(meant, abs=2 * CELL)


def test_inversion():
    seat, pad = Seat(Settings(STRAIGHT.feel, invert=Invert(steer=True, reel=True))), VirtualPad()
    pad.axis(0, 0.5)
    pad.axis(3, 1.0)
    assert seat.delta == pytest.approx(-0.5, abs=CELL)
    assert seat.stick.command(None).ell == pytest.approx(1.0, abs=CELL)


@pytest.mark.parametrize(
    "text", ["axis 0", "-axis 3", "hat 0 x", "-hat 1 y", "button 12", "buttons 3 4"]
)
def test_texts_of_sources_come_back(text):
    layout = layout_of({"name": "a", "steer": text}, "pads.x", "test")
    assert str(layout.steer) == text
    assert layout_of(layout.table(), "pads.x", "test") == layout


@pytest.mark.parametrize(
    ("table", "says"),
    [
        ({"steer": "axis"}, "pads.x.steer must be like 'axis 0'"),
        ({"steer": 3}, "pads.x.steer must be like 'axis 0'"),
        ({"stear": "axis 0"}, "pads.x.stear is not known: did you mean 'steer'?"),
        ({"buttons": {"restrat": "button 0"}}, "did you mean 'restart'?"),
        ({"buttons": "button 0"}, "pads.x.buttons must be a table"),
        ({"name": 3}, "pads.x.name must be a text, got 3"),
        (3, "pads.x must be a table, got 3"),
    ],
)
def test_layouts_that_are_none(table, says):
    with pytest.raises(InputError) as error:
        layout_of(table, "pads.x", "file.toml")
    assert says in str(error.value)
    assert "(file.toml)" in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("kind", [VirtualPad, OddPad])
def test_the_steering_pad_shakes_and_no_other(kind):
    pygame.joystick.init()
    pads = [kind(), kind()]
    guid = pygame.joystick.Joystick(0).get_guid()
    layout = layout_of({"name": "odd", "steer": "axis 0"}, "pads", "test")
    seat = Seat(Settings(Feel(dead_zone=0.0), pads={guid: layout} if kind is OddPad else {}))
    seat.look()
    pads[1].axis(0, 1.0)
    seat.look()
    seat.stick.rumble(0.25, 0.75)
    assert pads[1].shaken[-1] == pytest.approx((0.25, 0.75), abs=1e-4)
    assert pads[0].shaken == []


def test_rumble_without_a_pad_is_nothing(seat):
    seat.stick.rumble(1.0, 1.0)
