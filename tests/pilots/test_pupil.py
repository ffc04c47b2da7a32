"""The simulated pupil: slow, noisy, the same for the same seed; the assist makes the difference."""

from random import Random

import numpy as np
import pytest

from kitemj.flight.live import SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.pilots.pupil import NOISE, REACTION, Pupil, Reaction
from pupil import Class, crash

SEEDS = range(4)


@pytest.mark.parametrize("kite", ["trainer", "sport"])
def test_pupils_who_look_at_the_nose_fly_a_minute(kite: str) -> None:
    """Some with the assist, some without: a crash of one of so few would be 25 of 100."""
    assert [crash(Class(kite, False, seed % 2 == 0), seed) for seed in SEEDS] == [None] * 4


def test_pupils_who_look_at_the_place_alone_need_the_assist() -> None:
    helped = [crash(Class("sport", True, True), seed) for seed in SEEDS]
    alone = [crash(Class("sport", True, False), seed) for seed in SEEDS]
    assert sum(each is None for each in helped) >= 3
    assert sum(each is None for each in alone) <= 1


def test_a_pupil_knows_two_keys_and_does_the_same_again() -> None:
    motion = SteeredFlight(scenario_of({"set": "sport", "duration": 1.0}, "test")).result.motion

    def pressed(seed: int) -> list[float]:
        pupil = Pupil(seed)
        return [pupil.key(motion._replace(t=0.01 * k)) for k in range(2000)]

    assert pressed(1) == pressed(1)
    assert pressed(1) != pressed(2)
    assert set(pressed(1)) == {-1.0, 0.0, 1.0}


def test_hands_are_late_by_a_reaction_and_its_noise() -> None:
    random, lates = Random(3), []
    for _ in range(300):
        hands, t = Reaction(random), 0.0
        while not hands.after(1.0, t):
            t += 0.001
        lates.append(t)
    assert np.mean(lates) == pytest.approx(REACTION, rel=0.05), "s; 4 standard errors"
    assert np.std(lates) == pytest.approx(NOISE * REACTION, rel=0.2), "s; 5 standard errors"
