"""Kites that drift away from the hand that pulls: held, parked, steadied, refused other things."""

from math import degrees, pi, radians

import numpy as np
import pytest

from kitemj.autopilot.drift_design import DriftDesign, Sideways, drift_design
from kitemj.autopilot.drift_hold import DriftHold, DriftPilot, check_slow
from kitemj.autopilot.follow import Estimate
from kitemj.dynamics.motion import Motion, State
from kitemj.equilibria.minimal import state_of
from kitemj.equilibria.trim import equilibria, trimmed
from kitemj.errors import InputError
from kitemj.flight.live import SteeredFlight
from kitemj.flight.pilot_settings import PilotSettings
from kitemj.flight.scenario import Scenario, Times
from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Sines
from kitemj.pilots.sight import sight
from kitemj.robustness.drift_loop import closed_loop, kite_answer, loop_gain

SETS = ("laksa", "thesis")
SETTLED = radians(0.2)
"""rad; a hold is there, a minute or two after it began 5 to 10° off."""
LINEAR = 0.02
"""Of the azimuth; what is left out beside the linear system at a tenth of full stick."""
GAP = 10e-6
"""m; the issue's, of models under feedback."""
HELD = PilotSettings(phases=("hold",))


@pytest.fixture(scope="module")
def designs() -> dict[str, DriftDesign]:
    """Of both sets."""
    return {name: drift_design(parameter_set(name)) for name in SETS}


def unstable() -> Parameters:
    """`laksa` that swings ever wider when left alone."""
    known = parameter_set("laksa")
    return known._replace(aero=known.aero._replace(Cl_beta=-0.49))


def flown(
    parameters: Parameters,
    pilot: DriftPilot,
    azimuth: float,
    duration: float,
    model: str = "lagrange",
) -> list[Motion]:
    """Motions of every tick, from rest turned about z_E to `azimuth` [rad], right positive."""
    x, lines = trimmed(parameters._replace(wind=parameters.wind._replace(gust_amplitude=0.0)))
    start = State(Angles(float(x[0]) + azimuth, *map(float, x[1:4])), state_of(x).q_dot)
    scenario = Scenario("test", parameters, Sines(lines.ell), start, Times(duration), False)
    flight = SteeredFlight(scenario, model)
    motions = [flight.result.motion]
    for _ in range(round(duration / 0.01)):
        motions.append(flight.tick(pilot.command(motions[-1])).motion)
    return motions


def off(motions: list[Motion], azimuth: float, since: float) -> float:
    """Largest error of azimuth [rad] from `since` [s] on."""
    return max(abs(sight(m).azimuth - azimuth) for m in motions if m.t >= since)


@pytest.mark.parametrize("name", SETS)
def test_held_aside_in_gusts_within_the_hands_limits(name: str) -> None:
    parameters, point = parameter_set(name), radians(6.0)
    wind = parameters.wind._replace(gust_amplitude=0.2, gust_frequency=2 * pi / 10.0)
    pilot = DriftPilot(parameters, HELD._replace(azimuth=point))
    motions = flown(parameters._replace(wind=wind), pilot, radians(-4.0), 70.0)
    gust = [sight(m).azimuth for m in motions[-1000:]]  # of 10 s, which is too quick for the hands
    assert abs(float(np.mean(gust)) - point) < SETTLED
    sticks = np.abs([[m.control.delta, m.control.delta_dot] for m in motions]).max(axis=0)
    assert sticks[0] <= 0.1
    assert sticks[1] <= 0.01 + 1e-9  # rounding
    assert motions[-1].control.delta < 0.0  # it stands right while the left hand pulls


def test_a_wind_from_aside_leaves_no_error_to_a_hold_and_no_stick_to_a_parked_kite() -> None:
    known, aside = parameter_set("laksa"), radians(4.0)
    parameters = known._replace(wind=known.wind._replace(azimuth=aside))
    pilot = DriftPilot(known, HELD)
    assert off(flown(parameters, pilot, 0.0, 65.0), 0.0, 60.0) < SETTLED
    pilot.hold = DriftHold(known, None)
    parked = flown(parameters, pilot, radians(5.0), 65.0)
    top = sight(parked[0]).azimuth - radians(5.0)
    assert top == pytest.approx(aside)  # the wind's azimuth, as the pilot sees it
    assert off(parked, top, 60.0) < SETTLED
    assert abs(parked[-1].control.delta) < 0.001


