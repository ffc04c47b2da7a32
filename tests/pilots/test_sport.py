"""The kite to learn on: what it does on its own, and what pilots make of it, in 5 to 8 m/s."""

from math import degrees, hypot, pi, radians

import numpy as np
import pytest

from kitemj.dynamics.lagrange import accelerations
from kitemj.dynamics.lagrange_kite import flown
from kitemj.dynamics.motion import Motion, State
from kitemj.flight.equilibrium import equilibrium_state
from kitemj.flight.limits import GROUND
from kitemj.flight.live import Command, SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Segment, rest_ell
from kitemj.physics.wind import Wind
from kitemj.pilots.manoeuvres import Eight, Hold, Land, Loop, Pilot
from kitemj.pilots.sight import Sight, Twist, sight, turned

SPORT = parameter_set("sport")
WINDS = (5.0, 6.5, 8.0)
AGREEMENT = 5e-6
"""m; MuJoCo beside Lagrange at 2 ms, up to 20 s of loops and eights: 1.8 µm measured."""
SOFT = 3.0
"""m/s of G in the tick before the touch; 0.9 to 1.7 measured."""


class Table:
    """A stick that holds each row (from when [s], δ in -1..1) until the next."""

    def __init__(self, *rows: tuple[float, float]) -> None:
        self._rows = rows

    def command(self, motion: Motion) -> Command:
        return Command([delta for start, delta in self._rows if motion.t >= start][-1])


STILL = Table((0.0, 0.0))


class PilotedFlight:
    """All motions of a live flight, the departures, and the largest gap to the reference."""

    def __init__(self, pilot: Pilot, wind: float, duration: float) -> None:
        tables = {"set": "sport", "duration": duration, "wind": {"speed": wind}}
        flight = SteeredFlight(scenario_of(tables, "test"), reference="lagrange")
        result = flight.restart()
        self.motions, self.departures, self.gap = [result.motion], [], 0.0
        while result.motion.t < duration - 1e-9 and not self.landed:
            result = flight.tick(pilot.command(result.motion))
            self.motions.append(result.motion)
            self.gap = max(self.gap, result.gap or 0.0)
            if result.departure:
                self.departures.append(result.departure)

    @property
    def landed(self) -> bool:
        return any(departure.limit is GROUND for departure in self.departures)

    @property
    def sights(self) -> list[Sight]:
        return [sight(motion) for motion in self.motions]

    @property
    def twist(self) -> list[float]:
        twist = Twist()
        return [twist.look(motion) for motion in self.motions]

    def holds(self) -> None:
        """Within the model's limits, beside the reference, lines neither weak nor overloaded."""
        assert not [str(d) for d in self.departures if d.limit is not GROUND]
        assert self.gap <= AGREEMENT
        pulls = [pull for motion in self.motions for pull in motion.tensions]
        assert min(pulls) > 0.5, "N"
        assert max(pulls) < 150.0, "N"


def in_wind(speed: float) -> Parameters:
    return SPORT._replace(wind=Wind(speed))


def at_rest(parameters: Parameters) -> Segment:
    rest = rest_ell(parameters.lines.length, parameters.kite.y_A)
    return Segment(0.0, Control(rest, 0.0, 0.0, 0.0, 0.0, 0.0))


def speed(motion: Motion) -> float:
    return hypot(*motion.body.v_G_E)


@pytest.mark.parametrize("wind", WINDS)
def test_every_small_disturbance_dies_out(wind):
    parameters = in_wind(wind)
    q, q_dot = equilibrium_state(parameters)
    x, h = np.array([*q, *q_dot]), 1e-5
    lines = at_rest(parameters).control

    def rates(x: np.ndarray) -> np.ndarray:
        q, q_dot = Angles(*x[:4]), Angles(*x[4:])
        return np.array([*q_dot, *accelerations(parameters, lines, 0.0, q, q_dot).q_ddot])

    columns = [rates(x + h * e) - rates(x - h * e) for e in np.eye(8)]
    values = np.linalg.eigvals(np.array(columns).T / (2 * h))
    assert values.real.max() < -0.03, "1/s: -0.21, -0.12, -0.045 in 5, 6.5, 8 m/s"


@pytest.mark.parametrize("aside", [-0.3, 0.1, 0.3])
def test_comes_back_to_the_top_by_itself(aside):
    q, q_dot = equilibrium_state(SPORT)
    start = State(q._replace(eta=q.eta + aside), q_dot)
    end = flown(SPORT, at_rest(SPORT), 0.0, start, 15000, 0.002)
    assert abs(end.q.eta) + abs(end.q.phi) < 0.1 * abs(aside), "rad, after 30 s"


