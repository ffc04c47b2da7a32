"""Where frames go, and what the person there wants: a window, or nobody."""

import os
import time
from collections.abc import Callable, Iterable, Iterator, Mapping

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.cockpit.senses import Senses
from kitemj.controls.actions import Wishes
from kitemj.controls.keys import KEYS
from kitemj.controls.pads import events
from kitemj.controls.stick import PersonStick, Stick
from kitemj.drawing.picture import LEAST, Picture
from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.pilots.crash import Touch

FRAME_RATE = 30
Frame = NDArray[np.uint8]


class Screen:
    """Takes frames, and says what the person at it wants; this one shows them to nobody.

    `stick` is that of the person at it, `wishes` what they ask for; `size` [px] what frames
    should have from now on, None: what they have; `closed`: the window's own cross was pressed,
    which ends more than a flight.
    """

    size: tuple[int, int] | None = None
    closed = False

    def __init__(self, stick: Stick) -> None:
        self.stick, self.wishes = stick, Wishes()

    @property
    def message(self) -> str:
        """A sentence on the stick for the person; empty: none."""
        return ""

    @property
    def assist(self) -> bool:
        """Whether the assist is to fly what the stick asks for."""
        return False

    @property
    def flown(self) -> str:
        """What the autopilot is to fly; empty: it does not."""
        return ""

    def offer(self, offers: Mapping[str, str], at_once: bool) -> None:
        """Tells what an autopilot could fly, as `HandOver.offer`."""

    def poll(self) -> None:
        """Takes in what the person did since."""

    def sense(
        self, parameters: Parameters, motion: Motion, touch: Touch | None, moving: bool
    ) -> None:
        """Lets the person hear and feel the motion, and `touch`, how the kite met the ground.

        Nothing while it is not `moving`.
        """

    def show(self, frame: Frame, wall: float) -> None:
        """Shows a frame painted `wall` [s] after the start."""

    def close(self) -> None:
        """Gives everything back."""


class Unattended(Screen):
    """One where nobody is: the autopilot of the scenario has the stick."""

    flown = "scenario"


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


SHAPES = (4 / 3, 21 / 9)
"""Width over height of a picture, the least and the most; a window of another shape has edges."""
RESTED = 0.3
"""s; for which a window keeps its size before the picture takes it."""


def shaped(size: tuple[int, int]) -> tuple[int, int]:
    """The largest picture [px] of an allowed shape in a window of `size`; even numbers."""
    wide, tall = size
    least, most = SHAPES
    wide, tall = min(wide, round(most * tall)), min(tall, round(wide / least))
    return max(wide - wide % 2, LEAST[0]), max(tall - tall % 2, LEAST[1])


class RestingSize:
    """The size that a window's picture should have: it follows the window when that rests."""

    def __init__(self, size: tuple[int, int], clock: Callable[[], float] = time.monotonic) -> None:
        """`size` [px] of the window at first."""
        self._clock, self._last, self._since = clock, size, clock()

    def rested(self, size: tuple[int, int]) -> tuple[int, int] | None:
        """The picture's size [px] for a window of `size` now; None while it is being changed."""
        if size != self._last:
            self._last, self._since = size, self._clock()
        return shaped(size) if self._clock() - self._since >= RESTED else None


def full() -> bool:
    """Whether the window fills the screen."""
    return bool(pygame.display.get_surface().get_flags() & pygame.FULLSCREEN)


def change_fullness(windowed: tuple[int, int]) -> None:
    """Makes the window fill the screen, or gives it the size `windowed` [px] again."""
    if full():
        pygame.display.set_mode(windowed)  # window managers keep the large size of one
        pygame.display.set_mode(windowed, pygame.RESIZABLE)  # that may have any
    else:
        pygame.display.set_mode((0, 0), pygame.FULLSCREEN)


PERSONAL = ("law", "two sticks", "assist", "autopilot", "figure")
"""Actions that change who steers, and how."""
BRIEFLY = 2.0
"""s; for what the person has just asked for."""


class Window(Screen):
    """A window of its own; `actions.HELP` says its keys. Its frames follow its size.

    The `person` steers, unless a programmed `stick` does; keys and buttons work either way.
    """

    def __init__(
        self, width: int, height: int, title: str, person: PersonStick, stick: Stick | None = None
    ) -> None:
        super().__init__(stick or person)
        self._person, self._windowed = person, (width, height)
        if not pygame.display.get_surface():  # else there is a window from before
            pygame.display.set_mode((width, height), pygame.RESIZABLE)
        self._resting = RestingSize(pygame.display.get_window_size())
        pygame.display.set_caption(title)
        self._senses = Senses(person.rumble)

    @property
    def message(self) -> str:
        """A sentence on the stick for the person; empty: none."""
        return self._person.message

    @property
    def assist(self) -> bool:
        """Whether the assist is to fly what the person asks for."""
        return self._person.assist and self.stick is self._person and not self.flown

    @property
    def flown(self) -> str:
        """What the autopilot is to fly; empty: it does not."""
        return self._person.hand_over.flown

    def offer(self, offers: Mapping[str, str], at_once: bool) -> None:
        """Tells the person what an autopilot could fly; a programme flies by itself."""
        if self.stick is self._person:
            self._person.hand_over.offer(offers, at_once)

    def events(self) -> Iterator[tuple[pygame.event.Event, tuple[str, ...]]]:
        """All events since, each with the actions that a pad asks for by it."""
        for event in events():
            self.closed |= event.type == pygame.QUIT
            yield event, self._person.handle(event)

    def poll(self) -> None:
        """Reads all events."""
        for event, asked in self.events():
            self._ask(asked)
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
        self.size = self._resting.rested(pygame.display.get_window_size())

    def _ask(self, names: Iterable[str]) -> None:
        """Takes in actions; those of the window or the stick are done here."""
        for name in names:
            if name == "full screen":
                if not full():
                    self._windowed = pygame.display.get_window_size()
                change_fullness(self._windowed)
            elif name in PERSONAL:
                self._person.change(name)
            else:
                self.wishes.ask([name])
                if name == "sound":
                    said = "are on" if self.wishes.sound else "are off"
                    self._person.notices.say(f"sound and rumble {said}", BRIEFLY)

    @property
    def push(self) -> tuple[float, float]:
        """How far the pad's sticks are pushed to the right and down, -1..1."""
        return self._person.push

    def say(self, sentence: str) -> None:
        """Shows a sentence for some seconds."""
        self._person.notices.say(sentence)

    def sense(
        self, parameters: Parameters, motion: Motion, touch: Touch | None, moving: bool
    ) -> None:
        """Lets the person hear and feel the motion, unless they wish not to."""
        self._senses.feel(parameters, motion, touch, self.wishes.sound and moving)

    def fit(self, picture: Picture, below: int = 0, at_once: bool = False) -> bool:
        """Has the picture fill the window above `below` [px], once that rests; whether it changed.

        `at_once`: now, whether the window rests or not.
        """
        wide, tall = pygame.display.get_window_size()
        room = (wide, tall - below)
        size = shaped(room) if at_once else self._resting.rested(room)
        if size is None or size == (picture.width, picture.height):
            return False
        picture.resize(*size)
        return True

    def show(self, frame: Frame, wall: float) -> None:
        """Puts the frame on the screen."""
        put_in_window(pygame.image.frombuffer(frame.data, frame.shape[1::-1], "RGB"))

    def close(self) -> None:
        """Lets go of the pads, and is silent; the window stays, for whoever comes next."""
        self._senses.close()
        self._person.close()
