"""What is written can be read: over any picture, at any size, with nothing over or under it.

Every text that is put on a frame is noted with the pixels behind it.
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import product
from typing import Any, NamedTuple

import numpy as np
import pygame
import pytest
from numpy.typing import NDArray

from kitemj.controls.actions import HELP, INSTRUMENTS, PANELS
from kitemj.drawing import text as texts
from kitemj.drawing.alarms import Alarm
from kitemj.drawing.colours import LEFT, RIGHT
from kitemj.drawing.help_page import paint_help
from kitemj.drawing.history import CHART_COLUMNS, Traces
from kitemj.drawing.instruments import Instruments
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.drawing.wished import Wished
from kitemj.flight.limits import LIMITS, Departure
from kitemj.flight.pilot_settings import Guided
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.vectors import Vector
from kitemj.pilots.course import LessonStatus
from kitemj.pilots.crash import Touch
from kitemj.scene.gl import NoGraphics
from tests.scene.motions import EQUILIBRIUM, LAKSA, motion_at
from tests.support import pulling

SIZES = ((1280, 720), (1920, 1080), (640, 360))
SHAPES = (*SIZES, (960, 720), (1680, 720))
WCAG = 4.5
"""The least contrast of text by WCAG 2.1, success criterion 1.4.3 (level AA)."""
COVERED = 0.12
"""Of the picture: the most that a pilot's instruments may take."""
LEAST = {"pilot": 8.0, "engineer": 7.5}
"""px, digits in a frame of 360 rows: as text of 11 and 10 px, the smallest of usual screens."""

USUAL = {
    "pilot": lambda w, h: pygame.Rect(0.05 * w, 0.0, 0.9 * w, 0.6 * h),
    "engineer": lambda w, h: pygame.Rect(w / 3, 0.3 * h, w / 3, 0.3 * h),
}
"""Where the kite is while it flies; a pilot follows it with the eyes, and sees all of the sky."""

CALM = motion_at(LAKSA, EQUILIBRIUM)
SLACK = motion_at(LAKSA, EQUILIBRIUM, slack=1.0)
OVER = pulling(CALM, 700.0, 43.8)
FAR = Vector(300.0, -30.0, -1234.5)
WILD = pulling(CALM, 12345.0, -12.3)._replace(
    air=CALM.air._replace(alpha=-3.11, beta=-1.55, speed=123.4),
    body=CALM.body._replace(p_G_E=FAR),
    t=3599.9,
)
LATE = np.where(np.arange(CHART_COLUMNS) % 90, 1e-3, 0.02)
TRACES = Traces(np.empty((0, 3)), -60.0, LATE, 0.02 + LATE)
LESSON = LessonStatus(
    2,
    7,
    "Turn left",
    "Push the stick a little right, until the nose comes over the top and points right",
    -0.4,
    0.5,
    False,
)
CRASH = Touch(3.5, "right wing's trailing corner", 29.7, 27.7, -1.2, 25.0, 67.0, 26.0)
SOFT = Touch(9.0, "left tip", 1.2, 1.1, 1.2, 25.0, 0.2, 1.4)
GONE = "the gamepad is gone: hands level until another one, or a key, is pressed"


def recent(name: str, age: float = 2.0) -> Readings:
    """A limit that was crossed a while ago."""
    limit = next(each for each in LIMITS if each.name == name)
    alarm = Alarm(Departure(1.0, limit, "left -0.12 N, right 33.00 N"), age)
    return Readings(traces=TRACES._replace(alarm=alarm, twist=0.0), stick="keys", gap=1.234e-7)


WISHED = Wished(None, Guided("untwist", 0.217, 123.4, 0.3, 0.5, 12.0))
"""As much as an autopilot may have to tell."""

MOMENTS: dict[str, tuple[Any, Readings]] = {
    "calm": (CALM, Readings(assist=True, speed=0.25, stick="gamepad", gap=2.5)),
    "slack": (SLACK, Readings(speed=0.0, missed_ticks=3, traces=TRACES)),
    "over": (OVER, Readings(message=GONE)),
    "wild": (
        WILD,
        Readings(
            model="newton_euler and lagrange",
            stick="reference: newton_euler 12/12",
            gap=1234.5,
            speed=0.25,
            missed_ticks=12345,
            lateness=12.3456,
            assist=True,
            traces=TRACES,
        ),
    ),
    "lesson": (CALM, Readings(lesson=LESSON)),
    "praise": (CALM, Readings(lesson=LESSON._replace(praised=True, push=0.0))),
    "crash": (CALM, Readings(touch=CRASH, lesson=LESSON._replace(down=True), message=GONE)),
    "guided": (CALM, Readings(wished=WISHED, speed=0.0, message=GONE, stick="autopilot")),
    "landed": (CALM, Readings(touch=SOFT, lesson=LESSON)),
    **{f"was {limit.name}": (CALM, recent(limit.name)) for limit in LIMITS},
    "all": (CALM, recent("overload", 0.0)._replace(lesson=LESSON, message=GONE, assist=True)),
}