@pytest.mark.parametrize("wind", WINDS)
def test_a_stick_that_does_nothing_stays_aloft_even_after_a_knock(wind):
    flight = PilotedFlight(Table((0.0, 0.0), (1.0, 0.2), (1.3, 0.0)), wind, 60.0)
    flight.holds()
    azimuths = [degrees(seen.azimuth) for seen in flight.sights]
    assert max(map(abs, azimuths)) > 1.0, "a knock that is felt: 6°, 17°, 26°"
    assert not flight.landed
    assert min(degrees(seen.elevation) for seen in flight.sights) > 45.0


@pytest.mark.parametrize("wind", WINDS)
@pytest.mark.parametrize("side", [1.0, -1.0], ids=["right", "left"])
def test_turns_to_the_hand_that_pulls(wind, side):
    flight = PilotedFlight(Table((0.0, side)), wind, 2.0)  # s; later the loop leads back
    flight.holds()
    azimuths = [side * degrees(seen.azimuth) for seen in flight.sights]
    assert min(azimuths) > -2.0, "never to speak of to the other side: -1.6 in the weakest wind"
    assert max(azimuths) > 8.0, "9° in the weakest wind, 20° in the others"
    assert side * flight.motions[-1].control.delta > 0
    left, right = flight.motions[-1].lengths
    assert side * (left - right) > 0


@pytest.mark.parametrize("wind", WINDS)
@pytest.mark.parametrize("side", [1.0, -1.0], ids=["right", "left"])
def test_loops_once_and_climbs_back_with_one_twist(wind, side):
    flight = PilotedFlight(Loop(side), wind, 14.0)
    flight.holds()
    assert flight.twist[-1] == pytest.approx(side, abs=0.05)
    assert abs(degrees(flight.sights[-1].azimuth)) < 5.0
    assert degrees(flight.sights[-1].elevation) > 60.0
    assert min(-motion.body.p_G_E.z for motion in flight.motions) > 10.0, "m above ground"


@pytest.mark.parametrize("wind", WINDS)
def test_full_stick_turns_in_3_to_8_m_and_loops_in_2_to_5_s(wind):
    flight = PilotedFlight(Table((0.0, 1.0)), wind, 4.5)
    flight.holds()
    turns, t = np.array(flight.twist), np.array([motion.t for motion in flight.motions])
    quarter, full = (float(np.interp(part, turns, t)) for part in (0.25, 1.25))
    assert 1.5 < full - quarter < 5.0, "s from flying right to flying right again"
    rounds = [i for i, turn in enumerate(turns) if 0.25 < turn < 1.25]
    path = sum(speed(flight.motions[i]) for i in rounds) * 0.01
    assert 3.0 < path / (2 * pi) < 8.0, "m"


@pytest.mark.parametrize("wind", WINDS)
def test_figures_of_eight_leave_the_lines_untwisted(wind):
    pilot = Eight()
    flight = PilotedFlight(pilot, wind, 20.0)
    flight.holds()
    assert pilot.passes >= 6
    assert max(map(abs, flight.twist)) < 0.6
    azimuths = [degrees(seen.azimuth) for seen in flight.sights]
    assert min(azimuths) < -20.0 < 20.0 < max(azimuths)
    assert min(-motion.body.p_G_E.z for motion in flight.motions) > 5.0, "m above ground"


@pytest.mark.parametrize("wind", WINDS)
@pytest.mark.parametrize("side", [1.0, -1.0], ids=["right", "left"])
def test_lands_softly_at_the_edge_of_the_window(wind, side):
    flight = PilotedFlight(Land(side), wind, 20.0)
    flight.holds()
    assert flight.landed
    assert side * degrees(flight.sights[-1].azimuth) > 60.0
    assert speed(flight.motions[-2]) < SOFT


@pytest.mark.parametrize("wind", WINDS)
def test_a_pilot_holds_the_top(wind):
    flight = PilotedFlight(Hold(), wind, 10.0)
    flight.holds()
    assert min(degrees(seen.elevation) for seen in flight.sights) > 60.0
    assert max(abs(degrees(seen.azimuth)) for seen in flight.sights) < 5.0


def test_the_sight_is_what_the_pilot_sees():
    kite = PilotedFlight(STILL, 6.5, 0.1).motions[0]
    assert sight(kite).azimuth == pytest.approx(0.0, abs=1e-12)
    assert sight(kite).heading == pytest.approx(0.0, abs=1e-12)
    assert sight(kite).elevation == pytest.approx(radians(70.7), abs=radians(0.1))
    right = PilotedFlight(Table((0.0, 1.0)), 6.5, 1.3).motions[-1]
    assert right.body.p_G_E.y < 0, "m: right of the pilot is -y_E"
    assert sight(right).azimuth > 0
    assert sight(right).heading > radians(30.0)
    assert sight(right).turning > 0


def test_turns_are_counted_through_half_turns():
    assert turned(3.5 * pi) == pytest.approx(-0.5 * pi)
    assert turned(-0.5 * pi, pi) == pytest.approx(1.5 * pi)
