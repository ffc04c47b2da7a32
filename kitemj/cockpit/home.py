"""From the title to a flight or a recording, and back, in one window."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from kitemj.child import Child
from kitemj.cockpit.demonstration import Demonstration
from kitemj.cockpit.menu import Entry, Menu
from kitemj.cockpit.replay_window import ReplayWindow
from kitemj.cockpit.screens import Screen, Window
from kitemj.cockpit.title import Title
from kitemj.drawing.picture import Picture
from kitemj.errors import InputError
from kitemj.flight.scenario import Scenario
from kitemj.physics.parameter_files import set_names
from kitemj.physics.parameters import Parameters
from kitemj.realtime.launch import launch
from kitemj.recording.file import read_recording
from kitemj.recording.recorder import latest
from kitemj.signals import interrupted


@dataclass
class Kept:
    """What outlives a flight: the picture, and whether a person wishes to hear and feel.

    `closed`: the window's own cross was pressed, so nothing more is wanted.
    """

    picture: Picture
    sound: bool = True
    closed: bool = False

    def note(self, window: Screen) -> None:
        """Keeps what a window that is left was told."""
        self.sound, self.closed = window.wishes.sound, window.closed


class Doors(NamedTuple):
    """What is behind the title, made by whoever knows what was asked for.

    scenario: of a set's name, for the kite that flies in the background
    window: for a person and a scenario
    fly: flies the set with that name, with lessons or without, in a launched process
    passed: how many of how many lessons are passed
    """

    scenario: Callable[[str], Scenario]
    window: Callable[[Scenario], Window]
    fly: Callable[[str, bool, Child, Kept], int]
    passed: Callable[[], tuple[int, int]]


class Home:
    """Goes from door to door until the title is left.

    `kite`: the set to begin with, for which the lessons are; `size` [px] of the picture; `sound`:
    whether it is heard and felt; `quality` as a picture's.
    """

    def __init__(
        self, doors: Doors, kite: str, size: tuple[int, int], sound: bool, quality: str = "auto"
    ) -> None:
        self._doors, self._kite, self._lessons_kite = doors, kite, kite
        self._size, self._quality, self._marked, self._message = size, quality, "", ""
        self._kept = Kept(Picture(doors.scenario(kite).parameters, *size, quality), sound)

    def run(self, launched: Child) -> int:
        """Until it is left; returns the exit status of the last flight. `launched`: the first's."""
        child: Child | None = launched
        status, chosen = 0, ""
        self._marked = "lessons" if not self._doors.passed()[0] else "fly"
        try:
            while chosen != "leave" and not self._kept.closed and not interrupted():
                child = child or launch()  # loads while the title is looked at
                chosen = self._title()
                if chosen in ("fly", "lessons"):
                    kite = self._kite if chosen == "fly" else self._lessons_kite
                    self._paint(self._doors.scenario(kite).parameters)
                    flown, child = child, None
                    status = self._doors.fly(kite, chosen == "lessons", flown, self._kept)
                elif chosen == "replay":
                    self._watch()
        except KeyboardInterrupt:
            pass  # leaving in a hurry is leaving
        finally:
            self._kept.picture.close()
            if child:
                child.kill()  # it only loads, and nobody waits for that
                child.close()
        return status

    def _title(self) -> str:
        """What is chosen on the title page."""
        scenario, menu = self._doors.scenario(self._kite), self._menu()
        picture, show = self._paint(scenario.parameters), Demonstration(scenario)
        with self._window(scenario) as window:
            chosen = Title(picture, window, menu, show, self._message).run()
        self._message, self._marked = "", menu.entry.key
        self._kite = next(entry.offered for entry in menu.entries if entry.key == "kite")
        return chosen

    def _menu(self) -> Menu:
        passed, lessons = self._doors.passed()
        last, kites = latest(), set_names()
        kite = self._doors.scenario(self._kite).parameters
        entries = [
            Entry("fly", "Fly", "the sky is yours"),
            Entry("lessons", "Lessons", f"{passed} of {lessons} passed"),
            Entry("replay", "Watch the last flight", last.name if last else "", bool(last)),
            Entry("kite", "Kite", _about(kite), True, kites, kites.index(self._kite)),
            Entry("leave", "Leave"),
        ]
        marked = [entry.key for entry in entries].index(self._marked)
        return Menu(entries, marked)

    def _watch(self) -> None:
        """Shows the last flight of this folder."""
        path = latest()
        try:
            recording = read_recording(path or Path())
        except InputError as error:
            self._message = str(error)
            return
        picture = self._paint(recording.parameters)
        with self._window(self._doors.scenario(self._kite)) as window:
            ReplayWindow(recording, None, picture, window).run()

    @contextmanager
    def _window(self, scenario: Scenario) -> Iterator[Window]:
        """The window for something else than a flight."""
        window = self._doors.window(scenario)
        window.wishes.sound = self._kept.sound
        try:
            yield window
        finally:
            self._kept.note(window)
            window.close()

    def _paint(self, parameters: Parameters) -> Picture:
        """The picture that is kept, made anew where it is of another kite."""
        if parameters != self._kept.picture.parameters:
            self._kept.picture.close()
            self._kept.picture = Picture(parameters, *self._size, self._quality)
        return self._kept.picture


def _about(parameters: Parameters) -> str:
    """A kite in a few numbers."""
    kite, lines, wind = parameters.kite, parameters.lines, parameters.wind
    return (
        f"{kite.span:.3g} m wide, {kite.mass:.2g} kg, lines of {lines.length:g} m, "
        f"wind {wind.speed:g} m/s"
    )
