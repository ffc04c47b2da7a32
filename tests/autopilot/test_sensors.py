"""Sensors measure when they say, as late as they say, and with the noise that they say."""

from math import radians

import numpy as np
import pytest
from scipy.stats import chi2

from kitemj.autopilot.sensors import Measurement, Sensors, measured
from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.flight.gliding import gliding
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.pilot_settings import SensorSettings
from kitemj.flight.scenario import Scenario, Times
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.steering import Sines, rest_ell
from kitemj.pilots.sight import sight

ROUNDING = 1e-9
"""s; sums of ticks."""


def flown(model: str = "lagrange", ticks: int = 60) -> list[Motion]:
    """A second half of a turn by a little stick."""
    parameters = parameter_set("sport")
    rest = Sines(rest_ell(parameters.lines.length, parameters.kite.y_A))
    start = gliding(parameters, 0.2, 0.8, 0.5)
    flight = SteeredFlight(Scenario("turn", parameters, rest, start, Times(5.0), False), model)
    motions = [flight.result.motion]
    for _ in range(ticks):
        motions.append(flight.tick(Command(0.1)).motion)
    return motions


@pytest.fixture(scope="module")
def motions() -> list[Motion]:
    """Flown once."""
    return flown()


def test_without_noise_it_is_the_truth_at_once(motions: list[Motion]) -> None:
    sensors = Sensors(SensorSettings(), 1)
    for motion in motions:
        (one,), seen = sensors.look(motion), sight(motion)
        assert one[:4] == (motion.t, seen.azimuth, seen.elevation, seen.heading)
        assert one.pulls == tuple(line.tension_ground for line in motion.lines)
        assert one.lengths == motion.lengths


def test_noise_is_as_large_as_was_asked(motions: list[Motion]) -> None:
    settings = SensorSettings(noise=radians(1.0), pull_noise=0.05, length_noise=0.02)
    n, true = 2000, measured(motions[-1], SensorSettings(), 7, 0)
    low, high = chi2.ppf([1e-5, 1.0 - 1e-5], n)
    drawn = [measured(motions[-1], settings, 7, k) for k in range(n)]

    def numbers(one: Measurement) -> np.ndarray:
        return np.array([*one[1:4], *one.pulls, *one.lengths])

    sigma = np.array([settings.noise] * 3 + [0.05 * pull for pull in true.pulls] + [0.02] * 2)
    off = (np.array([numbers(one) for one in drawn]) - numbers(true)) / sigma
    squares = np.sum(off**2, axis=0)
    assert np.all((low < squares) & (squares < high))
    apart = np.corrcoef(off.T) - np.eye(7)
    assert np.abs(apart).max() < 5.0 / np.sqrt(n)  # five standard deviations of none at all


def test_when_it_measures_and_when_that_arrives(motions: list[Motion]) -> None:
    sensors = Sensors(SensorSettings(rate=30.0, delay=0.034), 1)
    arrived = [(motion.t, one.t) for motion in motions for one in sensors.look(motion)]
    taken = np.array([t for _, t in arrived])
    due = np.ceil(np.arange(len(taken)) / (30.0 * TICK) - ROUNDING) * TICK
    assert np.abs(taken - due).max() < ROUNDING
    assert arrived[0] == (0.0, 0.0)
    late = np.array([now - t for now, t in arrived[1:]])
    assert np.abs(late - 0.04).max() < ROUNDING  # 34 ms, up to the next tick
    assert len(taken) == 17  # of 19 in 0.6 s; those of 0.57 s and 0.60 s are on their way


def test_a_seed_is_the_same_noise_in_all_models() -> None:
    settings = SensorSettings(rate=50.0, noise=radians(1.0))
    told = []
    for model in ("lagrange", "newton-euler", "mujoco"):
        start = flown(model, 0)[0]
        true = measured(start, SensorSettings(), 3, 5)
        told.append(measured(start, settings, 3, 5).azimuth - true.azimuth)
    assert np.ptp(told) < 1e-12  # rad, rounding; noise is 0.017
    start = flown("lagrange", 0)[0]
    assert measured(start, settings, 3, 5) != measured(start, settings, 4, 5)
    assert measured(start, settings, 3, 5) == measured(start, settings, 3, 5)


def test_goes_on_from_what_was_saved_and_begins_anew(motions: list[Motion]) -> None:
    settings = SensorSettings(rate=30.0, delay=0.05, noise=0.01)
    sensors = Sensors(settings, 2)
    first = [sensors.look(motion) for motion in motions[:20]]
    saved = sensors.save()
    after = [sensors.look(motion) for motion in motions[20:]]
    other = Sensors(settings, 2)
    other.resume(saved)
    assert [other.look(motion) for motion in motions[20:]] == after
    assert [sensors.look(motion) for motion in motions[:20]] == first  # time went back


@pytest.mark.parametrize("rate", [100.1, 0.5])
def test_a_rate_that_there_cannot_be(rate: float) -> None:
    with pytest.raises(InputError, match="rate"):
        Sensors(SensorSettings(rate=rate), 1)
