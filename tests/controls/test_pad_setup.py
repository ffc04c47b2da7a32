"""`kitemj pad`: the questions by themselves, then asked of a virtual pad, then flown with."""

import io
import itertools
import os
import sys
import time
from queue import SimpleQueue

import pygame
import pytest

from kitemj.cli import main
from kitemj.controls import pad_setup
from kitemj.controls.pad_layout import Layout, PadSource
from kitemj.controls.pad_setup import HOLD, QUESTIONS, Questions, Reading, moved
from kitemj.controls.pad_terminal import ask, state_text
from kitemj.controls.pads import events
from kitemj.controls.settings import read_settings, write_layout
from kitemj.controls.stick import PersonStick
from kitemj.errors import InputError
from kitemj.physics.parameter_files import parameter_set
from tests.controls.virtual_pad import OddPad, VirtualPad

REST = Reading((0.0, 0.0, -1.0), (0, 0, 0, 0), ((0, 0),))
"""Axis 2 is a trigger."""


def axis(number, value):
    axes = list(REST.axes)
    axes[number] = value
    return REST._replace(axes=tuple(axes))


def pressed(*numbers):
    return REST._replace(buttons=tuple(int(i in numbers) for i in range(4)))


def hat(x, y):
    return REST._replace(hats=((x, y),))


class Person:
    """Holds things long enough, then lets go."""

    def __init__(self):
        self.questions, self._t = Questions(REST), 0.0
        self.questions.see(self._t, REST)

    def hold(self, reading, seconds=2 * HOLD):
        said = []
        until = self._t + seconds
        while self._t < until:
            said.append(self.questions.see(self._t, reading))
            self._t += 0.05
        said.append(self.questions.see(self._t, REST))
        return "".join(said)

    def go_on_to(self, key):
        while self.questions.asked.key != key:
            self.questions.skip()


@pytest.fixture
def person():
    return Person()


def test_what_moved():
    assert moved(REST, REST) is None
    assert moved(REST, axis(0, 0.4)) is None
    assert moved(REST, axis(0, -0.8)) == PadSource("axis", 0, sign=-1)
    assert moved(REST, axis(2, 0.5)) == PadSource("axis", 2)
    assert moved(REST, hat(0, -1)) == PadSource("hat", 0, 1, -1)
    assert moved(REST, pressed(3)) == PadSource("button", 3)
    slanting = REST._replace(axes=(0.6, -0.9, -1.0))
    assert moved(REST, slanting) == PadSource("axis", 1, sign=-1)


def test_a_trigger_that_is_a_button_too():
    both = axis(2, 1.0)._replace(buttons=(0, 1, 0, 0))
    assert moved(REST, both).kind == "axis"
    assert moved(REST, both, button=True) == PadSource("button", 1)


def test_sticks_hats_and_buttons_make_a_layout(person):
    assert person.questions.asked == QUESTIONS[0]
    assert person.hold(axis(1, -1.0)) == "steer is -axis 1"
    assert person.hold(hat(0, 1)) == "reel is hat 0 y"
    person.questions.skip()
    assert person.hold(axis(0, 1.0)) == "right_line is axis 0"
    assert person.hold(pressed(2)) == "restart is button 2"
    person.go_on_to("pause")
    assert person.hold(axis(2, 1.0)) == "pause is axis 2"
    person.go_on_to(QUESTIONS[-1].key)
    person.questions.skip()
    assert person.questions.asked is None
    assert person.questions.layout("mine") == Layout(
        "mine",
        steer=PadSource("axis", 1, sign=-1),
        reel=PadSource("hat", 0, 1),
        right_line=PadSource("axis", 0),
        buttons={"restart": PadSource("button", 2), "pause": PadSource("axis", 2)},
    )


def test_a_short_touch_does_not_count(person):
    assert person.hold(axis(0, 1.0), HOLD / 2) == ""
    assert person.questions.asked.key == "steer"


def test_nothing_counts_until_all_is_let_go(person):
    for reading in (axis(0, 1.0), pressed(1)):
        for i in range(20):
            person.questions.see(i * 0.1, reading)
    assert person.questions.asked.key == "reel"
    assert person.questions.layout("").steer == PadSource("axis", 0)


def test_what_is_held_at_the_start_does_not_count():
    questions = Questions(REST)
    assert [questions.see(i * 0.1, pressed(0)) for i in range(20)] == [""] * 20


