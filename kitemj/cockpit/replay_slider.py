"""The strip below a replay: play and pause, time, a slider that shows limits left; key hints."""

from collections.abc import Sequence

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.cockpit.replay_player import Player
from kitemj.controls.actions import REPLAY_ACTIONS
from kitemj.drawing.text import put, width

BAR, HINTS = 48, 24  # px, of the slider and of the line below it
HEIGHT = BAR + HINTS
GROUND, TROUGH = (24, 28, 34), (52, 58, 66)
WHITE, DIM = (255, 255, 255), (205, 212, 220)
BAD, CALL = (255, 70, 60), (255, 214, 60)
BUTTON = 48  # px on the left that play and pause
TIMES = 250  # px on the right for the numbers
HINT, GAP = 11, " " * 4  # px, of the hints' digits; between two hints


class Slider:
    """`beyond` (rows,): whether a limit is left; `starts`: rows where episodes begin."""

    def __init__(self, beyond: NDArray[np.bool_], starts: Sequence[int], width: int) -> None:
        self._left, self._right = BUTTON, width - TIMES
        room, rows = self._right - self._left, len(beyond)
        column = np.arange(rows) * room // rows
        self._outside = np.unique(column[beyond]).tolist()
        self._starts = [row * room // rows for row in starts if row > 0]
        self.pressed = False  # whether the handle is held

    def handle(self, event: pygame.event.Event, at: tuple[float, float], player: Player) -> None:
        """Takes in an event of the mouse at `at`, px from the strip's upper left corner."""
        x, y = at
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1 and 0 <= y < BAR:
            if x < self._left:
                player.toggle()
                return
            self.pressed = x <= self._right
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            self.pressed = False
        if self.pressed:
            player.seek((x - self._left) / (self._right - self._left) * player.duration)

    def paint(self, strip: pygame.Surface, player: Player) -> None:
        """Paints the strip as it is now."""
        strip.fill(GROUND)
        middle, room = BAR // 2, self._right - self._left
        if player.playing:
            strip.fill(WHITE, (17, middle - 8, 5, 16))
            strip.fill(WHITE, (26, middle - 8, 5, 16))
        else:
            pygame.draw.polygon(strip, WHITE, [(17, middle - 9), (17, middle + 9), (32, middle)])
        strip.fill(TROUGH, (self._left, middle - 5, room, 10))
        for x in self._outside:
            strip.fill(BAD, (self._left + x, middle - 5, 1, 10))
        for x in self._starts:
            strip.fill(WHITE, (self._left + x, middle - 10, 2, 20))
        handle = self._left + round(player.t / player.duration * room) if player.duration else 0
        strip.fill(CALL, (handle - 3, middle - 13, 7, 26))
        right = strip.get_width() - 14
        put(strip, f"{player.t:.2f} / {player.duration:.2f} s", right, middle - 10, 14, WHITE, 1)
        put(strip, f"×{player.speed:g}", right, middle + 11, 13, DIM, 1)
        put(strip, hints(right - 14), 14, BAR + HINTS // 2 - 4, HINT, DIM)


def hints(room: float) -> str:
    """As many keys and what they do as fit into `room` [px]."""
    line = ""
    for action in REPLAY_ACTIONS:
        hint = f"{' '.join(action.shown.split())}: {action.help}"
        longer = f"{line}{GAP}{hint}" if line else hint
        if action.shown and width(longer, HINT) <= room:
            line = longer
    return line
