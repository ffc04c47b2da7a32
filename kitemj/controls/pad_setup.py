"""The dialogue that finds a pad's layout: which axis is which way, which button does what.

Nothing here waits, prints or reads a pad: `Questions` is shown readings at times, and says what
it wants to know.
"""

from collections.abc import Iterator
from typing import Any, NamedTuple

from kitemj.controls.actions import ACTIONS
from kitemj.controls.pad_layout import PRESSED, WAYS, Layout, PadSource

HOLD = 0.3
"""s; as long a control is to be held before it is believed."""


class Reading(NamedTuple):
    """The state of a joystick at one time: axes in -1..1, buttons 0 or 1, hats (x, y)."""

    axes: tuple[float, ...]
    buttons: tuple[int, ...]
    hats: tuple[tuple[int, int], ...]

    @classmethod
    def of(cls, joystick: Any) -> "Reading":
        """The present reading of a pygame joystick."""
        return cls(
            tuple(float(joystick.get_axis(i)) for i in range(joystick.get_numaxes())),
            tuple(int(joystick.get_button(i)) for i in range(joystick.get_numbuttons())),
            tuple(joystick.get_hat(i) for i in range(joystick.get_numhats())),
        )


def moved(rest: Reading, now: Reading, button: bool = False) -> PadSource | None:
    """The source away from its rest: the axis that is farthest away, else a hat, else a button.

    Triggers rest at -1; many report an axis and a button, and where a `button` is wanted the
    button is meant.
    """
    return next(_away(rest, now, button), None)


def _away(rest: Reading, now: Reading, button: bool) -> Iterator[PadSource]:
    down = zip(rest.buttons, now.buttons, strict=True)
    pressed = [PadSource("button", i) for i, (before, after) in enumerate(down) if after > before]
    if button:
        yield from pressed
    ways = [after - before for before, after in zip(rest.axes, now.axes, strict=True)]
    far = max(range(len(ways)), key=lambda i: abs(ways[i]), default=-1)
    if ways and abs(ways[far]) > PRESSED:
        yield PadSource("axis", far, sign=1 if ways[far] > 0 else -1)
    for i, (before, after) in enumerate(zip(rest.hats, now.hats, strict=True)):
        for part in (0, 1):
            if after[part] and not before[part]:
                yield PadSource("hat", i, part, after[part])
    yield from pressed


class Question(NamedTuple):
    """`key` is a way or the name of an action; `text` is what to do; `button`: one will do."""

    key: str
    text: str
    button: bool = False


QUESTIONS = (
    Question("steer", "push the left stick to the right and hold it"),
    Question("reel", "push the right stick up, away from you, and hold it"),
    Question("left_line", "pull the left stick down, towards you, and hold it"),
    Question("right_line", "pull the right stick down, towards you, and hold it"),
    *(
        Question(each.name, f"press the button that is to mean: {each.name}", button=True)
        for each in ACTIONS
    ),
)
BACK = "press the button for the opposite way"
"""Asked where a way is a button: a cross may be four of them."""


class Questions:
    """Asks for each control in turn; `rest` is the reading with nothing touched.

    `asked` is the question of the moment, None at the end. A control counts when it was held
    for `HOLD`; the next one only when all have been let go, which `ready` says.
    """

    def __init__(self, rest: Reading) -> None:
        self._rest = rest
        self._left = list(QUESTIONS)
        self._found: dict[str, PadSource] = {}
        self._first: PadSource | None = None  # of two buttons, the one found
        self._held: tuple[float, PadSource] | None = None
        self.ready = False

    @property
    def asked(self) -> Question | None:
        """The question to be answered now; None: all are."""
        if not self._left:
            return None
        return self._left[0]._replace(text=BACK) if self._first else self._left[0]

    def skip(self) -> None:
        """Leaves the control that is asked for without a source."""
        self._left, self._first, self._held = self._left[1:], None, None

    def see(self, t: float, now: Reading) -> str:
        """Takes a reading at time `t` [s]; returns a sentence about it, or an empty one."""
        if not (question := self.asked):
            return ""
        source = moved(self._rest, now, question.button)
        if source is None:
            self._held, self.ready = None, True
            return ""
        if not self.ready:
            return ""
        if self._held is None or self._held[1] != source:
            self._held = (t, source)
        if t - self._held[0] < HOLD:
            return ""
        self._held, self.ready = None, False
        return self._take(question, source)

    def layout(self, name: str) -> Layout:
        """The layout found until now."""
        ways = {key: self._found[key] for key in WAYS if key in self._found}
        buttons = {key: source for key, source in self._found.items() if key not in WAYS}
        return Layout(name, **ways, buttons=buttons)

    def _take(self, question: Question, source: PadSource) -> str:
        """Takes a source as the answer; returns a sentence, which may say why not."""
        if question.button:
            if self._first is None and (user := self._user(source)):
                return f"{source} is for {user} already: another one"
        elif source.kind == "axis" and abs(self._rest.axes[source.number]) > PRESSED:
            return f"{source} does not rest in the middle, like a trigger: a stick is wanted"
        elif source.kind == "button" and self._first is None:
            self._first = source
            return f"{source} it is"
        elif self._first:
            if source.kind != "button" or source == self._first:
                return f"{source} cannot be the opposite of {self._first}: another button"
            source = PadSource("buttons", source.number, self._first.number)
        self._found[question.key] = source
        self.skip()
        return f"{question.key} is {source}"

    def _user(self, source: PadSource) -> str:
        """The name of the way or action that uses this source already; empty: it is free."""
        for key, taken in self._found.items():
            if source == taken or (key in WAYS and _parts(source) & _parts(taken)):
                return key
        return ""


def _parts(source: PadSource) -> set[tuple[str, int, int]]:
    """The parts of the pad that a source is made of, whichever way it moves."""
    if source.kind == "buttons":
        return {("button", source.number, 0), ("button", source.second, 0)}
    return {(source.kind, source.number, source.second)}
