"""Where frames go: a window, or a film when there is no display."""

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

import numpy as np
import pygame
from numpy.typing import NDArray
from pygame._sdl2 import controller

from kitemj.cockpit.film import Film
from kitemj.cockpit.picture import VIEWS
from kitemj.cockpit.stick import PersonStick, Stick

FRAME_RATE = 30
Frame = NDArray[np.uint8]


@dataclass
class Wishes:
    """What the person at a screen wants: states, then deeds that are done once and forgotten.

    `rate` is simulated over wall time, 0 a pause; `turn` [rad] and `zoom` move the eye of the
    orbit view.
    """

    view: str = VIEWS[0]
    rate: float = 1.0
    instruments: bool = True
    help: bool = False
    leaving: bool = False
    restarting: bool = False
    stepping: bool = False
    turn: tuple[float, float] = (0.0, 0.0)
    zoom: float = 1.0

    def forget_deeds(self) -> None:
        """Once they are done."""
        self.restarting = self.stepping = False
        self.turn, self.zoom = (0.0, 0.0), 1.0


class Screen(Protocol):
    """Takes frames, and says what the person at it wants."""

    stick: Stick
    wishes: Wishes

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


HELP = (
    "Left stick, arrow keys, A D\tsteer: the hand on that side pulls",
    "Mouse, left button held\tsteer as far as from the middle",
    "Right stick, W S\tlet line out, take it in",
    "V\tnext view",
    "Mouse, right button, wheel\tturn and near the orbit view",
    "Space   .\tpause; one tick",
    "-   =\tslower, faster",
    "R\tstart again",
    "I\tinstruments",
    "Esc\tleave",
)
RATES = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0)
TURN = 0.005
"""rad; of the orbit view for each pixel."""


class Window:
    """A window of its own; `HELP` says its keys."""

    def __init__(self, width: int, height: int, title: str) -> None:
        self._size = (width, height)
        pygame.display.set_mode(self._size, pygame.RESIZABLE)
        pygame.display.set_caption(title)
        pygame.joystick.init()
        self._person = PersonStick()
        self.stick: Stick = self._person
        self.wishes = Wishes()
        self._rate = 1.0  # when not paused

    @property
    def message(self) -> str:
        """What the person should know of the stick."""
        return self._person.message

    def poll(self) -> None:
        """Reads all events."""
        for event in pygame.event.get():
            self._person.handle(event)
            if event.type == pygame.QUIT:
                self.wishes.leaving = True
            elif event.type == pygame.KEYDOWN:
                self._key(event.key)
            elif event.type == pygame.MOUSEMOTION and event.buttons[2]:
                across, down = event.rel
                turn = self.wishes.turn
                self.wishes.turn = (turn[0] - TURN * across, turn[1] + TURN * down)
            elif event.type == pygame.MOUSEWHEEL:
                self.wishes.zoom *= 1.1**event.y

    def _key(self, key: int) -> None:
        wishes = self.wishes
        if key == pygame.K_ESCAPE:
            wishes.leaving = True
        elif key == pygame.K_r:
            wishes.restarting = True
        elif key == pygame.K_v:
            wishes.view = VIEWS[(VIEWS.index(wishes.view) + 1) % len(VIEWS)]
        elif key == pygame.K_i:
            wishes.instruments = not wishes.instruments
        elif key in (pygame.K_F1, pygame.K_SLASH, pygame.K_QUESTION):
            wishes.help = not wishes.help
        elif key == pygame.K_PERIOD:
            wishes.stepping = True
        elif key == pygame.K_SPACE:
            wishes.rate = self._rate if wishes.rate == 0 else 0.0
        elif key in (pygame.K_MINUS, pygame.K_EQUALS):
            further = RATES.index(self._rate) + (1 if key == pygame.K_EQUALS else -1)
            self._rate = RATES[max(0, min(further, len(RATES) - 1))]
            wishes.rate = self._rate

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

    message = ""

    def __init__(
        self, path: Path, width: int, height: int, stick: Stick, overwrite: bool = False
    ) -> None:
        self._film = Film(path, width, height, FRAME_RATE, overwrite)
        self.stick, self.wishes = stick, Wishes()

    def poll(self) -> None:
        """Nobody is there."""

    def show(self, frame: Frame, wall: float) -> None:
        """Adds the frame for as many film frames as have passed."""
        while self._film.frames < wall * FRAME_RATE + 1:
            self._film.add(frame)

    def close(self) -> None:
        """Completes the film."""
        self._film.close()
