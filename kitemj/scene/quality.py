"""How much a frame may cost, and the choice of it by measuring."""

from typing import NamedTuple


class Quality(NamedTuple):
    """`texels` across a face of the sky, `samples` of a pixel, `scale` of the pixels that are
    rendered to those that are shown, and whether what moves in the wind is drawn.
    """

    texels: int
    samples: int
    scale: float
    details: bool


HIGH = Quality(768, 0, 1.0, True)
