"""What the observer believes is near the truth, and as near as it says."""

from math import cos, hypot, pi, radians, sin, sqrt

import numpy as np
import pytest

from kitemj.autopilot.flight_model import Flying, glide_of, moved_on
from kitemj.autopilot.follow import Estimate
from kitemj.autopilot.observer import Observer
from kitemj.autopilot.truth import true_estimate
from kitemj.dynamics.motion import Motion
from kitemj.flight.gliding import gliding
from kitemj.flight.live import Command, SteeredFlight
from kitemj.flight.pilot_settings import SensorSettings, TurnRateLaw
from kitemj.flight.scenario import Scenario, Times
from kitemj.paths.sphere import ahead_of, course, direction
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.steering import Sines, rest_ell
from kitemj.pilots.sight import turned

PARAMETERS = parameter_set("sport")
LAW = TurnRateLaw(c1=0.45, c2=4.0, exponent=0.4, airspeed=12.0, lag=2.8)
"""Rough: an observer must stand a law that is not quite the kite's."""
REAL = SensorSettings(rate=50.0, delay=0.05, noise=radians(1.0))
SETTLED = 100
"""Ticks until the first belief is forgotten."""


@pytest.fixture(scope="module")
def motions() -> list[Motion]:
    """6 s of S-turns, stick to and fro."""
    rest = Sines(rest_ell(PARAMETERS.lines.length, PARAMETERS.kite.y_A))
    start = gliding(PARAMETERS, 0.0, 0.7, 0.6)
    flight = SteeredFlight(
        Scenario("turns", PARAMETERS, rest, start, Times(9.0), False), "lagrange"
    )
    motions = [flight.result.motion]
    for tick in range(600):
        seen = true_estimate(flight.result.motion)
        wish = 0.6 if tick % 300 > 150 else -0.6
        off = turned(wish - seen.azimuth - seen.heading)
        motions.append(flight.tick(Command(max(-0.5, min(0.5, 0.6 * off)))).motion)
    return motions


def errors(motions: list[Motion], settings: SensorSettings, seed: int = 1) -> np.ndarray:
    """Of position, course [rad], turning [rad/s] and airspeed (a part), row by row."""
    observer = Observer(PARAMETERS, LAW, settings, seed)
    rows = []
    for motion in motions:
        seen, true = observer.look(motion), true_estimate(motion)
        across = cos(true.elevation) * (seen.azimuth - true.azimuth)
        rows.append(
            (
                hypot(across, seen.elevation - true.elevation),
                turned(seen.course - true.course),
                seen.turning - true.turning,
                seen.airspeed / true.airspeed - 1.0,
            )
        )
    return np.array(rows)[SETTLED:]


def rms(values: np.ndarray) -> np.ndarray:
    return np.asarray(np.sqrt(np.mean(values**2, axis=0)))


def test_ideal_sensors(motions: list[Motion]) -> None:
    position, way, turning, airspeed = rms(errors(motions, SensorSettings()))
    assert position < radians(0.02)
    assert way < radians(1.0)
    assert turning < 0.15
    assert airspeed < 0.07


def test_real_sensors(motions: list[Motion]) -> None:
    found = rms(np.concatenate([errors(motions, REAL, seed) for seed in range(4)]))
    assert found[0] < radians(0.55)  # half the noise
    assert found[1] < radians(4.0)
    assert found[2] < 0.35
    assert found[3] < 0.07


def test_it_is_as_sure_as_it_may_be(motions: list[Motion]) -> None:
    """Normalised squared errors of place and heading: their mean is 3 when all is as said.

    (Bar-Shalom, Li & Kirubarajan, Estimation with Applications, 2001, section 5.4.) The model's
    error is not white, so a factor of two and a half is left to it.
    """
    squares = []
    for seed in range(4):
        observer = Observer(PARAMETERS, LAW, REAL._replace(delay=0.0), seed)
        for tick, motion in enumerate(motions):
            observer.look(motion)
            if tick < SETTLED or tick % 10:
                continue
            kite, true = observer.kite, true_estimate(motion)
            p = direction(true.azimuth, true.elevation)
            nose = ahead_of(p, true.heading)
            right = np.cross(kite.nose, kite.p)
            off = np.array(p) - np.array(kite.p)
            e = np.array([off @ kite.nose, off @ right, np.array(nose) @ right])
            squares.append(e @ np.linalg.solve(observer.covariance[:3, :3], e))
    assert 3.0 / 2.5 < np.mean(squares) < 3.0 * 2.5


def test_over_the_zenith_nothing_breaks() -> None:
    glide, p = glide_of(PARAMETERS), direction(0.0, radians(85.0))
    kite = Flying(0.0, p, ahead_of(p, 0.0), 15.0, 0.0, 0.0, 0.0, 0.0)
    free = glide._replace(push=0.0, gravity=0.0)
    none = LAW._replace(c1=0.0, c2=0.0)
    for _ in range(40):
        kite = moved_on(kite, 0.01, 0.0, 25.0, free, none)
    angle = radians(85.0) + 15.0 * 0.4 / 25.0
    assert np.allclose(kite.p, (cos(angle), 0.0, sin(angle)), atol=1e-3)
    assert abs(abs(course(kite.p, kite.nose)) - pi) < 1e-9  # up became down
    assert abs(sqrt(sum(x * x for x in kite.nose)) - 1.0) < 1e-12


def test_it_turns_to_the_hand_that_pulls() -> None:
    glide, p = glide_of(PARAMETERS), direction(0.0, 0.7)
    kite = Flying(0.0, p, ahead_of(p, 0.0), 15.0, 0.0, 0.0, 0.0, 6.5)
    for _ in range(30):
        kite = moved_on(kite, 0.01, 0.2, 25.0, glide, LAW)
    assert kite.turning > 0.3
    assert course(kite.p, kite.nose) > 0.05
    assert kite.p.y > 0.0


def test_goes_on_to_the_same_bits_and_begins_anew(motions: list[Motion]) -> None:
    observer = Observer(PARAMETERS, LAW, REAL, 5)
    first = [observer.look(motion) for motion in motions[:50]]
    saved = observer.save()
    after: list[Estimate] = [observer.look(motion) for motion in motions[50:100]]
    observer.resume(saved)
    assert [observer.look(motion) for motion in motions[50:100]] == after
    assert [observer.look(motion) for motion in motions[:50]] == first
