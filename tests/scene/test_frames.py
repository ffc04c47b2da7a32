"""Kite and lines in rendered frames: where the geometry says, and seen against anything."""

from collections.abc import Iterator

import numpy as np
import pytest
from numpy.typing import NDArray

from kitemj.dynamics.motion import Motion
from kitemj.errors import NoGraphics
from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.vectors import Vector, plus, times, unrotated
from kitemj.scene.canopy import canopy
from kitemj.scene.cloth import fill_of
from kitemj.scene.figure import hands
from kitemj.scene.lines import drawn
from kitemj.scene.renderer import Renderer
from kitemj.scene.views import CAMERAS, Camera, Pixel, pixel
from tests.scene.motions import motion_at
from tests.support import pulling

STUNT = parameter_set("sport")
SIZE = 640, 360
HIGH = Angles(0.0, 0.6, 0.0, -0.1)


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    try:
        opened = Renderer(STUNT, *SIZE)
    except NoGraphics as reason:
        pytest.skip(str(reason))
    with opened:
        yield opened


def frame(renderer: Renderer, motion: Motion, camera: Camera) -> NDArray[np.int64]:
    renderer.render(motion, None, camera, forces=False)
    return renderer.frame().astype(int)


def without_kite(renderer: Renderer, motion: Motion, camera: Camera) -> NDArray[np.int64]:
    """The same, the kite and its lines out of sight."""
    up = Vector(0.0, 0.0, 1e4)
    body = motion.body._replace(p_G_E=plus(motion.body.p_G_E, up))
    lines = tuple(line._replace(points=(up, up)) for line in motion.lines)
    return frame(renderer, motion._replace(body=body, lines=lines), camera)


def test_the_sail_is_where_its_vertices_are(renderer: Renderer) -> None:
    motion = pulling(motion_at(STUNT, HIGH._replace(eta=0.4)), 20.0, 60.0)
    camera = CAMERAS["chase"](STUNT, motion)
    seen = frame(renderer, motion, camera) - without_kite(renderer, motion, camera)
    changed = np.abs(seen).max(axis=2) > 25
    shape = canopy(STUNT.kite).shape(fill_of(STUNT, motion))
    body = motion.body
    at = [pixel(camera, plus(body.p_G_E, unrotated(body.R_BE, Vector(*p))), *SIZE) for p in shape]
    columns, rows = ([p[k] for p in at] for k in (0, 1))
    above = changed[: int(np.median(rows))]  # of the lines
    assert np.flatnonzero(above.any(axis=1)).min() == pytest.approx(min(rows), abs=2.0)
    right = np.flatnonzero(changed[:, int(np.median(columns)) :].any(axis=0))
    assert int(np.median(columns)) + right.max() >= max(columns) - 2.0
    picture = frame(renderer, motion, camera)
    for y, strong, weak in ((0.30, 0, 2), (-0.30, 2, 0)):
        p = pixel(camera, plus(body.p_G_E, unrotated(body.R_BE, Vector(0.05, y, 0.0))), *SIZE)
        mean = picture[around(p, 4)].mean(axis=(0, 1))
        assert mean[strong] > 1.5 * mean[weak]


def around(p: Pixel, far: int) -> tuple[slice, slice]:
    """The pixels that are at most `far` from one, as an index of a frame."""
    row, column = round(p.row), round(p.column)
    return slice(row - far, row + far + 1), slice(column - far, column + far + 1)


def test_the_load_is_seen(renderer: Renderer) -> None:
    motion = motion_at(STUNT, HIGH)
    camera = CAMERAS["chase"](STUNT, motion)
    slack, full = (frame(renderer, pulling(motion, T, T), camera) for T in (0.0, 200.0))
    tail = plus(motion.body.p_G_E, unrotated(motion.body.R_BE, Vector(-0.35, 0.0, 0.0)))
    between = around(pixel(camera, tail, *SIZE), 12)  # the lines, which move with the hands
    assert np.count_nonzero(np.abs(full - slack)[between].max(axis=2) > 25) > 20


def test_light_goes_through_the_sail(renderer: Renderer) -> None:
    """Overhead the sun is on the far side; the near one is not black."""
    motion = motion_at(STUNT, Angles(0.0, 0.1, 0.0, 0.0))
    camera = CAMERAS["chase"](STUNT, motion)
    white = plus(motion.body.p_G_E, unrotated(motion.body.R_BE, Vector(-0.2, 0.06, 0.0)))
    at = pixel(camera, white, *SIZE)
    panel = frame(renderer, motion, camera)[around(at, 3)].min(axis=2)
    assert panel.max() > 215, "white, beside rods and seams"


@pytest.mark.parametrize("place", [0.1, 0.5, 0.8])
@pytest.mark.parametrize("gamma", [0.6, 1.45], ids=["sky", "ground"])
def test_lines_are_seen_against_sky_and_ground(
    renderer: Renderer, gamma: float, place: float
) -> None:
    """3 : 1 is what WCAG asks of graphics; the line's two colours have it against either."""
    motion = motion_at(STUNT, HIGH._replace(gamma=gamma))
    camera = CAMERAS["pilot"](STUNT, motion)
    if gamma > 1.0:  # down upon the field
        camera = CAMERAS["top"](STUNT, motion)._replace(wide=False)
    plain, lined = without_kite(renderer, motion, camera), frame(renderer, motion, camera)
    for line, hand in zip(motion.lines, hands(STUNT, motion), strict=True):
        start, end = drawn(line, hand)
        at = pixel(camera, plus(times(1 - place, start), times(place, end)), *SIZE)
        if not (5 < at.column < SIZE[0] - 5 and 5 < at.row < SIZE[1] - 5):
            continue
        near = around(at, 2)
        ratios = contrast(plain[near].mean(axis=(0, 1)), lined[near].reshape(-1, 3))
        assert ratios.max() > 3.0


def contrast(ground: NDArray[np.float64], colours: NDArray[np.int64]) -> NDArray[np.float64]:
    """Of each colour to the ground, WCAG 2.2."""

    def luminance(rgb: NDArray[np.float64]) -> NDArray[np.float64]:
        c = rgb / 255
        linear = np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
        return linear @ np.array([0.2126, 0.7152, 0.0722])

    a, b = luminance(np.asarray(ground, float)), luminance(colours.astype(float))
    return (np.maximum(a, b) + 0.05) / (np.minimum(a, b) + 0.05)
