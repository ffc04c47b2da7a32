"""The help page over the picture: which key does what."""

import pygame

from kitemj.drawing.colours import CALL, WHITE
from kitemj.drawing.panel import Panel
from kitemj.drawing.text import width

STEP, EDGE, GAP, SIZE = 30, 32, 30, 16  # units: between lines, around, between columns, digits
DARKER = 0.55  # opacity of the picture's shade


def paint_help(surface: pygame.Surface, lines: tuple[str, ...], unit: float) -> None:
    """Paints the page of `lines`; text before a tab has a column of its own.

    A page that is larger than the frame is made smaller.
    """
    rows = [line.partition("\t") for line in lines]
    keys = [_units(key, unit, True) for key, tab, _ in rows if tab]
    first = max(keys, default=0.0) + GAP
    wide = max(
        first + _units(text, unit) if tab else _units(key, unit, True) for key, tab, text in rows
    )
    room, tall = wide + 2 * EDGE, STEP * len(rows) + 40
    scale = min(unit, surface.get_width() / room, surface.get_height() / tall)
    corner = (surface.get_width() - room * scale) / 2, (surface.get_height() - tall * scale) / 2
    shade = pygame.Surface(surface.get_size())
    shade.set_alpha(round(255 * DARKER))
    surface.blit(shade, (0, 0))
    panel = Panel(surface, (*corner, room, tall), scale)
    panel.ground()
    for i, (key, tab, text) in enumerate(rows):
        row = 20 + STEP * (i + 0.5)
        panel.text(key, EDGE, row, SIZE, CALL if tab else WHITE, bold=True)
        panel.text(text, EDGE + first, row, SIZE, WHITE)


def _units(text: str, unit: float, bold: bool = False) -> float:
    return width(text, SIZE * unit, bold) / unit
