"""Grass that bends and gusts that run over the field: shapes of the model, moved in the scene.

Both follow the air of `Airflow`; the shapes are placed each frame, since a model's own stay.
"""

from math import hypot
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kitemj.mujoco_import import mujoco
from kitemj.physics.frames import world
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector
from kitemj.scene.airflow import Airflow
from kitemj.scene.ground import coast_distance
from kitemj.scene.model_parts import Mesh, add_mesh, add_shape, add_texture
from kitemj.scene.noise import on_grid, smooth, tile_of
from kitemj.scene.sun import land_to_E
from kitemj.scene.views import downwind

Floats = NDArray[np.float64]
GUSTS = 6
GUST_LONG, GUST_WIDE = 5.5, 11.0  # m, half of a gust along the wind and across, for short lines
GUST_ALPHA = 0.28  # of one in the wind's usual speed
GUST_LIFT = 0.025  # m, that the lowest is over the ground
GUST_COLOUR = (0.93, 0.96, 0.66)
CLUMPS = 26
BLADES = 70  # of a clump
BLADE = 0.55  # m
BEND = 0.55  # by how much of its height grass leans in the usual wind
GRASSES = ((0.33, 0.45, 0.17), (0.47, 0.50, 0.24), (0.29, 0.42, 0.15))  # of their tips


def add_gusts_and_grass(spec: Any, parameters: Parameters) -> None:
    """Adds the shapes of gusts and clumps of grass to a drawing model."""
    half = gust_size(parameters)
    image = np.empty((64, 64, 4), np.uint8)
    image[:] = [*(round(255 * c) for c in GUST_COLOUR), 0]
    image[..., 3] = 255 * _gust_texture()
    add_texture(spec, "gust", image)
    turn = np.linspace(0, 2 * np.pi, 9)[:-1] + np.pi / 8
    corners = np.stack([np.cos(turn), np.sin(turn), 0 * turn], 1) / np.cos(np.pi / 8)
    faces = np.array([(0, k, k + 1) for k in range(1, 7)], np.int32)
    add_mesh(spec, "gust", Mesh(corners * (*half, 1.0), faces), corners[:, :2] / 2 + 0.5)
    for number in range(GUSTS):
        look = {"material": "gust", "rgba": [1.0, 1.0, 1.0, 0.5]}
        add_shape(spec.worldbody, "gust", name=f"gust_{number}", **look)
    for kind, colour in enumerate(GRASSES):
        add_texture(spec, f"grass_{kind}", _blade_texture(colour))
        mesh = _clump(kind)
        add_mesh(spec, f"clump_{kind}", mesh, np.repeat(mesh.vertices[:, 2:] / BLADE, 2, axis=1))
    for number in range(CLUMPS):
        kind = number % len(GRASSES)
        add_shape(spec.worldbody, f"clump_{kind}", name=f"clump_{number}", material=f"grass_{kind}")


class GustsAndGrass:
    """Places gusts and grass in scenes of a drawing model."""

    def __init__(self, parameters: Parameters, model: Any) -> None:
        self._parameters, self._model, self._air = parameters, model, Airflow(parameters)
        self._gusts = {model.geom(f"gust_{k}").id: k for k in range(GUSTS)}
        self._clumps = {model.geom(f"clump_{k}").id: k for k in range(CLUMPS)}
        self._places = clump_places(parameters)
        feet = [land_to_E(parameters, Vector(x, y, 0.0)) for x, y in self._places[:, :2]]
        self._feet = np.array([world(foot) for foot in feet])
        self._shapes = _turned(self._places[:, 3]) * self._places[:, 2, None, None]
        wind = world(downwind(parameters))
        self._wind = np.array(wind)
        self._turn = np.array([wind, (-wind.y, wind.x, 0.0), (0.0, 0.0, 1.0)]).T

    def show(self, shown: bool) -> None:
        """Says whether scenes that are made from now on have gusts and grass."""
        alpha = self._model.geom_rgba[:, 3]
        alpha[[*self._gusts]], alpha[[*self._clumps]] = (0.5, 1.0) if shown else (0.0, 0.0)

    def place(self, mjv: Any, t: float) -> None:
        """Moves what `mjv_updateScene` has put into the scene to where it is at `t` [s]."""
        drift, strength = self._air.drift(t), self._air.strength(t)
        # grass leans by a shear, which keeps its foot
        lean = BEND * bend(drift, strength, *self._places[:, :2].T)
        shapes = self._shapes.copy()
        shapes[:, :, 2] += (self._places[:, 2] * lean)[:, None] * self._wind
        kind = int(mujoco.mjtObj.mjOBJ_GEOM)
        for geom in mjv.geoms[: mjv.ngeom]:
            number = geom.objid
            if geom.objtype != kind:
                continue
            if number in self._gusts:
                self._place_gust(geom, self._gusts[number], drift, strength)
            elif number in self._clumps:
                k = self._clumps[number]
                geom.pos[:] = self._feet[k] + shapes[k] @ geom.pos
                geom.mat[:] = shapes[k] @ geom.mat

    def _place_gust(self, geom: Any, number: int, drift: float, strength: float) -> None:
        ahead, left, alpha = gust(self._parameters, number, drift, strength)
        centre = world(land_to_E(self._parameters, Vector(ahead, left, 0.0)))
        geom.pos[:] = (centre.x, centre.y, GUST_LIFT + 0.004 * number)
        geom.mat[:] = self._turn @ geom.mat
        geom.rgba[3] = alpha


