"""`kitemj pad` at a terminal: lists pads, shows what they send, asks for a layout."""

import os
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from queue import SimpleQueue
from typing import Any

import pygame
from pygame._sdl2 import controller
from rich.live import Live
from rich.text import Text

from kitemj.controls.pad_layout import PRESSED, WAYS, Layout
from kitemj.controls.pad_setup import Questions, Reading, moved
from kitemj.controls.pads import events
from kitemj.controls.settings import Settings
from kitemj.errors import InputError

LOOK = 0.02
"""s; between two looks at a pad."""
SETTLED = 1.0
"""s; until triggers have said that they rest at -1, and hands have let go."""


@contextmanager
def joysticks() -> Iterator[list[Any]]:
    """All joysticks that are plugged in; raises InputError where there is none."""
    os.environ["SDL_VIDEODRIVER"] = "dummy"
    os.environ["SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS"] = "1"
    pygame.display.init()
    pygame.joystick.init()
    try:
        pads = [pygame.joystick.Joystick(i) for i in range(pygame.joystick.get_count())]
        if not pads:
            raise InputError("there is no gamepad: plug one in; keys and mouse fly without")
        yield pads
    finally:
        pygame.joystick.quit()
        pygame.display.quit()


def summary(pads: list[Any], settings: Settings, path: Path) -> str:
    """A line for each pad: its name, its GUID, who knows its layout; `path` has the settings."""
    controller.init()
    lines = []
    for i, pad in enumerate(pads):
        known = "SDL knows it" if controller.is_controller(i) else "no layout: run kitemj pad"
        if pad.get_guid() in settings.pads:
            known = f"layout in {path}"
        lines.append(f"{pad.get_name()}  {pad.get_guid()}  {known}")
    controller.quit()
    return "\n".join(lines)


def show(pads: list[Any], settings: Settings) -> None:
    """Shows the state of every pad, ten times a second and more, until Ctrl-C."""
    with Live(refresh_per_second=20) as live:
        while True:
            read_events()
            lines = [state_text(pad, settings.pads.get(pad.get_guid())) for pad in pads]
            live.update(Text("\n".join(lines)))
            time.sleep(2 * LOOK)


def state_text(pad: Any, layout: Layout | None) -> str:
    """The state of a joystick now and its deflections by `layout`, in a few lines."""
    now = Reading.of(pad)
    down = [str(i) for i, pressed in enumerate(now.buttons) if pressed]
    lines = [
        pad.get_name(),
        "  axes     " + "  ".join(f"{i}: {value:+.2f}" for i, value in enumerate(now.axes)),
        "  buttons  " + (" ".join(down) or "none"),
        "  hats     " + ("  ".join(f"{i}: {x:+d} {y:+d}" for i, (x, y) in enumerate(now.hats))),
    ]
    if layout and layout.missing(pad) is None:
        ways = zip(WAYS, layout.hands(pad), strict=True)
        asked = [name for name, at in layout.buttons.items() if at.read(pad) > PRESSED]
        meaning = [*(f"{way} {value:+.2f}" for way, value in ways), *asked]
        lines.append("  meaning  " + "  ".join(meaning))
    return "\n".join(lines)


def choose(pads: list[Any]) -> tuple[Any, Reading]:
    """The only pad, else the one that is moved; and its reading at rest."""
    print("let go of all sticks and buttons")
    for _ in range(round(SETTLED / LOOK)):
        time.sleep(LOOK)
        read_events()
    rests = [Reading.of(pad) for pad in pads]
    if len(pads) == 1:
        return pads[0], rests[0]
    print(f"{len(pads)} pads: press a button of the one that is meant")
    while True:
        time.sleep(LOOK)
        read_events()
        for pad, rest in zip(pads, rests, strict=True):
            if moved(rest, Reading.of(pad)):
                return pad, rest


def ask(
    pad: Any,
    rest: Reading,
    typed: "SimpleQueue[str]",
    tell: Callable[[str], None],
    clock: Callable[[], float] = time.monotonic,
) -> Layout:
    """Asks until all is answered or D is `typed`; `rest` is the pad's reading untouched.

    Raises InputError where the pad goes away, or no stick was found.
    """
    questions, shown = Questions(rest), None
    while question := questions.asked:
        if question != shown and questions.ready:
            tell(f"{question.text} ...")
            shown = question
        time.sleep(LOOK)
        for event in read_events():
            gone = event.type == pygame.JOYDEVICEREMOVED
            if gone and event.instance_id == pad.get_instance_id():
                raise InputError(f"the pad {pad.get_name()} is gone; nothing was written")
        if says := questions.see(clock(), Reading.of(pad)):
            tell(f"    {says}")
        if not typed.empty():
            if typed.get().strip().lower() == "d":
                break
            questions.skip()
    layout = questions.layout(pad.get_name())
    if not any(layout.ways):
        raise InputError("no stick was found, so nothing was written: run kitemj pad again")
    return layout


def read_events() -> list[pygame.event.Event]:
    """Returns all events; KeyboardInterrupt for the one that SDL makes of a signal to end."""
    found = events()
    if any(event.type == pygame.QUIT for event in found):
        raise KeyboardInterrupt
    return found


def typed_lines() -> "SimpleQueue[str]":
    """A queue of lines as they are typed, filled by a thread.

    From the file itself: a thread that waits inside Python's own reader would hold its lock
    when the command ends.
    """
    lines: SimpleQueue[str] = SimpleQueue()
    number = sys.stdin.fileno()

    def read() -> None:
        rest = b""
        while more := os.read(number, 1024):
            *whole, rest = (rest + more).split(b"\n")
            for line in whole:
                lines.put(line.decode(errors="replace"))

    threading.Thread(target=read, daemon=True).start()
    return lines
