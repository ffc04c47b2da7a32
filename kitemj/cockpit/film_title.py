"""The title of a film: a line or two in its lower third, there at the start and soon gone."""

from collections.abc import Iterable, Iterator

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.drawing.text import put, width, wrapped

Frame = NDArray[np.uint8]
SHOWN = 3.0
"""s of the film."""
FADE = 0.5
"""s in which it comes, and goes."""
LEFT, FOOT, ROOM = 0.06, 0.72, 0.6
"""Of the frame: where the lines begin, where the last one stands, how far they may go."""
DIGIT = 1 / 24
"""Of the height, in a frame of 16:9: that of a digit."""
SHADE = 0.58
"""Of the picture's light that is taken away behind the text: white is read over white clouds."""
SOFT = (6.0, 3.5)
"""Heights of a digit, to the right and up and down, in which that ends."""


def titled(frames: Iterable[Frame], title: str, rate: int) -> Iterator[Frame]:
    """`frames`, of which there are `rate` a second, the first of them with `title` over them."""
    for number, frame in enumerate(frames):
        opacity = title_opacity(number / rate)
        yield with_title(frame, title, opacity) if title and opacity else frame


def title_opacity(t: float) -> float:
    """How much of a title is seen `t` [s] after the start: 0 nothing, 1 all of it."""
    return float(_eased(min(t, SHOWN - t) / FADE))


def with_title(frame: Frame, title: str, opacity: float = 1.0) -> Frame:
    """A copy of the frame (height, width, 3) with `title` over it."""
    height, wide = frame.shape[:2]
    size = DIGIT * min(height, wide * 9 / 16)
    lines, step = _even_lines(title, ROOM * wide, size), 1.9 * size
    first = FOOT * height - step * (len(lines) - 1)
    rule = pygame.Rect(round(LEFT * wide), round(first - size), max(2, round(size / 10)), 0)
    rule.height = round(FOOT * height + size - rule.top)
    text = rule.right + 0.8 * size
    right = text + max(width(line, size) for line in lines)
    across = _eased(1 - (np.arange(wide) - right - size / 2) / (SOFT[0] * size))
    beyond = np.maximum(rule.top - np.arange(height), np.arange(height) - rule.bottom)
    down = _eased(1 - beyond / (SOFT[1] * size))
    lettered = (frame * (1 - SHADE * opacity * np.outer(down, across))[:, :, None]).astype(np.uint8)
    layer = pygame.Surface((wide, height), pygame.SRCALPHA)
    layer.fill((255, 255, 255), rule)
    for number, line in enumerate(lines):
        put(layer, line, text, first + number * step, size)
    layer.set_alpha(round(255 * opacity))
    pygame.image.frombuffer(lettered.data, (wide, height), "RGB").blit(layer, (0, 0))
    return lettered


def _even_lines(title: str, room: float, size: float) -> tuple[str, ...]:
    """The lines of `title`, as few as `room` [px] allows, the last about as long as the others."""
    lines = wrapped(title, room, size)
    narrow = 1.15 * width(title, size) / len(lines)
    even = wrapped(title, narrow, size)
    return even if len(even) == len(lines) else lines


def _eased(part: float | NDArray[np.float64]) -> NDArray[np.float64]:
    """0 up to 0, 1 from 1 on, and softly from one to the other."""
    inside = np.clip(part, 0.0, 1.0)
    return np.asarray(inside * inside * (3 - 2 * inside))