def test_a_trigger_is_no_stick(person):
    assert "does not rest in the middle" in person.hold(axis(2, 1.0))
    assert person.questions.asked.key == "steer"


def test_two_buttons_for_a_way(person):
    assert person.hold(pressed(3)) == "button 3 it is"
    assert person.questions.asked.text == pad_setup.BACK
    assert "cannot be the opposite of button 3" in person.hold(pressed(3))
    assert "cannot be the opposite of button 3" in person.hold(axis(0, 1.0))
    assert person.hold(pressed(1)) == "steer is buttons 1 3"
    person.go_on_to("restart")
    assert "button 3 is for steer already" in person.hold(pressed(3))


def test_a_button_means_one_thing(person):
    assert person.hold(axis(0, 1.0)) == "steer is axis 0"
    person.go_on_to("restart")
    assert "axis 0 is for steer already" in person.hold(axis(0, 1.0))
    assert "-axis 0 is for steer already" in person.hold(axis(0, -1.0))
    assert person.hold(hat(0, 1)) == "restart is hat 0 y"
    assert "hat 0 y is for restart already" in person.hold(hat(0, 1))
    assert person.hold(hat(0, -1)) == f"{QUESTIONS[5].key} is -hat 0 y"


@pytest.fixture
def bench(monkeypatch):
    """SDL without a window, quick questions, no pads."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    monkeypatch.setenv("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1")
    monkeypatch.setattr(pad_setup, "HOLD", 0.05)
    looks, sleep = itertools.count(), time.sleep

    def patient(seconds):
        assert next(looks) < 1000, "the questions do not end"
        sleep(seconds)

    monkeypatch.setattr(time, "sleep", patient)
    pygame.display.init()
    pygame.joystick.init()
    yield
    pygame.joystick.quit()
    pygame.display.quit()


def answers(pad):
    """What a person does at each question's first words."""
    return {
        "push the left stick": (lambda: pad.axis(3, -1.0), lambda: pad.axis(3, 0.0)),
        "push the right stick": (lambda: pad.hat(0, 0, 1), lambda: pad.hat(0, 0, 0)),
        "press the button that is to mean: restart": (
            lambda: pad.button(6, True),
            lambda: pad.button(6, False),
        ),
    }


class Obedient:
    """Reads what is told; does what is asked, skips what it does not know."""

    def __init__(self, pad, skip):
        self._answers, self._skip, self._undo = answers(pad), skip, None
        self.read = []

    def tell(self, text):
        self.read.append(text)
        if self._undo:
            self._undo()
            self._undo = None
        if not text.strip().endswith("..."):
            return
        for beginning, (do, undo) in self._answers.items():
            if text.startswith(beginning):
                do()
                self._undo = undo
                return
        self._skip()


EXPECTED = Layout(
    "odd pad",
    steer=PadSource("axis", 3, sign=-1),
    reel=PadSource("hat", 0, 1),
    buttons={"restart": PadSource("button", 6)},
)


def test_a_person_is_asked_with_the_pad_in_the_hand(bench):
    pad, typed = OddPad(), SimpleQueue()
    pygame.event.pump()
    joystick = pygame.joystick.Joystick(0)
    obedient = Obedient(pad, lambda: typed.put(""))
    ticks = itertools.count()
    clock = lambda: next(ticks) * 0.03  # noqa: E731
    assert ask(joystick, Reading.of(joystick), typed, obedient.tell, clock) == EXPECTED
    assert "    steer is -axis 3" in obedient.read


def test_a_pad_that_goes_is_a_sentence(bench):
    pad = OddPad()
    events()
    joystick = pygame.joystick.Joystick(0)
    with pytest.raises(InputError, match="the pad odd pad is gone; nothing was written"):
        ask(joystick, Reading.of(joystick), SimpleQueue(), lambda _: pad.unplug())


class Terminal(io.StringIO):
    """Standard output that a person reads line by line."""

    def __init__(self, tell):
        super().__init__()
        self._tell = tell

    def write(self, text):
        if text.strip():
            self._tell(text)
        return super().write(text)


