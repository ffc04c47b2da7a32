"""The shadow of the kite on the ground: its outline seen from the sun, with a soft rim.

An outline costs no pass of its own, as a shadow map would; a kite's is close to convex.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from kitemj.dynamics.motion import Body
from kitemj.physics.vectors import Vector
from kitemj.scene.decor import Colour, add_flat

SUN_WIDTH = 0.0093  # rad, that the sun is wide: so much wider is the rim for each metre of way
DARK: Colour = (0.03, 0.05, 0.08)
DEPTH = 0.42  # of the darkest part
LAYERS = 2  # that make the rim soft
LIFT = 0.012  # m, a layer lies over the ground or over the one below it
MOST_POINTS = 40


def few_points(vertices: NDArray[np.float64]) -> NDArray[np.float64]:
    """The corners (n, 3) of a body's convex hull, not more than a picture needs."""
    corners = vertices[ConvexHull(vertices).vertices]
    return np.asarray(corners[:: 1 + len(corners) // MOST_POINTS])


def outline(points_B: NDArray[np.float64], body: Body, sun_E: Vector) -> NDArray[np.float64]:
    """Corners (n, 2) [m; x_E, y_E] of the shadow of points (m, 3) [m, B] of a body, in order.

    `sun_E`: the direction towards the sun. Empty for a body that casts none.
    """
    points = points_B @ np.array(body.R_BE) + np.array(body.p_G_E)
    way = np.minimum(points[:, 2:], 0.0) / sun_E.z
    ground = points[:, :2] - way * np.array(sun_E[:2])
    try:
        return np.asarray(ground[ConvexHull(ground).vertices])
    except (QhullError, ValueError):  # edge-on, or no numbers
        return np.empty((0, 2))


def add_shadow(
    mjv: Any, points_B: NDArray[np.float64], body: Body, sun_E: Vector, scale: float = 1.0
) -> None:
    """Adds the shadow to a scene; it is paler and softer the higher the body is.

    scale: by which the body is drawn larger than it is
    """
    corners = outline(scale * points_B, body, sun_E)
    if not len(corners):
        return
    middle = corners.mean(axis=0)
    half = float(np.mean(np.hypot(*(corners - middle).T)))
    rim = 0.5 * SUN_WIDTH * max(-body.p_G_E.z, 0.0) / -sun_E.z / half
    for layer in range(LAYERS):
        spread = 2 * layer / (LAYERS - 1) - 1
        wide = middle + (1 - spread * rim) * (corners - middle)
        if spread * rim < 1:
            # W: as the engine has it
            level = np.full(len(wide), LIFT * (layer + 1))
            add_flat(mjv, np.stack([wide[:, 0], -wide[:, 1], level], 1), DARK, DEPTH / LAYERS)
