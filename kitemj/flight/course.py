"""The first-flight course: which lesson is flown, what is to be done now, which are passed."""

from collections.abc import Collection
from math import inf, pi
from typing import NamedTuple

from kitemj.dynamics.motion import Motion, State
from kitemj.flight.crash import AGAIN, FirstTouch
from kitemj.flight.equilibrium import equilibrium_state
from kitemj.flight.lessons import LESSONS, Advice, Entry, Held, Look
from kitemj.flight.pilots import Twist, sight
from kitemj.physics.parameters import Parameters

BLINK = 0.5
"""s; who sees less often cannot count turns."""
PRAISED = 3.0
"""s for which a passed lesson is praised."""
READING = 0.4
"""s for which an advice stays at least: the kite may change its mind faster than one reads."""
FULL = 0.85
"""Of the stick's way: held as far as it goes."""

NEVER_MIND = "Never mind, that is how everybody learns"
FINISHED = "You have passed them all. The sky is yours"


class Standing(NamedTuple):
    """What a panel shows of the course; `number` of `count`, 0 when all are passed.

    `push` in -1..1 is where the stick should be, right positive; `progress` in 0..1.
    """

    number: int
    count: int
    title: str
    advice: str
    push: float
    progress: float
    praised: bool


class Eyes:
    """Looks at motions one after another."""

    def __init__(self, parameters: Parameters) -> None:
        self._limit, self._twist, self._pull = parameters.stick.delta, Twist(), Held()
        self._up: float | None = None  # turns of the nose when it last pointed up

    def look(self, motion: Motion) -> Look:
        """The next instant; turns are counted when this is asked every half turn or more."""
        seen, twist = sight(motion), self._twist.look(motion)
        pulling = self._pull.look(abs(motion.control.delta) > FULL * self._limit, motion.t)
        nearest = twist - seen.heading / (2 * pi)  # turns at which the nose points up
        self._up = nearest if self._up is None else self._up
        look = Look(motion, seen, 2 * pi * (twist - self._up), twist, pulling)
        if look.upright:
            self._up = nearest
        return look


class Course:
    """The lessons that are not `passed` yet, flown in order; told of the motions of one flight.

    Every tick or every frame will do. Where time jumps back, at a restart or a rewind, and
    after half a second unseen, the attempt at the present lesson begins again; a touch of
    the ground ends it until then. Raises InputError where the kite cannot hang still.
    """

    def __init__(self, parameters: Parameters, passed: Collection[str] = ()) -> None:
        """`passed`: keys of LESSONS; others are ignored."""
        self._parameters, self._ground = parameters, FirstTouch(parameters)
        self._rest = equilibrium_state(parameters)
        self.passed = {entry.key for entry in LESSONS} & set(passed)
        self._t = inf
        self._praise = -inf  # until when
        self._index, self._down, self._praised = -1, "", ""
        self.skip()

    @property
    def lesson(self) -> Entry | None:
        """The one that is flown; None: all are passed."""
        return LESSONS[self._index] if self._index >= 0 else None

    @property
    def start(self) -> State | None:
        """Where a flight should begin for this lesson; None: anywhere."""
        if not self.lesson or not self.lesson.aside:
            return None
        q, q_dot = self._rest
        return State(q._replace(eta=q.eta + self.lesson.aside), q_dot)

    @property
    def standing(self) -> Standing:
        """What is to be shown now."""
        praised, entry, now = self._t < self._praise, self.lesson, self._shown
        text = f"Well done! {self._praised}" if praised else self._down or now.text
        if not entry:
            return Standing(0, len(LESSONS), "All lessons", text or FINISHED, 0.0, 1.0, praised)
        push = 0.0 if praised or self._down else now.push
        return Standing(
            self._index + 1, len(LESSONS), entry.title, text, push, self._progress, praised
        )

    def watch(self, motion: Motion, crashed: bool = False) -> None:
        """The next motion; `crashed` where the caller knows of a crash."""
        if motion.t < self._t:
            self._down, self._praise = "", -inf
            self._begin()
        elif motion.t - self._t > BLINK:
            self._begin()
        self._t = motion.t
        touch = self._ground.watch(motion)
        if self._down or not self._attempt:
            return
        advice = self._attempt.watch(self._eyes.look(motion)._replace(touch=touch))
        self._progress = advice.progress
        passed = advice.progress >= 1.0
        if touch or crashed:
            gentle = touch is not None and touch.gentle and not crashed
            self._down = f"{'A soft landing' if gentle else NEVER_MIND}. {AGAIN}"
        if passed:
            self._pass()
        elif advice.text != self._shown.text and motion.t - self._since >= READING:
            self._shown, self._since = advice, motion.t

    def skip(self) -> None:
        """To the next lesson that is not passed, the first after the last."""
        order = [*range(self._index + 1, len(LESSONS)), *range(self._index + 1)]
        left = [index for index in order if LESSONS[index].key not in self.passed]
        self._index = left[0] if left else -1
        self._begin()

    def begin_again(self) -> None:
        """The present lesson from its start; the whole course once all are passed."""
        if not self.lesson:
            self.passed.clear()
            self._index = 0
        self._praise = -inf
        self._begin()

    def _pass(self) -> None:
        assert self.lesson
        self.passed.add(self.lesson.key)
        self._praise, self._praised = self._t + PRAISED, f"{self.lesson.title}: passed"
        self.skip()

    def _begin(self) -> None:
        """An attempt of which nothing has been seen."""
        rest = pi / 2 - self._rest.q.gamma
        self._attempt = self.lesson.begin(rest) if self.lesson else None
        self._eyes = Eyes(self._parameters)
        self._shown, self._since, self._progress = Advice("", 0.0, 0.0), -inf, 0.0
