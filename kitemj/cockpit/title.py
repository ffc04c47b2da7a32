"""The title: a kite flies in the background, and a person chooses what is to be done."""

from math import cos, sin

import pygame

from kitemj.cockpit.demonstration import Demonstration
from kitemj.cockpit.menu import Menu
from kitemj.cockpit.screens import FRAME_RATE, Window, change_fullness, put_in_window
from kitemj.cockpit.title_page import paint_title
from kitemj.controls.actions import MENU_BUTTONS
from kitemj.controls.keys import MENU_KEYS
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.dynamics.motion import Motion
from kitemj.physics.vectors import cross, plus, times
from kitemj.scene.views import Camera, Orbit, looking, orbiting

PACE = 0.12  # rad/s of the eye's swing about the kite
SWING, BELOW, RISE = 0.5, 0.22, 0.1  # rad, to the sides; below the kite, so that it has sky behind
AWAY = 2.5  # spans
ASIDE = 0.34  # rad by which the eye looks past the kite, which leaves the left to the text
PUSHED, LET_GO = 0.6, 0.3  # of a stick's way: it asks for a step; it may ask again


class Title:
    """Runs in a `window`, painted by `picture`, until something of the `menu` is chosen."""

    def __init__(
        self, picture: Picture, window: Window, menu: Menu, show: Demonstration, message: str = ""
    ) -> None:
        self._picture, self._window, self._menu = picture, window, menu
        self._show, self._message = show, message
        self._boxes: list[pygame.Rect] = []
        self._place = pygame.Rect(0, 0, picture.width, picture.height)
        self._pushed, self._t = False, 0.0

    def run(self) -> str:
        """Returns the key of what was chosen; "leave" for none."""
        clock = pygame.time.Clock()
        self._window.fit(self._picture, at_once=True)
        self.paint()
        while not self._menu.chosen:
            wall = clock.tick(FRAME_RATE) / 1000
            self._t += wall
            self._show.advance(wall)
            self.poll()
            self.paint()
        return self._menu.chosen

    def poll(self) -> None:
        """Does what keys, buttons, sticks and the mouse say."""
        for event, buttons in self._window.events():
            for name in buttons:
                self._menu.ask(MENU_BUTTONS.get(name, ""))
            if event.type == pygame.QUIT:
                self._menu.ask("leave")
            elif event.type == pygame.KEYDOWN:
                self._ask(MENU_KEYS.get(event.key, ""))
            elif event.type in (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN):
                self._point(event)
        self._push()
        self._window.fit(self._picture)

    def paint(self) -> None:
        """Paints the kite, and the page over it."""
        picture, motion = self._picture, self._show.motion
        picture.depth = "none"
        self._window.sense(picture.parameters, motion, None, moving=True)
        frame = picture.paint(motion, None, Readings(), self._camera(motion))
        surface = pygame.image.frombuffer(frame.data, (picture.width, picture.height), "RGB")
        self._boxes = paint_title(surface, self._menu, self._message)
        self._place = put_in_window(surface)

    def _camera(self, motion: Motion) -> Camera:
        """An eye that swings about the kite, which it has on its right."""
        parameters, t = self._picture.parameters, PACE * self._t
        orbit = Orbit(SWING * sin(t), RISE * cos(0.7 * t) - BELOW, AWAY * parameters.kite.span)
        camera = orbiting(parameters, motion, orbit)
        right = cross(camera.forward, camera.up)
        ahead = plus(times(cos(ASIDE), camera.forward), times(-sin(ASIDE), right))
        return looking(camera.position, plus(camera.position, ahead))._replace(near=camera.near)

    def _ask(self, action: str) -> None:
        if action == "full screen":
            change_fullness((self._picture.width, self._picture.height))
        elif action == "sound":
            self._window.wishes.ask(["sound"])
        else:
            self._menu.ask(action)

    def _point(self, event: pygame.event.Event) -> None:
        """The mouse marks what it is over, and chooses it."""
        scale = self._picture.width / self._place.width
        x, y = ((event.pos[i] - self._place.topleft[i]) * scale for i in (0, 1))
        found = pygame.Rect(x, y, 1, 1).collidelist(self._boxes)
        if found < 0 or not self._menu.entries[found].open:
            return
        self._menu.marked = found
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            self._menu.ask("choose")

    def _push(self) -> None:
        """A stick that is pushed asks once, until it is let go."""
        across, down = self._window.push
        far = max(abs(across), abs(down))
        if far > PUSHED and not self._pushed:
            way = ("left", "right") if abs(across) > abs(down) else ("up", "down")
            self._menu.ask(way[(across if abs(across) > abs(down) else down) > 0])
            self._pushed = True
        elif far < LET_GO:
            self._pushed = False
