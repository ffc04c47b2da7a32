"""Where frames go, and what the person there wants: a window, or nobody."""

import os
from collections.abc import Iterable

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.controls.actions import Wishes
from kitemj.controls.keys import KEYS
from kitemj.controls.pads import events
from kitemj.controls.stick import PersonStick, Stick

FRAME_RATE = 30
Frame = NDArray[np.uint8]


class Screen:
    """Takes frames, and says what the person at it wants; this one shows them to nobody.

    `stick` is that of the person at it, `wishes` what they ask for.
    """

    def __init__(self, stick: Stick) -> None:
        self.stick, self.wishes = stick, Wishes()

    @property
    def message(self) -> str:
        """A sentence on the stick for the person; empty: none."""
        return ""

    def poll(self) -> None:
        """Takes in what the person did since."""

    def show(self, frame: Frame, wall: float) -> None:
        """Shows a frame painted `wall` [s] after the start."""

    def close(self) -> None:
        """Gives everything back."""


def display_found() -> bool:
    """Whether a window can be opened; starts pygame's display if so."""
    os.environ.setdefault("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1")
    # SDL would put the frames up with an OpenGL context of its own, which stays current in
    # this thread and keeps the picture's from becoming so
    os.environ.setdefault("SDL_FRAMEBUFFER_ACCELERATION", "0")
    if os.name == "posix" and os.uname().sysname == "Linux":
        named = ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")
        if not any(os.environ.get(name) for name in named):
            return False  # SDL would take a text console, where nobody can be asked
    try:
        pygame.display.init()
    except pygame.error:
        return False
    return True


AROUND = 100
"""px of a desktop's height that bars and a window's title may take; no system tells pygame."""


def fitting(size: tuple[int, int], below: int = 0) -> tuple[int, int]:
    """The largest picture of the shape of `size` [px] that a desktop shows whole in a window.

    `below` [px]: what the window has beneath the picture. Needs pygame's display.
    """
    wide, tall = pygame.display.get_desktop_sizes()[0]
    room = pygame.Rect(0, 0, wide, tall - AROUND - below)
    picture = pygame.Rect(0, 0, *size)
    return size if room.contains(picture) else picture.fit(room).size


TURN = 0.005
"""rad; of the orbit view for each pixel."""


def put_in_window(picture: pygame.Surface) -> pygame.Rect:
    """Shows the picture as large as the window allows, its shape kept; returns its place there."""
    surface = pygame.display.get_surface()
    place = picture.get_rect().fit(surface.get_rect())
    if place.size != picture.get_size():
        picture = pygame.transform.smoothscale(picture, place.size)
        surface.fill((0, 0, 0))
    surface.blit(picture, place)
    pygame.display.flip()
    return place


class Window(Screen):
    """A window of its own; `actions.HELP` says its keys. A frame keeps its shape in any window.

    The `person` steers, unless a programmed `stick` does; keys and buttons work either way.
    """

    def __init__(
        self, width: int, height: int, title: str, person: PersonStick, stick: Stick | None = None
    ) -> None:
        super().__init__(stick or person)
        self._person, self._size = person, (width, height)
        pygame.display.set_mode(self._size, pygame.RESIZABLE)
        pygame.display.set_caption(title)
        self._windowed: tuple[int, int] | None = None  # its size before it was full

    @property
    def message(self) -> str:
        """A sentence on the stick for the person; empty: none."""
        return self._person.message

    def poll(self) -> None:
        """Reads all events."""
        for event in events():
            self._ask(self._person.handle(event))
            if event.type == pygame.QUIT:
                self._ask(["leave"])
            elif event.type == pygame.KEYDOWN:
                self._ask([KEYS[event.key]] if event.key in KEYS else [])
            elif event.type == pygame.MOUSEMOTION and event.buttons[2]:
                across, down = event.rel
                turn = self.wishes.turn
                self.wishes.turn = (turn[0] - TURN * across, turn[1] + TURN * down)
            elif event.type == pygame.MOUSEWHEEL:
                self.wishes.zoom *= 1.1**event.y

    def _ask(self, names: Iterable[str]) -> None:
        """Takes in actions; those of the window or the stick are done here."""
        for name in names:
            if name == "full screen":
                self._change_fullness()
            elif name in ("law", "two sticks"):
                self._person.change(name)
            else:
                self.wishes.ask([name])

    def _change_fullness(self) -> None:
        if self._windowed is None:
            self._windowed = pygame.display.get_window_size()
            pygame.display.set_mode((0, 0), pygame.FULLSCREEN)
            return
        pygame.display.set_mode(self._windowed)  # window managers keep the large size of one
        pygame.display.set_mode(self._windowed, pygame.RESIZABLE)  # that may have any
        self._windowed = None

    def show(self, frame: Frame, wall: float) -> None:
        """Puts the frame on the screen."""
        put_in_window(pygame.image.frombuffer(frame.data, self._size, "RGB"))

    def close(self) -> None:
        """Closes the window and lets go of the pads; fonts stay, pictures may go on."""
        self._person.close()
        pygame.display.quit()
