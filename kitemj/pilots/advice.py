"""How a lesson says what to do: in words and as a stick.

The words are those of a teacher beside a beginner: which way to push, how much, and until
when. They look further ahead than a pilot's hand, since they must be read before they are
done: of what was said and is not yet seen in the kite they take account. Written, as the pilots
are, for the sets `sport` and `trainer` in 5 to 8 m/s.
"""

from math import radians
from typing import NamedTuple

from kitemj.pilots.sight import LEFT, RIGHT, WORDS, Observation, turned

LONG = 0.8
"""s; a stick held nearly full for so long is a loop, and after that the ground."""
LATE = 0.8
"""s; what is said is read and done so much later."""
AHEAD = 0.4
"""s; and so much later the kite has answered."""
TURN = 2.5
"""rad/s of the nose for a full push, by and by."""
NEAR, FAR = radians(20.0), radians(45.0)
"""Of the nose by then: less is not worth a word, more is not a little."""
SOME, MORE = 0.2, 0.4
"""Of the stick's way: what is meant by a little, and by a push."""
LEAN = radians(35.0)
"""Of the nose to the middle, at most, on the way to the top."""


class Advice(NamedTuple):
    """What to do now, in words and as a stick (`push` in -1..1, right positive).

    `progress` is 1 once the lesson is passed.
    """

    text: str
    push: float
    progress: float = 0.0


def stick(look: Observation, wish: float, about: float = 0.0) -> Advice:
    """How to turn the nose to `wish` [rad], the way round that is nearest to `about`.

    Back from there, up, the assist turns it by itself.
    """
    coming = AHEAD * look.sight.turning + TURN * look.said
    soon = turned(wish - look.sight.heading, about) - coming
    side = RIGHT if soon > 0 else LEFT
    if abs(soon) < NEAR or (look.assist and side * wish <= 0.0):
        return Advice("Let go", 0.0)
    if abs(soon) < FAR:
        return Advice(f"Push the stick a little {WORDS[side]}", SOME * side)
    return Advice(f"Push the stick {WORDS[side]}", MORE * side)


def up(look: Observation) -> Advice:
    """How to turn the nose up, leaning to the middle; the assist does it by itself."""
    if look.assist:
        return Advice("Let go", 0.0)
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
