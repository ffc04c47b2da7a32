"""A recording in a window: every view, a slider over its time, play, pause and speed."""

import numpy as np
import pygame

from kitemj.cockpit.film_sources import RecordingSource
from kitemj.cockpit.replay_player import Player
from kitemj.cockpit.replay_slider import HEIGHT, Slider
from kitemj.cockpit.screens import FRAME_RATE, fitting, put_in_window
from kitemj.controls.actions import REPLAY_HELP, VIEWS
from kitemj.controls.keys import REPLAY_KEYS
from kitemj.controls.pads import events
from kitemj.drawing.picture import Picture
from kitemj.recording.file import Recording
from kitemj.recording.replay import Replay
from kitemj.recording.table import LIMITS


def show(recording: Recording, again: Replay | None, size: tuple[int, int], view: str) -> None:
    """Shows the recording, with `again` as its reference, until the window is left.

    `size` [px] of the picture, made smaller where the desktop is. Raises NoGraphics or
    InputError before a window opens.
    """
    with Picture(recording.parameters, *fitting(size, HEIGHT)) as picture:
        window = ReplayWindow(recording, again, picture, view)
        try:
            window.run()
        except KeyboardInterrupt:
            pass  # leaving in a hurry is leaving
        finally:
            pygame.display.quit()


class ReplayWindow:
    """Its keys are `actions.REPLAY_ACTIONS`; the page that tells them stops the player."""

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
        self.leaving = self.help = False
        self._shown: tuple[object, ...] | None = None

    def run(self) -> None:
        """Plays until the window is left; paints only what has changed."""
        clock = pygame.time.Clock()
        while not self.leaving:
            wall = clock.tick(FRAME_RATE) / 1000
            self.poll()
            if not self.help:
                self.player.advance(wall)
            self.paint()

    def poll(self) -> None:
        """Does what the keys and the mouse say."""
        for event in events():
            if event.type == pygame.QUIT:
                self.leaving = True
            elif event.type == pygame.KEYDOWN:
                self._ask(REPLAY_KEYS.get(event.key, ""), bool(event.mod & pygame.KMOD_SHIFT))
            elif event.type in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEMOTION):
                self._slider.handle(event, self._in_strip(event.pos), self.player)
            elif event.type in (pygame.VIDEORESIZE, pygame.VIDEOEXPOSE):
                self._shown = None

    def paint(self) -> None:
        """Paints the picture of the present moment, and the strip below it."""
        player, picture = self.player, self._picture
        state = (player.t, player.speed, player.playing, self.view, self.help)
        if state == self._shown:
            return
        self._shown = state
        motion, reference, readings, _ = self._source.shot(player.t, player.speed)
        readings = readings._replace(help=REPLAY_HELP if self.help else ())
        frame = picture.paint(motion, reference, readings, self.view)
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

    def _ask(self, action: str, shift: bool) -> None:
        player = self.player
        if action == "leave":
            self.leaving = True
        elif action == "help":
            self.help = not self.help
        elif action == "play":
            player.toggle()
        elif action in ("back", "on"):
            step = self._tick if shift else 1.0
            player.seek(player.t + (step if action == "on" else -step))
        elif action in ("faster", "slower"):
            player.change_speed(1 if action == "faster" else -1)
        elif action in ("start", "end"):
            player.seek(0.0 if action == "start" else player.duration)
        elif action == "view":
            self.view = VIEWS[(VIEWS.index(self.view) + 1) % len(VIEWS)]
