"""How a kite meets the ground: which part, how fast, where, and what is said of it."""

from math import atan2, cos, hypot, pi, radians, sin, sqrt

import pytest

from kitemj.dynamics.motion import Body, Motion, PerLine, straight_lines
from kitemj.flight.live import Command, SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.physics.frames import Angles
from kitemj.physics.loads import Air
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control
from kitemj.physics.vectors import Rotation, Vector, cross, rotated
from kitemj.pilots.crash import DAMAGES, SOFT, FirstTouch, Touch, touch_at
from kitemj.pilots.manoeuvres import Land

SPORT = parameter_set("sport")
STILL = Vector(0.0, 0.0, 0.0)
DOWN = Vector(0.0, 0.0, 1.0)
ROUNDING = 1e-9


def attitude(nose_down: float, left_down: float) -> Rotation:
    """A kite that looks into the wind, its left half to the pilot's left, then tilted [rad].

    y_E is the pilot's left, and so is y_B.
    """
    a, b = nose_down, left_down
    x_B = Vector(cos(a), 0.0, sin(a))
    y_B = Vector(-sin(b) * sin(a), cos(b), sin(b) * cos(a))
    return Rotation(x_B, y_B, cross(x_B, y_B))


def motion_of(
    R_BE: Rotation,
    velocity: Vector = STILL,
    place: Vector = Vector(-20.0, 0.0, 0.0),  # noqa: B008  immutable
    spin: Vector = STILL,
    t: float = 0.0,
) -> Motion:
    """A body on the ground below `place`: its lowest corner a millimetre under it."""
    kite, lift = SPORT.kite, 0.0
    for x in (-1, 1):
        for y in (-1, 1):
            for z in (-0.05, 0.05):
                corner = Vector(x * kite.chord / 2, y * kite.span / 2, z)
                lift = max(lift, R_BE.x.z * corner.x + R_BE.y.z * corner.y + R_BE.z.z * corner.z)
    body = Body(Vector(place.x, place.y, place.z - lift + 1e-3), R_BE, velocity, spin)
    still = Control(25.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    lines = straight_lines(SPORT, body, still, PerLine(5.0, 5.0))
    return Motion(t, Angles(0.0, 0.0, 0.0, 0.0), body, still, lines, Air(0.2, 0.0, 5.0))


def touched(*where: float, parameters: Parameters = SPORT, **how: Vector) -> Touch:
    touch = touch_at(parameters, motion_of(attitude(*map(radians, where)), **how))
    assert touch
    return touch


@pytest.mark.parametrize(
    ("nose_down", "left_down", "part"),
    [
        (40.0, 0.0, "nose"),
        (-40.0, 0.0, "tail"),
        (0.0, 40.0, "left tip"),
        (0.0, -40.0, "right tip"),
        (40.0, 20.0, "left wing's leading corner"),
        (-40.0, 20.0, "left wing's trailing corner"),
        (40.0, -20.0, "right wing's leading corner"),
        (-40.0, -20.0, "right wing's trailing corner"),
        (1.0, 1.0, "belly"),
        (181.0, 1.0, "belly"),
    ],
)
def test_the_lowest_part_is_named(nose_down: float, left_down: float, part: str) -> None:
    assert touched(nose_down, left_down).part == part


def test_nothing_is_said_of_a_kite_in_the_air() -> None:
    high = motion_of(attitude(0.3, 0.0), place=Vector(-20.0, 0.0, -5.0))
    assert touch_at(SPORT, high) is None


@pytest.mark.parametrize("turned", [0.0, 0.5, -2.0])
@pytest.mark.parametrize(("azimuth", "side"), [(40.0, "right"), (-70.0, "left")])
def test_the_place_is_told_from_downwind_and_right_is_the_pilots_right(
    turned: float, azimuth: float, side: str
) -> None:
    parameters = SPORT._replace(wind=SPORT.wind._replace(azimuth=turned))
    # downwind is -x_E turned about z_E, and the pilot's right of it -y_E turned as much
    ahead, right = 23.0 * cos(radians(azimuth)), 23.0 * sin(radians(azimuth))
    s, c = sin(turned), cos(turned)
    place = Vector(-c * ahead + s * right, -s * ahead - c * right, 0.0)
    touch = touched(30.0, 0.0, parameters=parameters, place=place)
    assert touch.distance == pytest.approx(23.0, abs=SPORT.kite.span)
    assert touch.azimuth == pytest.approx(radians(azimuth), abs=radians(4.0))
    assert touch.place.endswith(f"to the {side}")


def test_the_energy_is_that_of_moving_and_turning() -> None:
    kite = SPORT.kite
    spin = Vector(3.0, -2.0, 1.0)
    touch = touched(40.0, 20.0, velocity=Vector(1.0, 2.0, 6.0), spin=spin)
    turning = kite.inertia_x * 9.0 + kite.inertia_y * 4.0 + kite.inertia_z * 1.0
    expected = 0.5 * (kite.mass * 41.0 + turning)
    assert touch.energy == pytest.approx(expected, rel=ROUNDING)
    assert touch.hardness == pytest.approx(sqrt(2 * expected / kite.mass), rel=ROUNDING)


def test_the_speed_is_that_of_the_part_that_touches() -> None:
    spin_E = Vector(2.0, 0.0, 0.0)  # about the wind's axis: the left tip goes down
    R_BE = attitude(0.0, radians(30.0))
    touch = touch_at(SPORT, motion_of(R_BE, DOWN, spin=rotated(R_BE, spin_E)))
    assert touch
    arm = hypot(SPORT.kite.span / 2, 0.05)
    turn = atan2(0.05, SPORT.kite.span / 2) + radians(30.0)
    assert touch.sinking == pytest.approx(1.0 + 2.0 * arm * cos(turn), rel=ROUNDING)
    across = 2.0 * arm * sin(turn)
    assert touch.speed == pytest.approx(hypot(across, touch.sinking), rel=ROUNDING)


def test_harder_breaks_more_and_soft_breaks_nothing() -> None:
    said = []
    for speed in (1.0, 2.9, 3.1, 5.9, 6.1, 8.9, 9.1, 12.9, 13.1, 17.9, 18.1, 40.0):
        touch = touched(40.0, 20.0, velocity=Vector(0.0, 0.0, speed))
        assert touch.gentle == (speed < SOFT)
        assert ("estimate" in str(touch)) == (not touch.gentle)
        said.append(touch.damage)
    assert said[::2] == said[1::2]
    assert len(set(said)) == len(DAMAGES) + 1
    nose = touched(40.0, 0.0, velocity=Vector(0.0, 0.0, 15.0))
    assert "spine" in nose.damage


def test_a_soft_part_of_a_hard_kite_is_no_landing() -> None:
    """The corner stands still while the kite turns about it."""
    R_BE = attitude(0.0, radians(30.0))
    spin_E = Vector(6.0, 0.0, 0.0)
    corner = Vector(SPORT.kite.chord / 2, SPORT.kite.span / 2, 0.05)
    arm = Vector(0.0, *(R_BE.y[i] * corner.y + R_BE.z[i] * corner.z for i in (1, 2)))
    touch = touch_at(
        SPORT,
        motion_of(R_BE, Vector(0.0, 6.0 * arm.z, -6.0 * arm.y), spin=rotated(R_BE, spin_E)),
    )
    assert touch
    assert touch.speed == pytest.approx(0.0, abs=1e-9)
    assert touch.hardness > 6.0
    assert not touch.gentle


def fly(stick: float, until: float, wind: float, every: int, model: str) -> Touch | None:
    tables = {"set": "sport", "duration": 30.0, "wind": {"speed": wind}}
    flight = SteeredFlight(scenario_of(tables, "test"), model, step=0.002)
    ground, result = FirstTouch(flight.parameters), flight.restart()
    while result.motion.t < 12.0 and not ground.touch:
        result = flight.tick(Command(stick if result.motion.t < until else 0.0))
        if flight.ticks % every == 0:
            ground.watch(result.motion)
    return ground.touch


@pytest.mark.parametrize("model", ["mujoco", "lagrange"])
def test_a_dive_is_told_as_it_was_before_the_ground_pushed(model: str) -> None:
    """MuJoCo's ground halves the speed within the tick of the touch, Lagrange has no ground."""
    touch, seldom = (fly(-1.0, 1.0, 6.5, every, model) for every in (1, 3))
    assert touch
    assert seldom
    assert touch.speed == pytest.approx(15.0, abs=0.2), "m/s, of the free flight"
    assert seldom.speed == pytest.approx(touch.speed, abs=0.5)
    assert touch.part == seldom.part == "left wing's leading corner"
    assert touch.azimuth < radians(-30.0), "the left hand pulled"
    assert touch.distance == pytest.approx(25.0, abs=1.5)
    assert not touch.gentle


def test_a_pilots_landing_is_gentle() -> None:
    tables = {"set": "sport", "duration": 30.0}
    flight = SteeredFlight(scenario_of(tables, "test"), step=0.002)
    ground, result, pilot = FirstTouch(flight.parameters), flight.restart(), Land()
    while result.motion.t < 20.0 and not ground.watch(result.motion):
        result = flight.tick(pilot.command(result.motion))
    touch = ground.touch
    assert touch
    assert touch.gentle
    assert "right" in touch.part
    assert touch.damage == "A soft landing"


def test_only_the_first_touch_counts_until_time_jumps_back() -> None:
    ground, tilt = FirstTouch(SPORT), attitude(0.7, 0.0)
    fast, slow = Vector(0.0, 0.0, 9.0), Vector(0.0, 0.0, 1.0)
    ground.watch(motion_of(tilt, fast, Vector(-20.0, 0.0, -1.0), t=1.0))
    first = ground.watch(motion_of(tilt, slow, t=1.01))
    assert first
    assert first.speed == pytest.approx(9.0), "m/s, before the touch"
    assert ground.watch(motion_of(tilt, slow, t=1.02)) is first
    assert ground.watch(motion_of(tilt, fast, Vector(-20.0, 0.0, -9.0), t=0.0)) is None
    again = ground.watch(motion_of(attitude(0.0, pi / 4), slow, t=0.01))
    assert again
    assert again.part == "left tip"
