"""Where the cameras of the views stand, and how they move."""

from inspect import signature
from math import cos, pi, sin

import pytest

import kitemj
from kitemj.cockpit.filming import FilmStyle
from kitemj.controls.actions import VIEWS, Wishes
from kitemj.drawing.picture import Picture
from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.vectors import minus, norm
from kitemj.scene import views
from tests.scene.motions import EQUILIBRIUM, LAKSA, SPORT, motion_at

ATTITUDES = [
    Angles(phi, gamma, eta, theta)
    for phi in (-1.4, 0.0, 1.4)
    for gamma in (-0.3, 0.0, 0.6, 1.5)
    for eta in (-1.2, 0.0, 1.2)
    for theta in (-2.5, 0.0, 1.2)
]


@pytest.mark.parametrize("overrides", [{}, SPORT], ids=["laksa", "sport"])
def test_the_chase_camera_holds_in_any_attitude(overrides: dict[str, dict[str, float]]) -> None:
    parameters = parameter_set("laksa", overrides)
    for q in ATTITUDES:
        motion = motion_at(parameters, q)
        camera = views.chase(parameters, motion)
        assert camera.position.z < -0.5, "above the ground"
        roll = camera.forward.x * camera.up.y - camera.forward.y * camera.up.x
        assert abs(roll) < 1e-12, "the horizon is level"
        assert camera.up.z < 0
        at = views.pixel(camera, motion.body.p_G_E, 1280, 720)
        if motion.body.p_G_E.z < 0:
            assert 500 < at.column < 780
            assert 300 < at.row < 370, "near the middle, but for an eye at the ground"
        assert camera.forward.x < 0, "downwind, so that +y_E stays on the left"


def test_the_chase_camera_moves_without_a_jump() -> None:
    steps = 400
    turns = [2 * pi * i / steps for i in range(steps + 1)]
    path = [Angles(0.9 * sin(u), 0.4 * cos(u), 1.5 * sin(u), u) for u in turns]
    motions = [motion_at(LAKSA, q) for q in path]
    cameras = [views.chase(LAKSA, m) for m in motions]
    for m, n, a, b in zip(motions[:-1], motions[1:], cameras[:-1], cameras[1:], strict=True):
        moved = norm(minus(n.body.p_G_E, m.body.p_G_E))
        assert norm(minus(b.position, a.position)) < 1.1 * moved + 0.01
        assert norm(minus(b.forward, a.forward)) < 3.0 * moved / LAKSA.lines.length + 1e-3


def test_every_view_that_can_be_asked_for_has_a_camera() -> None:
    assert (*views.CAMERAS, "orbit") == VIEWS


def test_the_pilot_view_is_the_first_and_the_one_that_is_not_asked_for() -> None:
    assert VIEWS[0] == Wishes().view == FilmStyle().view == "pilot"
    for function in (kitemj.film, Picture.paint):
        assert signature(function).parameters["view"].default == "pilot"


def test_the_orbit_goes_round_and_near_and_is_kept_within_bounds() -> None:
    motion = motion_at(LAKSA, EQUILIBRIUM)
    start = views.first_orbit(LAKSA)._replace(azimuth=0.0)
    behind = views.orbiting(LAKSA, motion, start).position
    right = views.orbiting(LAKSA, motion, start.turned(pi / 2, 0.0)).position
    G = motion.body.p_G_E
    assert behind.x > G.x + 10, "upwind of the kite"
    assert right.y < G.y - 10, "on the pilot's right"
    assert norm(minus(behind, G)) == pytest.approx(start.distance)
    assert start.zoomed(2.0, LAKSA).distance == pytest.approx(start.distance / 2)
    for orbit in (start.turned(0.0, 9.0), start.turned(40.0, -9.0), start.zoomed(1e9, LAKSA)):
        for bounded in (orbit, orbit.zoomed(1e-9, LAKSA)):
            camera = views.orbiting(LAKSA, motion, bounded)
            assert camera.position.z < 0, "above the ground"
            assert norm(camera.forward) == pytest.approx(1.0)
