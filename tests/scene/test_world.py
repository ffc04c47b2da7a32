"""Sky, ground, shadow and signs of the wind: each is where sun and wind put it."""

from collections.abc import Iterator
from math import atan2, cos, sin

import numpy as np
import pytest
from numpy.typing import NDArray

from kitemj.dynamics.motion import Body, Motion
from kitemj.mujoco_import import mujoco
from kitemj.physics.frames import R_BE, Angles, world
from kitemj.physics.vectors import Vector, cross, dot, minus, norm, plus, times
from kitemj.physics.wind import Wind
from kitemj.scene import views
from kitemj.scene.airflow import STEP, Airflow
from kitemj.scene.gl import NoGraphics
from kitemj.scene.ground import coast_distance, land
from kitemj.scene.gusts_and_grass import GUSTS, gust
from kitemj.scene.quality import HIGH, QUALITIES
from kitemj.scene.renderer import Renderer
from kitemj.scene.scene import Scene
from kitemj.scene.shadow import outline
from kitemj.scene.sky import RIM, directions, sky, sky_colour
from kitemj.scene.sun import sun
from kitemj.scene.wind_signs import RIBBON, SOCK, ribbon, sock
from tests.scene.motions import motion_at
from tests.support import LAKSA

AZIMUTH = atan2(3.0, 4.0)
ALONG, LEFT = Vector(-0.8, -0.6, 0.0), Vector(-0.6, 0.8, 0.0)
"""The wind's way of that azimuth, and the left of who looks that way: 3-4-5 triangles."""
BESIDE = LAKSA._replace(wind=Wind(7.0, azimuth=AZIMUTH))
GUSTY = Wind(6.0, gust_amplitude=0.4, gust_frequency=0.5, azimuth=AZIMUTH)
STILL = Angles(AZIMUTH, 0.5, 0.0, -0.2)
SIDE = 64  # texels of a small sky
SMALL = HIGH._replace(texels=256)
LIKENESS = 0.98  # correlation; of a sky that is turned or mirrored it is below 0.6


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    try:
        opened = Renderer(BESIDE, 320, 180, SMALL)
    except NoGraphics as reason:
        pytest.skip(str(reason))
    with opened:
        yield opened


def unit(v: Vector) -> Vector:
    return times(1 / norm(v), v)


def flying(t: float = 0.0) -> Motion:
    return motion_at(BESIDE, STILL)._replace(t=t)


def test_the_sky_has_no_seam_at_the_edges_of_its_cube() -> None:
    """Where two faces meet, texels differ as neighbours in one face do.

    The four walls in a row, each read from left to right, and their upper edges at the roof's.
    """
    # what is beyond the edges is there for the mixing of neighbours only
    pictures = sky(SIDE, 0.3)[:, RIM:-RIM, RIM:-RIM].astype(float)
    east, west, north, south, roof = pictures
    walls = (east, north, west, south)
    seams = [(walls[k][:, -1], walls[(k + 1) % 4][:, 0]) for k in range(4)]
    seams += [(roof[::-1, -1], east[0]), (roof[0, ::-1], north[0])]
    seams += [(roof[:, 0], west[0]), (roof[-1], south[0])]
    inside = [(face[:, 1:-1], face[:, 2:]) for face in walls] + [(roof[1:-1], roof[2:])]
    usual = max(np.abs(one - other).mean() for one, other in inside)
    for one, other in seams:
        assert np.abs(one - other).mean() < 1.5 * usual, "of 255; of texels of clouds"


@pytest.mark.parametrize("turn", [0.0, 1.6, 3.1, -1.5])
def test_the_engine_shows_the_sky_where_it_was_painted(renderer: Renderer, turn: float) -> None:
    """Up at 40°, all around: the frame is as the sky's own colours in the directions of pixels."""
    level = plus(times(cos(turn), ALONG), times(sin(turn), LEFT))
    eye = Vector(0.0, 0.0, -300.0)
    camera = views.looking(eye, plus(eye, plus(times(0.77, level), times(0.64, views.UP))))
    renderer.render(flying(), None, camera, forces=False)
    rows, columns = np.meshgrid(np.arange(180), np.arange(320), indexing="ij")
    focal, right = 90.0 / np.tan(camera.field / 2), cross(camera.forward, camera.up)
    rays = np.array(camera.forward) + (
        ((columns - 159.5) / focal)[..., None] * np.array(right)
        - ((rows - 89.5) / focal)[..., None] * np.array(camera.up)
    )
    rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
    parts = [rays @ np.array(axis) for axis in (ALONG, LEFT, views.UP)]
    expected = blocks(255 * sky_colour(*parts)[0])
    pixels = renderer.frame()
    assert pixels[[0, -1]].any(axis=-1).all(), "to the upper and lower edge"
    assert pixels[:, [0, -1]].any(axis=-1).all(), "to the edges at the sides"
    frame = blocks(pixels[..., 0].astype(float))
    assert np.abs(frame - expected).max() < 0.25 * np.ptp(expected)
    assert np.corrcoef(frame.ravel(), expected.ravel())[0, 1] > LIKENESS


