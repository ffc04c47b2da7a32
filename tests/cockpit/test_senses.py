"""What a pad tells the hands: which line pulls more, that the ground was met, and when to rest."""

import pytest

from kitemj.cockpit import senses
from kitemj.cockpit.senses import KNOCK, Senses, strengths
from kitemj.flight.live import SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.pilots.crash import Touch
from kitemj.sound.hearing import SILENCE, Heard

SCENARIO = scenario_of({"set": "sport", "duration": 60.0}, "test")
MOTION = SteeredFlight(SCENARIO).result.motion
TOUCH = Touch(1.0, "nose", 9.0, 8.0, 0.0, 20.0, 10.0, 9.0)


class Loud:
    """A loudspeaker that remembers."""

    def __init__(self):
        self.now, self.thuds = SILENCE, []

    def hear(self, now):
        self.now = now

    def thud(self, speed):
        self.thuds.append(speed)

    def close(self):
        self.now = SILENCE


@pytest.fixture
def felt(monkeypatch):
    """Senses with all that was felt since."""
    monkeypatch.setattr(senses, "Speaker", Loud)
    shaken = []
    made = Senses(lambda low, high: shaken.append((low, high)))
    made.shaken = shaken
    return made


def pulled(left, right):
    lines = zip(MOTION.lines, (left, right), strict=True)
    return MOTION._replace(lines=tuple(line._replace(tension_kite=T) for line, T in lines))


def test_the_motor_of_the_hand_that_pulls_more_shakes_the_more_the_larger_the_difference():
    assert strengths(Heard(left=0.3, right=0.3)) == (0.0, 0.0)
    assert strengths(Heard(left=0.3, right=0.33)) == (0.0, 0.0), "too small to be felt"
    low, high = strengths(Heard(left=0.2, right=0.7))
    assert low == 0.0 < high < 1.0
    assert strengths(Heard(left=0.7, right=0.2)) == (high, low)
    assert strengths(Heard(left=0.2, right=0.9))[1] > high


def test_a_hard_pull_is_felt_in_that_hand_and_ends(felt):
    felt.feel(SCENARIO.parameters, pulled(5.0, 100.0), None, on=True)
    low, high = felt.shaken[-1]
    assert low == 0.0 < high
    felt.feel(SCENARIO.parameters, MOTION, None, on=True)
    felt.feel(SCENARIO.parameters, MOTION, None, on=True)
    assert felt.shaken[1:] == [(0.0, 0.0)], "told once that it is over"


def test_the_ground_is_heard_once_and_felt_for_a_while(felt):
    for _ in range(2 * KNOCK):
        felt.feel(SCENARIO.parameters, MOTION, TOUCH, on=True)
    assert felt._speaker.thuds == [TOUCH.speed]
    assert felt.shaken == [(1.0, 1.0)] * KNOCK + [(0.0, 0.0)]


def test_off_is_silent_and_still(felt):
    felt.feel(SCENARIO.parameters, pulled(5.0, 100.0), None, on=True)
    assert felt._speaker.now.airspeed > 0.0
    felt.feel(SCENARIO.parameters, pulled(5.0, 100.0), TOUCH, on=False)
    assert felt._speaker.now == SILENCE
    assert felt._speaker.thuds == []
    assert felt.shaken[-1] == (0.0, 0.0)
