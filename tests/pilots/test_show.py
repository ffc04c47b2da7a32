"""The show: what a newcomer sees first, on a kite that it must not fly into the ground."""

from math import degrees

import pytest

from kitemj.controls.stick import show_of
from kitemj.flight.live import SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.physics.parameter_files import parameter_set
from kitemj.pilots.show import Show
from kitemj.pilots.sight import Twist, sight

SHOW = 20.0
"""s, for which `kitemj fly` shows it where there is no display."""


FLIGHTS = [("sport", 5.0), ("sport", 6.5), ("sport", 8.0), ("trainer", 6.5), ("trainer", 8.0)]


@pytest.mark.parametrize(("kite", "wind"), FLIGHTS)
def test_a_show_has_eights_and_a_loop_each_way_and_ends_where_it_began(kite, wind):
    tables = {"set": kite, "duration": 60.0, "wind": {"speed": wind}}
    flight, pilot, twist = SteeredFlight(scenario_of(tables, "test")), Show(), Twist()
    result, sights, turns, height = flight.restart(), [], [], []
    while result.motion.t < SHOW:
        result = flight.tick(pilot.command(result.motion))
        assert result.departure is None, str(result.departure)
        sights.append(sight(result.motion))
        turns.append(twist.look(result.motion))
        height.append(-result.motion.body.p_G_E.z)
    assert min(height) > 5.0, "m"
    azimuths = [degrees(seen.azimuth) for seen in sights]
    assert min(azimuths) < -20 < 20 < max(azimuths), "eights"
    assert max(turns) > 0.95 or min(turns) < -0.95, "a loop"
    assert abs(turns[-1]) < 0.2, "untwisted by another"
    top, last = sights[0], sights[-1]
    assert degrees(abs(last.azimuth)) < 12
    assert degrees(top.elevation - last.elevation) < 12


def test_a_flight_that_begins_again_has_the_show_from_its_beginning():
    flight, pilot = SteeredFlight(scenario_of({"set": "sport", "duration": 60.0}, "test")), Show()
    flown = []
    for _ in range(2):
        result = flight.restart()
        while result.motion.t < 3.0:
            result = flight.tick(pilot.command(result.motion))
        flown.append(result.motion)
    assert flown[0] == flown[1]


@pytest.mark.parametrize("kite", ["sport", "trainer", "thesis", "laksa"])
def test_a_kite_that_only_drifts_has_a_programme_in_place_of_the_show(kite):
    steered_by = show_of(parameter_set(kite)).name
    assert steered_by == ("pilot" if kite in ("sport", "trainer") else "programme")
