"""The path that an autopilot flies: where the projection says, seen against anything, told."""

from math import degrees, nan, radians

import numpy as np
import pygame
import pytest
from numpy.typing import NDArray

from kitemj.drawing.flight_panels import window_title
from kitemj.drawing.instruments import WINDOW_TOP, Instruments
from kitemj.drawing.readings import Readings
from kitemj.drawing.sky_path import DASH, EDGE, GAP, PATH, SHADE, WIDTH, paint_sky_path
from kitemj.drawing.wind_window import WindWindow, bearing
from kitemj.drawing.wished import FOLLOWED, LEFT, Wished, in_E
from kitemj.flight.pilot_settings import Guided
from kitemj.paths.sphere import direction
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.vectors import Vector, times
from kitemj.scene.views import CAMERAS, downwind, pixel
from tests.drawing.test_legible import ANY, CALM, frame_of, luminance, noted, painted
from tests.scene.motions import LAKSA

GRAPHICS = 3.0
"""The least contrast of what is no text by WCAG 2.1, success criterion 1.4.11."""
NEAR = (WIDTH + EDGE) / 2 + 0.8
"""px; half of the line with its shade, half a pixel's diagonal, a piece's bow."""
AZIMUTH, ELEVATION = 0.45, 0.35
GUIDED = Guided("path", radians(1.26), 4.46, AZIMUTH, ELEVATION, 0.0)


def eight() -> NDArray[np.float64]:
    """A closed curve of 240 directions, to the right of downwind more than to the left."""
    t = np.linspace(0.0, 2 * np.pi, 240, endpoint=False)
    ways = zip(0.2 + 0.6 * np.sin(t), 0.6 + 0.2 * np.sin(2 * t), strict=True)
    return np.array([direction(a, e) for a, e in ways])


