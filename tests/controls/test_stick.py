"""What hands ask of the lines: one stick, a stick for each line, keys, mouse, programmes."""

from pathlib import Path

import pygame
import pytest

from kitemj.controls.held_keys import BACK, LONGEST, RISE, USUAL, HeldKeys
from kitemj.controls.pads import events
from kitemj.controls.programmed import (
    ProgrammedStick,
    Row,
    read_programmed_stick,
    show,
)
from kitemj.controls.settings import Feel, Settings
from kitemj.controls.stick import PersonStick, PilotStick
from kitemj.controls.stick_mapping import Deflections, command_of, one_line_each
from kitemj.errors import InputError
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.shaping import StickLaw
from kitemj.physics.steering import Control, line_motion, rest_ell
from kitemj.pilots.manoeuvres import Hold
from kitemj.pilots.sight import Twist
from tests.controls.virtual_pad import VirtualPad

STICKS = Path(__file__).parents[2] / "scenarios" / "sticks"
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
    monkeypatch.setenv("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1")
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


class Clock:
    """Wall time [s] that passes when the test says so."""

    def __init__(self):
        self.now = 0.0

    def __call__(self):
        return self.now


def seated(settings=Settings(), parameters=SPORT):  # noqa: B008
    """A person whose keys have a clock of the test's."""
    person = PersonStick(settings, parameters)
    person.clock = Clock()
    person._keys = HeldKeys(person.clock)
    return person


def after(person, seconds, frames=30):
    """The command after so long [s], looked at in each of so many frames."""
    for _ in range(frames):
        person.clock.now += seconds / frames
        command = person.command(None)
    return command


@pytest.fixture
def person(desk):
    person = seated()
    yield person
    person.close()


def test_keys_steer_while_they_are_held(person, desk):
    desk.update({pygame.K_d, pygame.K_DOWN})
    assert after(person, 1.0) == Command(USUAL, -USUAL)
    assert person.name == "keys"
    desk.add(pygame.K_LSHIFT)
    assert after(person, 1.0) == Command(1.0, -1.0)
    desk.clear()
    assert after(person, 1.0) == Command(0.0, 0.0)


@pytest.mark.parametrize("frames", [3, 4, 7, 30])
def test_a_key_is_a_ramp_at_every_frame_rate(person, desk, frames):
    """Half of the way in half of the time; back at once; the other way through the centre."""
    desk.add(pygame.K_RIGHT)
    assert after(person, RISE / 2, frames).delta == pytest.approx(USUAL / 2)
    assert after(person, RISE / 2, frames).delta == pytest.approx(USUAL)
    desk.clear()
    assert after(person, BACK / 2, frames).delta == pytest.approx(USUAL / 2)
    desk.add(pygame.K_LEFT)
    turned = after(person, BACK / 2 + RISE / 4, frames).delta
    assert turned == pytest.approx(-USUAL / 4)
    desk.add(pygame.K_LSHIFT)
    assert after(person, RISE, frames).delta == -1.0


def test_a_window_that_did_not_answer_moves_no_key_all_the_way(person, desk):
    desk.add(pygame.K_RIGHT)
    assert after(person, 10.0, frames=1).delta == pytest.approx(USUAL * LONGEST / RISE)


def test_held_keys_go_before_the_pad_and_give_the_kite_back(person, desk):
    pad = VirtualPad()
    pad.left_stick(-1.0)
    for event in events():
        person.handle(event)
    desk.add(pygame.K_RIGHT)
    assert after(person, 1.0).delta == USUAL
    desk.clear()
    assert after(person, 1.0).delta == -1.0


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
    assert after(person, 1.0) == Command(USUAL, 0.0, StickLaw.ACCELERATION)


def test_settings_say_how_a_flight_begins(desk):
    person = PersonStick(Settings(Feel(two_sticks=True), StickLaw.RATE), SPORT)
    assert (person.law, person.two_sticks) == (StickLaw.RATE, True)
    person.close()


def test_the_assist_goes_on_and_off_and_says_so(person):
    assert not person.assist
    person.change("assist")
    assert person.assist
    assert person.message.startswith("the assist flies")
    person.change("assist")
    assert not person.assist
    assert "the stick moves the lines" in person.message


def test_a_kite_that_drifts_has_no_assist(desk):
    person = seated(Settings(assist="always"), THESIS)
    assert not person.assist
    person.change("assist")
    assert not person.assist
    assert "no assist for this kite" in person.message
    person.close()


