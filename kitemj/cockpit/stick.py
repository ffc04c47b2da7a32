"""What a person holds: a gamepad, else keys, else the mouse; or a programme in their place."""

from bisect import bisect_right
from collections.abc import Sequence
from typing import Any, Protocol

import pygame
from pygame._sdl2 import controller

from kitemj.dynamics.motion import Motion
from kitemj.flight.live import Command
from kitemj.flight.pilots import Pilot

DEAD_ZONE = 0.08
"""Of full deflection; worn sticks do not come back to zero."""

FULL = 32767
KEYS = {
    "left": (pygame.K_LEFT, pygame.K_a),
    "right": (pygame.K_RIGHT, pygame.K_d),
    "out": (pygame.K_UP, pygame.K_w),
    "in": (pygame.K_DOWN, pygame.K_s),
}


class Stick(Protocol):
    """Something that asks for δ and ℓ; `name` is shown among the instruments."""

    @property
    def name(self) -> str:
        """What steers."""

    def command(self, motion: Motion) -> Command:
        """What is asked for now; `motion` is what the pilot sees."""


class ProgrammedStick:
    """Holds each row of a table until the next: times [s], δ and ℓ in -1..1; then begins anew."""

    name = "programme"

    def __init__(self, rows: Sequence[tuple[float, float, float]], period: float) -> None:
        self._rows, self._period = list(rows), period
        self._times = [row[0] for row in rows]

    def command(self, motion: Motion) -> Command:
        """The row that holds at the motion's time."""
        row = self._rows[bisect_right(self._times, motion.t % self._period) - 1]
        return Command(row[1], row[2])


SHOW = ProgrammedStick(
    [(0.0, 0.0, 0.0), (2.0, 1.0, 0.0), (12.0, -1.0, 0.0), (28.0, 0.4, 0.0), (36.0, 0.0, 0.0)],
    period=40.0,
)
"""Right, left, a little right, centre: for a kite that only drifts."""


class PilotStick:
    """A pilot in a person's place."""

    name = "pilot"

    def __init__(self, pilot: Pilot) -> None:
        self.command = pilot.command


class PersonStick:
    """The newest pad that is plugged in; without one, held keys or the mouse with its button.

    Needs pygame's display and joystick modules; `handle` is to see every event.
    """

    def __init__(self) -> None:
        self._pads: dict[int, Any] = {}
        self._mouse: float | None = None
        self.message = ""
        controller.init()

    @property
    def name(self) -> str:
        """What steers at present."""
        if self._pads:
            return "gamepad"
        return "mouse" if self._mouse is not None else "keys"

    def handle(self, event: pygame.event.Event) -> None:
        """Pads that come and go; the mouse."""
        if event.type == pygame.JOYDEVICEADDED:
            self._add(event.device_index)
        elif event.type == pygame.JOYDEVICEREMOVED and event.instance_id in self._pads:
            self._pads.pop(event.instance_id)
            self.message = "the gamepad is gone: the stick returns to its centre"
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            self._mouse = None
        elif event.type in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEMOTION) and (
            event.type == pygame.MOUSEBUTTONDOWN or event.buttons[0]
        ):
            middle = pygame.display.get_window_size()[0] / 2
            self._mouse = max(-1.0, min(1.0, (event.pos[0] - middle) / middle * 2))

    def command(self, motion: Motion) -> Command:
        """Where the stick is now."""
        if self._pads:
            return self._pad_command(list(self._pads.values())[-1])
        if self._mouse is not None:
            return Command(self._mouse, 0.0)
        held = pygame.key.get_pressed()
        down = {name: any(held[key] for key in keys) for name, keys in KEYS.items()}
        return Command(
            float(down["right"]) - float(down["left"]), float(down["out"]) - float(down["in"])
        )

    def _add(self, index: int) -> None:
        if controller.is_controller(index):
            pad = controller.Controller(index)
            self._pads[pad.as_joystick().get_instance_id()] = pad
        else:
            joystick = pygame.joystick.Joystick(index)
            self._pads[joystick.get_instance_id()] = joystick
        self.message = ""

    @staticmethod
    def _pad_command(pad: Any) -> Command:
        """Left stick sideways is δ, right stick up and down is ℓ (up pays out)."""
        if isinstance(pad, controller.Controller):
            sideways = pad.get_axis(pygame.CONTROLLER_AXIS_LEFTX) / FULL
            up = -pad.get_axis(pygame.CONTROLLER_AXIS_RIGHTY) / FULL
        else:
            sideways, up = pad.get_axis(0), -pad.get_axis(3) if pad.get_numaxes() > 3 else 0.0
        return Command(_beyond_dead_zone(sideways), _beyond_dead_zone(up))


def _beyond_dead_zone(deflection: float) -> float:
    """0 within the dead zone, 1 at the end, straight in between."""
    size = max(0.0, min(1.0, (abs(deflection) - DEAD_ZONE) / (1 - DEAD_ZONE)))
    return size if deflection > 0 else -size
