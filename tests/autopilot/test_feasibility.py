"""What is said of a path before the flight, against flights and against arithmetic."""

import re
from math import degrees, radians, sqrt, tan
from typing import NamedTuple

import numpy as np
import pytest

from kitemj.autopilot.follow import at, follow, learn, length_of, nothing_learnt, stick_for
from kitemj.autopilot.rehearse import on_path
from kitemj.autopilot.truth import true_estimate
from kitemj.errors import FlightError, InputError
from kitemj.flight.equilibrium import equilibrium
from kitemj.flight.limits import touches_ground
from kitemj.flight.pilot_settings import PathSettings, TurnRateLaw
from kitemj.paths.check_path import COMFORT, asked_by, check_path, scaled, usual_path
from kitemj.paths.feasibility import AUTHORITY, feasibility, turning_on
from kitemj.paths.glide import airspeeds, glide_ratio, trim, with_weight
from kitemj.paths.path import path_of, periodic_slope
from kitemj.physics.compiled import Array
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import norm
from kitemj.turning.gains import Gains
from kitemj.turning.hands import moved

LAW = TurnRateLaw(0.29, -3.0, 0.4, 16.0, 2.8)
"""About that of `sport`; a kite of another size turns on radii as many times as large."""
EASY = PathSettings(width=radians(88.0), height=radians(28.5), elevation=radians(40.0))
EIGHT = PathSettings(width=radians(82.0), height=radians(28.0), elevation=radians(38.0))
CIRCLE = PathSettings(kind="circle", radius=radians(22.0), elevation=radians(42.0))
HARD = CIRCLE._replace(radius=radians(11.0), elevation=radians(40.0))

FOUND_SPEED = 0.08  # of the speed; what is left out (sideslip, the lift's tilt) slows it by 4-5 %
FOUND_STICK = 0.12  # of the stick's way; errors and the sideslip are not in what is worked out
BALANCED = 0.01  # of the weight; steps along the path
WORSE = 1.2  # times the glide's error, at least, is the one without weight and mass


def of(size: float, length: float, wind: float, name: str = "sport") -> Parameters:
    """The set, scaled: areas and masses by the square, inertias by the 4th power."""
    known = parameter_set(name)
    body, s = known.kite, size
    kite = body._replace(
        mass=s**2 * body.mass,
        area=s**2 * body.area,
        **{name: s * getattr(body, name) for name in ("chord", "span", "x_A", "y_A", "z_A")},
        **{name: s**4 * getattr(body, name) for name in ("inertia_x", "inertia_y", "inertia_z")},
    )
    wind_, lines = known.wind._replace(speed=wind), known.lines._replace(length=length)
    return known._replace(kite=kite, lines=lines, wind=wind_)


def law_of(size: float) -> TurnRateLaw:
    """Of `sport` so many times as large."""
    return LAW._replace(c1=LAW.c1 / size)


class Laps(NamedTuple):
    """What was flown from the second lap on; each (n,)."""

    progress: Array
    speed: Array
    delta: Array
    error: Array
    down: bool


def laps(settings: PathSettings, parameters: Parameters, until: float = 4.0) -> Laps:
    """A flight that begins on the path, and is learnt from; `speed` in winds."""
    path, gains = path_of(settings, glide_ratio(parameters)), Gains(0.4)
    flight, rows, down = on_path(parameters, path), [], False
    progress, learnt, full = 0.0, nothing_learnt(), parameters.stick.delta
    for _ in range(4000):
        motion = flight.result.motion
        seen = true_estimate(motion)
        asked = follow(path, LAW, gains, seen, progress, learnt, full)
        learnt = learn(path, LAW, gains, seen, asked, asked.progress - progress, learnt)
        progress = asked.progress
        speed = norm(motion.body.v_G_E) / parameters.wind.speed
        rows.append((progress / length_of(path), speed, motion.control.delta, asked.error))
        command = moved(stick_for(LAW, gains, seen, asked), motion.control, parameters.stick)
        try:
            down = touches_ground(parameters, flight.tick(command).motion)
        except FlightError:
            down = True
        if down or progress > until * length_of(path):
            break
    lap, *others = np.array([row for row in rows if row[0] > 1.0 or down]).T
    return Laps(lap * length_of(path), *others, down)


def error(of: Array, beside: Array) -> float:
    """rms, a part of the rms of `beside`."""
    return float(sqrt(np.mean((of - beside) ** 2) / np.mean(beside**2)))


