"""What a person asks for adds up to the wishes that the cockpit grants."""

import pygame
import pytest

from kitemj.controls.actions import (
    DEPTHS,
    HELP,
    INSTRUMENTS,
    MENU_BUTTONS,
    NAMES,
    RATES,
    REPLAY_ACTIONS,
    REPLAY_BUTTONS,
    REPLAY_HELP,
    VIEWS,
    Wishes,
)
from kitemj.controls.keys import KEYS, MENU_KEYS, REPLAY_KEYS, TOGGLES
from kitemj.controls.pads import STANDARD, TRIGGERS

STEERING = {pygame.K_LEFT, pygame.K_RIGHT, pygame.K_UP, pygame.K_DOWN}
STEERING |= {pygame.K_w, pygame.K_a, pygame.K_s, pygame.K_d}


def test_every_action_has_a_key_and_no_key_of_steering():
    assert set(KEYS.values()) == NAMES
    assert not STEERING & set(KEYS)


def test_every_action_is_on_the_help_page_by_a_key():
    page = " ".join(HELP).lower()
    for action in NAMES - set(TOGGLES.values()):
        keys = [key for key, name in KEYS.items() if name == action]
        assert any(pygame.key.name(key)[:3] in page for key in keys), action


def test_pads_ask_for_what_there_is():
    asked = [*STANDARD.values(), *TRIGGERS.values()]
    assert set(asked) <= NAMES
    assert len(set(asked)) == len(asked)


def test_each_instrument_has_its_key():
    assert [name.removeprefix("toggle ") for name in TOGGLES.values()] == list(INSTRUMENTS)
    for key, name in zip(TOGGLES, INSTRUMENTS, strict=True):
        wishes = Wishes()
        wishes.ask([KEYS[key]])
        assert wishes.depth == "engineer", "where single instruments are"
        assert wishes.shown == set(INSTRUMENTS)
        wishes.ask([KEYS[key]])
        assert wishes.shown == set(INSTRUMENTS) - {name}
        wishes.ask([KEYS[key]])
        assert wishes.shown == set(INSTRUMENTS)


def test_depths_go_round_and_keep_what_was_chosen():
    wishes, seen = Wishes(), []
    for _ in DEPTHS:
        seen.append(wishes.depth)
        wishes.ask(["instruments"])
    assert tuple(seen) == DEPTHS == ("pilot", "engineer", "none")
    wishes.ask(["instruments", "toggle knob", *["instruments"] * 3])
    assert wishes.depth == "engineer"
    assert wishes.shown == set(INSTRUMENTS) - {"knob"}


def test_rates_and_pause():
    wishes = Wishes()
    wishes.ask(["slower", "pause"])
    assert wishes.rate == 0.0
    wishes.ask(["pause"])
    assert wishes.rate == 0.5
    wishes.ask(["faster"] * 10)
    assert wishes.rate == max(RATES)
    wishes.ask(["slower"] * 10)
    assert wishes.rate == min(RATES)


def test_views_go_round():
    wishes, seen = Wishes(), []
    for _ in VIEWS:
        seen.append(wishes.view)
        wishes.ask(["view"])
    assert tuple(seen) == VIEWS
    assert wishes.view == VIEWS[0]


def test_deeds_are_taken_once_in_their_order():
    wishes = Wishes()
    wishes.ask(["save", "rewind", "help", "restart"])
    wishes.turn, wishes.zoom = (0.1, 0.2), 1.1
    assert wishes.taken() == (["save", "rewind", "restart"], (0.1, 0.2), 1.1)
    assert wishes.taken() == ([], (0.0, 0.0), 1.0)
    assert wishes.help


def test_an_unknown_action_is_an_error():
    with pytest.raises(KeyError):
        Wishes().ask(["fly to the moon"])


def test_the_flight_waits_under_the_help_page_and_goes_on_as_before():
    wishes = Wishes()
    wishes.ask(["slower", "help"])
    assert wishes.pace == 0.0
    wishes.ask(["help"])
    assert wishes.pace == 0.5
    wishes.ask(["pause", "help", "help"])
    assert wishes.pace == 0.0, "paused by hand"
    wishes.ask(["pause"])
    assert wishes.pace == 0.5


def test_every_action_of_a_replay_has_a_key_and_stands_on_its_page():
    names = {action.name for action in REPLAY_ACTIONS}
    assert set(REPLAY_KEYS.values()) == names
    page = " ".join(REPLAY_HELP).lower()
    for name in names:
        keys = [key for key, asked in REPLAY_KEYS.items() if asked == name]
        assert any(pygame.key.name(key)[:3] in page for key in keys), name


def test_a_pad_watches_and_chooses_with_its_cross_and_its_buttons():
    cross = (
        (pygame.CONTROLLER_BUTTON_DPAD_UP, "up", None),
        (pygame.CONTROLLER_BUTTON_DPAD_DOWN, "down", None),
        (pygame.CONTROLLER_BUTTON_DPAD_LEFT, "left", "back"),
        (pygame.CONTROLLER_BUTTON_DPAD_RIGHT, "right", "on"),
        (pygame.CONTROLLER_BUTTON_A, "choose", "play"),
        (pygame.CONTROLLER_BUTTON_B, "leave", "leave"),
    )
    for button, on_the_title, watching in cross:
        assert MENU_BUTTONS.get(STANDARD[button]) == on_the_title
        assert REPLAY_BUTTONS.get(STANDARD[button]) == watching
    assert set(REPLAY_BUTTONS.values()) <= {action.name for action in REPLAY_ACTIONS}
    assert set(MENU_BUTTONS.values()) <= set(MENU_KEYS.values())


def test_sound_is_a_state_and_watching_a_deed():
    wishes = Wishes()
    wishes.ask(["sound", "watch"])
    assert not wishes.sound
    assert wishes.taken()[0] == ["watch"]
    wishes.ask(["sound"])
    assert wishes.sound
