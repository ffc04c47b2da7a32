"""The choice of a quality: by times that are made up here."""

import pytest

from kitemj.errors import InputError
from kitemj.scene.quality import BATCH, FILM, QUALITIES, SETTLING, QualityChooser, quality_of

RATE = 30.0
FRAME = 1.0 / RATE


def after(times: list[float], begin: str = "high") -> str:
    """The name of the quality that is chosen after frames that took so long [s]."""
    chooser = QualityChooser(RATE, begin)
    for each in times:
        chooser.painted(each)
    return next(name for name, quality in QUALITIES.items() if quality == chooser.quality)


def test_qualities_are_dearer_one_by_one() -> None:
    pixels = [quality.scale for quality in QUALITIES.values()]
    assert pixels == sorted(pixels)
    assert quality_of("film") == FILM
    with pytest.raises(InputError, match=r"no quality 'best'; there are: low, medium, high, film"):
        quality_of("best")


def test_a_quick_machine_keeps_the_high_quality_and_climbs_to_it() -> None:
    assert after([0.3 * FRAME] * 30) == "high"
    assert after([0.75 * FRAME] * 30) == "high"
    assert after([0.1 * FRAME] * 30, "low") == "high"


def test_a_slow_machine_steps_down_as_far_as_it_must() -> None:
    batch = BATCH + SETTLING
    assert after([0.9 * FRAME] * (batch - 1)) == "high", "not before it has been measured"
    assert after([0.9 * FRAME] * batch + [0.6 * FRAME] * 30) == "medium"
    assert after([0.95 * FRAME] * 30) == "low"
    assert after([3.0 * FRAME] * 3 * batch) != "high"


def test_what_was_too_slow_is_not_tried_again() -> None:
    batch = BATCH + SETTLING
    assert after([0.9 * FRAME] * batch + [0.1 * FRAME] * 20) == "medium"


def test_one_slow_frame_decides_nothing() -> None:
    assert after([0.5 * FRAME, 0.5 * FRAME, 0.5 * FRAME, 20 * FRAME] + [0.5 * FRAME] * 26) == "high"
    assert after([9 * FRAME] * SETTLING + [0.5 * FRAME] * 28) == "high", "the first fill caches"


def test_after_the_first_second_all_stays() -> None:
    assert after([0.5 * FRAME] * 31 + [5 * FRAME] * 60) == "high"
