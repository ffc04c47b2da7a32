"""The lessons of a first flight: each watches the kite and says the one thing to do next.

A lesson's advice is what a pilot of `pilots.py` would do now, put in words, so a pupil who
does only what is said flies the lesson. Written, as the pilots are, for the set `sport` in
5 to 8 m/s. A lesson knows nothing of crashes, restarts or the other lessons.
"""

from collections.abc import Callable
from math import degrees, inf, pi, radians
from typing import NamedTuple, Protocol

from kitemj.dynamics.motion import Motion
from kitemj.flight.crash import Touch
from kitemj.flight.pilots import Sight, turned

LEFT, RIGHT = -1.0, 1.0
WORDS = {LEFT: "left", RIGHT: "right"}


class Look(NamedTuple):
    """One instant as a lesson sees it.

    `turned` [rad]: how far the nose has turned to the right since it last pointed up; `twist`:
    its turns to the right, not whole, since the attempt began;
    `pulling` [s]: for how long the stick has been held nearly full; `touch`: of the ground.
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


class Advice(NamedTuple):
    """What to do now, in words and as a stick (`push` in -1..1, right positive).

    `progress` is 1 once the lesson is passed.
    """

    text: str
    push: float
    progress: float


class Lesson(Protocol):
    """One attempt at one lesson."""

    def watch(self, look: Look) -> Advice:
        """To be told of every tick or frame, in order."""


UPRIGHT = radians(30.0)
THOUGHT = 1.0
"""s; from seeing that it goes wrong to the stick on the other side."""
LONG = 0.8
"""s; full stick for longer is a loop, and after that the ground."""


class Held:
    """For how long [s] something has been so without a break."""

    def __init__(self) -> None:
        self._since = inf

    def look(self, so: bool, t: float) -> float:
        """Up to `t` [s]."""
        self._since = min(self._since, t) if so else inf
        return max(t - self._since, 0.0) if so else 0.0


def stick(look: Look, wish: float, about: float = 0.0) -> tuple[str, float]:
    """How to turn the nose to `wish` [rad], the way round that is nearest to `about`.

    In words, and as a beginner would move the stick: a little, more, or not at all. It looks
    ahead, for words must be read before they are done.
    """
    error = turned(wish - look.sight.heading, about) - AHEAD * look.sight.turning
    push = GAIN * error / max(look.motion.air.speed, 5.0)
    if abs(push) < LITTLE:
        return "Let go", 0.0
    side = RIGHT if push > 0 else LEFT
    if abs(push) < MUCH:
        return f"Push the stick a little {WORDS[side]}", SOME * side
    return f"Push the stick {WORDS[side]}", MORE * side


AHEAD = 0.6
"""s."""
GAIN = 6.0
"""m/s of air for each rad of error, as of the pilots."""
LITTLE, MUCH = 0.15, 0.5
SOME, MORE = 0.2, 0.4


def up(look: Look) -> tuple[str, float]:
    """How to turn the nose up and a little to the middle."""
    return stick(look, max(-LEAN, min(LEAN, -0.4 * look.sight.azimuth)))


LEAN = radians(35.0)


def to_the_sky(look: Look) -> Advice | None:
    """What comes before any lesson: a kite that dives, and a stick held full too long."""
    if look.falling:
        words, push = up(look)
        return Advice(f"You are low! {words}, until the nose points to the sky", push, 0.0)
    if look.pulling > LONG:
        return Advice("Let go: full stick held long flies into the ground", 0.0, 0.0)
    return None


class Top:
    """From the side to the top of the window, straight, and held there.

    A kite that is left alone comes back too, but slowly.
    """

    def __init__(self, rest: float) -> None:
        """`rest` [rad]: the elevation of a kite that stands still at the top."""
        self._rest, self._held = rest, Held()
        self._out: float | None = None  # when it was last out at the side
        self._home = False

    def watch(self, look: Look) -> Advice:
        """Out, home in time, held."""
        t, azimuth = look.motion.t, abs(look.sight.azimuth)
        low = look.sight.elevation < self._rest - radians(DEEP)
        if azimuth > radians(OUT):
            self._out, self._home = t, False
        elif azimuth < radians(HOME) and not low and self._out is not None:
            self._home |= t - self._out < IN_TIME
        held = self._held.look(self._home and azimuth < radians(NEAR) and not low, t)
        progress = 0.3 + 0.7 * min(held / HOLD, 1.0) if self._home else 0.3 * self._way(azimuth)
        words, push = up(look)
        danger = to_the_sky(look)
        if danger:
            return danger._replace(progress=progress)
        if self._home:
            text = f"Hold it at the top: {max(HOLD - held, 0.0):.0f} s more"
            if push:
                text = f"{words}: the nose must point up"
            return Advice(text, push, progress)
        if self._out is None or t - self._out > IN_TIME:
            side = LEFT if look.sight.azimuth < 0 else RIGHT
            text = f"Push the stick a little {WORDS[side]}: fly out to the side, then come back"
            return Advice(text, 0.25 * side, progress)
        goal = "until the nose points up and to the middle" if push else "the kite flies home"
        return Advice(f"{words}{', ' if push else ': '}{goal}", push, progress)

    def _way(self, azimuth: float) -> float:
        """How much of the way home is behind it."""
        if self._out is None:
            return 0.0
        return max(0.0, min(1.0, 1 - degrees(azimuth) / OUT))


OUT, HOME, NEAR, DEEP = 30.0, 10.0, 15.0, 10.0
"""deg: of azimuth, out at the side, home, near enough to home; of elevation, too low."""
IN_TIME = 5.0
"""s from OUT to HOME; a kite that is left alone takes 7 s or more."""
HOLD = 5.0
"""s."""


class Turn:
    """The nose to one side and off that way, then up again."""

    def __init__(self, side: float) -> None:
        self._side, self._held = side, Held()
        self._aside = False

    def watch(self, look: Look) -> Advice:
        """Turned, away from the middle, upright."""
        side, seen = self._side, look.sight
        nose, away = side * look.turned / radians(NOSE), side * seen.azimuth / radians(AWAY)
        if nose > ROUND:  # that was no turn but a loop
            self._aside = False
        elif min(nose, away) >= 1:
            self._aside = True
        held = self._held.look(self._aside and look.upright, look.motion.t)
        parts = max(0.0, min(nose, 1.0)) + max(0.0, min(away, 1.0))
        progress = 0.6 + 0.4 * min(held / STEADY, 1.0) if self._aside else 0.3 * parts
        danger = to_the_sky(look)
        if danger:
            return danger._replace(progress=progress)
        if self._aside:
            words, push = up(look)
            goal = ", until the nose points up" if push else ": the nose is coming up"
            return Advice(f"Well turned. {words}{goal}", push, progress)
        words, push = stick(look, side * AIM, side * pi / 4)
        name = WORDS[side]
        if push * side > 0:
            return Advice(f"{words}, until the nose points {name}", push, progress)
        if push:
            return Advice(f"{words}: the nose has turned too far", push, progress)
        return Advice(f"Let go: the kite flies {name} by itself", push, progress)


NOSE, AWAY = 45.0, 15.0
"""deg; of the nose from up, of the kite from the middle."""
ROUND = 4.5
"""In parts of NOSE: more is a loop."""
AIM = radians(65.0)
STEADY = 1.0
"""s; upright for so long is no accident."""


class Round:
    """A full loop to one side, then upright again."""

    def __init__(self, side: float) -> None:
        self._side, self._held = side, Held()
        self._looped = False

    def watch(self, look: Look) -> Advice:
        """Round, upright."""
        name, share = WORDS[self._side], self._side * look.turned / (2 * pi)
        self._looped |= share > LOOPED
        held = self._held.look(self._looped and look.upright, look.motion.t)
        if self._looped:
            words, push = up(look)
            goal = ", until the nose points up" if push else ": the nose is coming up"
            progress = 0.8 + 0.2 * min(held / STEADY, 1.0)
            return Advice(f"All the way round! {words}{goal}", push, progress)
        progress = 0.8 * max(0.0, min(share / LOOPED, 1.0))
        if share > RELEASE:
            return Advice("Let go now: the rest of the loop comes by itself", 0.0, progress)
        if share > STARTED:
            return Advice(f"Keep it {name}: the nose goes all the way round", self._side, progress)
        if share < -STARTED:
            text = f"That is the other way: push the stick {name}"
            return Advice(text, 0.6 * self._side, progress)
        if look.sight.elevation < radians(ROOM):
            words, push = up(look)
            return Advice(f"A loop needs room. {words}: climb first", push, progress)
        return Advice(f"Push the stick fully {name} and keep it there", self._side, progress)


LOOPED, RELEASE, STARTED = 0.9, 0.65, 0.1
"""Of a turn; a beginner lets go a quarter of a second after being told to."""
ROOM = 40.0
"""deg of elevation that a loop begins above."""


class FigureEight:
    """Across the middle, back, and across again: what one turn twists the other untwists."""

    def __init__(self) -> None:
        self._side = 0.0  # of the middle, where it was last
        self._reach = 0.0  # rad; how far out since it crossed the middle
        self._crossings: list[Crossing] = []

    def watch(self, look: Look) -> Advice:
        """Three crossings of the middle, well out in between, lines as they were."""
        side = RIGHT if look.sight.azimuth > 0 else LEFT
        if self._side and side != self._side:
            self._cross(side, look)
            self._reach = 0.0
        self._side, self._reach = side, max(self._reach, abs(look.sight.azimuth))
        done = self._done()
        parts = len(self._crossings) + 0.9 * min(self._reach / radians(WIDE), 1.0)
        progress = 1.0 if done else min(parts / 4, 0.99)
        back = self._reach > radians(BACK)
        way = -self._side if back else self._side
        dive = 2.0 * (look.sight.elevation - radians(CROSSED))
        words, push = stick(look, way * (pi / 2 + max(-DIVE, min(DIVE, dive))), way * pi / 2)
        danger = to_the_sky(look) if look.falling else None
        return (
            danger._replace(progress=progress)
            if danger
            else Advice(self._words(words, push, way, back), push, progress)
        )

    def _cross(self, way: float, look: Look) -> None:
        across = radians(45.0) < way * look.sight.heading < radians(150.0)
        new = Crossing(look.motion.t, way, look.twist)
        if not across or self._reach < radians(WIDE):
            self._crossings = []
        elif self._crossings and new.t - self._crossings[-1].t > LAZY:
            self._crossings = [new]
        else:
            self._crossings = [*self._crossings, new][-3:]

    def _done(self) -> bool:
        if len(self._crossings) < 3:
            return False
        return abs(self._crossings[-1].twist - self._crossings[0].twist) < 0.25

    def _words(self, words: str, push: float, way: float, back: bool) -> str:
        name = WORDS[way]
        if len(self._crossings) == 3:
            return f"That was a circle, not an eight. {words}, until the nose points {name}"
        if not push:
            return f"Let go: across to the {name}"
        if push * way < 0:
            return f"{words}: the nose has turned too far"
        over = "comes over the top and points" if back else "points"
        return f"{words}, until the nose {over} {name}"


class Crossing(NamedTuple):
    """Of the middle, at `t` [s], which `way`; `twist` in turns of the nose to the right."""

    t: float
    way: float
    twist: float


WIDE = 15.0
"""deg of azimuth; less is no eight but a wiggle."""
BACK, CROSSED = 18.0, 38.0
"""deg: azimuth where it is time to turn back; elevation to cross the middle at."""
DIVE = radians(25.0)
"""Of the nose below or above the horizontal on the way across."""
LAZY = 15.0
"""s between crossings; who takes longer has drifted."""


class Touchdown:
    """Softly to the ground, which is only to be had at the edge of the window."""

    def __init__(self) -> None:
        self._side = 0.0

    def watch(self, look: Look) -> Advice:
        """A gentle touch."""
        azimuth, elevation = degrees(look.sight.azimuth), degrees(look.sight.elevation)
        if self._side * azimuth < (-OUT if self._side else 1.0):  # to the nearer edge
            self._side = LEFT if azimuth < -OUT else RIGHT
        side, name = self._side, WORDS[self._side]
        if look.touch and look.touch.gentle:
            return Advice("Landed", 0.0, 1.0)
        way, down = min(max(side * azimuth / RIM, 0.0), 1.0), max(0.0, 1 - elevation / RIM)
        progress = 0.6 * way + 0.35 * down * (way == 1.0)
        below = LOW_WAY if way < 1 else 0.0
        sink = max(-0.5, min(STEEP, SLOPE * (look.sight.elevation - below)))
        words, push = stick(look, side * (pi / 2 + sink), side * pi / 4)
        if way < 1 and look.falling:
            words, push = up(look)
            return Advice(f"Not so steep! {words}, until the nose points up", push, progress)
        if way < 1:
            goal = f", until the nose points {name}" if push else f": it flies {name}, to the edge"
            return Advice(f"{words}{goal}", push, progress)
        if push * side > 0:
            return Advice(f"{words}: the nose a little lower", push, progress)
        if push:
            return Advice(f"{words}: raise the nose, it sinks too fast", push, progress)
        return Advice("Let go: at the edge it sinks softly by itself", 0.0, progress)


RIM = 55.0
"""deg of azimuth; beyond, the pull fades."""


class Entry(NamedTuple):
    """A lesson in the course: its name in files, its title, and how an attempt begins.

    `aside` [rad]: by how much η is turned where a flight begins for it; 0 at the equilibrium.
    """

    key: str
    title: str
    begin: Callable[[float], Lesson]
    aside: float = 0.0


LESSONS = (
    Entry("top", "Hold the top", Top, 0.35),
    Entry("turn-left", "Turn left", lambda rest: Turn(LEFT)),
    Entry("turn-right", "Turn right", lambda rest: Turn(RIGHT)),
    Entry("loop-left", "A loop to the left", lambda rest: Round(LEFT)),
    Entry("loop-right", "A loop to the right", lambda rest: Round(RIGHT)),
    Entry("eight", "A figure of eight", lambda rest: FigureEight()),
    Entry("land", "Land", lambda rest: Touchdown()),
)
"""In the order in which they are flown; `begin` is told the elevation of rest [rad]."""
LOW_WAY, STEEP, SLOPE = radians(20.0), 0.35, 1.2
