"""The first-flight course: which lesson is flown, what is to be done now, which are passed."""

from collections import deque
from collections.abc import Callable, Collection
from itertools import pairwise
from math import inf, pi
from typing import NamedTuple

from kitemj.dynamics.motion import Motion
from kitemj.flight.equilibrium import equilibrium_state
from kitemj.physics.parameters import Parameters
from kitemj.pilots.advice import LATE, Advice
from kitemj.pilots.crash import FirstTouch
from kitemj.pilots.lessons import Eight, Landing, Lesson, Loop, Top, Turn
from kitemj.pilots.sight import LEFT, RIGHT, Observer

BLINK = 0.5
"""s; who sees less often cannot count turns."""
PRAISED = 3.0
"""s for which a passed lesson is praised."""
READING = 0.4
"""s for which an advice stays at least: the kite may change faster than one reads."""

NOTHING = Advice("", 0.0)
NEVER_MIND = "Never mind, that is how one learns"
FINISHED = "You have passed them all. The sky is yours"


class Entry(NamedTuple):
    """A lesson in the course: its name in files, its title, and how an attempt begins.

    `begin` is told the elevation of rest [rad].
    """

    key: str
    title: str
    begin: Callable[[float], Lesson]


LESSONS = (
    Entry("top", "Hold the top", Top),
    Entry("turn-left", "Turn left", lambda rest: Turn(LEFT)),
    Entry("turn-right", "Turn right", lambda rest: Turn(RIGHT)),
    Entry("loop-left", "A loop to the left", lambda rest: Loop(LEFT)),
    Entry("loop-right", "A loop to the right", lambda rest: Loop(RIGHT)),
    Entry("eight", "A figure of eight", lambda rest: Eight()),
    Entry("land", "Land", lambda rest: Landing()),
)
"""In the order in which they are flown."""


class LessonStatus(NamedTuple):
    """What a panel shows of the course: lesson `number` of `total`, 0 when all are passed.

    `push` in -1..1 is where the stick should be, right positive; `progress` in 0..1; `down`:
    the kite lies on the ground, and the lesson waits for another flight.
    """

    number: int
    total: int
    title: str
    advice: str
    push: float
    progress: float
    praised: bool
    down: bool = False


class Course:
    """The lessons that are not `passed` yet, flown in order; told of the motions of one flight.

    Every tick or every frame will do. Where time jumps, at a restart, a rewind or after half
    a second unseen, the attempt at the present lesson begins again; a touch of the ground
    ends it until then. Raises InputError where the kite cannot hang still.
    """

    def __init__(self, parameters: Parameters, passed: Collection[str] = ()) -> None:
        """`passed`: keys of LESSONS; others are ignored."""
        self._parameters, self._rest = parameters, equilibrium_state(parameters)
        self.passed = {entry.key for entry in LESSONS} & set(passed)
        self._t, self._praise = inf, -inf  # the latter: until when
        self._praised = self._down = ""
        self._shown, self._since = NOTHING, -inf
        self._ground, self._index = FirstTouch(parameters), -1
        self.skip()

    @property
    def lesson(self) -> Entry | None:
        """The one that is flown; None: all are passed."""
        return LESSONS[self._index] if self._index >= 0 else None

    @property
    def status(self) -> LessonStatus:
        """What is to be shown now."""
        entry, total, number = self.lesson, len(LESSONS), self._index + 1
        title = entry.title if entry else "All lessons"
        if self._t < self._praise:
            text = f"Well done! {self._praised}"
            return LessonStatus(number, total, title, text, 0.0, 1.0, True)
        progress = self._progress if entry else 1.0
        if self._down:
            return LessonStatus(number, total, title, self._down, 0.0, progress, False, True)
        now = self._shown if entry else Advice(FINISHED, 0.0)
        return LessonStatus(number, total, title, now.text, now.push, progress, False)

    def watch(self, motion: Motion, crashed: bool = False, assist: bool = False) -> None:
        """The next motion; `crashed` where the caller knows of a crash, `assist`: it is on."""
        if not 0 <= motion.t - self._t <= BLINK:
            self._ground = FirstTouch(self._parameters)
            self._down, self._praise = "", -inf
            self._begin()
        self._t = motion.t
        touch = self._ground.watch(motion)
        if self._down or not self._attempt:
            return
        self._said.append((motion.t, self._shown.push))
        look = self._observer.look(motion)
        look = look._replace(touch=touch, assist=assist, said=self._pending(motion.t))
        advice = self._attempt.watch(look)
        self._progress = advice.progress
        if touch or crashed:
            gentle = touch is not None and touch.gentle and not crashed
            self._down = "A soft landing" if gentle else NEVER_MIND
        if advice.progress >= 1.0:
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

    def _pending(self, t: float) -> float:
        """What was said within `LATE` of time `t` [s], as in `Observation`."""
        while self._said[0][0] < t - LATE:
            self._said.popleft()
        return sum(push * (then - now) for (now, _), (then, push) in pairwise(self._said))

    def _pass(self) -> None:
        assert self.lesson
        self.passed.add(self.lesson.key)
        self._praise, self._praised = self._t + PRAISED, f"{self.lesson.title}: passed"
        self.skip()

    def _begin(self) -> None:
        """An attempt of which nothing has been seen."""
        rest = pi / 2 - self._rest.q.gamma
        self._attempt = self.lesson.begin(rest) if self.lesson else None
        self._observer = Observer(self._parameters)
        self._said = deque[tuple[float, float]]()  # when, which push
        self._shown, self._since, self._progress = NOTHING, -inf, 0.0
