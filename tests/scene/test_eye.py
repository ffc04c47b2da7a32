"""Eyes that follow: softly, and never so that the kite is lost."""

from functools import cache
from itertools import pairwise
from math import exp, radians

import numpy as np
import pytest

from kitemj.dynamics.motion import Motion
from kitemj.flight.live import SteeredFlight
from kitemj.flight.scenario import scenario_of
from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.vectors import Vector, cross, minus, norm, plus, times
from kitemj.pilots.manoeuvres import Land, Loop
from kitemj.scene.eye import GAP, Eye, damped
from kitemj.scene.views import UP, Camera, pixel
from tests.scene.motions import motion_at

STUNT = parameter_set("sport")
FOLLOWING = ("pilot", "chase")
FRAME = 1280, 720
INNER = 0.8
"""Of the frame; what is further out is easily missed."""
CALM = radians(200.0)
"""rad/s² that a camera turns with at most: half a turn/s after 1 s; 165°/s² measured."""
FAST = radians(60.0)
"""rad/s that it turns at most: a quarter of the width of a frame in half a second."""

BREATH = radians(8.0)
"""rad/s that its field opens and closes with at most, a sixth of it; 5°/s measured."""


@cache
def flown(kite: str = "sport") -> tuple[Motion, ...]:
    """A loop to the right at full stick, and then low to the edge and down to the ground: 30 Hz."""
    scenario = scenario_of({"set": kite, "duration": 40.0}, "test")
    flight = SteeredFlight(scenario, model="lagrange")
    loop, land = Loop(), Land()
    result, motions = flight.restart(), []
    while result.departure is None and result.motion.t < 40.0:
        if flight.ticks % 3 == 0:
            motions.append(result.motion)
        pilot = loop if result.motion.t < 6.0 else land
        result = flight.tick(pilot.command(result.motion))
    assert loop.looped
    return tuple(motions)


def cameras(view: str, motions: tuple[Motion, ...], kite: str = "sport") -> list[Camera]:
    eye = Eye(parameter_set(kite))
    return [eye.look(motion, view) for motion in motions]


@pytest.mark.parametrize("view", FOLLOWING)
@pytest.mark.parametrize("kite", ["sport", "trainer"])
def test_the_kite_stays_in_the_inner_frame(kite: str, view: str) -> None:
    (width, height), span = FRAME, parameter_set(kite).kite.span
    for motion, camera in zip(flown(kite), cameras(view, flown(kite), kite), strict=True):
        for side in (-0.5, 0.0, 0.5):
            tip = plus(motion.body.p_G_E, times(side * span, motion.body.R_BE.y))
            seen = pixel(camera, tip, width, height)
            assert seen.depth > 0
            assert abs(2 * seen.column / width - 1) < INNER
            assert abs(2 * seen.row / height - 1) < INNER


@pytest.mark.parametrize("view", FOLLOWING)
def test_a_camera_turns_and_moves_calmly(view: str) -> None:
    seen = cameras(view, flown())
    dt = flown()[1].t - flown()[0].t
    turns = np.cross(*(np.array([c.forward for c in part]) for part in (seen[:-1], seen[1:]))) / dt
    assert np.linalg.norm(turns, axis=1).max() < FAST
    assert np.linalg.norm(np.diff(turns, axis=0), axis=1).max() / dt < CALM
    fields = np.array([camera.field for camera in seen])
    assert np.abs(np.diff(fields)).max() / dt < BREATH


@pytest.mark.parametrize("view", FOLLOWING)
def test_the_horizon_is_level_and_the_kite_against_the_sky(view: str) -> None:
    for motion, camera in zip(flown(), cameras(view, flown()), strict=True):
        right = cross(camera.forward, camera.up)
        assert abs(right.z) < 1e-9
        assert camera.up.z < 0
        if -motion.body.p_G_E.z > 4.0:
            # a point far ahead at the eye's height is on the horizon
            level = plus(camera.position, times(1e6, cross(UP, right)))
            horizon = pixel(camera, level, *FRAME)
            kite = pixel(camera, motion.body.p_G_E, *FRAME)
            assert kite.row < horizon.row, "above it"