@pytest.fixture(scope="module")
def flown() -> dict[str, tuple[PathSettings, Parameters, Laps]]:
    cases = {
        "eight, 5 m/s": (EIGHT, of(1.0, 25.0, 5.0)),
        "eight, 6.5 m/s": (EIGHT, of(1.0, 25.0, 6.5)),
        "circle, 5 m/s": (CIRCLE, of(1.0, 25.0, 5.0)),
        "easy": (EASY, of(1.0, 25.0, 8.0)),
    }
    return {name: (*case, laps(*case)) for name, case in cases.items()}


@pytest.mark.parametrize("name", ["sport", "trainer", "laksa", "thesis"])
def test_the_glide_ratio_is_that_of_rest_in_a_wind_that_makes_weight_nothing(name: str) -> None:
    known = parameter_set(name)
    storm = known._replace(wind=known.wind._replace(speed=1e5))
    rest = equilibrium(storm)
    assert glide_ratio(known) == pytest.approx(1 / tan(rest.gamma), rel=1e-6)
    assert trim(known).alpha == pytest.approx(rest.alpha, rel=1e-6)
    assert glide_ratio(storm) == glide_ratio(known)


@pytest.mark.parametrize("name", ["eight, 5 m/s", "eight, 6.5 m/s", "circle, 5 m/s", "easy"])
def test_a_kite_flies_at_the_speed_that_was_worked_out(
    flown: dict[str, tuple[PathSettings, Parameters, Laps]], name: str
) -> None:
    settings, parameters, found = flown[name]
    light = path_of(settings, glide_ratio(parameters))
    heavy = with_weight(light, parameters)
    by_weight, by_glide = (
        error(np.array([at(path, path.speed, float(s)) for s in found.progress]), found.speed)
        for path in (heavy, light)
    )
    assert by_weight < FOUND_SPEED
    assert by_glide > WORSE * by_weight


def test_without_weight_and_mass_the_speed_is_the_glide() -> None:
    known = of(1.0, 25.0, 6.5)
    feather = known._replace(kite=known.kite._replace(mass=1e-3 * known.kite.mass))
    path = path_of(EIGHT, glide_ratio(feather))
    assert with_weight(path, feather).speed == pytest.approx(path.speed, rel=5e-3)


def test_forces_make_the_acceleration_along_the_nose() -> None:
    # Newton's law in SI, in vectors across the line: lift, drag and weight along the nose
    parameters = of(1.0, 25.0, 5.0)
    path = with_weight(path_of(EIGHT, glide_ratio(parameters)), parameters)
    found, kite, L = trim(parameters), parameters.kite, 25.0
    v, p, t = 5.0 * path.speed, path.points, path.ahead
    gained = periodic_slope(v**2 / 2, path.spacing * L)
    right = np.cross(t, p)
    acceleration = gained[:, None] * t + (v**2 / L * path.curvature)[:, None] * right
    air = v[:, None] * t - [5.0, 0.0, 0.0]
    out = np.sum(air * p, axis=1)
    across = air - out[:, None] * p
    nose = across / np.linalg.norm(across, axis=1)[:, None]
    airspeed = np.linalg.norm(air, axis=1)
    way = air / airspeed[:, None]
    lift = p - np.sum(p * way, axis=1)[:, None] * way
    lift /= np.linalg.norm(lift, axis=1)[:, None]
    dynamic = 0.5 * 1.225 * kite.area * airspeed**2
    force = dynamic[:, None] * (found.lift * lift - found.drag * way)
    force = force - [0.0, 0.0, kite.mass * 9.81]
    missing = np.sum((force - kite.mass * acceleration) * nose, axis=1)
    assert abs(missing).max() < BALANCED * kite.mass * 9.81


@pytest.mark.parametrize("name", ["eight, 6.5 m/s", "circle, 5 m/s", "easy"])
def test_a_feasible_path_is_flown_with_the_stick_that_was_worked_out(
    flown: dict[str, tuple[PathSettings, Parameters, Laps]], name: str
) -> None:
    settings, parameters, found = flown[name]
    asked = check_path(settings, parameters, LAW)
    assert asked.share <= 0.7
    most = float(np.abs(found.delta).max()) / parameters.stick.delta
    assert most == pytest.approx(asked.stick, abs=FOUND_STICK)
    assert most < 0.85  # never near the stop
    assert not found.down
    assert degrees(sqrt(float(np.mean(found.error**2)))) < 1.5


def test_an_infeasible_path_is_flown_at_the_stop_and_missed() -> None:
    parameters = of(1.0, 25.0, 6.5)
    asked = asked_by(HARD, parameters, LAW)
    assert asked.stick > 1.3
    found = laps(HARD, parameters)
    assert np.abs(found.delta).max() > 0.97 * parameters.stick.delta
    assert found.down or degrees(np.abs(found.error).max()) > 5.0


