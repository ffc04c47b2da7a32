"""The actions a person can ask for by key or pad: their names, keys and help.

`Wishes` is what they add up to: states that last, and deeds that are done once.
"""

from collections.abc import Iterable
from typing import NamedTuple

VIEWS = ("pilot", "chase", "side", "top", "orbit")
"""Where a picture can be seen from."""

PANELS = ("flight", "air", "window", "chart", "lines", "knob", "model")
"""Instruments that are boxes at the edges of a picture."""

INSTRUMENTS = (*PANELS, "inset", "trail", "forces", "labels")
"""What the engineer's depth can show over the view."""

DEPTHS = ("pilot", "engineer", "none")
"""How much is shown over the view: what one flies by; all numbers; nothing."""


class Action(NamedTuple):
    """`shown` is how its keys are called on the help page; `help` what it does."""

    name: str
    shown: str
    help: str


ACTIONS = (
    Action("restart", "R   (A)", "start again"),
    Action("rewind", "Backspace   (right stick pressed)", "5 s back"),
    Action("save", "F5   F9   (cross down, up)", "mark this moment; go back to it"),
    Action("load", "", ""),
    Action("pause", "Space   .   (Start)", "pause; one tick"),
    Action("step", "", ""),
    Action("slower", "-   =   (shoulders)", "slower, faster"),
    Action("faster", "", ""),
    Action("law", "T   (B)", "the stick asks for δ, its rate, its acceleration"),
    Action("two sticks", "Y   (left stick pressed)", "a stick for each line"),
    Action("assist", "H   (cross left)", "the assist on or off: the stick asks for turns"),
    Action("autopilot", "P   (right trigger)", "hand over to the autopilot; a push takes back"),
    Action("figure", "O   (left trigger)", "what it flies: an eight, a circle, hold, land"),
    Action("view", "V   (Y)", "next view"),
    Action("instruments", "I   (X)", "instruments: pilot's, engineer's, none; 1 to 9, 0, L: one"),
    Action("full screen", "F11   F", "full screen"),
    Action("sound", "M", "sound and rumble, or neither"),
    Action("watch", "G   (cross right)", "watch again what was flown; the flight waits"),
    Action("next lesson", "N   B", "next lesson; begin the lesson again"),
    Action("begin lesson", "", ""),
    Action("help", "F1   ?", "this page, while the flight waits"),
    Action("leave", "Esc", "leave"),
)

NAMES = frozenset(each.name for each in ACTIONS) | {f"toggle {name}" for name in INSTRUMENTS}

HELP = (
    "Left stick, arrow keys, A D\tsteer (Shift: fully); the knob shows which hand pulls",
    "Mouse, left button held\tsteer as far as from the middle",
    "Right stick, W S\tlet line out, take it in",
    "Mouse, right button, wheel\tturn and near the orbit view",
    *(f"{action.shown}\t{action.help}" for action in ACTIONS if action.shown),
)

REPLAY_ACTIONS = (
    Action("help", "F1", "all keys"),
    Action("play", "Space", "play, pause"),
    Action("leave", "Esc", "leave"),
    Action("back", "Left   Right", "1 s back, on; with Shift one tick"),
    Action("on", "", ""),
    Action("faster", "Up   Down", "faster, slower"),
    Action("slower", "", ""),
    Action("start", "Home   End", "the start, the end"),
    Action("end", "", ""),
    Action("view", "V", "next view"),
    Action("instruments", "I", "instruments"),
    Action("sound", "M", "sound"),
    Action("full screen", "F11   F", "full screen"),
)
"""What can be asked for while a recording is shown, the most needed hint first."""

REPLAY_BUTTONS = {
    **dict.fromkeys(("restart", "pause"), "play"),
    **{"rewind": "back", "assist": "back", "watch": "on", "law": "leave"},
    **{name: name for name in ("help", "faster", "slower", "view", "instruments", "sound")},
}
"""What a pad's button asks for while a recording is shown, by what it asks for in flight."""

MENU_BUTTONS = {
    **dict.fromkeys(("restart", "pause"), "choose"),
    **{"law": "leave", "load": "up", "save": "down", "watch": "right"},
    **dict.fromkeys(("rewind", "assist"), "left"),
}
"""What a pad's button asks for on the title page, by what it asks for in flight."""

REPLAY_HELP = (
    *(f"{action.shown}\t{action.help}" for action in REPLAY_ACTIONS if action.shown),
    "Mouse, on the picture, wheel\tturn and near the orbit view",
    "Pad\tA: play, pause; cross left, right: 1 s back, on; shoulders: slower, faster; B: leave",
    "Mouse, on the slider\tgo to that moment; white: a flight begins, red: beyond a limit",
)

RATES = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0)


class Wishes:
    """What the person at a screen asks for: view, panels, time, and deeds not yet done.

    `rate` is simulated over wall time, 0 a pause; `depth` that of the instruments, `shown` those
    of the engineer's; `turn` [rad] and `zoom` move the eye of the orbit view; `sound`: the kite is
    heard and felt. `deeds` are actions to be done once, by whoever can; `taken` hands them over.
    """

    def __init__(self, view: str = VIEWS[0]) -> None:
        self.view, self.rate, self.help, self.leaving = view, 1.0, False, False
        self.depth, self.shown = DEPTHS[0], set(INSTRUMENTS)
        self.turn, self.zoom = (0.0, 0.0), 1.0
        self.sound = True
        self.deeds: list[str] = []
        self._speed = 1.0  # when not paused

    @property
    def pace(self) -> float:
        """Simulated over wall time now: `rate`, but 0 while the help page hides the kite."""
        return 0.0 if self.help else self.rate

    def ask(self, names: Iterable[str]) -> None:
        """Takes in actions by their names; raises KeyError for an unknown one."""
        for name in names:
            if name not in NAMES:
                raise KeyError(name)
            self._ask(name)

    def _ask(self, name: str) -> None:
        if name == "leave":
            self.leaving = True
        elif name == "help":
            self.help = not self.help
        elif name == "view":
            self.view = VIEWS[(VIEWS.index(self.view) + 1) % len(VIEWS)]
        elif name == "instruments":
            self.depth = DEPTHS[(DEPTHS.index(self.depth) + 1) % len(DEPTHS)]
        elif name.startswith("toggle ") and self.depth != "engineer":
            self.depth = "engineer"  # where single instruments are
        elif name.startswith("toggle "):
            self.shown ^= {name.removeprefix("toggle ")}
        elif name == "sound":
            self.sound = not self.sound
        elif name == "pause":
            self.rate = 0.0 if self.rate else self._speed
        elif name in ("slower", "faster"):
            further = RATES.index(self._speed) + (1 if name == "faster" else -1)
            self.rate = self._speed = RATES[max(0, min(further, len(RATES) - 1))]
        else:
            self.deeds.append(name)

    def taken(self) -> tuple[list[str], tuple[float, float], float]:
        """Returns the deeds, the turn and the zoom asked for since, and forgets them."""
        deeds, turn, zoom = self.deeds, self.turn, self.zoom
        self.deeds, self.turn, self.zoom = [], (0.0, 0.0), 1.0
        return deeds, turn, zoom
