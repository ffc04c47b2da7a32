"""What is heard of a motion: which line pulls, and when cloth flutters."""

from math import radians

from kitemj.dynamics.motion import Motion
from kitemj.flight.live import Command, SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.sound.hearing import heard

SCENARIO = scenario_of({"set": "sport", "duration": 60.0}, "test")
SPORT = SCENARIO.parameters


def flown(delta: float, ticks: int) -> Motion:
    flight = SteeredFlight(SCENARIO)
    for _ in range(ticks):
        flight.tick(Command(delta))
    return flight.result.motion


def pulling(motion: Motion, *pulls: float) -> Motion:
    lines = zip(motion.lines, pulls, strict=True)
    return motion._replace(lines=tuple(line._replace(tension_kite=pull) for line, pull in lines))


def test_a_kite_at_rest_is_heard_in_its_wind_and_does_not_flutter():
    now = heard(SPORT, flown(0.0, 1))
    assert abs(now.airspeed - SPORT.wind.speed) < 0.1
    assert 0.0 < now.left < 0.3
    assert abs(now.left - now.right) < 0.01
    assert now.flutter == 0.0


def test_the_line_that_pulls_more_is_the_louder_one():
    at_rest = flown(0.0, 1)
    now = heard(SPORT, pulling(at_rest, 10.0, 90.0))
    assert now.right > now.left > 0.0
    assert heard(SPORT, pulling(at_rest, 10.0, 900.0)).right < 1.0


def test_slack_lines_and_stalled_sails_flutter():
    at_rest = flown(0.0, 1)
    assert heard(SPORT, pulling(at_rest, 0.0, 5.0)).flutter == 1.0
    stall = SPORT.limits.alpha_stall
    angles = ((stall - 0.01, 0.0, 0.0), (stall + radians(4), 0.4, 0.6), (-1.0, 1.0, 1.0))
    for alpha, least, most in angles:
        motion = at_rest._replace(air=at_rest.air._replace(alpha=alpha))
        assert least <= heard(SPORT, motion).flutter <= most


def test_of_a_kite_on_the_ground_only_the_wind_is_heard():
    now = heard(SPORT, flown(0.0, 1), down=True)
    assert 0.0 < now.airspeed < SPORT.wind.speed
    assert now.left == now.right == now.flutter == 0.0
