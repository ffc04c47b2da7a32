"""Sound made of numbers: samples of what is heard, from tables of noise that are read faster or
slower.

A table holds a noise of one colour, made so that its end goes on at its beginning. Read at
another rate it has another pitch; rate and loudness change from sample to sample, so no chunk of
samples begins with a jump. The same numbers always make the same samples.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.sound.hearing import Heard

RATE = 22050  # samples/s
CHUNK = 2048
"""Samples made at a time, 93 ms: short to a hand, long to a thread that makes them."""
VOLUME = 0.5  # of all that a loudspeaker has; moderate

Floats = NDArray[np.float64]
Samples = NDArray[np.int16]
"""(count, 2), the left ear first."""

LENGTH = 1 << 17  # of a table, 6 s
SEED = 14

WIND_PITCH = 28.0  # Hz at 1 m/s; of the rush about sail and ears, an estimate
STROUHAL = 0.2  # a thin round line sheds vortices at 0.2 V/d; Rayleigh, The Theory of Sound, § 372
THICK = 0.0008  # m, of a line that holds 700 N; usual ones are 0.5 to 1.2 mm
ALONG = 0.5  # of the kite's airspeed: the middle of its line
WIND_AT, LINE_AT, FLAPS = 400.0, 1000.0, 8.0  # Hz of the tables as they are
HIGHEST = 5.0  # times a table's own pitch: beyond, it would fold back
LOUD = 15.0  # m/s; the rush has a quarter of its loudness here


class Place(NamedTuple):
    """Where each table is read next, in its samples."""

    wind: float = 0.0
    left: float = 0.0
    right: float = LENGTH / 3
    flutter: float = 0.0
    swell: float = 0.0


def samples(before: Heard, after: Heard, place: Place, count: int = CHUNK) -> tuple[Samples, Place]:
    """The next `count` samples, in which `before` becomes `after`; and the place after them."""
    part: Floats = np.arange(1, count + 1, dtype=np.float64) / count
    # a sound that ends or begins keeps its pitch meanwhile
    first, last = before if before.airspeed else after, after if after.airspeed else before
    rates = np.outer(_rates(first), 1 - part) + np.outer(_rates(last), part)
    rush, left, right, flutter = np.outer(_gains(before), 1 - part) + np.outer(_gains(after), part)
    at: Floats = np.array(place, np.float64)[:, None] + np.cumsum(rates, axis=1)
    wind, line, cloth, swell = _tables()
    rush = rush * (1.0 + 0.4 * _read(swell, at[4]))
    flap = flutter * _read(cloth, at[3])
    ears: Floats = np.stack(
        [
            rush * _read(wind, at[0]) + left * _read(line, at[1]) + flap,
            rush * _read(wind, at[0] + LENGTH / 2) + right * _read(line, at[2]) + flap,
        ],
        axis=1,
    )
    return _whole(ears), Place(*(at[:, -1] % LENGTH).tolist())


def thud(speed: float) -> Samples:
    """A kite that meets the ground at `speed` [m/s]: a dull knock, and the rustle of its sail."""
    t: Floats = np.arange(RATE // 2, dtype=np.float64) / RATE
    knock = np.sin(2 * np.pi * (70.0 * t + 2.0 * (1.0 - np.exp(-t / 0.03)))) * np.exp(-t / 0.09)
    rustle = _read(_tables()[0], 4.0 * RATE * t) * np.exp(-t / 0.05)
    rise = np.minimum(t / 0.002, 1.0) * np.minimum((t[-1] - t) / 0.02, 1.0)
    loud = min(max(speed, 1.0) / 12.0, 1.0)
    one: Floats = loud * rise * (0.9 * knock + 0.5 * rustle)
    return _whole(np.stack([one, one], axis=1))


def _rates(now: Heard) -> Floats:
    """How fast each table is read, in the order of `Place`."""
    rush = now.airspeed * WIND_PITCH / WIND_AT
    hum = now.airspeed * ALONG * STROUHAL / THICK / LINE_AT
    flaps = now.airspeed / (2.0 * now.chord) / FLAPS  # a luff beats once in two chords; estimate
    line = [min(hum * (0.9 + 0.3 * pull), HIGHEST) for pull in (now.left, now.right)]
    return np.array([min(rush, HIGHEST), *line, min(max(flaps, 0.5), 3.0), 1.0])


def _gains(now: Heard) -> Floats:
    """How loud rush, left line, right line and flutter are."""
    share = now.airspeed / (now.airspeed + LOUD)
    lines = [1.2 * share * pull for pull in (now.left, now.right)]
    return np.array([1.8 * share * share, *lines, 0.9 * now.flutter * min(2.0 * share, 1.0)])


def _whole(ears: Floats) -> Samples:
    """Samples of parts of full loudness; what is too loud is bent, not cut."""
    return np.asarray(np.round(32767 * VOLUME * np.tanh(ears)), np.int16)


def _read(table: Floats, at: Floats) -> Floats:
    """The table between its samples, around and around."""
    whole = np.floor(at)
    first = whole.astype(np.int64) & (LENGTH - 1)
    return np.asarray(table[first] + (at - whole) * (table[first + 1] - table[first]))


@lru_cache(1)
def _tables() -> tuple[Floats, Floats, Floats, Floats]:
    """Wind, line, cloth, swell: noises of root mean square 0.25, with a sample more at the end."""
    random = np.random.default_rng(SEED)
    pitch = np.fft.rfftfreq(LENGTH, 1 / RATE) + 1e-9

    def noise(at: float, octaves: float) -> Floats:
        height = np.exp(-0.5 * (np.log2(pitch / at) / octaves) ** 2) / np.sqrt(pitch)
        turns = np.exp(2j * np.pi * random.random(len(pitch)))
        return np.fft.irfft(height * turns, LENGTH)

    beats = round(FLAPS * LENGTH / RATE)
    since = np.zeros(LENGTH)
    starts = (np.arange(beats) + random.uniform(-0.25, 0.25, beats)) * LENGTH / beats
    t = np.arange(RATE // 4)
    one = (1.0 - np.exp(-t / RATE / 0.003)) * np.exp(-t / RATE / 0.025)
    for start, strong in zip(starts.astype(int), random.uniform(0.4, 1.0, beats), strict=True):
        since[(start + t) % LENGTH] += strong * one
    made = noise(WIND_AT, 1.1), noise(LINE_AT, 0.12), noise(900.0, 1.0) * since, noise(0.7, 0.8)
    wind, line, cloth, swell = (
        np.append(each, each[0]) * 0.25 / np.sqrt(np.mean(each * each)) for each in made
    )
    return wind, line, cloth, swell
