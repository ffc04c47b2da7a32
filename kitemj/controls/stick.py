"""Sticks: a person with a gamepad, the keys or the mouse; or a pilot in their place."""

from typing import Protocol

import pygame

from kitemj.controls.hand_over import HandOver
from kitemj.controls.held_keys import HeldKeys
from kitemj.controls.notices import Notices
from kitemj.controls.pads import Pads
from kitemj.controls.programmed import show
from kitemj.controls.settings import Settings
from kitemj.controls.stick_mapping import Deflections, command_of
from kitemj.dynamics.motion import Motion
from kitemj.flight.live import Command
from kitemj.physics.parameters import Parameters
from kitemj.physics.shaping import StickLaw
from kitemj.pilots.manoeuvres import Pilot, turns
from kitemj.pilots.show import Show

ASKS = ("an angle δ, to which the hands go", "a rate of δ", "an acceleration of δ")
"""What each law means, in words."""
ASSIST = "the assist flies: the stick asks for turns; hands off, it flies to the top"
NO_ASSIST = "there is no assist for this kite, which drifts and does not turn"


class Stick(Protocol):
    """Something that asks for δ and ℓ; `name` is shown among the instruments."""

    @property
    def name(self) -> str:
        """The name of what steers."""

    def command(self, motion: Motion) -> Command:
        """The command asked for now; `motion` is what the pilot sees."""


class PilotStick:
    """A stick moved by a pilot of `kitemj.pilots`."""

    name = "pilot"

    def __init__(self, pilot: Pilot) -> None:
        self.command = pilot.command


def show_of(parameters: Parameters) -> Stick:
    """The pilot of a show for a kite that turns, else a programmed stick."""
    return PilotStick(Show()) if turns(parameters) else show(parameters)


class PersonStick:
    """Held keys, the mouse with its button held, and the pad that was moved last.

    Whatever of these is away from its centre steers, in that order. `law`, `two_sticks` and
    `assist`, whether the assist flies what the stick asks for, may be changed in flight;
    `hand_over` knows whether an autopilot flies instead.

    Needs pygame's display module; `handle` is to see every event.
    """

    def __init__(self, settings: Settings, parameters: Parameters) -> None:
        self.law, self.two_sticks = settings.law, settings.feel.two_sticks
        self.notices = Notices()
        self.hand_over = HandOver(self.notices)
        self._parameters = parameters
        self.assist = settings.assist == "always" and turns(parameters)
        self._keys, self._pads = HeldKeys(), Pads(settings, self.notices)
        self._mouse: float | None = None

    def close(self) -> None:
        """Lets go of the pads."""
        self._pads.close()

    @property
    def name(self) -> str:
        """The name of what steers at present."""
        if self._keys.any_held:
            return "keys"
        if self._mouse is not None:
            return "mouse"
        return "gamepad" if self._pads.steering else "keys"

    @property
    def message(self) -> str:
        """A sentence on the pads for the person; empty: none."""
        return self.notices.newest

    def handle(self, event: pygame.event.Event) -> tuple[str, ...]:
        """Takes in an event of pads or mouse; returns the actions that it asks for."""
        left = getattr(event, "button", 0) == 1  # where the event is of the mouse
        dragged = event.type == pygame.MOUSEMOTION and event.buttons[0]
        if event.type == pygame.WINDOWFOCUSLOST or (left and event.type == pygame.MOUSEBUTTONUP):
            self._mouse = None
        elif dragged or (left and event.type == pygame.MOUSEBUTTONDOWN):
            middle = pygame.display.get_window_size()[0] / 2
            self._mouse = max(-1.0, min(1.0, (event.pos[0] - middle) / middle * 2))
        return self._pads.handle(event)

    @property
    def push(self) -> tuple[float, float]:
        """How far the pad's sticks are pushed to the right and down, -1..1."""
        hands = self._pads.hands()
        return hands.steer, max(hands.left, -hands.reel, key=abs)

    def rumble(self, low: float, high: float) -> None:
        """Shakes the pad that steers, if there is one that can; low and high motor, 0..1."""
        self._pads.rumble(low, high)

    def change(self, what: str) -> None:
        """Changes to the next "law" or "figure"; all else goes on and off."""
        if what == "autopilot":
            self.hand_over.change(self._asked())
        elif what == "figure":
            self.hand_over.next_figure()
        elif what == "assist":
            flew = bool(self.hand_over.flown)  # who wants help does not want to be flown
            self.hand_over.take_back()
            self.assist = turns(self._parameters) and (flew or not self.assist)
            said = ASSIST if self.assist else "the assist is off: the stick moves the lines"
            self.notices.say(said if turns(self._parameters) else NO_ASSIST)
        elif what == "law":
            self.law = StickLaw((self.law + 1) % len(StickLaw))
            self.notices.say(f"the stick asks for {ASKS[self.law]}")
        else:
            self.two_sticks = not self.two_sticks
            said = "each stick pulls its own line" if self.two_sticks else "one stick steers"
            self.notices.say(said)

    def command(self, motion: Motion) -> Command:
        """The command of keys, mouse or pad now; who pushes takes back from the autopilot."""
        stick = self._asked()
        self.hand_over.watch(stick)
        return stick

    def _asked(self) -> Command:
        at = self._mouse or 0.0
        mouse = Deflections(at, 0.0, -at, at)
        ways = zip(self._keys.hands(), mouse, self._pads.hands(), strict=True)
        hands = Deflections(*(keys or mouse or pad for keys, mouse, pad in ways))
        return command_of(hands, self._parameters, self.law, self.two_sticks)
