"""The lesson and the card of a touch: in their places, legible, and nothing else painted over."""

import pygame
import pytest

from kitemj.drawing.alarms import Alarm
from kitemj.drawing.colours import CALL, GOOD, LEFT, RIGHT
from kitemj.drawing.instruments import Instruments
from kitemj.drawing.lesson_panel import (
    ARROWS,
    FLY_AGAIN,
    HEIGHT,
    START_AGAIN,
    _card,
    _fitting,
    beside,
    paint_lesson,
    paint_touch,
)
from kitemj.drawing.toast import paint_alarm, paint_message
from kitemj.flight.limits import GROUND, Departure
from kitemj.physics.parameter_files import parameter_set
from kitemj.pilots.course import NEVER_MIND, LessonStatus
from kitemj.pilots.crash import Touch

SPORT = parameter_set("sport")
SIZES = ((1280, 720), (640, 360), (1920, 1080), (1000, 720))
LONGEST = (
    "Push the stick a little right, until the nose comes over the top and points right",
    "That was a circle, not an eight. Push the stick a little right, back to the right",
    "Push the stick a little right: out to the side first, then come back",
    "All the way round! Push the stick a little right, until the nose points up",
    f"{NEVER_MIND}. {FLY_AGAIN}",
)
GREY = (128, 128, 128)
LESSON = LessonStatus(2, 7, "Turn left", LONGEST[0], -0.4, 0.5, False)
CRASH = Touch(3.5, "right wing's trailing corner", 29.7, 27.7, -1.2, 25.0, 67.0, 26.0)
SOFT = Touch(9.0, "left tip", 1.2, 1.1, 1.2, 25.0, 0.2, 1.4)
FELL = Alarm(Departure(3.5, GROUND, "30 m/s of air"))


class Cockpit:
    """A grey frame with room for what is said, no instruments."""

    def __init__(self, size: tuple[int, int] = (1280, 720)) -> None:
        self.surface = pygame.Surface(size)
        self.surface.fill(GREY)
        self.instruments = Instruments(SPORT, *size)
        self.unit = self.instruments.u

    def room(self, depth: str = "pilot") -> pygame.Rect:
        return self.instruments.room(depth)

    def lesson(self, depth: str = "pilot", **how: object) -> pygame.Rect:
        return paint_lesson(self.surface, self.room(depth), self.unit, LESSON._replace(**how))

    def columns(self, box: pygame.Rect, colour: tuple[int, int, int]) -> list[int]:
        """Those in `box` where something has this colour."""
        across, down = range(box.left, box.right), range(box.top, box.bottom)
        return [x for x in across if any(self.surface.get_at((x, y))[:3] == colour for y in down)]


def apart(boxes: list[pygame.Rect]) -> bool:
    return not any(a.colliderect(b) for i, a in enumerate(boxes) for b in boxes[i + 1 :])


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("depth", ["pilot", "engineer"])
def test_lesson_card_and_toasts_stand_beside_each_other(size: tuple[int, int], depth: str) -> None:
    cockpit = Cockpit(size)
    surface, unit, room = cockpit.surface, cockpit.unit, cockpit.room(depth)
    boxes = [cockpit.lesson(depth)]
    left = beside(room, boxes[-1], unit)
    boxes.append(paint_touch(surface, left, unit, CRASH))
    left = beside(left, boxes[-1], unit)
    boxes.append(paint_alarm(surface, left, unit, FELL, numbers=True))
    left = beside(left, boxes[-1], unit)
    boxes.append(paint_message(surface, left, unit, "the gamepad is gone"))
    assert apart(boxes)
    assert all(room.contains(box) for box in boxes[:1] + boxes[2:])
    assert boxes[1].centerx == pytest.approx(surface.get_width() / 2, abs=1)
    assert surface.get_rect().contains(boxes[1])
    assert boxes[1].bottom < 0.6 * surface.get_height(), "px, above a kite on the ground"


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("depth", ["pilot", "engineer"])
def test_every_advice_fits_in_two_lines(size: tuple[int, int], depth: str) -> None:
    cockpit = Cockpit(size)
    for text in LONGEST:
        room = cockpit.room(depth).width / cockpit.unit - 2 * ARROWS
        digits, lines = _fitting(text, room, cockpit.unit)
        assert len(lines) <= 2, lines
        assert " ".join(lines) == text
        assert digits >= 16


