"""Sound that follows the kite: pitch, loudness, ears, silence, and no jump between chunks."""

from itertools import pairwise

import numpy as np
import pytest

from kitemj.sound.hearing import SILENCE, Heard
from kitemj.sound.synthesis import CHUNK, RATE, Place, samples, thud

CALM = Heard(8.0, 0.2, 0.2, 0.0, 0.4)


def pitch(one):
    """The middle [Hz] of the power spectrum of one ear."""
    power = np.abs(np.fft.rfft(one)) ** 2
    return float(np.sum(np.fft.rfftfreq(len(one), 1 / RATE) * power) / np.sum(power))


def loudness(made):
    """Root mean square of all samples."""
    return float(np.sqrt(np.mean(made.astype(float) ** 2)))


def second(now):
    """A second of what is heard all the while."""
    return samples(now, now, Place(), RATE)[0]


def test_pitch_and_loudness_rise_with_the_airspeed():
    made = [second(CALM._replace(airspeed=speed)) for speed in (5.0, 8.0, 12.0, 18.0, 27.0)]
    for less, more in pairwise(made):
        assert pitch(more[:, 0]) > 1.2 * pitch(less[:, 0])
        assert loudness(more) > 1.2 * loudness(less)


def test_a_line_sings_in_its_own_ear_the_louder_the_more_it_pulls():
    pulls = [second(CALM._replace(right=pull)) for pull in (0.0, 0.2, 0.5, 0.9)]
    for less, more in pairwise(pulls):
        assert loudness(more[:, 1]) > loudness(less[:, 1])
        assert np.array_equal(more[:, 0], less[:, 0])


def test_a_line_sings_at_the_pitch_of_its_vortices():
    """Rayleigh's 0.2 V/d for 0.8 mm in the 4 m/s of its middle: 1 kHz, at no pull 0.9 kHz."""
    hum = second(CALM._replace(right=0.01)).astype(float) - second(CALM._replace(right=0.0))
    wind = np.abs(np.fft.rfft(hum[:, 1]))
    assert np.argmax(wind) == pytest.approx(900.0, rel=0.2)


def test_slack_cloth_flutters_in_beats():
    """Twenty beats a second in 16 m/s and a chord of 0.4 m, so its loudness goes up and down."""
    still, slack = (second(Heard(16.0, flutter=f, chord=0.4)) for f in (0.0, 1.0))
    assert loudness(slack) > 1.5 * loudness(still)
    swell = np.abs(slack[:, 0].astype(float))[: RATE // 100 * 100].reshape(-1, 100).mean(axis=1)
    beats = np.abs(np.fft.rfft(swell - swell.mean()))
    assert 10 <= np.argmax(beats) <= 30


def test_silence_is_silent_and_comes_without_a_click():
    assert not samples(SILENCE, SILENCE, Place())[0].any()
    fading, _ = samples(CALM, SILENCE, Place())
    assert np.abs(fading[:100]).max() > 100
    assert np.abs(fading[-20:]).max() <= 20
    assert np.abs(fading[-1]).max() == 0


def test_chunks_go_on_as_one_sound():
    """Two halves are the whole, and no step across an edge is larger than those within."""
    whole, end = samples(CALM, CALM, Place(), 2 * CHUNK)
    first, place = samples(CALM, CALM, Place())
    then, last = samples(CALM, CALM, place)
    assert np.abs(np.concatenate([first, then]).astype(int) - whole).max() <= 1, "rounding"
    assert last == pytest.approx(end)
    made, before, place = [], SILENCE, Place()
    for k in range(40):
        now = Heard(10.0 + 8.0 * np.sin(k), 0.5, 0.4 + 0.3 * np.cos(k), float(k % 5 == 0), 0.4)
        chunk, place = samples(before, now, place)
        made.append(chunk)
        before = now
    steps = np.abs(np.diff(np.concatenate(made).astype(float), axis=0)).max(axis=1)
    edges = np.arange(CHUNK - 1, len(steps), CHUNK)
    assert steps[edges].max() <= np.delete(steps, edges).max()


def test_the_same_flight_makes_the_same_sound():
    assert np.array_equal(second(CALM), second(CALM))


def test_a_harder_touch_is_a_louder_thud():
    soft, hard = thud(1.5), thud(9.0)
    assert loudness(hard) > 2.0 * loudness(soft) > 0.0
    for made in (soft, hard):
        assert np.abs(made[[0, -1]]).max() == 0, "neither begins nor ends with a click"