def blocks(channel: NDArray[np.float64]) -> NDArray[np.float64]:
    """Means of 10 x 10 px, (18, 32): larger than the texels of a small sky."""
    return np.asarray(channel.reshape(18, 10, 32, 10).mean(axis=(1, 3)))


def brightest(azimuth: float) -> NDArray[np.float64]:
    """The direction [W] of the brightest part of the sky without its clouds: the sun."""
    image = sky(256, azimuth).astype(float).sum(axis=-1).ravel()
    places = directions(256).reshape(-1, 3)
    places = places / np.linalg.norm(places, axis=-1, keepdims=True)
    up = places[:, 2] > 0.3
    found = places[up][image[up] >= image[up].max() - 1].mean(axis=0)
    return np.asarray(found / np.linalg.norm(found))


def test_shadow_light_and_sky_have_the_same_sun(renderer: Renderer) -> None:
    shone = np.array(world(sun(BESIDE))) / norm(sun(BESIDE))
    assert brightest(AZIMUTH) @ shone > 0.98, "but for clouds before it"
    assert renderer.scene.model.light_dir[0] == pytest.approx(-shone, abs=1e-6)
    G = Vector(-60.0, -20.0, -90.0)
    body = Body(G, R_BE(STILL), Vector(0.0, 0.0, 0.0), Vector(0.0, 0.0, 0.0))
    small = 0.01 * np.array([(1, 0, 0), (0, 1, 0), (-1, -1, 0), (0, 0, 1)])
    x, y = outline(small, body, sun(BESIDE)).mean(axis=0)
    assert unit(minus(G, Vector(x, y, 0.0))) == pytest.approx(unit(sun(BESIDE)), abs=1e-3)
    # behind the pilot's left shoulder: the shadow falls ahead of the kite and to its right
    assert dot(minus(Vector(x, y, 0.0), G), ALONG) > 30
    assert dot(minus(Vector(x, y, 0.0), G), LEFT) < -30


def test_the_shadow_is_dark_and_in_the_picture_where_the_sun_puts_it(renderer: Renderer) -> None:
    motion = flying()
    G = motion.body.p_G_E
    place = plus(G, times(-G.z / sun(BESIDE).z, sun(BESIDE)))
    assert place.z == pytest.approx(0.0, abs=1e-9)
    eye = plus(place, Vector(0.1, 0.0, -40.0))
    camera = views.looking(eye, place)
    renderer.render(motion, None, camera, forces=False)
    there = renderer.frame()[80:100, 150:170].mean()
    renderer.render(motion_at(BESIDE, STILL._replace(phi=AZIMUTH + 1.0)), None, camera, False)
    light = renderer.frame()[80:100, 150:170].mean()
    assert there < 0.9 * light, "high up it is faint"


def test_a_low_kite_has_a_smaller_shadow_than_none_and_an_edge_on_one_none() -> None:
    body = Body(Vector(-9.0, 0.0, 0.5), R_BE(STILL), Vector(0, 0, 0), Vector(0, 0, 0))
    plate = np.array([(1.0, 1.0, 0.0), (1.0, -1.0, 0.0), (-1.0, -1.0, 0.0), (-1.0, 1.0, 0.0)])
    corners = outline(plate, body, sun(BESIDE))
    assert np.hypot(*(corners - (-9.0, 0.0)).T).max() < 2.0, "below the ground it stays beneath"
    line = np.array([(1.0, 0.0, 0.0), (0.0, 0.0, 0.0), (-1.0, 0.0, 0.0)])
    assert not len(outline(line, body, sun(BESIDE)))


@pytest.mark.parametrize("t", [0.0, 0.37, 5.0, 61.3])
def test_sock_and_ribbon_stream_downwind(t: float) -> None:
    top = Vector(0.0, 0.0, -4.0)
    for speed in (3.0, 8.0):
        v = times(speed, ALONG)
        for points, length in ((sock(top, v, 7.0, t), SOCK), (ribbon(top, v, 7.0, t), RIBBON)):
            end = minus(Vector(*points[-1]), top)
            assert dot(end, ALONG) > 0.5 * length
            assert abs(dot(end, LEFT)) < 0.5 * length
            assert norm(end) <= length + 1e-9
    weak = minus(Vector(*sock(top, times(1.0, ALONG), 7.0, t)[-1]), top)
    strong = minus(Vector(*sock(top, times(9.0, ALONG), 7.0, t)[-1]), top)
    assert weak.z > 3 * strong.z, "m; z points down"
    hanging = ribbon(top, Vector(0.0, 0.0, 0.0), 7.0, t)[-1]
    assert hanging == pytest.approx((0.0, 0.0, -4.0 + RIBBON), abs=0.1)