@pytest.fixture
def keyboard(monkeypatch):
    """A function that types lines into the command's standard input."""
    end, begin = os.pipe()
    with open(end, encoding="utf-8") as reader:  # noqa: PTH123
        monkeypatch.setattr(sys, "stdin", reader)
        yield lambda line: os.write(begin, f"{line}\n".encode())
        os.close(begin)
        time.sleep(0.05)  # for the thread that reads to see the end


def test_the_command_writes_a_layout_that_flies(bench, tmp_path, monkeypatch, keyboard):
    path, pad = tmp_path / "settings.toml", OddPad()
    obedient = Obedient(pad, lambda: keyboard(""))
    monkeypatch.setattr(sys, "stdout", Terminal(obedient.tell))
    assert main(["pad", "--settings", str(path)]) == 0
    settings = read_settings(path)
    assert list(settings.pads.values()) == [EXPECTED]
    pygame.display.init()
    pygame.display.set_mode((200, 100))
    person = PersonStick(settings, parameter_set("sport"))
    pad = OddPad()  # the command has let go of SDL, and SDL of the other
    pad.axis(3, -1.0)
    pad.button(6, True)
    actions = [name for event in events() for name in person.handle(event)]
    assert actions == ["restart"]
    assert person.command(None).delta == 1.0
    person.close()


def test_of_several_pads_the_touched_one_is_asked_about(bench, tmp_path, monkeypatch, keyboard):
    path, other, pad = tmp_path / "settings.toml", VirtualPad("other"), OddPad()
    obedient = Obedient(pad, lambda: keyboard("d"))

    def tell(text):
        if text.startswith("2 pads"):
            pad.button(0, True)
        elif text.startswith("the pad"):
            pad.button(0, False)
        obedient.tell(text)

    monkeypatch.setattr(sys, "stdout", Terminal(tell))
    assert main(["pad", "--settings", str(path)]) == 0
    assert [layout.name for layout in read_settings(path).pads.values()] == ["odd pad"]
    assert read_settings(path).pads.popitem()[1] == EXPECTED._replace(buttons={})
    del other


@pytest.mark.parametrize("words", [[], ["--list"], ["--show"]])
def test_no_pad_is_a_sentence(bench, capsys, words, tmp_path):
    assert main(["pad", *words, "--settings", str(tmp_path / "none.toml")]) == 2
    assert "there is no gamepad: plug one in" in capsys.readouterr().err


def test_a_damaged_file_is_refused_before_anything_is_asked(bench, tmp_path, capsys):
    path, pad = tmp_path / "settings.toml", OddPad()
    path.write_text("dead_zone = 7")
    assert main(["pad", "--settings", str(path)]) == 2
    out, err = capsys.readouterr()
    assert "dead_zone must be <= 0.5, got 7" in err
    assert "--overwrite" in err
    assert out == ""
    assert path.read_text() == "dead_zone = 7"
    del pad


def test_the_list_says_who_knows_each_pad(bench, tmp_path, capsys):
    path, pads = tmp_path / "settings.toml", [VirtualPad("one"), OddPad("two"), OddPad("three")]
    pygame.event.pump()
    guids = [pygame.joystick.Joystick(i).get_guid() for i in range(3)]
    write_layout(path, guids[2], EXPECTED)
    assert main(["pad", "--list", "--settings", str(path)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines == [
        f"one  {guids[0]}  SDL knows it",
        f"two  {guids[1]}  no layout: run kitemj pad",
        f"three  {guids[2]}  layout in {path}",
    ]
    del pads


def test_what_a_pad_says_now(bench):
    pad = OddPad()
    joystick = pygame.joystick.Joystick(0)
    pad.axis(3, -0.5)
    pad.button(6, True)
    pad.hat(0, 1, -1)
    pygame.event.pump()
    text = state_text(joystick, EXPECTED)
    assert "2: -1.00  3: -0.50" in text
    assert "buttons  6" in text
    assert "0: +1 -1" in text
    assert "steer +0.50  reel -1.00  left_line +0.00  right_line +0.00  restart" in text


def test_showing_ends_with_ctrl_c(bench, monkeypatch, capsys, tmp_path):
    pad, looks = OddPad(), itertools.count()

    def interrupt(_):
        if next(looks) == 3:
            raise KeyboardInterrupt

    monkeypatch.setattr(time, "sleep", interrupt)
    assert main(["pad", "--show", "--settings", str(tmp_path / "none.toml")]) == 0
    assert "odd pad" in capsys.readouterr().out
    del pad
