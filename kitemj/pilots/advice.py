"""What a lesson sees of a flight, and how it says what to do: in words and as a stick.

The words are those of a teacher beside a beginner: which way to push, how much, and until
when. They look further ahead than a pilot's hand, since they must be read before they are
done. Written, as the pilots are, for the set `sport` in 5 to 8 m/s.
"""

from math import inf, pi, radians
from typing import NamedTuple

from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters
from kitemj.pilots.crash import Touch
from kitemj.pilots.sight import Sight, Twist, sight, turned

LEFT, RIGHT = -1.0, 1.0
WORDS = {LEFT: "left", RIGHT: "right"}

UPRIGHT = radians(30.0)
THOUGHT = 1.0
"""s; from seeing that it goes wrong to the stick on the other side."""
FULL, LONG = 0.85, 0.8
"""Of the stick's way; s. Held so far for so long it is a loop, and after that the ground."""

AHEAD = 0.6
"""s; tried with pupils who do what is said 0.1, 0.25 and 0.4 s later."""
GAIN = 6.0
"""m/s of air for each rad of error, as the pilots'."""
LITTLE, MUCH = 0.15, 0.5
"""Of the stick's way: less is not worth a word, more is not a little."""
SOME, MORE = 0.2, 0.4
"""Of the stick's way: what is meant by a little, and by a push."""
LEAN = radians(35.0)
"""Of the nose to the middle, at most, on the way to the top."""


class Observation(NamedTuple):
    """One instant as a lesson sees it.

    `turned` [rad]: how far the nose has turned to the right since it last pointed up;
    `twist`: its turns to the right, not whole, since the attempt began; `pulling` [s]: for
    how long the stick has been held nearly full; `touch`: the flight's first of the ground.
    """

    motion: Motion
    sight: Sight
    turned: float
    twist: float
    pulling: float
    touch: Touch | None = None

    @property
    def upright(self) -> bool:
        """Whether the nose points up, more or less."""
        return abs(self.sight.heading) < UPRIGHT

    @property
    def falling(self) -> bool:
        """Whether the kite will be in the grass before a beginner has thought."""
        return -self.motion.body.p_G_E.z < THOUGHT * self.motion.body.v_G_E.z


class Held:
    """For how long [s] something has been so without a break."""

    def __init__(self) -> None:
        self._since = inf

    def look(self, so: bool, t: float) -> float:
        """Up to `t` [s]."""
        self._since = min(self._since, t) if so else inf
        return t - self._since if so else 0.0


class Observer:
    """Looks at the motions of one attempt, in order."""

    def __init__(self, parameters: Parameters) -> None:
        self._limit, self._twist, self._pull = parameters.stick.delta, Twist(), Held()
        self._up: float | None = None  # turns of the nose when it last pointed up

    def look(self, motion: Motion) -> Observation:
        """The next instant; to be asked every half turn of the nose or more often."""
        seen, twist = sight(motion), self._twist.look(motion)
        pulling = self._pull.look(abs(motion.control.delta) > FULL * self._limit, motion.t)
        nearest = twist - seen.heading / (2 * pi)
        up = nearest if self._up is None else self._up
        look = Observation(motion, seen, 2 * pi * (twist - up), twist, pulling)
        self._up = nearest if look.upright else up
        return look


class Advice(NamedTuple):
    """What to do now, in words and as a stick (`push` in -1..1, right positive).

    `progress` is 1 once the lesson is passed.
    """

    text: str
    push: float
    progress: float = 0.0


def stick(look: Observation, wish: float, about: float = 0.0) -> Advice:
    """How to turn the nose to `wish` [rad], the way round that is nearest to `about`."""
    error = turned(wish - look.sight.heading, about) - AHEAD * look.sight.turning
    push = GAIN * error / max(look.motion.air.speed, 5.0)
    if abs(push) < LITTLE:
        return Advice("Let go", 0.0)
    side = RIGHT if push > 0 else LEFT
    if abs(push) < MUCH:
        return Advice(f"Push the stick a little {WORDS[side]}", SOME * side)
    return Advice(f"Push the stick {WORDS[side]}", MORE * side)


def up(look: Observation) -> Advice:
    """How to turn the nose up, leaning to the middle."""
    return stick(look, max(-LEAN, min(LEAN, -0.4 * look.sight.azimuth)))


def completed(start: Advice, pushing: str, resting: str) -> Advice:
    """An advice of `stick` with what it is good for: until when, or what the kite then does."""
    text = f"{start.text}, {pushing}" if start.push else f"{start.text}: {resting}"
    return start._replace(text=text)


def danger(look: Observation) -> Advice | None:
    """What goes before any lesson: a kite that dives, and a stick held full too long."""
    if look.falling:
        climb = up(look)
        return climb._replace(text=f"You are low! {climb.text}, until the nose points to the sky")
    if look.pulling > LONG:
        return Advice("Let go: full stick held long flies into the ground", 0.0)
    return None