@pytest.mark.parametrize("depth", ["pilot", "engineer"])
def test_nothing_is_painted_outside_the_lesson(depth: str) -> None:
    cockpit = Cockpit()
    box = cockpit.lesson(depth)
    assert box.height == pytest.approx(HEIGHT * cockpit.unit, abs=1)
    assert cockpit.surface.get_at(box.center)[:3] != GREY
    cockpit.surface.fill(GREY, box)
    whole = pygame.mask.from_threshold(cockpit.surface, GREY, (1, 1, 1, 255))
    assert whole.count() == cockpit.surface.get_width() * cockpit.surface.get_height()


def test_the_arrows_point_where_the_stick_should_go_and_say_how_far() -> None:
    shown = {}
    for push in (-1.0, -0.4, -0.2, 0.0, 0.2, 0.4, 1.0):
        cockpit = Cockpit()
        box = cockpit.lesson(push=push)
        shown[push] = cockpit.columns(box, LEFT), cockpit.columns(box, RIGHT)
        lefts, rights = shown[push]
        assert bool(lefts) == (push < 0)
        assert bool(rights) == (push > 0)
        assert all(x < box.centerx - 150 for x in lefts), "px, at the left end of the bar"
        assert all(x > box.centerx + 150 for x in rights)
    for side, which in ((-1, 0), (1, 1)):
        lengths = [len(shown[side * size][which]) for size in (0.2, 0.4, 1.0)]
        assert lengths[0] * 3 == lengths[1] * 1.5 == lengths[2], "one, two, three of a size"


def test_the_bar_is_as_long_as_the_progress() -> None:
    lengths = {}
    for progress in (0.0, 0.25, 0.5, 1.0, 1.5):
        cockpit = Cockpit()
        lengths[progress] = len(cockpit.columns(cockpit.lesson(progress=progress), GOOD))
    assert lengths[0.0] == 0
    assert lengths[0.25] == pytest.approx(lengths[1.0] / 4, abs=1)
    assert lengths[0.5] == pytest.approx(lengths[1.0] / 2, abs=1)
    assert lengths[1.5] == lengths[1.0] > 350


def test_praise_is_green_and_advice_is_not() -> None:
    for praised in (True, False):
        cockpit = Cockpit()
        box = cockpit.lesson(praised=praised, progress=0.0)
        assert bool(cockpit.columns(box, GOOD)) == praised


def test_a_crash_calls_and_a_landing_is_green() -> None:
    for touch, colour, other in ((CRASH, CALL, GOOD), (SOFT, GOOD, None)):
        cockpit = Cockpit()
        box = paint_touch(cockpit.surface, cockpit.room(), cockpit.unit, touch)
        assert cockpit.surface.get_at((box.centerx, box.top + 8))[:3] == colour
        assert other is None or not cockpit.columns(box, other)


def test_a_card_without_much_room_is_smaller() -> None:
    cockpit = Cockpit()
    wide = paint_touch(cockpit.surface, cockpit.room(), cockpit.unit, CRASH)
    room = pygame.Rect(400, 300, 700, wide.height - 20)
    small = paint_touch(cockpit.surface, room, cockpit.unit, CRASH)
    assert wide.height > room.height
    assert small.height <= room.height
    assert small.width < wide.width


def test_what_is_left_is_the_larger_part() -> None:
    room = pygame.Rect(100, 50, 300, 400)
    assert beside(room, pygame.Rect(120, 50, 50, 100), 1.0) == pygame.Rect(100, 160, 300, 290)
    assert beside(room, pygame.Rect(120, 350, 50, 100), 1.0) == pygame.Rect(100, 50, 300, 290)


def test_a_lesson_that_waits_for_another_flight_says_so_on_the_card() -> None:
    waits = LESSON._replace(down=True, advice=NEVER_MIND)
    for lesson, last in (
        (None, START_AGAIN),
        (LESSON, START_AGAIN),
        (waits, f"{NEVER_MIND}. {FLY_AGAIN}"),
        (waits._replace(advice=CRASH.damage), FLY_AGAIN),
    ):
        cockpit, plain = Cockpit(), Cockpit()
        room = cockpit.room()
        paint_touch(cockpit.surface, room, 1.0, CRASH, lesson)
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("kitemj.drawing.lesson_panel.START_AGAIN", last)
            paint_touch(plain.surface, room, 1.0, CRASH)
        assert pygame.image.tobytes(cockpit.surface, "RGB") == pygame.image.tobytes(
            plain.surface, "RGB"
        )
    assert _card(CRASH, START_AGAIN, 900.0, 1.0)[-1][0] == START_AGAIN
