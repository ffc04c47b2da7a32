"""Gamepads made by SDL itself: pygame sees them as it sees real ones."""

import ctypes
from ctypes import (
    CFUNCTYPE,
    POINTER,
    Structure,
    c_char_p,
    c_int,
    c_int16,
    c_uint8,
    c_uint16,
    c_uint32,
    c_void_p,
)
from pathlib import Path

import pygame

RUMBLE = CFUNCTYPE(c_int, c_void_p, c_uint16, c_uint16)
"""Of the low motor and of the high one, 0..65535; returns 0."""

GAME_CONTROLLER, XBOX_VENDOR, XBOX_PRODUCT = 1, 0x045E, 0x028E


class Description(Structure):
    """SDL_VirtualJoystickDesc, version 1."""

    _fields_ = (
        ("version", c_uint16),
        ("type", c_uint16),
        ("naxes", c_uint16),
        ("nbuttons", c_uint16),
        ("nhats", c_uint16),
        ("vendor_id", c_uint16),
        ("product_id", c_uint16),
        ("padding", c_uint16),
        ("button_mask", c_uint32),
        ("axis_mask", c_uint32),
        ("name", c_char_p),
        ("userdata", c_void_p),
        ("Update", c_void_p),
        ("SetPlayerIndex", c_void_p),
        ("Rumble", RUMBLE),
        ("RumbleTriggers", c_void_p),
        ("SetLED", c_void_p),
        ("SendEffect", c_void_p),
    )


def sdl() -> ctypes.CDLL:
    """The very SDL library that pygame loaded."""
    maps = Path("/proc/self/maps").read_text().splitlines()
    path = next(line.split()[-1] for line in maps if "libSDL2-2" in line or "libSDL2-" in line)
    library = ctypes.CDLL(path)
    library.SDL_JoystickAttachVirtualEx.argtypes = [POINTER(Description)]
    library.SDL_JoystickOpen.restype = c_void_p
    library.SDL_JoystickSetVirtualAxis.argtypes = [c_void_p, c_int, c_int16]
    library.SDL_JoystickSetVirtualButton.argtypes = [c_void_p, c_int, c_uint8]
    library.SDL_JoystickSetVirtualHat.argtypes = [c_void_p, c_int, c_uint8]
    library.SDL_JoystickInstanceID.argtypes = [c_void_p]
    library.SDL_JoystickClose.argtypes = [c_void_p]
    return library


class VirtualPad:
    """An Xbox-like pad; needs pygame's joystick module to be initialised."""

    kind, vendor, product = GAME_CONTROLLER, XBOX_VENDOR, XBOX_PRODUCT
    axes, buttons, hats = 6, 15, 0
    triggers: tuple[int, ...] = ()  # SDL minds those that it knows itself

    def __init__(self, name: str = "virtual pad") -> None:
        assert pygame.joystick.get_init()
        self._sdl = sdl()
        self.shaken: list[tuple[float, float]] = []
        self._rumble = RUMBLE(self._shake)  # SDL calls it for as long as the pad is there
        description = Description(
            version=1,
            type=self.kind,
            naxes=self.axes,
            nbuttons=self.buttons,
            nhats=self.hats,
            vendor_id=self.vendor,
            product_id=self.product,
            button_mask=(1 << self.buttons) - 1,
            axis_mask=(1 << self.axes) - 1,
            name=name.encode(),
            Rumble=self._rumble,
        )
        index = self._sdl.SDL_JoystickAttachVirtualEx(ctypes.byref(description))
        assert index >= 0, "SDL could not make a virtual joystick"
        self._handle = self._sdl.SDL_JoystickOpen(index)
        self._instance = self._sdl.SDL_JoystickInstanceID(self._handle)
        for number in self.triggers:
            self.axis(number, -1.0)
        self._sdl.SDL_JoystickUpdate()  # SDL takes what an axis says first for its rest

    def _shake(self, _: int, low: int, high: int) -> int:
        self.shaken.append((low / 65535, high / 65535))
        return 0

    def axis(self, number: int, x: float) -> None:
        """Moves an axis to `x` in -1..1."""
        self._sdl.SDL_JoystickSetVirtualAxis(self._handle, number, round(x * 32767))

    def button(self, number: int, down: bool) -> None:
        """Presses a button or lets it go."""
        self._sdl.SDL_JoystickSetVirtualButton(self._handle, number, down)

    def hat(self, number: int, x: int, y: int) -> None:
        """Tilts a hat: `x` to the right, `y` up."""
        bits = (y > 0) | (x > 0) << 1 | (y < 0) << 2 | (x < 0) << 3
        self._sdl.SDL_JoystickSetVirtualHat(self._handle, number, bits)

    def left_stick(self, x: float) -> None:
        """Moves the left stick sideways: -1 left, 1 right."""
        self.axis(0, x)

    def unplug(self) -> None:
        """Pulls the cable."""
        indices = range(self._sdl.SDL_NumJoysticks())
        instances = [self._sdl.SDL_JoystickGetDeviceInstanceID(i) for i in indices]
        self._sdl.SDL_JoystickDetachVirtual(instances.index(self._instance))
        self._sdl.SDL_JoystickClose(self._handle)


class OddPad(VirtualPad):
    """A pad that SDL knows nothing of, with a hat; axis 2 is a trigger."""

    kind, vendor, product = 0, 0x1234, 0x4321
    axes, buttons, hats = 5, 8, 1
    triggers = (2,)

    def __init__(self, name: str = "odd pad") -> None:
        super().__init__(name)
