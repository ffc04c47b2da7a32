"""`kitemj pad`: which control of a gamepad does what."""

import argparse
import os
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any

from kitemj.commands.words import Parser, command
from kitemj.errors import InputError

if TYPE_CHECKING:
    from kitemj.cockpit.layout import Layout
    from kitemj.cockpit.pad_setup import Reading

LOOK = 0.02
"""s; between two looks at a pad."""
SETTLED = 0.5
"""s; until triggers have said that they rest at -1, and hands have let go."""


def add(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Adds the subcommand to the others."""
    parser = command(
        commands,
        "pad",
        "ask for each control of a gamepad that has no known layout, and keep the answers",
        "kitemj pad --list",
    )
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--list", action="store_true", help="which pads there are, who knows them")
    what.add_argument("--show", action="store_true", help="what they say now, until Ctrl-C")
    parser.add_argument("--settings", type=Path, metavar="FILE", help="default: the user's own")
    parser.add_argument("--overwrite", action="store_true", help="replace a damaged file")
    parser.set_defaults(run=run)


def run(words: argparse.Namespace) -> int:
    """Returns the exit status."""
    import pygame

    from kitemj.cockpit.settings import settings_path

    path = words.settings or settings_path()
    # a terminal asks, no window: pads are read all the same
    os.environ["SDL_VIDEODRIVER"] = "dummy"
    os.environ["SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS"] = "1"
    pygame.display.init()
    pygame.joystick.init()
    try:
        pads = [pygame.joystick.Joystick(i) for i in range(pygame.joystick.get_count())]
        if not pads:
            raise InputError("there is no gamepad: plug one in; keys and mouse fly without")
        if words.list:
            return _list(pads, path)
        if words.show:
            return _show(pads, path)
        return _set_up(pads, path, words.overwrite)
    finally:
        pygame.joystick.quit()
        pygame.display.quit()


def _list(pads: list[Any], path: Path) -> int:
    from pygame._sdl2 import controller

    from kitemj.cockpit.settings import settings_or_defaults

    settings, problem = settings_or_defaults(path)
    controller.init()
    for i, pad in enumerate(pads):
        if pad.get_guid() in settings.pads:
            known = f"layout in {path}"
        else:
            known = "SDL knows it" if controller.is_controller(i) else "no layout: run kitemj pad"
        print(f"{pad.get_name()}  {pad.get_guid()}  {known}")
    controller.quit()
    if problem:
        print(problem)
    return 0


def _show(pads: list[Any], path: Path) -> int:
    """Every pad's raw values, and what they mean where its layout is in the settings."""
    import pygame
    from rich.live import Live
    from rich.text import Text

    from kitemj.cockpit.settings import settings_or_defaults

    settings, problem = settings_or_defaults(path)
    print(problem or "Ctrl-C ends")
    try:
        with Live(refresh_per_second=20) as live:
            while True:
                pygame.event.pump()
                lines = [said(pad, settings.pads.get(pad.get_guid())) for pad in pads]
                live.update(Text("\n".join(lines)))
                time.sleep(2 * LOOK)
    except KeyboardInterrupt:
        return 0


def said(pad: Any, layout: "Layout | None") -> str:
    """What a joystick says now, in a few lines."""
    from kitemj.cockpit.layout import PRESSED, WAYS
    from kitemj.cockpit.pad_setup import Reading

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


def _set_up(pads: list[Any], path: Path, overwrite: bool) -> int:
    from kitemj.cockpit.settings import check_writable, write_layout

    check_writable(path, overwrite)
    typed = _typed()
    pad, rest = _choose(pads)
    print(f"the pad {pad.get_name()}: Enter skips a question, D and Enter skips the rest")
    layout = ask(pad, rest, typed, print)
    if not any(layout.ways):
        raise InputError("no stick was found, so nothing was written: run kitemj pad again")
    write_layout(path, pad.get_guid(), layout, overwrite)
    print(f"written to {path}; kitemj fly uses it")
    return 0


def _choose(pads: list[Any]) -> "tuple[Any, Reading]":
    """The only pad, else the one that is moved; and what it says at rest."""
    import pygame

    from kitemj.cockpit.pad_setup import Reading, moved

    print("let go of all sticks and buttons")
    for _ in range(int(SETTLED / LOOK)):
        time.sleep(LOOK)
        pygame.event.pump()
    rests = [Reading.of(pad) for pad in pads]
    if len(pads) == 1:
        return pads[0], rests[0]
    print(f"{len(pads)} pads: press a button of the one that is meant")
    while True:
        time.sleep(LOOK)
        pygame.event.pump()
        for pad, rest in zip(pads, rests, strict=True):
            if moved(rest, Reading.of(pad)):
                return pad, rest


def ask(
    pad: Any,
    rest: "Reading",
    typed: "SimpleQueue[str]",
    tell: Callable[[str], None],
    clock: Callable[[], float] = time.monotonic,
) -> "Layout":
    """Asks until all is answered or D is `typed`; `rest` is what the pad says untouched.

    Raises InputError where the pad goes away.
    """
    import pygame

    from kitemj.cockpit.pad_setup import Questions, Reading
    from kitemj.cockpit.pads import events

    questions, told = Questions(rest), None
    while question := questions.asked:
        if question != told:
            tell(f"{question.text} ...")
            told = question
        time.sleep(LOOK)
        for event in events():
            gone = event.type == pygame.JOYDEVICEREMOVED
            if gone and event.instance_id == pad.get_instance_id():
                raise InputError(f"the pad {pad.get_name()} is gone; nothing was written")
        if says := questions.see(clock(), Reading.of(pad)):
            tell(f"    {says}")
        line = _line(typed)
        if line is not None and line.strip().lower() == "d":
            break
        if line is not None:
            questions.skip()
    return questions.layout(pad.get_name())


def _line(typed: "SimpleQueue[str]") -> str | None:
    try:
        return typed.get_nowait()
    except Empty:
        return None


def _typed() -> "SimpleQueue[str]":
    """Lines as they are typed, read beside us.

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
