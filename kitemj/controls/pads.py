"""The gamepads that are plugged in; the one moved last steers.

A pad is read through its layout in the settings, else through SDL's own where SDL knows it;
a pad that neither knows does not steer: its axis 0 may be anything.
"""

from typing import Any

import pygame
from pygame._sdl2 import controller

from kitemj.controls.notices import Notices
from kitemj.controls.pad_layout import PRESSED, Layout
from kitemj.controls.settings import Settings
from kitemj.controls.stick_mapping import Deflections, shaped_deflection

FULL = 32767
STANDARD = {
    pygame.CONTROLLER_BUTTON_A: "restart",
    pygame.CONTROLLER_BUTTON_B: "law",
    pygame.CONTROLLER_BUTTON_X: "instruments",
    pygame.CONTROLLER_BUTTON_Y: "view",
    pygame.CONTROLLER_BUTTON_START: "pause",
    pygame.CONTROLLER_BUTTON_BACK: "help",
    pygame.CONTROLLER_BUTTON_LEFTSHOULDER: "slower",
    pygame.CONTROLLER_BUTTON_RIGHTSHOULDER: "faster",
    pygame.CONTROLLER_BUTTON_LEFTSTICK: "two sticks",
    pygame.CONTROLLER_BUTTON_RIGHTSTICK: "rewind",
    pygame.CONTROLLER_BUTTON_DPAD_LEFT: "assist",
    pygame.CONTROLLER_BUTTON_DPAD_DOWN: "save",
    pygame.CONTROLLER_BUTTON_DPAD_UP: "load",
    pygame.CONTROLLER_BUTTON_DPAD_RIGHT: "watch",
}
"""Actions of the buttons where SDL knows the pad."""

TRIGGERS = {
    pygame.CONTROLLER_AXIS_TRIGGERRIGHT: "autopilot",
    pygame.CONTROLLER_AXIS_TRIGGERLEFT: "figure",
}
"""Actions of its triggers, which are axes: one asks when it is pressed half way."""

PLUGGED = (pygame.JOYDEVICEADDED, pygame.JOYDEVICEREMOVED)

TOUCHED = 0.1
"""Of full deflection, at least: no dead zone at all would let a worn stick claim the kite."""

MOMENT = 250
"""ms that a rumble lasts unless it is asked for again, so that none outlives its flight."""

HELPLESS = ": run kitemj pad; keys and mouse fly"
CENTRED = "the stick returns to its centre; keys and mouse fly"


def events() -> list[pygame.event.Event]:
    """The events since the last call, pads that came and went first.

    As pygame.event.get, which in pygame 2.6 fails, and drops everything, over a pad that came
    and went between two looks.
    """
    found: list[pygame.event.Event] = []
    try:
        found += pygame.event.get(PLUGGED)
    except SystemError:
        found.append(pygame.event.Event(pygame.JOYDEVICEADDED))  # so that pads are looked for
    return found + pygame.event.get(pump=False)


def pressed(name: str, value: float, down: set[str]) -> tuple[str, ...]:
    """The action `name` if what asks for it has just gone down to `value`; notes it in `down`."""
    if value <= PRESSED:
        down.discard(name)
    elif name not in down:
        down.add(name)
        return (name,)
    return ()


class StandardPad:
    """A pad whose layout SDL knows."""

    def __init__(self, index: int) -> None:
        self._pad = controller.Controller(index)
        joystick = self._pad.as_joystick()
        self.name, self.instance = joystick.get_name(), joystick.get_instance_id()
        self._down: set[str] = set()

    def hands(self) -> Deflections:
        """Its deflections: left stick sideways steers, right stick up lets out."""
        out = -self._axis(pygame.CONTROLLER_AXIS_RIGHTY)
        left = self._axis(pygame.CONTROLLER_AXIS_LEFTY)
        return Deflections(self._axis(pygame.CONTROLLER_AXIS_LEFTX), out, left, -out)

    def actions(self, event: pygame.event.Event) -> tuple[str, ...]:
        """The actions of `STANDARD` and `TRIGGERS`."""
        if event.type == pygame.CONTROLLERAXISMOTION and event.axis in TRIGGERS:
            return pressed(TRIGGERS[event.axis], event.value / FULL, self._down)
        known = event.type == pygame.CONTROLLERBUTTONDOWN and event.button in STANDARD
        return (STANDARD[event.button],) if known else ()

    def rumble(self, low: float, high: float) -> None:
        """Shakes its left motor by `low` and its right one by `high`, 0..1, for a moment."""
        self._pad.rumble(low, high, MOMENT)

    def _axis(self, axis: int) -> float:
        return max(-1.0, float(self._pad.get_axis(axis)) / FULL)


