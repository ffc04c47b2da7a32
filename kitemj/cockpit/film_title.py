"""The title of a film: a line or two in its lower third, there at the start and soon gone."""

from collections.abc import Iterable, Iterator

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.drawing.text import put, wrapped

Frame = NDArray[np.uint8]
SHOWN = 3.0
"""s of the film."""
FADE = 0.5
"""s in which it comes, and goes."""
LEFT, FOOT, ROOM = 0.06, 0.76, 0.7
"""Of the frame: where the lines begin, where the last one stands, how far they may go."""
DIGIT = 1 / 20
"""Of the height: that of a digit."""
SHADE = 0.45
"""Of the picture's light that is taken away behind the middle of the text."""


def titled(frames: Iterable[Frame], title: str, rate: int) -> Iterator[Frame]:
    """`frames`, of which there are `rate` a second, the first of them with `title` over them."""
    for number, frame in enumerate(frames):
        opacity = title_opacity(number / rate)
        yield with_title(frame, title, opacity) if title and opacity else frame


def title_opacity(t: float) -> float:
    """How much of a title is seen `t` [s] after the start: 0 nothing, 1 all of it."""
    part = min(max(min(t, SHOWN - t) / FADE, 0.0), 1.0)
    return part * part * (3 - 2 * part)  # it begins and ends softly


def with_title(frame: Frame, title: str, opacity: float = 1.0) -> Frame:
    """A copy of the frame (height, width, 3) with `title` over it."""
    height, wide = frame.shape[:2]
    size = DIGIT * min(height, wide * 9 / 16)
    lines, step, middle = wrapped(title, ROOM * wide, size), 1.9 * size, FOOT * height
    top = middle - step * (len(lines) - 1)
    reach = 2.2 * size + step * len(lines)
    lettered = (frame * _shade(height, wide, (top + middle) / 2, reach, opacity)).astype(np.uint8)
    layer = pygame.Surface((wide, height), pygame.SRCALPHA)
    rule = pygame.Rect(round(LEFT * wide), round(top - size), max(2, round(size / 10)), 0)
    rule.height = round(middle + size - rule.top)
    layer.fill((255, 255, 255), rule)
    for number, line in enumerate(lines):
        put(layer, line, rule.right + size * 0.8, top + number * step, size)
    layer.set_alpha(round(255 * opacity))
    pygame.image.frombuffer(lettered.data, (wide, height), "RGB").blit(layer, (0, 0))
    return lettered


def _shade(
    height: int, wide: int, middle: float, reach: float, opacity: float
) -> NDArray[np.float32]:
    """What the light is multiplied with (height, width, 1); darkest where the text begins.

    height, wide: px of the frame
    middle, reach: px, where it is darkest and how far up and down that goes
    opacity: of the title
    """
    rows = np.exp(-(((np.arange(height) - middle) / reach) ** 2))
    columns = np.clip(1.25 - np.arange(wide) / (ROOM * wide), 0.0, 1.0)
    dark = SHADE * opacity * rows[:, None] * columns**2
    return np.asarray(1.0 - dark[:, :, None], np.float32)
