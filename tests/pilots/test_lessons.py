"""The lessons: flown by pilots, by tables, by a pupil who does what is said; not by luck."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from itertools import compress
from math import atan2, copysign, cos, degrees, pi, radians, sin
from random import Random

import numpy as np
import pytest

from kitemj.controls.held_keys import USUAL, Ramp
from kitemj.dynamics.motion import Motion, State
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.pilots import manoeuvres as pilots
from kitemj.pilots.advice import Advice
from kitemj.pilots.assist import Assist
from kitemj.pilots.course import BLINK, LESSONS, PRAISED, Course
from kitemj.pilots.crash import FirstTouch
from kitemj.pilots.lessons import OUT, Eight
from kitemj.pilots.manoeuvres import steer
from kitemj.pilots.pupil import Reaction
from kitemj.pilots.sight import Observation, Sight, sight, turned

KEYS = [entry.key for entry in LESSONS]
WINDS = (5.0, 6.5, 8.0)
STEP = 0.005
"""s; MuJoCo and Lagrange stay within 0.1 mm over a loop: no verdict hangs on that."""
FRAME = 3
"""Ticks between frames at a good 30 a second."""

Stick = Callable[[Motion], float]


def only(key: str, flight: SteeredFlight) -> Course:
    """A course of which one lesson is left."""
    return Course(flight.parameters, [other for other in KEYS if other != key])


def live(wind: float = 6.5, model: str = "lagrange") -> SteeredFlight:
    """A flight that begins at the top."""
    scenario = scenario_of({"set": "sport", "duration": 60.0, "wind": {"speed": wind}}, "test")
    return SteeredFlight(scenario, model, step=STEP)


def aside() -> SteeredFlight:
    """A flight that begins off to the left."""
    scenario = live().scenario
    q, q_dot = scenario.start
    start = State(q._replace(eta=q.eta + 0.3), q_dot)
    return SteeredFlight(replace(scenario, start=start), "lagrange", step=STEP)


def flown(flight: SteeredFlight, stick: Stick, duration: float = 40.0) -> list[Motion]:
    """All motions until the ground or the end."""
    motions, ground = [flight.restart().motion], FirstTouch(flight.parameters)
    while motions[-1].t < duration - TICK / 2 and not ground.watch(motions[-1]):
        motions.append(flight.tick(Command(stick(motions[-1]))).motion)
    return motions


def passed_at(course: Course, motions: Iterable[Motion]) -> float | None:
    """When the last lesson was passed [s]; None: never."""
    for motion in motions:
        course.watch(motion)
        if not course.lesson:
            return motion.t
    return None


def piloted(pilot: pilots.Pilot) -> Stick:
    return lambda motion: pilot.command(motion).delta


class Turner:
    """Off to one side and back, as the turning lesson wants it."""

    def __init__(self, side: float) -> None:
        self._side, self._aside = side, False

    def command(self, motion: Motion) -> Command:
        seen, side = sight(motion), self._side
        self._aside |= min(side * seen.azimuth / 0.3, side * seen.heading / 0.85) > 1
        if self._aside:
            return pilots.Hold().command(motion)
        return steer(motion, turned(side * radians(70.0) - seen.heading, side))


class Returner:
    """Out to the right and home again."""

    def __init__(self) -> None:
        self._out = False

    def command(self, motion: Motion) -> Command:
        seen = sight(motion)
        self._out |= degrees(seen.azimuth) > OUT
        if self._out:
            return pilots.Hold().command(motion)
        return steer(motion, turned(radians(60.0) - seen.heading))


PILOTS: dict[str, Callable[[], pilots.Pilot]] = {
    "top": Returner,
    "turn-left": lambda: Turner(-1.0),
    "turn-right": lambda: Turner(1.0),
    "loop-left": lambda: pilots.Loop(-1.0),
    "loop-right": lambda: pilots.Loop(1.0),
    "eight": pilots.Eight,
    "land": pilots.Land,
}

Rows = tuple[tuple[float, float], ...]
TURN: Rows = ((0.25, 0.4), (1.48, 0.2), (1.88, 0.0), (2.28, -0.4), (3.57, -0.2), (4.02, 0.0))
LOOP: Rows = ((0.25, 1.0), (2.81, 0.0), (3.3, -0.2), (3.85, 0.0))
EIGHT: Rows = (
    *((0.25, 0.4), (2.16, 0.2), (2.57, -0.4), (5.91, -0.2), (6.31, 0.0), (6.72, 0.4)),
    *((7.52, 0.2), (7.93, 0.4), (9.27, 0.2), (10.46, 0.0), (11.28, -0.4), (13.0, -0.2)),
    *((13.71, -0.4), (14.19, -0.2), (14.59, 0.0)),
)
TOP: Rows = (
    *((0.0, 0.4), (1.6, 0.0), (2.0, -0.4), (4.0, -0.2), (4.4, 0.4), (6.0, 0.2), (6.4, 0.0)),
    *((6.8, -0.2), (7.2, -0.4), (8.0, 0.0), (8.4, 0.4), (9.6, 0.0), (10.0, -0.4), (11.2, -0.2)),
    (11.6, 0.2),
)
LAND: Rows = (
    *((0.25, 0.4), (2.0, 0.2), (2.41, 0.0), (2.82, -0.2), (3.34, 0.0), (4.46, -0.2)),
    *((4.9, 0.0), (5.31, 0.2), (5.72, 0.0), (6.12, -0.2), (6.65, 0.0), (7.06, 0.2)),
    *((7.47, 0.0), (7.87, -0.2), (8.47, 0.0), (8.87, 0.2), (9.3, 0.0), (9.7, -0.2)),
)


def other_way(rows: Rows) -> Rows:
    return tuple((t, -delta) for t, delta in rows)


TABLES: dict[str, Rows] = {
    "top": TOP,
    "turn-left": other_way(TURN),
    "turn-right": TURN,
    "loop-left": other_way(LOOP),
    "loop-right": LOOP,
    "eight": EIGHT,
    "land": LAND,
}
"""From when [s] the stick is where, in 6.5 m/s: what a pupil did, written down."""


def table(rows: Rows) -> Stick:
    full = ((0.0, 0.0), *rows)
    return lambda motion: [delta for t, delta in full if motion.t >= t - TICK / 2][-1]


# what passes


@pytest.mark.parametrize("wind", WINDS)
@pytest.mark.parametrize("key", KEYS)
def test_a_pilot_passes_and_the_verdict_is_the_same_at_every_rate(key: str, wind: float) -> None:
    flight = live(wind)
    motions = flown(flight, piloted(PILOTS[key]()))
    every = passed_at(only(key, flight), motions)
    assert every is not None
    shown = flown_at_frames(motions)
    assert passed_at(only(key, flight), shown) == pytest.approx(every, abs=2 * FRAME * TICK)
    seen = np.random.default_rng(1).random(len(shown)) < 0.3  # a machine that is busy
    seen[[0, -1]] = True
    dropped = passed_at(only(key, flight), compress(shown, seen))
    assert dropped == pytest.approx(every, abs=0.5)


def flown_at_frames(motions: list[Motion]) -> list[Motion]:
    """What a screen shows of them; the last moment, which stays, in any case."""
    return [*motions[:-1:FRAME], motions[-1]]


@pytest.mark.parametrize("key", KEYS)
def test_a_table_of_the_stick_passes(key: str) -> None:
    flight = live(model="mujoco")
    assert passed_at(only(key, flight), flown(flight, table(TABLES[key]), 20.0)) is not None


class Follower:
    """Holds the key that the course points to, `late` [s] after it said so, give or take."""

    def __init__(self, course: Course, late: float, assist: bool, seed: int = 1) -> None:
        self.course, self._assist, self._pilot = course, assist, Assist()
        self._hands, self._ramp = Reaction(Random(seed), late), Ramp()

    def command(self, motion: Motion) -> Command:
        if round(motion.t / TICK) % FRAME == 0:
            self.course.watch(motion, assist=self._assist)
            self._assist &= "press H" not in self.course.status.advice
        push = self._hands.after(self.course.status.push, motion.t)
        full = 1.0 if abs(push) > 0.9 else USUAL  # with Shift
        self._pilot.hand = self._ramp.move(copysign(full, push) if push else 0.0, TICK)
        return self._pilot.command(motion) if self._assist else Command(self._pilot.hand)


def course_flown(
    kite: str, wind: float, late: float, assist: bool, passed: Iterable[str] = ()
) -> tuple[Course, int]:
    """A whole course, flown with a restart for each flight, and how many there were."""
    scenario = scenario_of({"set": kite, "duration": 60.0, "wind": {"speed": wind}}, "test")
    flight = SteeredFlight(scenario, "mujoco", step=STEP)
    course, flights = Course(flight.parameters, [*passed]), 0
    while course.lesson and flights < 6:  # a landing and a few crashes are allowed for
        stick = Follower(course, late, assist, flights)
        course.watch(flown(flight, piloted(stick), 60.0)[-1])
        flights += 1
    return course, flights


@pytest.mark.parametrize("late", [0.25, 0.4, 0.6])
@pytest.mark.parametrize("kite", ["sport", "trainer"])
def test_slow_hands_that_follow_the_arrows_pass_with_the_assist(kite: str, late: float) -> None:
    """All but the landing, which the assist refuses, in one flight."""
    course, flights = course_flown(kite, 6.5, late, assist=True, passed=["land"])
    assert course.passed == set(KEYS)
    assert flights == 1
    assert course.status.progress == 1.0


def test_in_the_weakest_wind_a_kite_that_rights_itself_gets_out_to_the_side() -> None:
    course, _ = course_flown("trainer", WINDS[0], 0.25, assist=True, passed=KEYS[1:])
    assert course.passed == set(KEYS)


@pytest.mark.parametrize(("late", "wind"), [(0.25, 6.5), (0.4, 5.0), (0.6, 8.0)])
def test_slow_hands_land_with_the_assist_switched_off_when_they_are_told_to(
    late: float, wind: float
) -> None:
    course, flights = course_flown("sport", wind, late, assist=True, passed=KEYS[:-1])
    assert course.passed == set(KEYS)
    assert flights <= 5


# what does not


@pytest.mark.parametrize("wind", WINDS)
def test_a_stick_that_does_nothing_passes_none(wind: float) -> None:
    flight = live(wind)
    motions = flown(flight, lambda motion: 0.0, 90.0)
    assert motions[-1].t == pytest.approx(90.0), "it stays aloft"
    for lesson in KEYS:
        assert passed_at(only(lesson, flight), motions[:: 2 * FRAME]) is None, lesson


def test_who_begins_at_the_side_has_not_flown_there() -> None:
    flight = aside()
    motions = flown(flight, piloted(pilots.Hold()), 20.0)
    assert degrees(abs(sight(motions[0]).azimuth)) > OUT
    assert degrees(abs(sight(motions[-1]).azimuth)) < 1.0
    assert passed_at(only("top", flight), motions) is None


@pytest.mark.parametrize("key", ["turn-left", "turn-right", "loop-left", "loop-right"])
def test_the_other_way_does_not_pass(key: str) -> None:
    flight = live()
    motions = flown(flight, table(other_way(TABLES[key])), 30.0)
    assert passed_at(only(key, flight), motions) is None
    held = 1.0 if key.endswith("left") else -1.0
    assert passed_at(only(key, flight), flown(flight, lambda motion: held)) is None


def test_a_loop_that_shows_its_nose_to_the_left_is_no_turn_to_the_left() -> None:
    flight = aside()  # out on the left, where a loop to the right stays for its first half
    motions = flown(flight, piloted(pilots.Loop(1.0)), 20.0)
    left = [m for m in motions if -2.6 < sight(m).heading < -0.8 and sight(m).azimuth < -0.3]
    assert left
    assert passed_at(only("turn-left", flight), motions[10:]) is None


def test_a_loop_is_no_turn() -> None:
    flight = live()
    motions = flown(flight, piloted(pilots.Loop(-1.0)), 15.0)
    assert passed_at(only("loop-left", flight), motions)
    assert passed_at(only("turn-left", flight), motions) is None


class Wiggle:
    """To and fro about the middle, the nose never far from up."""

    def __init__(self) -> None:
        self._side, self.crossed = 1.0, 0

    def command(self, motion: Motion) -> Command:
        seen = sight(motion)
        if self._side * seen.azimuth > radians(5.0):
            self._side, self.crossed = -self._side, self.crossed + 1
        return steer(motion, turned(self._side * radians(30.0) - seen.heading))


@pytest.mark.parametrize("wind", WINDS)
def test_a_wiggle_is_no_eight(wind: float) -> None:
    flight, pilot = live(wind), Wiggle()
    motions = flown(flight, piloted(pilot), 30.0)
    assert pilot.crossed > 5
    assert passed_at(only("eight", flight), motions) is None


def drawn(eight: bool, size: float, way: float) -> list[Advice]:
    """What is said of an eight or a circle, `size` [rad] to each side of the middle."""
    lesson, motion, said, twist = Eight(), live().restart().motion, [], 0.0
    before = None
    for s in np.arange(-1.2, 4 * pi, 0.05):
        high, dy = (sin(2 * s), 2 * cos(2 * s)) if eight else (-2 * cos(s), 2 * sin(s))
        heading = way * atan2(size * cos(s), 0.14 * dy)
        twist += turned(heading - before) / (2 * pi) if before is not None else 0.0
        before = heading
        seen = Sight(way * size * sin(s), radians(45.0) + 0.14 * high, heading, 0.0)
        said.append(lesson.watch(Observation(motion._replace(t=float(s)), seen, 0.0, twist, 0.0)))
    return said


@pytest.mark.parametrize("way", [-1.0, 1.0])
def test_an_eight_is_wide_enough_and_no_circle(way: float) -> None:
    assert max(advice.progress for advice in drawn(True, radians(25.0), way)) == 1.0
    assert max(advice.progress for advice in drawn(True, radians(12.0), way)) < 1.0
    circles = drawn(False, radians(25.0), way)
    assert max(advice.progress for advice in circles) < 1.0
    assert circles[-1].text.startswith("That was a circle, not an eight")


@pytest.mark.parametrize("held", [-1.0, -0.5, -0.2, 0.2, 0.5, 1.0])
def test_a_stick_that_is_only_held_passes_none(held: float) -> None:
    flight = live()
    motions = flown(flight, lambda motion: held)
    for key in KEYS[1:]:
        assert passed_at(only(key, flight), motions) is None, key


def test_chance_does_not_hold_loop_or_land() -> None:
    """Eights and turns do happen to a stick that is thrown about; of these there is none."""
    flight = live()
    for seed in range(8):
        pushes = np.random.default_rng(seed).uniform(-1.0, 1.0, 100)
        motions = flown(flight, lambda motion, p=pushes: float(p[int(motion.t / 0.5)]))
        for key in ("top", "loop-left", "loop-right", "land"):
            assert passed_at(only(key, flight), motions) is None, (seed, key)


# what is said, and when an attempt begins again


def test_a_crash_is_forgiven_and_the_lesson_begins_again() -> None:
    flight = live()
    course = only("turn-left", flight)
    crashed = flown(flight, table(((0.0, -1.0), (1.0, 0.0))))
    assert passed_at(course, crashed) is None
    assert "Never mind" in course.status.advice
    assert course.status.push == 0.0
    again = flown(flight, piloted(Turner(-1.0)))
    later = [motion._replace(t=motion.t + crashed[-1].t + TICK) for motion in again[:30]]
    assert passed_at(course, later) is None
    assert "Never mind" in course.status.advice, "only a jump in time is a restart"
    course.watch(again[0])
    assert "Never mind" not in course.status.advice
    assert course.status.progress < 0.1
    assert passed_at(course, again) is not None


def test_a_crash_that_only_the_caller_saw_counts() -> None:
    flight = live()
    course = only("loop-left", flight)
    course.watch(flight.restart().motion, crashed=True)
    assert "Never mind" in course.status.advice


def test_a_hard_touch_is_no_landing() -> None:
    flight = live()
    course = only("land", flight)
    assert passed_at(course, flown(flight, table(((0.0, -1.0), (1.0, 0.0))))) is None


def test_a_kite_found_on_the_ground_has_not_landed() -> None:
    flight = live()
    landed = flown(flight, piloted(pilots.Land()))[-1]
    course = only("land", flight)
    course.watch(landed)
    course.watch(landed._replace(t=landed.t + TICK))
    assert course.lesson


@pytest.mark.parametrize("jump", [-3.0, BLINK + 0.1])
def test_after_a_jump_in_time_the_attempt_begins_again(jump: float) -> None:
    flight = live()
    course = only("loop-left", flight)
    motions = flown(flight, piloted(pilots.Loop(-1.0)))
    first = passed_at(only("loop-left", flight), motions)
    assert first is not None
    half = next(i for i, m in enumerate(motions) if m.t > first - 1.2)  # round, not upright yet
    for motion in motions[:half]:
        course.watch(motion)
    assert course.status.progress >= 0.8
    for motion in motions[half:]:
        course.watch(motion._replace(t=motion.t + jump))
    assert course.lesson, "half a loop before and half after are no loop"


def test_full_stick_held_long_is_warned_of_and_so_is_a_dive() -> None:
    flight = live()
    course = only("turn-left", flight)
    said = []
    for motion in flown(flight, lambda motion: -1.0):
        course.watch(motion)
        said.append(course.status.advice)
    assert any(text.startswith("Let go: full stick") for text in said)
    assert any(text.startswith("You are low!") for text in said)


def test_one_thing_is_said_at_a_time_long_enough_to_be_read() -> None:
    flight = live()
    course, said = only("eight", flight), []
    for motion in flown(flight, piloted(pilots.Eight()))[::FRAME]:
        course.watch(motion)
        if not said or said[-1][1] != course.status.advice:
            said.append((motion.t, course.status.advice))
        assert len(course.status.advice) < 100
        assert 0.0 <= course.status.progress <= 1.0
    times = [t for t, text in said if "Well done" not in text]
    assert np.diff(times).min() > 0.35, "s"


def test_a_passed_lesson_is_praised_for_a_while_and_the_next_is_flown() -> None:
    flight = live()
    course = Course(flight.parameters, passed=["loop-left", "nonsense"])
    assert course.passed == {"loop-left"}
    motions = flown(flight, piloted(Returner()))
    praised = []
    for motion in motions:
        course.watch(motion)
        if course.status.praised:
            praised.append(motion.t)
    assert course.passed == {"top", "loop-left"}
    assert praised[-1] - praised[0] == pytest.approx(PRAISED, abs=2 * TICK)
    assert course.status.number == 2
    assert course.status.total == len(LESSONS)


def test_lessons_can_be_skipped_and_the_course_begun_again() -> None:
    flight = live()
    course = Course(flight.parameters, passed=KEYS[2:])
    titles = []
    for _ in range(3):
        titles.append(course.status.title)
        course.skip()
    assert titles == ["Hold the top", "Turn left", "Hold the top"]
    done = Course(flight.parameters, KEYS)
    assert done.lesson is None
    done.skip()
    assert done.lesson is None
    assert done.status.number == 0
    done.begin_again()
    assert done.status.title == "Hold the top"
    assert not done.passed
