"""What textures are made of: random fields without end, and colours that are mixed.

Fields are tiles that repeat seamlessly; the same seed gives the same field on every machine.
Colours are arrays (3, ...), red first, 0 to 1.
"""

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

Field = NDArray[np.floating[Any]]
Colour = tuple[float, float, float]
SIDE = 512  # texels of a tile, a power of two


@lru_cache(maxsize=16)
def tile_of(seed: int, slope: float, coarsest: int = 1) -> Field:
    """A periodic tile (SIDE, SIDE), mean 0 and deviation 1.

    seed: which of all tiles
    slope: of the amplitude over the wave number in octaves; 1 is rough, 2 smooth
    coarsest: the fewest waves across the tile
    """
    ky, kx = np.meshgrid(np.fft.fftfreq(SIDE, 1 / SIDE), np.fft.rfftfreq(SIDE, 1 / SIDE))
    k = np.hypot(kx, ky)
    amplitude = np.where(k >= coarsest, np.maximum(k, 1.0) ** -(slope + 0.5), 0.0)
    turn = np.random.default_rng(seed).uniform(0, 2 * np.pi, k.shape)
    tile = np.fft.irfft2((amplitude * np.exp(1j * turn)).T, s=(SIDE, SIDE))
    return np.asarray((tile - tile.mean()) / tile.std(), np.float32)


def at(tile: Field, x: Field, y: Field) -> Field:
    """The tile at places of any shape; one unit is the whole tile, between texels straight."""
    (i, i1, u), (j, j1, v) = _cells(x), _cells(y)
    flat = tile.ravel()
    above, below = i * SIDE, i1 * SIDE
    first = flat[above + j] * (1 - v) + flat[above + j1] * v
    second = flat[below + j] * (1 - v) + flat[below + j1] * v
    return np.asarray(first + u * (second - first))


def on_grid(tile: Field, x: Field, y: Field) -> Field:
    """The tile at all (x, y) of a grid, shape (len(x), len(y)); much quicker than `at`."""
    (i, i1, u), (j, j1, v) = _cells(x), _cells(y)
    rows = tile[i] + u[:, None] * (tile[i1] - tile[i])
    first = rows.take(j, axis=1)
    return np.asarray(first + v * (rows.take(j1, axis=1) - first))


def smooth(low: float, high: float, value: Field) -> Field:
    """0 up to `low`, 1 from `high` on, without a corner between."""
    share = np.clip((value - low) / (high - low), 0, 1)
    return np.asarray(share * share * (3 - 2 * share), np.float32)


def mixed(one: Field | Colour, other: Field | Colour, share: Field) -> Field:
    """The colours (3, ...) that are `one` where `share` (...) is 0, and `other` where it is 1."""
    first, second = (_spread(each, share.ndim) for each in (one, other))
    return np.asarray(first + share * (second - first))


def _spread(colour: Field | Colour, dimensions: int) -> Field:
    plain = np.asarray(colour, np.float32)
    return plain.reshape(3, *[1] * dimensions) if plain.ndim == 1 else plain


def _cells(x: Field) -> tuple[NDArray[np.int32], NDArray[np.int32], Field]:
    place = np.asarray(x, np.float32) * SIDE
    below = np.floor(place)
    first = below.astype(np.int32) & (SIDE - 1)
    return first, (first + 1) & (SIDE - 1), place - below
