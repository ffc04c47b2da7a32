"""A flight that goes back to a saved moment flies on from there to the same bits."""

import numpy as np
import pytest

from kitemj.dynamics.formulation import MODELS
from kitemj.flight.limits import GROUND
from kitemj.flight.live import Command, SteeredFlight
from kitemj.flight.scenario import scenario_of
from tests.recording.flights import LOOPS, restless

SPORT = {"set": "sport", "duration": 60.0}
VIOLENT = LOOPS | {"stick": {"delta": 0.9, "delta_dot": 3.0, "delta_ddot": 20.0}}
GUSTS = {
    "set": "laksa",
    "duration": 60.0,
    "wind": {"exponent": 0.14, "gust_amplitude": 0.1, "gust_frequency": 0.6},
}


def flat(value):
    """All numbers of nested tuples."""
    if isinstance(value, tuple):
        for part in value:
            yield from flat(part)
    else:
        yield float(value)


def numbers(result):
    return np.array(list(flat(result.motion)))


def flown(flight, stick, ticks):
    return [flight.tick(next(stick)) for _ in range(ticks)]


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("tables", [SPORT, GUSTS], ids=["sport", "gusts"])
def test_resumed_flight_has_the_same_bits(model, tables):
    flight = SteeredFlight(scenario_of(tables, "test"), model, "lagrange")
    flown(flight, restless(1), 150)
    saved = flight.save()
    first = flown(flight, restless(2), 200)
    assert flight.resume(saved) is saved.result
    again = flown(flight, restless(2), 200)
    for one, other in zip(first, again, strict=True):
        assert np.array_equal(numbers(one).view(np.int64), numbers(other).view(np.int64))
        assert one.gap == other.gap


def test_resumed_flight_has_the_same_bits_with_slack_lines_and_on_the_ground():
    flight = SteeredFlight(scenario_of(VIOLENT, "test"))
    stick = restless(5, hold=25)
    results, saved = [], []
    for _ in range(700):
        saved.append(flight.save())
        results.append(flight.tick(next(stick)))
    slack = [min(result.motion.tensions) == 0.0 for result in results]
    ground = [result.departure and result.departure.limit for result in results]
    assert any(slack)
    assert GROUND in ground
    for k in (slack.index(True) + 2, ground.index(GROUND) + 5):
        flight.resume(saved[k])
        stick = restless(5, hold=25)
        commands = [next(stick) for _ in range(700)]
        for result, command in zip(results[k : k + 60], commands[k : k + 60], strict=False):
            again = numbers(flight.tick(command))
            assert np.array_equal(again.view(np.int64), numbers(result).view(np.int64))


def test_another_stick_after_going_back_is_another_flight():
    flight = SteeredFlight(scenario_of(SPORT, "test"))
    flown(flight, restless(1), 50)
    saved = flight.save()
    first = flown(flight, iter([Command(1.0)] * 100), 100)
    flight.resume(saved)
    other = flown(flight, iter([Command(-1.0)] * 100), 100)
    apart = np.subtract(first[-1].motion.body.p_G_E, other[-1].motion.body.p_G_E)
    assert np.linalg.norm(apart) > 0.1