def test_an_unstable_kite_is_steadied_and_without_a_pilot_is_not() -> None:
    parameters = unstable()
    pilot = DriftPilot(parameters, HELD)
    start = radians(3.0)
    assert off(flown(parameters, pilot, start, 45.0), 0.0, 40.0) < SETTLED
    pilot.hold.wish = lambda seen, control: 0.0  # type: ignore[method-assign]
    assert off(flown(parameters, pilot, start, 30.0), 0.0, 20.0) > start


def test_three_models_fly_the_same_under_the_hold() -> None:
    parameters = parameter_set("thesis")
    places = []
    for model in ("lagrange", "newton-euler", "mujoco"):
        pilot = DriftPilot(parameters, HELD)
        motions = flown(parameters, pilot, radians(8.0), 6.0, model)
        places.append(np.array([m.body.p_G_E for m in motions]))
    for other in places[1:]:
        assert np.linalg.norm(other - places[0], axis=1).max() < GAP


def test_the_linear_kite_rests_where_the_trim_does(designs: dict[str, DriftDesign]) -> None:
    for name in SETS:
        there = equilibria(parameter_set(name), None, 0.01)[0]
        assert designs[name].azimuth * 0.01 == pytest.approx(-there.azimuth, rel=LINEAR)
        still = kite_answer(designs[name].sideways, 1e-6)[0]
        assert complex(still).real == pytest.approx(designs[name].azimuth, rel=1e-4)


def test_margins_are_those_that_the_issue_asks_for(designs: dict[str, DriftDesign]) -> None:
    frequencies = np.geomspace(1e-3, 50.0, 2000)
    for name in SETS:
        assert closed_loop(designs[name])[0].real < 0.0
        loop = loop_gain(designs[name], frequencies)
        crossings = np.diff(np.sign(np.abs(loop) - 1.0)) != 0.0
        phase = np.abs(np.angle(-loop[1:][crossings]))
        assert phase.size
        assert degrees(phase.min()) >= 45.0
        real = loop.real[1:][np.diff(np.sign(loop.imag)) != 0.0]
        assert real.min() > -0.5  # 6 dB


def test_the_loop_from_ticks_is_the_loop_that_is_flown(designs: dict[str, DriftDesign]) -> None:
    """The hold, asked tick by tick what it does with a kite that swings, answers as computed."""
    design, omega, tick = designs["laksa"], 0.8, 0.01
    pilot = DriftHold(parameter_set("laksa"), 0.0, design)
    swung = kite_answer(design.sideways, omega)
    at_rest = Estimate(0.0, 1.2, 0.0, 0.0, 0.0, 0.0, 7.0, 0.0)
    delta = rate = 0.0
    found = []
    for i in range(40000):
        azimuth, heading = (1e-3 * swung * np.exp(1j * omega * i * tick)).imag
        seen = at_rest._replace(azimuth=float(azimuth), heading=float(heading))
        wish = pilot.wish(seen, Control(200.0, 0.0, 0.0, delta, rate, 0.0))
        found.append(delta)
        ddot = 225.0 * (wish - delta) - 24.0 * rate  # the hands' spring: 15 rad/s, damped by 0.8
        delta, rate = delta + tick * rate + tick**2 / 2 * ddot, rate + tick * ddot
    turns = round(2 * pi / omega / tick) * 10
    times = np.arange(40000)[-turns:] * tick
    answer = 2j * np.mean(np.array(found[-turns:]) * np.exp(-1j * omega * times)) / 1e-3
    assert -answer == pytest.approx(complex(loop_gain(design, np.array([omega]))[0]), rel=1e-2)


def test_what_cannot_be_done_is_refused_before_the_flight() -> None:
    with pytest.raises(InputError, match=r"pilot\.phases must be .*'path'.*within ±10° of azimuth"):
        check_slow(PilotSettings(phases=("path",)), parameter_set("laksa"))
    with pytest.raises(InputError, match=r"pilot\.azimuth_deg must be within ±8\.6°, got 11\.0°"):
        DriftPilot(parameter_set("thesis"), HELD._replace(azimuth=radians(11.0)))
    check_slow(PilotSettings(phases=("path",)), parameter_set("sport"))


def test_a_stick_that_does_nothing_cannot_stop_what_grows(monkeypatch: pytest.MonkeyPatch) -> None:
    def cut(parameters: Parameters, model: str = "lagrange") -> Sideways:
        return whole._replace(B=0.0 * whole.B)

    whole = drift_design(unstable()).sideways
    monkeypatch.setattr("kitemj.autopilot.drift_design.sideways", cut)
    with pytest.raises(InputError, match=r"the stick cannot hold this kite in 7 m/s"):
        drift_design(unstable())
