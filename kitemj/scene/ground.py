"""The land and the sea as nested squares of texture around the pilot, each coarser than the last.

No texture repeats: every texel has the colour of its place. The coast lies beyond the reach
of the lines, a bay ahead of the pilot; the rest is in metres, whatever the lines.
Coordinates are those of the land's frame: x ahead (downwind), y left, the pilot at 0.
"""

from functools import lru_cache, partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.scene.noise import Field, mixed, on_grid, smooth, tile_of
from kitemj.scene.sky import HILLS, HORIZON

MARGIN = 1.04  # of a picture over its square: at the rim it would be mixed with the other side
INNERMOST = 14.0  # m, half the side of the finest square
FARTHER = 3  # times as large as the one in it is each square
SQUARES = 7
EXTENT = INNERMOST * FARTHER ** (SQUARES - 1)  # m; from there on all is haze
HAZE = 3500.0  # m, after which 63 % of a colour is haze
GRASS, DRY, LUSH = (0.42, 0.54, 0.25), (0.66, 0.62, 0.38), (0.28, 0.44, 0.19)
SAND, WET, FOAM = (0.87, 0.79, 0.61), (0.66, 0.57, 0.43), (0.95, 0.97, 0.96)
SHALLOW, SEA, DEEP = (0.40, 0.72, 0.68), (0.16, 0.48, 0.60), (0.11, 0.33, 0.52)
OPEN_LEFT, OPEN_RIGHT = 0.55, 1.25  # of the bay, breadth over depth to each side
PETAL, YELLOW = (0.97, 0.96, 0.90), (0.95, 0.83, 0.20)
DAISIES = 6.0  # a square metre where they are many


class Place(NamedTuple):
    """A grid of places: its rows' x and its columns' y [m]; width of a `texel` [m]."""

    x: Field
    y: Field
    texel: float

    def rough(self, period: float, seed: int, size: float = 1.0) -> Field:
        """A field (x, y) of deviation `size`, whose largest features are `period` [m] apart."""
        aside = np.float32(0.618 * seed)  # another part of the same tile
        x, y = self.x / (4 * period) + aside, self.y / (4 * period) - aside
        return size * on_grid(tile_of(31, 0.8, 4), x, y)


class Square(NamedTuple):
    """A square frame of ground: half sides `inner` (0: whole) and `outer` [m], its picture.

    The picture's half side is `MARGIN` times the outer.
    """

    inner: float
    outer: float
    image: NDArray[np.uint8]


def coast_distance(length: float) -> float:
    """How far ahead [m] of the pilot the sea begins, for lines of `length` [m]."""
    return 1.25 * length + 8.0