def test_keys_of_each_hand_pull_a_line(person, desk):
    person.two_sticks, person.law = True, StickLaw.RATE
    desk.add(pygame.K_s)  # the left hand pulls: A₊ comes nearer
    half = one_line_each(SPORT, USUAL / 2, 0.0)
    assert after(person, RISE / 2)[:2] == pytest.approx(half[:2])
    assert after(person, 1.0) == one_line_each(SPORT, USUAL, 0.0)
    desk.clear()
    desk.add(pygame.K_UP)  # the right hand gives line
    assert after(person, 1.0) == one_line_each(SPORT, 0.0, -USUAL)
    assert person.command(None).law is StickLaw.ANGLE


@pytest.mark.parametrize("parameters", [SPORT, THESIS], ids=["sport", "thesis"])
@pytest.mark.parametrize(("left", "right"), [(0.0, 0.6), (1.0, -1.0), (0.3, 0.7), (-1.0, -1.0)])
def test_each_stick_asks_for_its_own_line(parameters, left, right):
    limits, y_A, length = parameters.stick, parameters.kite.y_A, parameters.lines.length
    command = one_line_each(parameters, left, right)
    ell = rest_ell(length, y_A) + command.ell * limits.ell
    asked = Control(ell, 0.0, 0.0, command.delta * limits.delta, 0.0, 0.0)
    plus, minus = (line_motion(y_A, asked, side).length for side in (1.0, -1.0))
    assert plus == pytest.approx(length - limits.arm * left, abs=ROUNDING)
    assert minus == pytest.approx(length - limits.arm * right, abs=ROUNDING)


def test_the_right_stick_flies_by_its_line():
    """L₋ follows, L₊ stays, as nearly as a tick of constant acceleration can."""
    flight = SteeredFlight(scenario_of({"set": "sport", "duration": 60.0}, "test"))
    for _ in range(150):
        flight.tick(one_line_each(SPORT, 0.0, 0.6))
    limits = SPORT.stick
    grain = TICK**2 / 4 * (limits.ell_ddot + SPORT.kite.y_A * limits.delta_ddot)
    left, right = flight.kite.motion(flight.segment).lengths
    assert right == pytest.approx(25.0 - 0.6 * 0.25, abs=grain)
    assert left == pytest.approx(25.0, abs=grain)


def test_arms_longer_than_the_kite_is_wide_go_as_far_as_the_set_allows():
    long = SPORT._replace(stick=SPORT.stick._replace(arm=2.0))
    assert one_line_each(long, -1.0, 1.0) == Command(1.0, 0.0)
    assert one_line_each(long, 1.0, -1.0) == Command(-1.0, 0.0)


def test_a_mirrored_kite_goes_where_the_stick_points(desk):
    """But two sticks are two hands, and a pilot knows the kite."""
    assert THESIS.stick.mirrored
    assert not SPORT.stick.mirrored
    person = seated(parameters=THESIS)
    desk.add(pygame.K_RIGHT)
    assert after(person, 1.0).delta == -USUAL
    person.close()
    table = [Row(0.0, 0.5)]
    assert ProgrammedStick(table, THESIS).command(At(1.0)).delta == -0.5
    assert ProgrammedStick(table, SPORT).command(At(1.0)).delta == 0.5
    pull = Deflections(right=1.0)
    assert command_of(pull, THESIS, StickLaw.ANGLE, True).delta > 0
    motion = SteeredFlight(scenario_of({"set": "sport", "duration": 1.0}, "test")).result.motion
    assert PilotStick(Hold()).command(motion) == Hold().command(motion)


def test_a_programme_holds_its_rows_and_its_buttons_once():
    rows = [Row(1.0, 0.5, buttons=("law", "view")), Row(2.0, -0.5, buttons=("restart",))]
    stick = ProgrammedStick(rows, SPORT)
    deltas = [stick.command(At(t)).delta for t in (0.0, 0.99, 1.0, 1.99, 2.0, 99.0)]
    assert deltas == [0.0, 0.0, 0.5, 0.5, -0.5, -0.5]
    assert stick.actions(0.99) == ()
    assert stick.actions(1.0) == ("law", "view")
    assert stick.actions(1.5) == ()
    assert stick.actions(0.0) == ()  # a clock that began anew
    assert stick.actions(5.0) == ("restart",)


