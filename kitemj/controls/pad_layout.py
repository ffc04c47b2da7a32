"""Layouts of gamepads that SDL does not know: which axis, hat or button does what.

An axis is a number of the joystick, -1..1; a button counts as 0 or 1, two buttons as -1, 0 or
1, a hat as two axes: x to the right, y up. A minus in front turns the sense around.
"""

import re
from collections.abc import Mapping
from typing import Any, NamedTuple

import pygame

from kitemj.controls.actions import NAMES
from kitemj.controls.stick_mapping import Deflections
from kitemj.errors import InputError
from kitemj.physics.checked import check_keys

TEXT = re.compile(r"(-?)(?:(axis|button) (\d+)|(hat) (\d+) ([xy])|(buttons) (\d+) (\d+))")
EXAMPLES = "'axis 0', '-axis 3', 'hat 0 x', 'button 2' or 'buttons 13 14'"
PRESSED = 0.5
"""Of its way: from here on an axis or a hat counts as a button that is down."""

ENDS = 32768 / 32767
"""pygame's axes end at -1 and a little below 1."""


class PadSource(NamedTuple):
    """Something on a pad that moves: `kind` axis, button, buttons or hat; `sign` ±1.

    `second` is the other button of two, the one that counts as 1; of a hat 0 for x, 1 for y.
    """

    kind: str
    number: int
    second: int = 0
    sign: int = 1

    def __str__(self) -> str:
        """The source as a settings file has it."""
        text = f"{'-' if self.sign < 0 else ''}{self.kind} {self.number}"
        if self.kind == "hat":
            return f"{text} {'xy'[self.second]}"
        return f"{text} {self.second}" if self.kind == "buttons" else text

    def on(self, joystick: Any) -> bool:
        """Whether the joystick has this source."""
        if self.kind == "axis":
            return bool(self.number < joystick.get_numaxes())
        if self.kind == "hat":
            return bool(self.number < joystick.get_numhats())
        return bool(max(self.number, self.second) < joystick.get_numbuttons())

    def read(self, joystick: Any) -> float:
        """Where the source is now, in -1..1."""
        if self.kind == "axis":
            value = joystick.get_axis(self.number) * ENDS
        elif self.kind == "hat":
            value = joystick.get_hat(self.number)[self.second]
        elif self.kind == "button":
            value = joystick.get_button(self.number)
        else:
            value = joystick.get_button(self.second) - joystick.get_button(self.number)
        return self.sign * max(-1.0, min(1.0, float(value)))

    def value_in(self, event: pygame.event.Event) -> float | None:
        """Where the source is by `event`, in -1..1; None where the event is of something else.

        A button that is pressed and let go between two looks is seen in events only.
        """
        if self.kind == "button" and event.type in (pygame.JOYBUTTONDOWN, pygame.JOYBUTTONUP):
            if event.button == self.number:
                return float(event.type == pygame.JOYBUTTONDOWN)
        elif self.kind == "axis" and event.type == pygame.JOYAXISMOTION:
            if event.axis == self.number:
                return self.sign * float(event.value)
        elif self.kind == "hat" and event.type == pygame.JOYHATMOTION and event.hat == self.number:
            return self.sign * float(event.value[self.second])
        return None


def pad_source(text: Any, key: str, where: str) -> PadSource:
    """The source that a text names (``-axis 3``); else InputError, with `key` and `where`."""
    match = TEXT.fullmatch(text) if isinstance(text, str) else None
    if not match:
        raise InputError(f"{key} must be like {EXAMPLES}, got {text!r} ({where})")
    sign = -1 if match[1] else 1
    if match[4]:
        return PadSource("hat", int(match[5]), "xy".index(match[6]), sign)
    if match[7]:
        return PadSource("buttons", int(match[8]), int(match[9]), sign)
    return PadSource(match[2], int(match[3]), 0, sign)


class Layout(NamedTuple):
    """Where the four ways of `Deflections` are on a pad, and which source asks for which action.

    `name` is the pad's, for people.
    """

    name: str
    steer: PadSource | None = None
    reel: PadSource | None = None
    left_line: PadSource | None = None
    right_line: PadSource | None = None
    buttons: Mapping[str, PadSource] = {}

    @property
    def ways(self) -> tuple[PadSource | None, ...]:
        """The four sources, in the order of `Deflections`."""
        return self.steer, self.reel, self.left_line, self.right_line

    def hands(self, joystick: Any) -> Deflections:
        """The deflections of the joystick now; what has no source rests."""
        return Deflections(*(way.read(joystick) if way else 0.0 for way in self.ways))

    def missing(self, joystick: Any) -> PadSource | None:
        """A source that this joystick lacks; None: it has them all."""
        named = [*(way for way in self.ways if way), *self.buttons.values()]
        return next((source for source in named if not source.on(joystick)), None)

    def table(self) -> dict[str, Any]:
        """The layout as a settings file has it; `layout_of` reads it back."""
        ways = zip(WAYS, self.ways, strict=True)
        return {
            "name": self.name,
            **{key: str(way) for key, way in ways if way},
            "buttons": {action: str(source) for action, source in self.buttons.items()},
        }


WAYS = ("steer", "reel", "left_line", "right_line")


def table_of(value: Any, key: str, where: str) -> Mapping[str, Any]:
    """The value, which must be a table; else InputError, with `key` and `where`."""
    if not isinstance(value, Mapping):
        raise InputError(f"{key} must be a table, got {value!r} ({where})")
    return value


def layout_of(table: Any, section: str, where: str) -> Layout:
    """The layout of a table ``[pads.GUID]``; InputError where it is none."""
    check_keys(table_of(table, section, where), Layout._fields, section, where)
    name = table.get("name", "pad")
    if not isinstance(name, str):
        raise InputError(f"{section}.name must be a text, got {name!r} ({where})")
    buttons = table_of(table.get("buttons", {}), f"{section}.buttons", where)
    check_keys(buttons, sorted(NAMES), f"{section}.buttons", where)
    ways = {k: pad_source(table[k], f"{section}.{k}", where) for k in WAYS if k in table}
    sources = {k: pad_source(v, f"{section}.buttons.{k}", where) for k, v in buttons.items()}
    return Layout(name, **ways, buttons=sources)