class Words(NamedTuple):
    """A text as it was put: its pixels' box, the height of a digit [px], pixels before, after."""

    text: str
    height: float
    colour: tuple[int, int, int]
    box: pygame.Rect
    behind: NDArray[np.uint8]
    put: NDArray[np.uint8]

    @property
    def contrast(self) -> float:
        """The least over all pixels behind it."""
        light, dark = luminance(np.array(self.colour)), luminance(self.behind)
        high, low = np.maximum(light, dark), np.minimum(light, dark)
        return float(((high + 0.05) / (low + 0.05)).min())


def luminance(rgb: NDArray[Any]) -> NDArray[np.float64]:
    """Relative luminance of sRGB (..., 3) by WCAG 2.1."""
    c = rgb / 255
    linear = np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
    return np.asarray(linear @ [0.2126, 0.7152, 0.0722])


@contextmanager
def noted() -> Iterator[list[Words]]:
    """Within, everything that is written is in the list."""
    words: list[Words] = []
    real = texts.put

    def put(
        surface: pygame.Surface,
        text: str,
        x: float,
        y: float,
        height: float,
        colour: tuple[int, int, int] = (255, 255, 255),
        align: float = 0.0,
        bold: bool = False,
    ) -> None:
        if not text:
            return
        image = texts._rendered(text, round(height / texts.DIGIT), colour, bold)
        wide, tall = image.get_size()
        box = image.get_bounding_rect().move(round(x - align * wide), round(y - tall / 2))
        assert surface.get_rect().contains(box), text
        behind = pygame.surfarray.array3d(surface.subsurface(box))
        real(surface, text, x, y, height, colour, align, bold)
        after = pygame.surfarray.array3d(surface.subsurface(box))
        words.append(Words(text, height, colour, box, behind, after))

    using = [m for n, m in sys.modules.items() if n.startswith("kitemj.drawing.")]
    with pytest.MonkeyPatch.context() as patch:
        for module in using:
            if getattr(module, "put", None) is real:
                patch.setattr(module, "put", put)
        yield words


def frame_of(colour: tuple[int, int, int], size: tuple[int, int]) -> pygame.Surface:
    surface = pygame.image.frombuffer(bytearray(3 * size[0] * size[1]), size, "RGB")
    surface.fill(colour)
    return surface


def painted(
    moment: str,
    depth: str,
    size: tuple[int, int],
    colour: tuple[int, int, int] = (128, 128, 128),
    name: str = "laksa",
) -> tuple[list[Words], pygame.Surface, Instruments]:
    """The words, the frame and the instruments of a moment, over one colour."""
    motion, readings = MOMENTS[moment]
    surface, instruments = frame_of(colour, size), Instruments(parameter_set(name), *size)
    with noted() as words:
        instruments.paint(surface, motion, readings, depth, {*PANELS, "arrows"})
    return words, surface, instruments


SKY, GROUND = (108, 156, 219), (112, 142, 92)
ANY = [(255, 255, 255), (0, 0, 0), (128, 128, 128), SKY, GROUND, (255, 0, 0), (0, 0, 255)]


@pytest.mark.parametrize("colour", ANY)
def test_text_stands_out_from_any_background(colour: tuple[int, int, int]) -> None:
    for moment, depth in product(MOMENTS, ("pilot", "engineer")):
        words, _, _ = painted(moment, depth, SIZES[0], colour)
        assert words
        for each in words:
            assert each.contrast >= WCAG, (moment, depth, each.text, each.contrast)
    surface = frame_of(colour, SIZES[0])
    with noted() as words:
        paint_help(surface, HELP, 1.0)
    assert all(each.contrast >= WCAG for each in words)


def test_what_is_written_into_the_view_stands_out_too() -> None:
    try:
        picture = Picture(LAKSA)
    except NoGraphics as reason:
        pytest.skip(str(reason))
    with picture, noted() as words:
        picture.depth = "engineer"
        for view in ("pilot", "side", "top"):
            picture.paint(CALM, None, Readings(), view)
    assert any(each.text.startswith("wind ") for each in words)
    assert any(each.text == "50 m" for each in words)
    assert min(each.contrast for each in words) >= WCAG


@pytest.mark.parametrize("size", SHAPES)
@pytest.mark.parametrize("depth", ["pilot", "engineer"])
@pytest.mark.parametrize("name", ["laksa", "sport"])
def test_no_text_overlaps_anything(size: tuple[int, int], depth: str, name: str) -> None:
    for moment in MOMENTS:
        words, surface, instruments = painted(moment, depth, size, name=name)
        for each in words:
            plate = [box for box in instruments.taken if box.contains(each.box)]
            assert plate, f"{moment}: {each.text!r} is not on its plate"
            assert np.ptp(each.behind, axis=(0, 1)).max() == 0, f"{moment}: under {each.text!r}"
            now = pygame.surfarray.array3d(surface.subsurface(each.box))
            assert np.array_equal(now, each.put), f"{moment}: over {each.text!r}"
        boxes = instruments.taken
        apart = all(a.collidelist(boxes[i + 1 :]) < 0 for i, a in enumerate(boxes))
        assert apart, moment
        assert all(surface.get_rect().contains(box) for box in boxes)