def gust_size(parameters: Parameters) -> tuple[float, float]:
    """Half length along the wind and half breadth [m] of a gust; larger for long lines."""
    size = max(1.0, parameters.lines.length / 40.0)
    return GUST_LONG * size, GUST_WIDE * size


def gust(
    parameters: Parameters, number: int, drift: float, strength: float
) -> tuple[float, float, float]:
    """Place (ahead, left) [m, L] and alpha of one gust; `drift` [m], `strength` of `Airflow`."""
    long, wide = gust_size(parameters)
    first, last = -4.0 * long, 0.95 * coast_distance(parameters.lines.length)
    lap, share = divmod(drift / (last - first) + number / GUSTS, 1.0)
    aside = 2.0 * (0.618034 * (7.0 * lap + number) % 1.0) - 1.0  # elsewhere in each lap
    ahead = first + share * (last - first)
    near = min(1.0, share / 0.15, (1.0 - share) / 0.2)  # none comes or goes at once
    alpha = GUST_ALPHA * near * min(strength**3, 2.0)
    return ahead, aside * (2.0 * wide + 0.3 * last), alpha


def bend(drift: float, strength: float, x: Floats, y: Floats) -> Floats:
    """How far grass at places [m, L] leans, 1 on the whole: waves go through with the air."""
    along = x - drift
    wave = np.sin(0.9 * along + 0.35 * y) + 0.5 * np.sin(2.3 * along - 0.8 * y)
    return np.asarray(min(strength**2, 1.6) * (1.0 + 0.35 * wave))


def clump_places(parameters: Parameters) -> Floats:
    """Rows (CLUMPS, 4): ahead and left [m, L], height in blades, turn [rad] of clumps of grass."""
    rng = np.random.default_rng(21)
    places: list[tuple[float, ...]] = []
    edge = 0.8 * coast_distance(parameters.lines.length)
    while len(places) < CLUMPS:
        if len(places) % 2:  # along the beach
            x, y = rng.uniform(0.7, 1.0) * edge, rng.uniform(-1.4, 1.4) * edge
        else:
            x, y = rng.uniform(1.5, 14.0), rng.uniform(-13.0, 13.0)
        if abs(y) > 2.2 and hypot(x, y) > 4.0:
            places.append((x, y, rng.uniform(0.6, 1.25), rng.uniform(0.0, 6.28)))
    return np.array(places)


def _turned(angles: Floats) -> Floats:
    """Turns (n, 3, 3) about z by angles (n) [rad]."""
    c, s, none = np.cos(angles), np.sin(angles), np.zeros_like(angles)
    return np.array([[c, -s, none], [s, c, none], [none, none, none + 1]]).transpose(2, 0, 1)


def _gust_texture() -> NDArray[np.float32]:
    """Cover (64, 64), 0 to 1: a streaked cloud, nothing at the edges."""
    across = np.linspace(-1, 1, 64, dtype=np.float32)
    away = np.hypot(across[:, None], across[None, :])
    streaks = on_grid(tile_of(31, 0.8, 4), across * 0.17, across * 0.05)
    return np.asarray((1 - smooth(0.15, 1.0, away)) * np.clip(0.6 + 0.45 * streaks, 0, 1))


def _blade_texture(tip: tuple[float, float, float]) -> NDArray[np.uint8]:
    """Dark at the foot, where v is 0, and the colour `tip` at v = 1."""
    shade = np.linspace(0.6, 1.4, 16)[:, None, None] * np.array(tip)
    return np.asarray(np.clip(255 * np.repeat(shade, 16, axis=1), 0, 255), np.uint8)


def _clump(kind: int) -> Mesh:
    """Blades that spread from one place, each a triangle seen from both sides; foot at 0."""
    rng = np.random.default_rng(50 + kind)
    points, faces = [], []
    for blade in range(BLADES):
        turn, spread, out = rng.uniform(0, 2 * np.pi), rng.uniform(0.05, 0.7), 0.3 * rng.random()
        tall, half = BLADE * rng.uniform(0.5, 1.0), rng.uniform(0.008, 0.018)
        c, s = np.cos(turn), np.sin(turn)
        foot = np.array([out * c, out * s, 0.0])
        side, tip = (
            np.array([-s, c, 0.0]) * half,
            np.array([c * spread * tall, s * spread * tall, tall]),
        )
        points += [foot - side, foot + side, foot + tip]
        n = 3 * blade
        faces += [(n, n + 1, n + 2), (n + 1, n, n + 2)]
    return Mesh(np.array(points), np.array(faces, np.int32))
