"""A recording in a window: every view, a slider over its time, play, pause and speed."""

import numpy as np
import pygame

from kitemj.cockpit.film_sources import RecordingSource
from kitemj.cockpit.replay_player import Player
from kitemj.cockpit.replay_slider import HEIGHT, Slider
from kitemj.cockpit.screens import FRAME_RATE, put_in_window
from kitemj.controls.actions import VIEWS
from kitemj.controls.pads import events
from kitemj.drawing.picture import Picture
from kitemj.recording.file import Recording
from kitemj.recording.replay import Replay
from kitemj.recording.table import LIMITS


def show(recording: Recording, again: Replay | None, size: tuple[int, int], view: str) -> None:
    """Shows the recording, with `again` as its reference, until the window is left.

    `size` [px] of the picture. Raises NoGraphics or InputError before a window opens.
    """
    with Picture(recording.parameters, *size) as picture:
        window = ReplayWindow(recording, again, picture, view)
        try:
            window.run()
        except KeyboardInterrupt:
            pass  # leaving in a hurry is leaving
        finally:
            pygame.display.quit()


class ReplayWindow:
    """Esc leaves; the keys are those of ``kitemj replay --help``."""

    def __init__(
        self, recording: Recording, again: Replay | None, picture: Picture, view: str
    ) -> None:
        self._source, self._picture, self.view = RecordingSource(recording, again), picture, view
        self._tick = recording.header.tick
        self.player = Player(self._source.duration)
        beyond = np.logical_or.reduce([recording.columns[name] for name in LIMITS])
        starts = [episode.start for episode in recording.episodes]
        self._slider = Slider(beyond, starts, picture.width)
        self._whole = pygame.Surface((picture.width, picture.height + HEIGHT))
        pygame.display.set_mode(self._whole.get_size(), pygame.RESIZABLE)
        pygame.display.set_caption(f"kitemj: {self._source.caption}")
        self._place = self._whole.get_rect()
        self.leaving = False
        self._shown: tuple[float, float, bool, str] | None = None

    def run(self) -> None:
        """Plays until the window is left; paints only what has changed."""
        clock = pygame.time.Clock()
        while not self.leaving:
            wall = clock.tick(FRAME_RATE) / 1000
            self.poll()
            self.player.advance(wall)
            self.paint()

    def poll(self) -> None:
        """Does what the keys and the mouse say."""
        for event in events():
            if event.type == pygame.QUIT:
                self.leaving = True
            elif event.type == pygame.KEYDOWN:
                self._key(event.key, bool(event.mod & pygame.KMOD_SHIFT))
            elif event.type in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEMOTION):
                self._slider.handle(event, self._in_strip(event.pos), self.player)
            elif event.type in (pygame.VIDEORESIZE, pygame.VIDEOEXPOSE):
                self._shown = None

    def paint(self) -> None:
        """Paints the picture of the present moment, and the strip below it."""
        player, picture = self.player, self._picture
        state = (player.t, player.speed, player.playing, self.view)
        if state == self._shown:
            return
        self._shown = state
        frame = picture.paint(*self._source.shot(player.t, player.speed), self.view)
        size = (picture.width, picture.height)
        self._whole.blit(pygame.image.frombuffer(frame.data, size, "RGB"), (0, 0))
        strip = pygame.Rect(0, picture.height, picture.width, HEIGHT)
        self._slider.paint(self._whole.subsurface(strip), player)
        self._place = put_in_window(self._whole)

    def _in_strip(self, at: tuple[int, int]) -> tuple[float, float]:
        """Returns a place in the window as px of the strip as it was painted."""
        scale = self._whole.get_width() / self._place.width
        x, y = (at[0] - self._place.left) * scale, (at[1] - self._place.top) * scale
        return x, y - self._picture.height

    def _key(self, key: int, shift: bool) -> None:
        player = self.player
        if key == pygame.K_ESCAPE:
            self.leaving = True
        elif key == pygame.K_SPACE:
            player.toggle()
        elif key in (pygame.K_LEFT, pygame.K_RIGHT):
            step = self._tick if shift else 1.0
            player.seek(player.t + (step if key == pygame.K_RIGHT else -step))
        elif key in (pygame.K_UP, pygame.K_DOWN):
            player.change_speed(1 if key == pygame.K_UP else -1)
        elif key in (pygame.K_HOME, pygame.K_END):
            player.seek(0.0 if key == pygame.K_HOME else player.duration)
        elif key == pygame.K_v:
            self.view = VIEWS[(VIEWS.index(self.view) + 1) % len(VIEWS)]
