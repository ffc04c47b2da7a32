"""The machine of phases: their order, what ends them, launch and landing, twist, the ground."""

from collections.abc import Callable
from itertools import groupby
from math import cos, degrees, pi, radians
from pathlib import Path
from typing import NamedTuple, get_args

import pytest

from kitemj.autopilot.autopilot import Autopilot, SavedAutopilot
from kitemj.autopilot.observer import SavedObserver
from kitemj.autopilot.phases import PHASES
from kitemj.dynamics.motion import Motion, State
from kitemj.flight.equilibrium import equilibrium
from kitemj.flight.gliding import gliding
from kitemj.flight.limits import VALIDITY, departure_at, touches_ground
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.on_the_ground import launching
from kitemj.flight.pilot_settings import Guided, PhaseName, PilotSettings
from kitemj.flight.scenario import Scenario, Times
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Sines, rest_ell
from kitemj.pilots.crash import SOFT, FirstTouch, Touch
from kitemj.pilots.sight import sight

DOCS = Path(__file__).parents[2] / "docs" / "phases.md"
SINK = 3.0
"""m/s of ground speed at touch-down: what the issue of a landing allows."""
HALF_A_TURN = pi
"""rad of twist: less is none, since the lines are then as much wound as at a start."""
HOLDS = radians(6.0)
"""rad of azimuth beside the point that is held: a quarter of the span at 25 m is 5°."""


class Flown(NamedTuple):
    """A flight: what was seen in each tick, what the autopilot told, the first touch."""

    motions: list[Motion]
    told: list[Guided]
    touch: Touch | None
    parameters: Parameters

    @property
    def phases(self) -> list[PhaseName]:
        """In the order in which they were flown."""
        return [phase for phase, _ in groupby(guided.phase for guided in self.told)]


def in_wind(kite: str, wind: float) -> Parameters:
    """A set in a steady wind [m/s]."""
    parameters = parameter_set(kite)
    return parameters._replace(wind=parameters.wind._replace(speed=wind))


def flight_of(parameters: Parameters, start: State) -> SteeredFlight:
    """A flight of the Lagrangian kite."""
    rest = Sines(rest_ell(parameters.lines.length, parameters.kite.y_A))
    return SteeredFlight(Scenario("test", parameters, rest, start, Times(90.0), False), "lagrange")


def fly(
    parameters: Parameters,
    start: State,
    settings: PilotSettings,
    seconds: float,
    spoil: Callable[[Command], Command] = lambda command: command,
) -> Flown:
    """Flies until the ground, or for so long."""
    flight, pilot = flight_of(parameters, start), Autopilot(parameters, settings)
    watch, motions, told = FirstTouch(parameters), [flight.result.motion], []
    for _ in range(round(seconds / TICK)):
        command = spoil(pilot.command(motions[-1]))
        told.append(pilot.guided)
        motions.append(flight.tick(command).motion)
        if watch.watch(motions[-1]):
            break
    return Flown(motions, told, watch.touch, parameters)


STARTS = (("sport", 5.0, 1.0, "left"), ("trainer", 7.0, -1.0, "left"))
"""Set, m/s of wind, the side of the launch (right +1), that of the landing."""
HOP: tuple[PhaseName, ...] = ("launch", "hold", "land")


@pytest.fixture(
    scope="module", params=[("sport", 5.0, 1.0, "left"), ("trainer", 7.0, -1.0, "left")]
)
def hop(request: pytest.FixtureRequest) -> Flown:
    """From the ground at the edge to the ground at the edge."""
    kite, wind, side, landing = request.param
    parameters = in_wind(kite, wind)
    settings = PilotSettings(phases=HOP, hold=5.0, side=landing)
    return fly(parameters, launching(parameters, side), settings, 80.0)


def test_phases_are_flown_in_the_order_of_the_settings(hop: Flown) -> None:
    assert hop.phases == list(HOP)


def test_a_launch_stays_off_the_ground_and_a_landing_is_soft(hop: Flown) -> None:
    assert hop.touch is not None
    assert hop.told[-1].phase == "land"
    assert hop.touch.speed < SINK == SOFT
    assert degrees(hop.touch.azimuth) < -30.0  # on the left, far from the strong wind