def test_the_pilot_sees_the_horizon_low_below_a_kite_that_is_not_high() -> None:
    for elevation in range(5, 36, 5):
        motion = motion_at(STUNT, Angles(0.0, radians(90 - elevation), 0.0, -0.1))
        camera = Eye(STUNT).look(motion, "pilot")
        horizon = (
            pixel(camera, plus(camera.position, Vector(-1e6, 0.0, 0.0)), *FRAME).row / FRAME[1]
        )
        assert 0.7 < horizon < 1.0, elevation
        depth = pixel(camera, motion.body.p_G_E, *FRAME).depth
        wide = 2 * depth * np.tan(camera.field / 2) * FRAME[0] / FRAME[1]
        assert STUNT.kite.span / wide > 0.04, "of the frame's width"


@pytest.mark.parametrize("view", FOLLOWING)
def test_over_the_zenith_there_is_no_jump(view: str) -> None:
    """A kite that flies over the pilot, and beside the zenith, from 30° before to 15° beyond."""
    for aside in (-0.05, -1e-9, 1e-9, 0.05):
        motions = [
            motion_at(STUNT, Angles(0.0, radians(angle), aside, 0.0))._replace(t=0.03 * i)
            for i, angle in enumerate(np.arange(30.0, -15.0, -0.5))
        ]
        seen = cameras(view, tuple(motions))
        for (one, before), (other, after) in pairwise(zip(motions, seen, strict=True)):
            moved = norm(minus(other.body.p_G_E, one.body.p_G_E))
            assert norm(minus(after.forward, before.forward)) < 2.0 * moved / STUNT.lines.length
            assert norm(minus(after.up, before.up)) < 2.0 * moved / STUNT.lines.length
            assert norm(minus(after.position, before.position)) < 1.5 * moved + 1e-3


@pytest.mark.parametrize("view", FOLLOWING)
def test_a_pause_stands_still_and_a_jump_begins_anew(view: str) -> None:
    motions = flown()
    eye = Eye(STUNT)
    fresh = Eye(STUNT).look(motions[40], view)
    for motion in motions[:41]:
        followed = eye.look(motion, view)
    assert followed != fresh, "it has a past"
    assert eye.look(motions[40], view) == followed, "a pause"
    assert eye.look(motions[0], view) == Eye(STUNT).look(motions[0], view), "back in time"
    after = motions[0]._replace(t=motions[0].t + GAP)
    moved = motions[40]._replace(t=motions[0].t + 2.1 * GAP)
    eye.look(after, view)
    assert eye.look(moved, view) == fresh, "a gap"
    elsewhere = motions[5]._replace(t=moved.t)
    assert eye.look(elsewhere, view) == Eye(STUNT).look(elsewhere, view), "another flight"


@pytest.mark.parametrize("view", FOLLOWING)
def test_the_same_motions_give_the_same_cameras_at_any_rate(view: str) -> None:
    motions = flown()[:60]
    assert cameras(view, motions) == cameras(view, motions)
    often, seldom = cameras(view, motions)[::2], cameras(view, motions[::2])
    for one, other in zip(often, seldom, strict=True):
        assert norm(minus(one.forward, other.forward)) < radians(0.5)


def test_a_follower_is_the_oscillator_of_the_textbook() -> None:
    """Critically damped: after a step of its aim 1 - (1 + wt) e^-wt; 2/w behind a ramp."""
    w, t = 3.0, 0.7
    place, speed = damped(0.0, 0.0, 1.0, 0.0, w, 1.0, t)
    assert place == pytest.approx(1 - (1 + w * t) * exp(-w * t))
    assert speed == pytest.approx(w * w * t * exp(-w * t))
    for lead, lag in ((0.0, 2 / w), (0.5, 1 / w), (1.0, 0.0)):
        place, speed = damped(5.0, -1.0, 0.0, 2.0, w, lead, 20.0)
        assert place == pytest.approx(2.0 * (20.0 - lag))
        assert speed == pytest.approx(2.0)
    whole = damped(0.3, 0.2, 1.0, 0.4, w, 0.5, 0.5)
    half = damped(0.3, 0.2, 1.0, 0.4, w, 0.5, 0.25)
    assert damped(*half, 1.1, 0.4, w, 0.5, 0.25) == pytest.approx(whole)