def test_gusts_go_as_far_as_the_wind_and_are_strong_when_it_is() -> None:
    """The wind's own integral: V (t + ε (1 - cos Ωt)/Ω)."""
    parameters = LAKSA._replace(wind=GUSTY)
    air, eps, omega = Airflow(parameters), GUSTY.gust_amplitude, GUSTY.gust_frequency
    for t in (0.0, 3.3, 40.0, 7.1):
        way = GUSTY.speed * (t + eps * (1 - cos(omega * t)) / omega)
        assert air.drift(t) == pytest.approx(way, abs=GUSTY.speed * STEP**2), "m, of the sum"
    assert Airflow(parameters).drift(7.1) == air.drift(7.1), "whatever was asked before"
    for number in range(GUSTS):
        before, after = (gust(parameters, number, drift, 1.0) for drift in (20.0, 20.5))
        if after[0] > before[0]:  # not begun again meanwhile
            assert after[0] - before[0] == pytest.approx(0.5)
            assert after[1] == before[1]
        faint, bold = (gust(parameters, number, 20.0, share)[2] for share in (0.6, 1.2))
        assert 0 <= faint <= bold < 1
    alphas = [gust(parameters, number, 20.0, 1.0)[2] for number in range(GUSTS)]
    assert max(alphas) > 0.1


def geoms(scene: Scene, t: float) -> dict[str, tuple[float, ...]]:
    """Places [m, W] of the model's meshes in the scene of a time, by name."""
    scene.fill(flying(t), None, views.top(BESIDE, flying(t)), forces=False)
    kind = int(mujoco.mjtGeom.mjGEOM_MESH)
    seen = [geom for geom in scene.mjv.geoms[: scene.mjv.ngeom] if geom.type == kind]
    return {scene.model.geom(geom.objid).name: (*geom.pos,) for geom in seen}


def test_in_the_scene_gusts_run_downwind_and_grass_leans_that_way() -> None:
    few = HIGH._replace(texels=32)
    scene = Scene(BESIDE, 320, 180, few)
    before, after = geoms(scene, 3.0), geoms(scene, 3.2)
    ran = 0
    for number in range(GUSTS):
        name = f"gust_{number}"
        way = world(Vector(*np.subtract(after[name], before[name])))
        if norm(way) < 5.0:  # not begun again meanwhile
            assert way == pytest.approx(times(7.0 * 0.2, ALONG), abs=1e-3), "m, in 0.2 s"
            ran += 1
    assert ran >= GUSTS - 1
    calm = geoms(Scene(BESIDE._replace(wind=Wind(0.0, azimuth=AZIMUTH)), 320, 180, few), 3.0)
    for name in ("clump_0", "clump_1", "clump_2"):
        lean = world(Vector(*np.subtract(before[name], calm[name])))
        assert dot(lean, ALONG) > 0.01, "m, of the middle of its blades"
        assert abs(dot(lean, LEFT)) < 1e-3
    scene.surroundings.show_details(False)
    assert not [name for name in geoms(scene, 3.0) if name.startswith(("gust", "clump"))]


def test_the_same_time_gives_the_same_frame_and_another_time_another(renderer: Renderer) -> None:
    camera = views.side(BESIDE, flying())
    frames = []
    for t in (2.0, 30.0, 2.0):
        renderer.render(flying(t), None, camera, forces=False)
        frames.append(renderer.frame())
    assert np.array_equal(frames[0], frames[2])
    assert not np.array_equal(frames[0], frames[1])


@pytest.mark.parametrize("length", [15.0, 25.0, 80.0, 200.0])
def test_the_lines_reach_over_land_and_the_sea_is_ahead(length: float) -> None:
    coast, half, side = coast_distance(length), 3.0 * length, 96
    colours = land(coast, half, side).astype(int)
    place = ((np.arange(side) + 0.5) / side * 2 - 1) * half
    x, y = np.meshgrid(place, place, indexing="ij")
    sea = colours[..., 2] > colours[..., 0] + 30
    assert not sea[np.hypot(x, y) < length].any()
    assert sea[(x > coast + 12.0) & (np.abs(y) < 0.3 * x)].mean() > 0.9
    assert not sea[x < 0.5 * coast].any()
    green = colours[..., 1] > colours[..., 2] + 20
    assert green[x < 0].all()


def test_a_low_quality_shows_the_same_with_fewer_pixels() -> None:
    camera = views.chase(BESIDE, flying())
    frames = {}
    for name in ("low", "high"):
        with Renderer(BESIDE, 1280, 720, SMALL) as opened:
            opened.quality = QUALITIES[name]
            opened.render(flying(), None, camera, forces=False)
            frames[name] = opened.frame().astype(float)
    assert frames["low"].shape == frames["high"].shape == (720, 1280, 3)
    steps = {name: np.abs(np.diff(frame, axis=1)).mean() for name, frame in frames.items()}
    assert steps["low"] < steps["high"]
    coarse = {n: f.reshape(18, 40, 32, 40, 3).mean(axis=(1, 3)) for n, f in frames.items()}
    assert np.abs(coarse["low"] - coarse["high"]).max() < 12, "of 255: all is in its place"