def test_launch_and_landing_stay_within_what_the_model_vouches_for(hop: Flown) -> None:
    departures = (departure_at(hop.parameters, motion, VALIDITY) for motion in hop.motions[:-1])
    assert not list(filter(None, departures))


def test_a_point_is_held_as_long_as_was_asked(hop: Flown) -> None:
    held = [guided for guided in hop.told if guided.phase == "hold"]
    assert len(held) == pytest.approx(5.0 / TICK, abs=2)  # a tick at either end


def test_with_the_hands_crossed_it_comes_down_at_once() -> None:
    parameters = in_wind("sport", 6.5)
    settings = PilotSettings(phases=HOP, hold=5.0)
    start = launching(parameters, 1.0)
    found = fly(
        parameters, start, settings, 30.0, lambda command: command._replace(delta=-command.delta)
    )
    assert found.touch is not None
    assert found.told[-1].phase == "launch"


@pytest.mark.parametrize("azimuth", [0.0, radians(-20.0)])
def test_a_kite_is_parked_at_an_azimuth(azimuth: float) -> None:
    parameters = in_wind("sport", 6.5)
    settings = PilotSettings(phases=("hold",), azimuth=azimuth)
    found = fly(parameters, gliding(parameters, 0.2, 0.7, 0.5), settings, 25.0)
    for motion in found.motions[-300:]:
        assert sight(motion).azimuth == pytest.approx(azimuth, abs=HOLDS)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_twist_is_undone(way: float) -> None:
    parameters = in_wind("sport", 6.5)
    flight = flight_of(parameters, top(parameters))
    pilot = Autopilot(parameters, PilotSettings(phases=("untwist", "hold")))
    memory = pilot.memory
    pilot.command(flight.result.motion)  # with straight lines: the phase was over at once
    _, guided, (sensors, held) = pilot.save()
    assert held
    wound = SavedObserver(sensors, held._replace(twist=way * 2 * 2 * pi))
    pilot.resume(SavedAutopilot(memory, guided, wound))
    seen = []
    for _ in range(round(40.0 / TICK)):
        seen.append(pilot.command(flight.result.motion))
        flight.tick(seen[-1])
        assert not touches_ground(parameters, flight.result.motion)
        if pilot.guided.phase == "hold":
            break
    assert pilot.guided.phase == "hold"
    assert abs(pilot.guided.twist) < HALF_A_TURN


def top(parameters: Parameters) -> State:
    """At rest at the top of the window."""
    return gliding(parameters, 0.0, pi / 2 - equilibrium(parameters).gamma, 0.0)


@pytest.mark.parametrize("heading", [-150.0, 110.0])
def test_a_nose_that_points_down_is_turned_up_first(heading: float) -> None:
    parameters = in_wind("sport", 6.5)
    start = gliding(parameters, 0.3, radians(50.0), radians(heading))
    found = fly(parameters, start, PilotSettings(phases=("climb", "path")), 8.0)
    assert found.touch is None
    assert any(cos(sight(motion).heading) > 0.7 for motion in found.motions)


def test_what_is_remembered_is_all_that_there_is() -> None:
    parameters = in_wind("sport", 6.5)
    settings = PilotSettings(phases=("hold",))
    start = gliding(parameters, 0.3, 0.8, 0.5)
    one, other = Autopilot(parameters, settings), Autopilot(parameters, settings)
    flight = flight_of(parameters, start)
    for _ in range(300):
        flight.tick(one.command(flight.result.motion))
    other.resume(one.save())
    for _ in range(100):
        motion = flight.result.motion
        command = one.command(motion)
        assert other.command(motion) == command
        flight.tick(command)


def test_the_manual_has_every_phase() -> None:
    rows = [line.split("|") for line in DOCS.read_text("utf-8").splitlines() if "| `" in line]
    told = {row[1].strip().strip("`"): (row[2].strip(), row[3].strip()) for row in rows}
    assert told == {name: (phase.does, phase.until) for name, phase in PHASES.items()}
    assert set(told) == set(get_args(PhaseName))
