"""A gamepad made by SDL itself: pygame sees it as it sees a real one."""

import ctypes
from ctypes import (
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
        ("Rumble", c_void_p),
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
    library.SDL_JoystickClose.argtypes = [c_void_p]
    return library


class VirtualPad:
    """An Xbox-like pad; needs pygame's joystick module to be initialised."""

    def __init__(self) -> None:
        assert pygame.joystick.get_init()
        self._sdl = sdl()
        description = Description(
            version=1,
            type=GAME_CONTROLLER,
            naxes=6,
            nbuttons=15,
            vendor_id=XBOX_VENDOR,
            product_id=XBOX_PRODUCT,
            button_mask=(1 << 15) - 1,
            axis_mask=(1 << 6) - 1,
            name=b"virtual pad",
        )
        self._index = self._sdl.SDL_JoystickAttachVirtualEx(ctypes.byref(description))
        assert self._index >= 0, "SDL could not make a virtual joystick"
        self._handle = self._sdl.SDL_JoystickOpen(self._index)

    def left_stick(self, x: float) -> None:
        """Moves the left stick sideways: -1 left, 1 right."""
        self._sdl.SDL_JoystickSetVirtualAxis(self._handle, 0, int(x * 32767))

    def unplug(self) -> None:
        """Pulls the cable."""
        self._sdl.SDL_JoystickDetachVirtual(self._index)
        self._sdl.SDL_JoystickClose(self._handle)
