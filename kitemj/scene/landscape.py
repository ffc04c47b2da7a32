"""Sky and ground in the drawing model."""

from collections.abc import Container
from math import cos, sin
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector
from kitemj.scene.ground import EXTENT, MARGIN, coast_distance, squares
from kitemj.scene.model_parts import Mesh, add_blank_texture, add_mesh, add_shape
from kitemj.scene.sky import RIM, faces, sky
from kitemj.scene.sun import land_turn

CELLS = 12  # quadrilaterals along a side of a square
UNDER = 0.97  # of its inner side: a square begins under the one within, so that no gap shows
BOATS = ((130.0, 45.0, 1.9), (260.0, -160.0, 1.2), (420.0, 60.0, 1.7), (700.0, -60.0, 1.4))
"""How far out from the coast and to the left [m, L]; course [rad from straight ahead]."""
SKY = tuple(f"sky_{k}" for k in range(5))
FOOT = 0.14  # how far walls of the sky go below the horizon, in parts of their half height
STEP = 0.0005  # of its inner side: how much lower it lies


def add_landscape(spec: Any, parameters: Parameters, texels: int) -> dict[str, NDArray[np.uint8]]:
    """Adds the sky, of `texels` across a face, and the ground as the body "land".

    Returns the pictures that are to be painted on their textures, by name.
    """
    azimuth, length = parameters.wind.azimuth, parameters.lines.length
    pictures = {f"sky_{k}": image for k, image in enumerate(sky(texels, azimuth))}
    _add_sky(spec, texels)
    half = land_turn(azimuth) / 2
    body = spec.worldbody.add_body(name="land", quat=[cos(half), 0.0, 0.0, sin(half)])
    for k, (inner, outer, image) in enumerate(squares(length, 3 * texels // 4)):
        name = f"ground_{k}"
        pictures[name] = image
        add_blank_texture(spec, name, len(image))
        square = _square(UNDER * inner, outer)
        places = square.vertices[:, 1::-1] / (2 * MARGIN * outer) + 0.5
        add_mesh(spec, name, square, places)
        add_shape(body, name, material=name, pos=[0.0, 0.0, -STEP * inner])
    _add_boats(spec, body, coast_distance(length))
    return pictures


def _add_sky(spec: Any, texels: int) -> None:
    """Adds walls and roof, which `follow` puts around the eye.

    The engine's own sky costs twice as much where the processor draws. Normals point up, so that
    the light, which shows level ground as it is, does the same here.
    """
    for k in range(len(SKY)):
        low = 1.0 if k == len(SKY) - 1 else FOOT
        c, r = np.array([-1.0, 1.0, 1.0, -1.0]), np.array([-1.0, -1.0, low, low])
        corners = EXTENT * np.stack(faces(c, r)[k], axis=1)
        share = 0.5 - RIM / texels
        both = np.array([(0, 1, 2), (0, 2, 3), (1, 0, 2), (2, 0, 3)], np.int32)
        add_blank_texture(spec, SKY[k], texels)
        up = np.tile([0.0, 0.0, 1.0], (4, 1))
        add_mesh(spec, SKY[k], Mesh(corners, both), np.stack([c, r], 1) * share + 0.5, up)
        add_shape(spec.worldbody, SKY[k], name=SKY[k], material=SKY[k])


def follow(mjv: Any, shapes: Container[int], eye: Vector) -> None:
    """Moves the sky's shapes, geoms of these numbers, in a scene just made to an `eye` [m, W]."""
    for geom in mjv.geoms[: mjv.ngeom]:
        if geom.objid in shapes:
            geom.pos[:] += eye


def _add_boats(spec: Any, land: Any, coast: float) -> None:
    """Adds sailing boats of 7 m, which tell how far the sea goes."""
    hull = np.array([(-3.0, 0.0, 0.9), (3.6, 0.0, 1.1), (-2.6, 0.0, 0.0), (2.9, 0.0, 0.0)])
    sails = np.array([(0.0, 0.0, 1.4), (-2.8, 0.0, 1.4), (0.1, 0.0, 9.5)])
    jib = np.array([(0.3, 0.0, 1.2), (3.2, 0.0, 1.2), (0.2, 0.0, 8.2)])
    both = np.array([(0, 1, 2), (1, 0, 2), (3, 4, 5), (4, 3, 5)], np.int32)
    add_mesh(spec, "sails", Mesh(np.concatenate([sails, jib]), both))
    sides = np.array([(0, 1, 2), (1, 0, 2), (1, 3, 2), (3, 1, 2)], np.int32)
    add_mesh(spec, "hull", Mesh(hull, sides))
    spec.add_material(name="boat", emission=0.5, specular=0.0)
    for out, left, course in BOATS:
        turn = [cos(course / 2), 0.0, 0.0, sin(course / 2)]
        boat = land.add_body(pos=[coast + out, left, 0.0], quat=turn)
        add_shape(boat, "sails", material="boat", rgba=[0.97, 0.97, 0.95, 1])
        add_shape(boat, "hull", material="boat", rgba=[0.25, 0.28, 0.32, 1])


def _square(inner: float, outer: float) -> Mesh:
    """A flat square about the origin, its face up, without the square of half side `inner`.

    A mesh, since MuJoCo's plane costs thrice as much where the processor draws.
    """
    edge = np.linspace(-outer, outer, CELLS + 1)
    third = CELLS // 3
    if inner:
        edge[[third, 2 * third]] = -inner, inner
    corners = np.array([(a, b, 0.0) for a in edge for b in edge])
    middle = set(range(third, 2 * third)) if inner else set()
    cells = [(i, j) for i in range(CELLS) for j in range(CELLS) if {i, j} - middle]
    a = np.array([i * (CELLS + 1) + j for i, j in cells])
    b, c, d = a + CELLS + 1, a + CELLS + 2, a + 1
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    used, again = np.unique(faces, return_inverse=True)
    return Mesh(corners[used], again.reshape(faces.shape).astype(np.int32))