def test_the_least_radius_is_that_of_the_law() -> None:
    # Fagiano et al. (2014): without weight, drift and lag a kite turns on 1/(c₁ u)
    known = of(1.0, 25.0, 8.0)
    weightless = known._replace(environment=known.environment._replace(gravity=0.0))
    law = TurnRateLaw(0.25)
    asked = asked_by(EIGHT, weightless, law)
    path = with_weight(path_of(EIGHT, glide_ratio(weightless)), weightless)
    i = int(np.argmin(np.linalg.norm(path.points - asked.stick_at, axis=1)))
    over_air = float(path.speed[i] / airspeeds(path)[i])
    assert asked.least == pytest.approx(over_air / (0.25 * AUTHORITY * 0.7), rel=1e-9)
    assert asked.radius == pytest.approx(25.0 / abs(path.turning[i]), rel=1e-9)
    assert asked.stick == pytest.approx(AUTHORITY * asked.least / asked.radius, rel=1e-9)


def test_weight_turns_the_nose_as_the_law_says() -> None:
    parameters = of(1.0, 25.0, 5.0)
    path = with_weight(path_of(CIRCLE, glide_ratio(parameters)), parameters)
    _, gain, by_weight = turning_on(path, parameters, LAW)
    air = path.speed[:, None] * path.ahead - [1.0, 0.0, 0.0]
    i = int(path.points[:, 1].argmax())  # at the right, where a circle to the left goes up
    p, v = path.points[i], 5.0 * air[i]
    up = np.array([0.0, 0.0, 1.0]) - p[2] * p
    side = np.cross(up, p) / np.linalg.norm(up)  # to the pilot's right
    across = v - (v @ p) * p
    sine = across @ side / np.linalg.norm(across)
    airspeed = np.linalg.norm(v)
    level = np.hypot(p[0], p[1])
    assert by_weight[i] == pytest.approx(LAW.c2 / airspeed * sine * level)
    assert gain[i] == pytest.approx(LAW.gain(airspeed))


def test_rate_and_acceleration_of_the_hands_are_those_of_the_stick_in_time() -> None:
    parameters = of(1.0, 25.0, 6.5)
    path = with_weight(path_of(EIGHT, glide_ratio(parameters)), parameters)
    asked = feasibility(path_of(EIGHT, glide_ratio(parameters)), parameters, LAW)
    turning, gain, by_weight = turning_on(path, parameters, LAW)
    delta = (turning - by_weight) / gain
    step = path.spacing * 25.0 / 6.5 / path.speed
    t = np.append(0.0, np.cumsum(0.5 * (step + np.roll(step, -1))))
    even = np.linspace(0.0, t[-1], 4001)
    stick = np.interp(even, t, np.append(delta, delta[0]))
    smooth = np.convolve(
        np.concatenate([stick[-26:-1], stick, stick[1:26]]), np.ones(51) / 51, "valid"
    )
    rate = np.gradient(smooth, even)
    assert np.abs(rate).max() / 1.5 == pytest.approx(asked.rate, rel=0.03)
    assert np.abs(np.gradient(rate, even)).max() / 6.0 == pytest.approx(asked.acceleration, rel=0.1)


REFUSED = {
    "radius": (scaled(PathSettings(), 0.5), of(1.0, 25.0, 8.0)),
    "circle": (PathSettings(kind="circle", radius=0.2, elevation=0.6), of(1.0, 25.0, 8.0)),
    "window": (PathSettings(width=2.0, height=0.7, elevation=0.85), of(1.0, 25.0, 5.0)),
    "ground": (EIGHT._replace(elevation=radians(17.0)), of(1.0, 25.0, 6.5)),
    "points": (
        PathSettings(kind="points", points=((0.1, 0.5), (0.3, 0.6), (0.1, 0.7), (-0.1, 0.6))),
        of(1.0, 25.0, 8.0),
    ),
}
SAYS = {
    "radius": r"turns the nose on a radius of \d\.\d m at azimuth -?\d+ deg, elevation \d+ deg; .* "
    r"on 25 m lines in 8 m/s turns there on \d+\.\d m at least",
    "circle": r"on 25 m lines in 8 m/s",
    "window": r"(stops the kite|slows it to \d\.\d+ m/s) on 25 m lines in 5 m/s at azimuth",
    "ground": r"brings the kite's lowest corner to -?\d\.\d m above ground",
    "points": r"turns the nose",
}