class LaidOutPad:
    """A pad with a layout of its own."""

    def __init__(self, joystick: Any, layout: Layout) -> None:
        self._joystick, self._layout = joystick, layout
        self.name, self.instance = joystick.get_name(), joystick.get_instance_id()
        self._down: set[str] = set()

    def hands(self) -> Deflections:
        """The deflections by the layout."""
        return self._layout.hands(self._joystick)

    def actions(self, event: pygame.event.Event) -> tuple[str, ...]:
        """The actions of the layout, each when its source goes down."""
        asked: list[str] = []
        for name, source in self._layout.buttons.items():
            if (value := source.value_in(event)) is not None:
                asked += pressed(name, value, self._down)
        return tuple(asked)

    def rumble(self, low: float, high: float) -> None:
        """Shakes its left motor by `low` and its right one by `high`, 0..1, for a moment."""
        self._joystick.rumble(low, high, MOMENT)


Pad = StandardPad | LaidOutPad
"""One pad that can steer; `instance` is SDL's number for it while it is plugged in."""


class Pads:
    """All pads, in the order in which they were touched; `handle` is to see every event.

    What the person should know of them goes to `notices`.
    """

    def __init__(self, settings: Settings, notices: Notices) -> None:
        self._settings, self._say = settings, notices.say
        self._pads: dict[int, Pad] = {}
        self._known: set[int] = set()  # those that cannot steer, too
        self._away: set[int] = set()  # whose sticks are away from the centre
        pygame.joystick.init()
        controller.init()

    def close(self) -> None:
        """Lets go of all pads."""
        self._pads.clear()
        controller.quit()
        pygame.joystick.quit()

    @property
    def steering(self) -> Pad | None:
        """The pad that was touched last; None: no pad."""
        return next(reversed(self._pads.values()), None)

    def hands(self) -> Deflections:
        """The deflections of the steering pad, axes inverted as the settings say."""
        pad, feel, invert = self.steering, self._settings.feel, self._settings.invert
        if pad is None:
            return Deflections()
        ways = (shaped_deflection(way, feel.dead_zone, feel.expo) for way in pad.hands())
        steer, reel, left, right = ways
        return Deflections(
            -steer if invert.steer else steer, -reel if invert.reel else reel, left, right
        )

    def rumble(self, low: float, high: float) -> None:
        """Shakes the steering pad, if there is one that can; low and high motor, 0..1."""
        if self.steering:
            self.steering.rumble(low, high)

    def handle(self, event: pygame.event.Event) -> tuple[str, ...]:
        """The actions that the event asks for."""
        if event.type in PLUGGED:
            self._look_around()
        elif (pad := self._pads.get(getattr(event, "instance_id", -1))) is not None:
            actions = pad.actions(event)
            if self._touched(pad) or actions or event.type == pygame.JOYBUTTONDOWN:
                self._hand_over(pad)
            return actions
        return ()

    def _touched(self, pad: Pad) -> bool:
        """Whether its sticks have just left the centre."""
        was = pad.instance in self._away
        least = max(self._settings.feel.dead_zone, TOUCHED)
        if away := any(abs(way) > least for way in pad.hands()):
            self._away.add(pad.instance)
        else:
            self._away.discard(pad.instance)
        return away and not was

    def _hand_over(self, pad: Pad) -> None:
        if pad is not self.steering:
            self._pads[pad.instance] = self._pads.pop(pad.instance)
            self._say(f"the pad {pad.name} steers")

    def _look_around(self) -> None:
        """Notes which pads are there now: an event's own number may be another's by then."""
        joysticks = [pygame.joystick.Joystick(i) for i in range(pygame.joystick.get_count())]
        there = [joystick.get_instance_id() for joystick in joysticks]
        for gone in self._known.difference(there):
            self._remove(gone)
        for index, joystick in enumerate(joysticks):
            if there[index] not in self._known:
                self._known.add(there[index])
                self._add(index, joystick)

    def _add(self, index: int, joystick: Any) -> None:
        layout = self._settings.pads.get(joystick.get_guid())
        if layout and (missing := layout.missing(joystick)):
            self._say(f"the pad {layout.name} has no {missing}, which its layout names{HELPLESS}")
        elif layout:
            self._welcome(LaidOutPad(joystick, layout))
        elif controller.is_controller(index):
            self._welcome(StandardPad(index))
        else:
            self._say(f"the pad {joystick.get_name()} has no known layout{HELPLESS}")

    def _welcome(self, pad: Pad) -> None:
        """A pad that comes does not take the kite out of another's hands."""
        same = sum(other.name.startswith(pad.name) for other in self._pads.values())
        if same:
            pad.name += f" ({same + 1})"
        others = f"another pad, {pad.name}: the one moved last steers"
        self._say(others if self._pads else f"the pad {pad.name} steers")
        self._pads = {pad.instance: pad, **self._pads}

    def _remove(self, instance: int) -> None:
        self._known.discard(instance)
        self._away.discard(instance)
        if gone := self._pads.pop(instance, None):  # else it never steered
            other = self.steering
            after = f"the pad {other.name} steers" if other else CENTRED
            self._say(f"the pad {gone.name} is gone: {after}")
