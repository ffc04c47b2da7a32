"""Where frames go: a window, or a film when there is no display."""

import os
from pathlib import Path
from typing import Protocol

import numpy as np
import pygame
from numpy.typing import NDArray
from pygame._sdl2 import controller

from kitemj.cockpit.film import Film
from kitemj.cockpit.picture import VIEWS
from kitemj.cockpit.stick import SHOW, PersonStick, Stick

FRAME_RATE = 30
Frame = NDArray[np.uint8]


class Screen(Protocol):
    """Takes frames, and says what the person at it wants."""

    stick: Stick
    view: str
    leaving: bool
    restarting: bool

    @property
    def message(self) -> str:
        """What the person should know of the stick."""

    def poll(self) -> None:
        """Looks at what the person did since."""

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


class Window:
    """A window of its own; Esc leaves, R starts again, V changes the view."""

    def __init__(self, width: int, height: int, title: str) -> None:
        self._size = (width, height)
        pygame.display.set_mode(self._size, pygame.RESIZABLE)
        pygame.display.set_caption(title)
        pygame.joystick.init()
        self._person = PersonStick()
        self.stick: Stick = self._person
        self.view, self.leaving, self.restarting = VIEWS[0], False, False

    @property
    def message(self) -> str:
        """What the person should know of the stick."""
        return self._person.message

    def poll(self) -> None:
        """Reads all events."""
        self.restarting = False
        for event in pygame.event.get():
            self._person.handle(event)
            if event.type == pygame.QUIT:
                self.leaving = True
            elif event.type == pygame.KEYDOWN:
                self._key(event.key)

    def _key(self, key: int) -> None:
        if key == pygame.K_ESCAPE:
            self.leaving = True
        elif key == pygame.K_r:
            self.restarting = True
        elif key == pygame.K_v:
            self.view = VIEWS[(VIEWS.index(self.view) + 1) % len(VIEWS)]

    def show(self, frame: Frame, wall: float) -> None:
        """Puts the frame on the screen, as large as the window allows, its shape kept."""
        picture = pygame.image.frombuffer(frame.data, self._size, "RGB")
        surface = pygame.display.get_surface()
        place = picture.get_rect().fit(surface.get_rect())
        if place.size != self._size:
            picture = pygame.transform.smoothscale(picture, place.size)
            surface.fill((0, 0, 0))
        surface.blit(picture, place)
        pygame.display.flip()

    def close(self) -> None:
        """Closes the window and lets go of the pads; fonts stay, pictures may go on."""
        controller.quit()
        pygame.joystick.quit()
        pygame.display.quit()


class FilmScreen:
    """A film in real time: a frame that came late stands as long as it was the newest."""

    def __init__(self, path: Path, width: int, height: int, overwrite: bool = False) -> None:
        self._film = Film(path, width, height, FRAME_RATE, overwrite)
        self.stick: Stick = SHOW
        self.view, self.leaving, self.restarting, self.message = VIEWS[0], False, False, ""

    def poll(self) -> None:
        """Nobody is there."""

    def show(self, frame: Frame, wall: float) -> None:
        """Adds the frame for as many film frames as have passed."""
        while self._film.frames < wall * FRAME_RATE + 1:
            self._film.add(frame)

    def close(self) -> None:
        """Completes the film."""
        self._film.close()