@pytest.mark.parametrize("depth", ["pilot", "engineer"])
def test_no_text_is_smaller_than_a_small_screen_shows(depth: str) -> None:
    for moment in MOMENTS.keys() - {"wild"}:  # whose numbers are made to fit
        words, _, _ = painted(moment, depth, (640, 360))
        for each in words:
            assert each.height >= LEAST[depth], (moment, each.text)


def changed(moment: str, size: tuple[int, int], depth: str = "pilot") -> NDArray[np.bool_]:
    """Which pixels (rows, columns) of a frame are covered."""
    _, surface, _ = painted(moment, depth, size)
    return np.asarray((pygame.surfarray.array3d(surface) != 128).any(axis=2).T)


@pytest.mark.parametrize("size", SHAPES)
def test_a_pilots_instruments_are_a_small_part_of_the_picture(size: tuple[int, int]) -> None:
    assert 0.02 < changed("calm", size).mean() < COVERED
    assert changed("was slack", size).mean() < COVERED, "with a warning"


@pytest.mark.parametrize("size", SHAPES)
@pytest.mark.parametrize("depth", ["pilot", "engineer"])
def test_the_kites_usual_place_is_free(size: tuple[int, int], depth: str) -> None:
    flying = [moment for moment, (_, readings) in MOMENTS.items() if not readings.touch]
    for moment in flying:
        _, surface, _ = painted(moment, depth, size)
        place = pygame.surfarray.array3d(surface.subsurface(USUAL[depth](*size)))
        assert (place == 128).all(), moment


@pytest.mark.parametrize("size", SHAPES)
@pytest.mark.parametrize("depth", ["pilot", "engineer"])
def test_the_card_of_a_touch_is_over_a_kite_that_lies_on_the_ground(
    size: tuple[int, int], depth: str
) -> None:
    """Which is seen low in the frame; a lesson that waits for another flight is on the card."""
    covered = changed("crash", size, depth)
    rows, columns = covered.shape
    middle = slice(round(0.35 * columns), round(0.65 * columns))
    assert covered[round(0.1 * rows) : round(0.5 * rows), middle].any()
    low = covered[round(0.66 * rows) : round(0.8 * rows), middle]
    assert not low.any()


def test_what_a_pilot_flies_by_and_nothing_else() -> None:
    words, _, _ = painted("calm", "pilot", SIZES[0])
    told = [each.text for each in words]
    assert told == ["7.0", "m/s", "0:00", "L", "44 N", "R", "44 N", "ASSIST", "×0.25"]
    words, _, _ = painted("slack", "pilot", SIZES[0])
    told = [each.text for each in words]
    assert {"slack", "PAUSED"} <= set(told)
    assert any(text.startswith("SLACK: ") for text in told)
    assert not any("N," in text for text in told), "numbers are for engineers"
    assert painted("crash", "none", SIZES[0])[0] == []


@pytest.mark.parametrize("pulls", [(20.0, 120.0), (120.0, 20.0)])
def test_each_bar_is_on_its_side_beside_its_letter_as_tall_as_its_pull(
    pulls: tuple[float, float],
) -> None:
    surface, instruments = frame_of((128, 128, 128), SIZES[0]), Instruments(LAKSA, *SIZES[0])
    with noted() as words:
        instruments.paint(surface, pulling(CALM, *pulls), Readings())
    letters = [next(each.box for each in words if each.text == side) for side in "LR"]
    image, middle = pygame.surfarray.array3d(surface), instruments.box("head up").centerx
    tall = []
    for colour, letter, side in ((LEFT, letters[0], -1), (RIGHT, letters[1], 1)):
        columns = np.flatnonzero((image == colour).all(axis=2).sum(axis=1) > 15)
        assert (np.sign(columns - middle) == side).all()
        assert abs(columns.mean() - letter.centerx) < 20, "px"
        tall.append((image[round(columns.mean())] == colour).all(axis=1).sum())
    assert tall[0] / tall[1] == pytest.approx((pulls[0] / pulls[1]) ** 0.5, rel=0.15)


def test_every_limit_has_an_advice_of_its_own() -> None:
    assert len({limit.advice for limit in LIMITS}) == len(LIMITS)
    for limit in LIMITS:
        words, _, _ = painted(f"was {limit.name}", "engineer", SIZES[0])
        told = " ".join(each.text for each in words)
        assert f"{limit.name.upper()}: {limit.advice}" in told
        assert limit.sentence in told
        assert set(INSTRUMENTS) >= set(PANELS)
