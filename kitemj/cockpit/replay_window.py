"""A recording in a window: every view, a slider over its time, play, pause and speed."""

from collections.abc import Callable

import numpy as np
import pygame

from kitemj.cockpit.film_sources import RecordingSource
from kitemj.cockpit.replay_player import Player
from kitemj.cockpit.replay_slider import HEIGHT, Slider
from kitemj.cockpit.screens import (
    FRAME_RATE,
    TURN,
    Window,
    change_fullness,
    fitting,
    put_in_window,
)
from kitemj.controls.actions import REPLAY_BUTTONS, REPLAY_HELP, VIEWS
from kitemj.controls.keys import REPLAY_KEYS
from kitemj.controls.settings import settings_or_defaults
from kitemj.controls.stick import PersonStick
from kitemj.drawing.picture import Picture
from kitemj.recording.file import Recording
from kitemj.recording.replay import Replay
from kitemj.recording.table import LIMITS

MOUSE = (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEMOTION)


def show(recording: Recording, again: Replay | None, size: tuple[int, int], view: str) -> None:
    """Shows the recording, with `again` as its reference, until the window is left.

    `size` [px] of the picture, made smaller where the desktop is. Raises NoGraphics or
    InputError before a window opens.
    """
    settings, _ = settings_or_defaults()
    with Picture(recording.parameters, *fitting(size, HEIGHT), "auto") as picture:
        person = PersonStick(settings, recording.parameters)
        window = Window(picture.width, picture.height + HEIGHT, "kitemj", person)
        window.wishes.view, window.wishes.sound = view, settings.sound
        try:
            ReplayWindow(recording, again, picture, window).run()
        except KeyboardInterrupt:
            pass  # leaving in a hurry is leaving
        finally:
            window.close()
            pygame.display.quit()


class ReplayWindow:
    """Its keys are `actions.REPLAY_ACTIONS`; the page that tells them stops the player.

    It is shown in a `window`, whose wishes say the view to begin with, and whether to hear it.
    """

    def __init__(
        self, recording: Recording, again: Replay | None, picture: Picture, window: Window
    ) -> None:
        self._source, self._picture = RecordingSource(recording, again), picture
        self._window, self.view = window, window.wishes.view
        self._tick = recording.header.tick
        self.player = Player(self._source.duration)
        self._beyond = np.logical_or.reduce([recording.columns[name] for name in LIMITS])
        self._starts = [episode.start for episode in recording.episodes]
        self.leaving = self.help = False
        self._lay_out()

    def run(self, meanwhile: Callable[[], object] = lambda: None) -> None:
        """Plays until it is left; paints only what has changed. Calls `meanwhile` each frame."""
        picture, clock = self._picture, pygame.time.Clock()
        caption, trail = pygame.display.get_caption()[0], picture.whole_trail
        pygame.display.set_caption(f"kitemj: {self._source.caption}")
        picture.whole_trail = True
        self._window.fit(picture, HEIGHT, at_once=True)
        self._lay_out()
        while not self.leaving:
            wall = clock.tick(FRAME_RATE) / 1000
            meanwhile()
            self.poll()
            if not self.help:
                self.player.advance(wall)
            self.paint()
        picture.whole_trail = trail
        self._window.fit(picture, at_once=True)
        pygame.display.set_caption(caption)

    def _lay_out(self) -> None:
        """Begins with a strip below a picture of its present size."""
        size = self._picture.width, self._picture.height + HEIGHT
        self._slider = Slider(self._beyond, self._starts, self._picture.width)
        self._whole = pygame.Surface(size)
        self._place = self._whole.get_rect()
        self._shown: tuple[object, ...] | None = None

    def poll(self) -> None:
        """Does what keys, buttons and the mouse say."""
        for event, buttons in self._window.events():
            for name in buttons:
                self._ask(REPLAY_BUTTONS.get(name, ""), shift=False)
            if event.type == pygame.QUIT:
                self.leaving = self._window.wishes.leaving = True
            elif event.type == pygame.KEYDOWN:
                self._ask(REPLAY_KEYS.get(event.key, ""), bool(event.mod & pygame.KMOD_SHIFT))
            elif event.type in MOUSE:
                self._slider.handle(event, self._in_strip(event.pos), self.player)
                if event.type == pygame.MOUSEMOTION and any(event.buttons):
                    self._drag(event)
            elif event.type == pygame.MOUSEWHEEL:
                self._orbit()
                self._picture.eye.zoom(1.1**event.y)
            elif event.type in (pygame.VIDEORESIZE, pygame.VIDEOEXPOSE):
                self._shown = None
        if self._window.fit(self._picture, HEIGHT):
            self._lay_out()

    def paint(self) -> None:
        """Paints the picture of the present moment, and the strip below it."""
        player, picture, window = self.player, self._picture, self._window
        motion, reference, readings, _ = self._source.shot(player.t, player.speed)
        moving = player.playing and not self.help
        window.sense(picture.parameters, motion, readings.touch, moving)
        state = (player.t, player.speed, player.playing, self.view, self.help)
        if state == self._shown:
            return
        self._shown = state
        readings = readings._replace(help=REPLAY_HELP if self.help else ())
        picture.depth, picture.shown = window.wishes.depth, window.wishes.shown
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

    def _drag(self, event: pygame.event.Event) -> None:
        """Turns the eye around the kite, with any button held on the picture."""
        if not self._slider.pressed and self._in_strip(event.pos)[1] < 0:
            self._orbit()
            self._picture.eye.turn(-TURN * event.rel[0], TURN * event.rel[1])

    def _orbit(self) -> None:
        """Another place to look from is wanted, which only the orbit view has."""
        self.view, self._shown = "orbit", None

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
        elif action == "full screen":
            change_fullness(self._whole.get_size())
        elif action:
            self._window.wishes.ask([action])
            self._shown = None