@pytest.mark.parametrize("name", REFUSED)
def test_a_path_that_cannot_be_flown_is_refused_with_one_that_can(name: str) -> None:
    settings, parameters = REFUSED[name]
    with pytest.raises(InputError, match=SAYS[name]) as found:
        check_path(settings, parameters, LAW)
    said = str(found.value)
    assert said.startswith("pilot.path ")
    assert "\n" not in said
    size = re.search(r"([\d.]+) times as large would do", said)
    if size:  # what it names would do indeed, and little less would not
        factor = float(size[1])
        check_path(scaled(settings, factor * (1.01 if factor > 1 else 0.99)), parameters, LAW)
        with pytest.raises(InputError):
            check_path(scaled(settings, factor * (0.97 if factor > 1 else 1.03)), parameters, LAW)
    else:
        assert "no size of it would do there; a " in said


@pytest.mark.parametrize("kind", ["lemniscate", "circle"])
@pytest.mark.parametrize(
    ("size", "length", "winds"),
    [
        (1.0, 25.0, (5.0, 8.0)),
        (1.0, 60.0, (9.0,)),
        (0.6, 20.0, (4.5,)),
        (1.5, 50.0, (6.5,)),
    ],
)
def test_a_usual_path_suits_the_kite(
    size: float, length: float, winds: tuple[float, ...], kind: str
) -> None:
    for wind in winds:
        parameters, law = of(size, length, wind), law_of(size)
        settings = usual_path(parameters, law, kind)  # type: ignore[arg-type]
        asked = check_path(settings, parameters, law)
        if kind == "lemniscate":
            assert asked.share <= COMFORT * 1.25
        path = path_of(settings, glide_ratio(parameters))
        assert path.points[:, 2].min() > np.sin(radians(20.0)) - 1e-3
        assert asked.height > 1.0
        assert asked.winds > 0.7
        # no smaller one is as comfortable, unless it is as small as they get
        smaller = asked_by(scaled(settings, 0.9), parameters, law)
        assert smaller.share > min(asked.share, COMFORT) or degrees(settings.width) < 33.0


def test_longer_lines_need_a_smaller_angle_and_stronger_wind_a_larger() -> None:
    widths = [usual_path(of(1.0, length, 6.5), LAW).width for length in (25.0, 60.0)]
    assert widths == sorted(widths, reverse=True)
    widths = [usual_path(of(1.0, 25.0, wind), LAW).width for wind in (5.0, 8.0)]
    assert widths == sorted(widths)


def test_where_no_path_can_be_flown_that_is_said() -> None:
    slow = LAW._replace(c1=0.02)
    with pytest.raises(InputError, match="no lemniscate suits this kite") as found:
        usual_path(of(1.0, 25.0, 6.5), slow)
    assert "\n" not in str(found.value)
    with pytest.raises(InputError, match="nor a usual path"):
        check_path(EIGHT, of(1.0, 25.0, 6.5), slow)


def test_without_wind_or_turning_there_is_no_path() -> None:
    with pytest.raises(InputError, match=r"wind.speed > 0 m/s, got 0 m/s"):
        check_path(EIGHT, of(1.0, 25.0, 0.0), LAW)
    with pytest.raises(InputError, match="turns to the hand that pulls"):
        usual_path(of(1.0, 25.0, 6.5), LAW._replace(c1=-0.1))


def test_on_the_least_radius_the_stick_is_where_it_may_be_and_weight_counts() -> None:
    parameters = of(1.0, 25.0, 5.0)
    asked = asked_by(EIGHT, parameters, LAW)
    path = with_weight(path_of(EIGHT, glide_ratio(parameters)), parameters)
    i = int(np.argmin(np.linalg.norm(path.points - asked.stick_at, axis=1)))
    turning, gain, by_weight = (float(each[i]) for each in turning_on(path, parameters, LAW))
    most = np.sign(turning) * 5.0 * float(path.speed[i]) / asked.least
    assert abs(by_weight) > 0.02 * abs(turning)
    assert abs(most - by_weight) / gain == pytest.approx(AUTHORITY * parameters.stick.delta)


def test_the_height_is_that_of_a_wing_tip_of_a_kite_that_strays() -> None:
    parameters = of(1.0, 25.0, 6.5)
    level = PathSettings(kind="circle", radius=radians(10.0), elevation=radians(34.0))
    asked = asked_by(level, parameters, LAW)
    tip = sqrt(2.0**2 + 0.4**2) / 2
    assert asked.height == pytest.approx(25.0 * np.sin(radians(34.0 - 10.0 - 4.0)) - tip, rel=1e-4)