def test_the_show_begins_anew_after_its_period():
    stick = show(THESIS)
    assert [stick.command(At(t)).delta for t in (3.0, 13.0, 43.0)] == [-1.0, 1.0, -1.0]


def table(folder, text):
    path = folder / "stick.csv"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_table_of_one_stick(tmp_path):
    path = table(
        tmp_path,
        "# a turn\n\nt, steer, reel, law, buttons\n0,0.5,0,,\n"
        "1.5,,-1,rate,\n2,-1,0,angle,restart; two sticks\n",
    )
    stick = read_programmed_stick(path, SPORT)
    assert stick.command(At(1.0)) == Command(0.5, 0.0)
    assert stick.command(At(1.5)) == Command(0.5, -1.0, StickLaw.RATE)
    assert stick.command(At(3.0)) == Command(-1.0, 0.0, StickLaw.ANGLE)
    assert stick.actions(2.0) == ("restart", "two sticks")


def test_a_table_of_a_stick_for_each_line(tmp_path):
    stick = read_programmed_stick(table(tmp_path, "t,left,right\n0,0.2,1\n"), THESIS)
    assert stick.command(At(0.0)) == one_line_each(THESIS, 0.2, 1.0)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("t,stear\n0,1", "stear is not known: did you mean 'steer'?"),
        ("steer\n1", "t among them"),
        ("", "t among them"),
        ("t,steer\n", "t among them"),
        ("t,steer,left\n0,0,0", "steer and reel, or left and right, not both"),
        ("t,steer\n0,0\n2,1\n2,0", "t must ascend: 2 s after 2 s"),
        ("t,steer\n0,1.5", "steer must be in -1..1, got 1.5"),
        ("t,steer\n0,nan", "steer must be in -1..1, got nan"),
        ("t,steer\n-1,0", "t must be >= 0 s, got -1 s"),
        ("t,steer\ninf,0", "t must be >= 0 s, got inf s"),
        ("t,steer\n0,right", "steer must be a number, got 'right'"),
        ("t,steer\n,1", "t is missing"),
        ("t,steer\n0", "1 cells where the first line names 2 columns"),
        ("t,law\n0,speed", "law must be one of angle, rate, acceleration, got 'speed'"),
        ("t,buttons\n0,restrat", "buttons.restrat is not known: did you mean 'restart'?"),
    ],
)
def test_tables_that_are_none(tmp_path, text, says):
    with pytest.raises(InputError) as error:
        read_programmed_stick(table(tmp_path, text), SPORT)
    assert says in str(error.value)
    assert "stick.csv" in str(error.value)
    assert "\n" not in str(error.value)


def test_the_stick_that_ships_flies_its_loop():
    """Ten seconds after it, the kite has turned once and is still aloft."""
    stick = read_programmed_stick(STICKS / "loop_right.csv", SPORT)
    flight, twist = SteeredFlight(scenario_of({"set": "sport", "duration": 60.0}, "test")), Twist()
    for _ in range(1200):
        flight.tick(stick.command(flight.result.motion))
        turns = twist.look(flight.result.motion)
        assert flight.result.departure is None
    assert turns == pytest.approx(1.0, abs=0.25)
    assert stick.actions(12.0) == ("view",)


def test_barely_pushed_the_other_way_the_lines_go_there(tmp_path):
    """At 0.16 s δ̇ is 10 µrad/s: to the limit on that side it would be three hours."""
    rows = "t,steer,law\n0.00,-0.16,acceleration\n0.10,0.27,acceleration\n"
    laksa = parameter_set("laksa")  # its stick is mirrored
    stick = read_programmed_stick(table(tmp_path, rows), laksa)
    flight = SteeredFlight(scenario_of({"set": "laksa", "duration": 60.0}, "test"))
    for _ in range(30):
        flight.tick(stick.command(flight.result.motion))
    most = laksa.stick.delta_ddot
    asked = 0.16 * most * 0.1 - 0.27 * most * 0.2  # rad/s
    assert flight.result.motion.control.delta_dot == pytest.approx(asked, abs=ROUNDING)


def test_a_table_that_is_not_there(tmp_path):
    with pytest.raises(InputError, match=r"cannot read .*none\.csv: there is no such file"):
        read_programmed_stick(tmp_path / "none.csv", SPORT)