@lru_cache(maxsize=2)
def squares(length: float, side: int) -> tuple[Square, ...]:
    """The ground for lines of `length` [m], its finest textures `side` texels wide."""
    outer = [INNERMOST * FARTHER**k for k in range(SQUARES)]
    sides = [side if k < 4 else side // 2 for k in range(SQUARES)]
    halves = [MARGIN * half for half in outer]
    images = map(partial(land, coast_distance(length)), halves, sides)
    return tuple(map(Square, [0.0, *outer[:-1]], outer, images))


def land(coast: float, half: float, side: int) -> NDArray[np.uint8]:
    """Colours (side, side, 3) of the square |x|, |y| <= `half`; row for x, column for y.

    coast: m ahead, where the sea begins
    """
    across = ((np.arange(side, dtype=np.float32) + 0.5) / side * 2 - 1) * np.float32(half)
    whole = Place(across, across, 2 * half / side)
    colour, inland = _meadow(whole), np.full((side, side), 50.0, np.float32)
    # the coast is nowhere nearer than ahead, but for its roughness
    ahead = across > 0.6 * coast - 8.0
    if ahead.any():
        place = whole._replace(x=across[ahead])
        inland[ahead] = _inland(place, coast)
        colour[:, ahead] = _with_coast(place, colour[:, ahead], inland[ahead], coast)
    if half > 100:
        away = np.hypot(across[:, None], across[None, :])
        haze = 0.86 - 0.86 * np.exp(-np.maximum(away - 100, 0) / HAZE)
        haze = np.maximum(haze, smooth(0.5 * EXTENT, EXTENT, away))
        colour = mixed(colour, mixed(HORIZON, HILLS[0], 0.45 * smooth(-50, 50, inland)), haze)
    colour = 255 * colour + np.random.default_rng(6).random((side, side), np.float32)
    return np.ascontiguousarray(np.moveaxis(np.clip(colour, 0, 255).astype(np.uint8), 0, -1))


def _inland(place: Place, coast: float) -> Field:
    """How far [m] from the waterline, positive on land: a bay that opens wider to the right."""
    wide = np.where(place.y > 0, OPEN_LEFT, OPEN_RIGHT)
    shore = (coast**3 + np.abs(place.y / wide) ** 3) ** (1 / 3)
    rough = place.rough(90.0, 31, 0.04 * coast) + place.rough(13.0, 32, 0.5)
    return np.asarray(shore[None, :] - place.x[:, None] + rough, np.float32)


def _with_coast(place: Place, colour: Field, inland: Field, coast: float) -> Field:
    """The meadow's colours with beach and sea on them."""
    beach = 3.0 + 0.16 * coast
    sand = 1 - smooth(0.85, 1.15, inland / beach + place.rough(24.0, 33, 0.22))
    colour = mixed(colour, _sand(place, inland), sand)
    return mixed(colour, _sea(place, inland), smooth(-0.4, 0.4, -inland))


def _meadow(place: Place) -> Field:
    """Grass: drier and lusher parts, tufts, and daisies where they are large enough to see."""
    large, small = place.rough(160.0, 34), place.rough(21.0, 35)
    colour = mixed(GRASS, DRY, 0.45 * smooth(-0.3, 1.8, large + 0.5 * small))
    colour = mixed(colour, LUSH, 0.55 * smooth(0.0, 2.0, small - 0.7 * large))
    if place.texel < 0.5:
        colour *= 1 + 0.08 * place.rough(2.4, 36)
    if place.texel < 0.1:
        colour *= 1 + 0.09 * place.rough(0.45, 37)
    if place.texel < 0.06:
        rng = np.random.default_rng(38)
        patches = smooth(-0.5, 1.5, place.rough(9.0, 39))
        bloom = rng.random(large.shape, np.float32) < DAISIES * place.texel**2 * patches
        white = rng.random(np.count_nonzero(bloom)) < 0.6
        colour[:, bloom] = np.where(white, np.array([PETAL]).T, np.array([YELLOW]).T)
    return colour


def _sand(place: Place, inland: Field) -> Field:
    """Sand with ripples, wet where waves have been."""
    colour = mixed(SAND, WET, 0.85 * smooth(-2.4, -0.6, -inland))
    ripples = place.rough(30.0, 40, 0.035)
    if place.texel < 0.3:
        ripples += place.rough(2.0, 41, 0.03)
    return colour * (1 + ripples)


def _sea(place: Place, inland: Field) -> Field:
    """Water: turquoise near the shore, three lines of surf, crests farther out."""
    out = -inland
    colour = mixed(SHALLOW, SEA, smooth(1.0, 28.0, out))
    colour = mixed(colour, DEEP, smooth(30.0, 400.0, out))
    colour *= 1 + 0.06 * on_grid(tile_of(42, 0.9, 4), place.x / 55, place.y / 260)
    wash = out + place.rough(17.0, 43, 0.9)
    foam = 0.95 * (1 - smooth(0.3, 1.5, np.abs(wash - 0.6)))
    for line, seed in ((5.5, 45), (12.0, 46)):
        broken = smooth(-0.4, 0.7, place.rough(45.0, seed))
        foam = np.maximum(foam, 0.8 * broken * (1 - smooth(0.4, 1.4, np.abs(wash - line))))
    if place.texel < 4:
        crests = smooth(2.1, 2.6, on_grid(tile_of(44, 0.7, 8), place.x / 40, place.y / 110))
        foam = np.maximum(foam, 0.6 * crests * smooth(15.0, 60.0, out))
    return mixed(colour, FOAM, foam)
