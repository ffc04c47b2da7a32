"""The sky as pictures on walls and roof of a cube: gradient, sun, clouds, hills in the haze.

All is a function of the direction, in the frame of the land: ahead (downwind), left, up.
"""

from functools import lru_cache
from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from kitemj.scene.noise import Field, at, mixed, smooth, tile_of
from kitemj.scene.sun import SUN, land_turn

HORIZON = (0.90, 0.93, 0.93)
LOW = (0.60, 0.79, 0.93)  # of the sky some 15° up
ZENITH = (0.19, 0.43, 0.78)
WARM = (1.0, 0.96, 0.86)
CLOUD, SHADE = (1.0, 0.995, 0.98), (0.74, 0.80, 0.88)
HILLS = ((0.66, 0.75, 0.82), (0.52, 0.63, 0.66), (0.40, 0.51, 0.45))  # far, nearer, near
RIM = 4  # texels of a picture beyond the edges of its face, for the mixing of neighbours
LOWEST = 0.15  # sine of the elevation up to which hills are looked for, both ways
ROWS = 256  # that are painted at a time: numbers that stay near the processor
TILE = 7.0  # cloud heights that a tile of clouds covers


def directions(side: int) -> NDArray[np.float32]:
    """Directions in W of the texels of walls and roof (5, side, side, 3): +x, -x, +y, -y, +z.

    On a wall rows go down and columns to the left; at the edges of the cube, `RIM` texels from
    those of a picture, the largest components are ±1.
    """
    across = (np.arange(side, dtype=np.float32) + 0.5 - side / 2) / (side / 2 - RIM)
    r, c = np.meshgrid(across, across, indexing="ij")
    return np.stack([np.stack(np.broadcast_arrays(*face), axis=-1) for face in faces(c, r)])


def faces(c: Field, r: Field) -> list[tuple[Field, Field, Field]]:
    """Directions in W of places on each face: `c` -1..1 along columns, `r` -1..1 along rows."""
    one = np.ones_like(c)
    return [(one, c, -r), (-one, -c, -r), (-c, one, -r), (c, -one, -r), (c, -r, one)]


@lru_cache(maxsize=2)
def sky(side: int, azimuth: float) -> NDArray[np.uint8]:
    """Pictures of walls and roof (5, side, side, 3), as `directions`, for a wind's `azimuth`."""
    every = directions(side).reshape(5 * side, side, 3)
    image = np.empty(every.shape, np.uint8)
    image[:] = 255 * np.array(HORIZON)
    rows = np.flatnonzero(every[:, 0, 2] > -LOWEST)
    turn, grain = land_turn(azimuth), np.random.default_rng(5)
    c, s = np.float32(cos(turn)), np.float32(sin(turn))
    for few in np.array_split(rows, max(len(rows) // ROWS, 1)):
        x, y, z = np.ascontiguousarray(np.moveaxis(every[few], -1, 0))
        size = np.sqrt(x * x + y * y + z * z)
        x, y, z = x / size, y / size, z / size
        colour = 255 * sky_colour(c * x + s * y, c * y - s * x, z)
        # a grain of one step hides the bands of eight bits
        colour += grain.random(x.shape, np.float32)
        image[few] = np.moveaxis(np.clip(colour, 0, 255), 0, -1)
    return image.reshape(5, side, side, 3)


def sky_colour(ahead: Field, left: Field, up: Field) -> Field:
    """RGB (3, ...) seen in unit directions of the land's frame."""
    colour = _gradient(np.clip(up, 0, 1))
    near = ahead * SUN.x + left * SUN.y + up * SUN.z
    shine = np.flatnonzero(near > 0.4)
    glow = np.zeros_like(near).ravel()
    glow[shine] = 0.55 * np.exp((near.flat[shine] - 1) * 28)
    glow[shine] += 0.22 * np.exp((near.flat[shine] - 1) * 5) - 0.22 * np.exp(-0.6 * 5)
    colour = mixed(colour, WARM, glow.reshape(near.shape))
    colour = _with_clouds(colour, ahead, left, up)
    colour = mixed(colour, (1.0, 1.0, 0.96), smooth(0.99955, 0.9998, near))
    low = np.abs(up) < LOWEST
    if low.any():
        colour[:, low] = _with_hills(colour[:, low], ahead[low], left[low], up[low])
    return colour


def _gradient(up: Field) -> Field:
    """RGB (3, ...) of the clear sky from a table of its sine of elevation."""
    steps = np.linspace(0, 1, 4096, dtype=np.float32)
    table = mixed(HORIZON, LOW, smooth(0.0, 0.30, steps) ** 0.6)
    table = mixed(table, ZENITH, smooth(0.04, 1.05, steps) ** 0.85)
    return np.asarray(table.take((4095 * up).astype(np.int32), axis=1))


def _with_clouds(colour: Field, ahead: Field, left: Field, up: Field) -> Field:
    """Heaps of fair weather and wisps, on a vault that bends down to the horizon."""
    away = 1 / (np.maximum(up, 0) + np.float32(0.10)) / TILE
    x, y = ahead * away, left * away
    shape, detail = tile_of(11, 1.1, 3), tile_of(12, 0.7, 6)
    fine = at(detail, 3.1 * x, 3.1 * y)
    here = at(shape, x, y) + 0.16 * fine
    cover = 0.96 * smooth(0.60, 1.45, here)
    wisps = 0.22 * smooth(0.3, 2.4, at(detail, 0.35 * x + 0.3, 1.5 * y))
    clouded = np.flatnonzero(cover > wisps)
    light = np.ones_like(up).ravel()
    x, y, fine, here = (np.asarray(each).flat[clouded] for each in (x, y, fine, here))
    lit = here - 0.16 * fine - at(shape, x + 0.014 * SUN.x, y + 0.014 * SUN.y)
    light[clouded] = np.clip(0.84 + 0.9 * lit + 0.07 * fine - 0.3 * smooth(1.0, 2.6, here), 0, 1)
    cover = np.maximum(cover, wisps) * smooth(0.0, 0.16, up)
    veil = mixed(SHADE, CLOUD, light.reshape(up.shape))
    return np.asarray(colour + cover * (veil - colour))


def _with_hills(colour: Field, ahead: Field, left: Field, up: Field) -> Field:
    """Three ranges, each paler than the one before it, that leave the sea's horizon free."""
    bearing = np.arctan2(left, ahead) / (2 * np.pi)
    tile, aside = tile_of(13, 1.1, 2), np.abs(bearing + 0.02)
    for k, (hill, height) in enumerate(zip(HILLS, (0.050, 0.036, 0.020), strict=True)):
        row = np.full_like(bearing, 0.17 + 0.3 * k)
        ridge = 1 + 0.33 * at(tile, row, (k + 2) * bearing)
        open_sea = smooth(0.055 + 0.022 * k, 0.15 + 0.03 * k, aside)
        top = height * ridge * open_sea - 0.002
        cover = smooth(-0.0016, 0.0016, top - up) * smooth(0.0, 0.1, open_sea)
        mist = 1.0 - 0.75 * np.clip(up / np.maximum(top, 1e-3), 0, 1) ** 0.7
        colour = mixed(colour, mixed(hill, HORIZON, mist), cover)
    return colour