def places_in(view: str, directions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Columns and rows by `views.pixel`, one by one."""
    camera, found = CAMERAS[view](LAKSA, CALM), []
    for way in in_E(downwind(LAKSA), directions):
        seen = pixel(camera, times(LAKSA.lines.length, Vector(*way)), 1280, 720)
        found.append((seen.column, seen.row))
    return np.array(found)


def painted_path(view: str, wished: Wished, colour: tuple[int, int, int]) -> NDArray[np.int64]:
    surface = frame_of(colour, (1280, 720))
    paint_sky_path(surface, CAMERAS[view](LAKSA, CALM), LAKSA, wished, CALM, 1.0)
    return pygame.surfarray.array3d(surface).astype(int)


def test_directions_are_those_that_a_pilot_sees_whatever_the_wind_blows_from() -> None:
    for azimuth in (0.0, 0.4, -2.0):
        parameters = parameter_set("laksa", {"wind": {"azimuth": azimuth}})
        (way,) = in_E(downwind(parameters), np.array([direction(0.3, 0.5)]))
        left, up = bearing(parameters, Vector(*way))
        assert (left, up) == pytest.approx((-degrees(0.3), degrees(0.5)))


@pytest.mark.parametrize("view", ["side", "top"])
def test_the_path_is_where_the_projection_says(view: str) -> None:
    """Every pixel of it is near the curve, and there is one at the middle of each dash."""
    path = eight()
    image = painted_path(view, Wished(path, GUIDED._replace(azimuth=nan)), (128, 128, 128))
    curve = places_in(view, np.concatenate([path, path[:1]]))
    on = np.argwhere((image != 128).any(axis=2))
    assert len(on) > 500
    steps = np.linspace(0.0, 1.0, 9)[:, None, None]
    fine = (curve[:-1] + steps * np.diff(curve, axis=0)).reshape(-1, 2)
    apart = np.linalg.norm(on[:, None] - fine[None], axis=2).min(axis=1)
    assert apart.max() < NEAR
    kite = pixel(CAMERAS[view](LAKSA, CALM), CALM.body.p_G_E, 1280, 720)
    dashes = range(DASH // 2, len(path), DASH + GAP)
    middles = (curve[dashes] + curve[np.array(dashes) + 1]) / 2
    inside = ((middles > 5) & (middles < (1275, 715))).all(axis=1)
    inside &= np.hypot(*(middles - (kite.column, kite.row)).T) > 150
    assert inside.sum() > 5
    for column, row in middles[inside]:
        assert np.linalg.norm(on - (column, row), axis=1).min() < NEAR


def test_the_kite_is_before_the_path() -> None:
    seen = pixel(CAMERAS["pilot"](LAKSA, CALM), CALM.body.p_G_E, 1280, 720)
    azimuth, up = bearing(LAKSA, CALM.body.p_G_E)
    across = np.array([direction(a, radians(up)) for a in np.linspace(-0.5, 0.5, 240)])
    image = painted_path("pilot", Wished(across), (128, 128, 128))
    column, row = round(seen.column), round(seen.row)
    assert abs(azimuth) < 1.0
    assert (image[column - 6 : column + 7, row - 6 : row + 7] == 128).all()
    assert (image != 128).any()


@pytest.mark.parametrize("colour", [*ANY, (244, 246, 250), (60, 110, 150)])
def test_line_or_shade_is_seen_against_anything(colour: tuple[int, int, int]) -> None:
    """Against what is behind: sky, cloud, sea, grass and the rest."""
    light, dark, behind = (luminance(np.array(each)) for each in (PATH, SHADE, colour))
    contrasts = [(max(each, behind) + 0.05) / (min(each, behind) + 0.05) for each in (light, dark)]
    assert max(contrasts) >= GRAPHICS
    assert (light + 0.05) / (dark + 0.05) >= GRAPHICS
    image = painted_path("side", Wished(eight(), GUIDED), colour)
    for ink in (PATH, SHADE):
        assert (np.abs(image - ink).max(axis=2) < 16).any(), "both are there"


def test_a_path_that_is_not_followed_is_fainter() -> None:
    joining = GUIDED._replace(phase="climb", azimuth=nan)
    assert Wished(eight(), joining).opacity == Wished(eight()).opacity == LEFT
    assert Wished(eight(), GUIDED).opacity == FOLLOWED
    followed, not_yet = (
        np.abs(painted_path("side", Wished(eight(), each), (0, 0, 0))).sum()
        for each in (GUIDED._replace(azimuth=nan), joining)
    )
    assert followed > 1.5 * not_yet


def test_the_attractor_is_marked_where_it_is_in_both_pictures() -> None:
    wished, ways = Wished(None, GUIDED), np.array([direction(AZIMUTH, ELEVATION)])
    image = painted_path("side", wished, (128, 128, 128))
    on = np.argwhere((image != 128).any(axis=2))
    assert on.mean(axis=0) == pytest.approx(places_in("side", ways)[0], abs=1.0)
    instruments = Instruments(LAKSA, 1280, 720)
    without, marked = (painted_window(instruments, each) for each in (None, wished))
    on = np.argwhere((without != marked).any(axis=2))
    box, window = instruments.box("window"), WindWindow(LAKSA)
    (place,) = window.places(in_E(downwind(LAKSA), ways))
    corner = np.array([box.left, box.top + WINDOW_TOP])
    assert on.mean(axis=0) == pytest.approx(place + corner, abs=1.0)


def painted_window(instruments: Instruments, wished: Wished | None) -> NDArray[np.int64]:
    """A frame with the engineer's wind window, without its title."""
    surface = frame_of((128, 128, 128), (1280, 720))
    instruments.paint(surface, CALM, Readings(wished=wished), "engineer", {"window"})
    box = instruments.box("window")
    surface.fill((0, 0, 0), (box.left, box.top, box.width, 34))
    return pygame.surfarray.array3d(surface).astype(int)


def test_the_path_stands_in_the_wind_window() -> None:
    instruments, path = Instruments(LAKSA, 1280, 720), eight()
    without, drawn = (painted_window(instruments, each) for each in (None, Wished(path)))
    on = np.argwhere((without != drawn).any(axis=2))
    box = instruments.box("window")
    corner = np.array([box.left, box.top + WINDOW_TOP])
    places = corner + WindWindow(LAKSA).places(in_E(downwind(LAKSA), path))
    apart = np.linalg.norm(on[:, None] - places[None], axis=2).min(axis=1)
    assert len(on) > 150
    assert apart.max() < NEAR


def test_phase_error_and_lap_are_told() -> None:
    assert window_title(Readings(wished=Wished(None, GUIDED))) == "path, 1.3° R, lap 4.46"
    left = GUIDED._replace(error=-0.01)
    assert "0.6° L" in window_title(Readings(wished=Wished(None, left)))
    hold = Guided("hold", nan, nan, 0.0, 1.2, 0.0)
    assert window_title(Readings(wished=Wished(None, hold))) == "hold"
    assert window_title(Readings()) == "wind window, rim 90°"
    words, _, _ = painted("guided", "pilot", (1280, 720))
    assert "AUTOPILOT: untwist" in [each.text for each in words]
    with noted():
        assert painted("guided", "engineer", (1280, 720))
