"""Handing over to an autopilot and taking back: by an action, by a push of the stick."""

import pygame
import pytest

from kitemj.controls.hand_over import BAND, SAID, HandOver
from kitemj.controls.notices import Notices
from kitemj.controls.pads import FULL, TRIGGERS, events
from kitemj.flight.live import Command
from tests.controls.test_stick import after, desk, person  # noqa: F401  fixtures
from tests.controls.virtual_pad import VirtualPad

CAN = dict.fromkeys(("eight", "circle", "hold", "land"), "")
LESS, MORE = 0.9 * BAND, 1.1 * BAND


@pytest.fixture
def hands():
    """Nobody has handed over yet; `said` is the newest sentence."""
    notices = Notices()
    hand_over = HandOver(notices)
    hand_over.offer(CAN)
    hand_over.said = lambda: notices.newest
    return hand_over


def test_a_push_beyond_the_band_takes_back_and_says_so(hands):
    for push in (Command(MORE), Command(-MORE), Command(0.0, MORE), Command(0.0, -MORE)):
        hands.change(Command())
        assert hands.flown == "eight"
        hands.watch(Command(LESS, -LESS))
        assert hands.flown == "eight"
        hands.watch(push)
        assert not hands.flown
        assert "you have the stick" in hands.said()


def test_who_hands_over_in_a_turn_may_let_go(hands):
    hands.change(Command(0.4))
    for delta in (0.4, 0.38, 0.3, 0.2, 0.1, 0.0):
        hands.watch(Command(delta))
    assert hands.flown == "eight"
    hands.watch(Command(0.4))
    assert not hands.flown, "pushed anew"
    hands.change(Command(0.4))
    hands.watch(Command(0.4 + MORE))
    assert not hands.flown, "pushed further"
    hands.change(Command(0.4))
    hands.watch(Command(-MORE))
    assert not hands.flown, "to the other side"
    hands.change(Command(0.4))
    hands.watch(Command(0.2))
    hands.watch(Command(0.2 + MORE))
    assert not hands.flown, "half let go, then pushed"


def test_figures_go_round_and_leave_out_what_cannot_be_flown(hands):
    hands.offer({**CAN, "circle": "too small a window for a circle"})
    hands.next_figure()
    assert not hands.flown, "it is only chosen"
    assert SAID["hold"] in hands.said()
    hands.change(Command())
    assert hands.flown == "hold"
    flown = []
    for _ in range(3):
        hands.next_figure()
        flown.append(hands.flown)
    assert flown == ["land", "eight", "hold"]


def test_a_kite_that_it_cannot_fly_stays_with_the_person_who_is_told_why(hands):
    hands.offer(dict.fromkeys(CAN, "this kite does not turn"))
    hands.change(Command())
    assert (hands.flown, hands.said()) == ("", "this kite does not turn")
    hands.next_figure()
    assert (hands.flown, hands.said()) == ("", "this kite does not turn")


def test_a_scenario_with_a_pilot_begins_with_it(hands):
    hands.offer({"scenario": "", **CAN}, at_once=True)
    assert hands.flown == "scenario"


def test_the_assist_and_the_autopilot_are_not_on_together(person):  # noqa: F811
    person.hand_over.offer(CAN)
    person.change("autopilot")
    assert person.hand_over.flown
    person.change("assist")
    assert (person.assist, person.hand_over.flown) == (True, "")


def test_a_key_that_steers_takes_back(person, desk):  # noqa: F811
    person.hand_over.offer(CAN)
    person.change("autopilot")
    assert after(person, 0.5) == Command()
    assert person.hand_over.flown
    desk.add(pygame.K_LEFT)
    after(person, 0.2)
    assert not person.hand_over.flown


def test_a_trigger_asks_once_each_time_it_is_pressed(person):  # noqa: F811
    VirtualPad()
    for event in events():
        person.handle(event)
    number = next(iter(person._pads._pads))

    def moved(axis, way):
        event = pygame.event.Event(
            pygame.CONTROLLERAXISMOTION, axis=axis, value=round(way * FULL), instance_id=number
        )
        return person.handle(event)

    for axis, action in TRIGGERS.items():
        asked = [moved(axis, way) for way in (0.2, 0.6, 1.0, 0.7, 0.1, 0.9)]
        assert asked == [(), (action,), (), (), (), (action,)]
