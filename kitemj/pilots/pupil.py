"""A simulated pupil: what a beginner at the keys makes of a kite, by chance, for tests and tables.

Stands for people, and is no autopilot. It has two keys, left and right, and knows of them only
held and not held. What it does now is what it decided a reaction ago. It flies about: after
some seconds it wants to go left, to the top, right. When the kite dives towards the ground it
wants the nose up. It never foresees that a nose that turns turns on. Whatever it sees it judges
wrongly by a factor that changes with every look, and its reactions differ as much.
"""

from collections import deque
from math import pi, radians
from random import Random

from kitemj.dynamics.motion import Motion
from kitemj.pilots.sight import LEFT, RIGHT, sight, turned

REACTION, NOISE = 0.3, 0.2
"""s; a standard deviation, in parts of the reaction and of what is judged."""
LOOK = 0.1
"""s between looks."""
MIND = 4.0
"""s until it wants something else."""
WAYS = (-1.0, 0.0, 1.0, 0.0)
"""Where it wants to go, in turn: left, the top, right, the top."""
SLANT, CLEARLY = radians(60.0), radians(25.0)
"""Of the nose on the way to a side; off by less no key is held."""
ASIDE, NEAR = radians(30.0), radians(12.0)
"""Of azimuth, where it wants the kite at a side; near enough to hold no key."""
ALARM = 2.0
"""s to the ground, at the speed at which the kite sinks."""
LEAN = 0.5
"""rad to the middle for each rad of azimuth, when it wants the nose up."""


class Reaction:
    """Hands that do what was decided some `seconds` ago, a fifth more or less each time."""

    def __init__(self, random: Random, seconds: float = REACTION) -> None:
        self._random, self._seconds, self._done = random, seconds, 0.0
        self._decided: deque[tuple[float, float]] = deque()  # when it will be done, and what
        self._last = 0.0

    def after(self, decision: float, t: float) -> float:
        """What is done at time `t` [s], at which `decision` is made."""
        if decision != self._last:
            self._last = decision
            due = t + self._seconds * about_one(self._random)
            self._decided.append((due, decision))
        while self._decided and self._decided[0][0] <= t:
            self._done = self._decided.popleft()[1]
        return self._done


def about_one(random: Random) -> float:
    """A factor of 1 with the noise of a person."""
    return max(0.0, random.gauss(1.0, NOISE))


class Pupil:
    """A pupil of one `seed`; the same seed does the same with the same kite.

    It looks at the nose, and holds the key that turns it where it is wanted, the shorter way;
    or, as a worse pupil does, only at the `place` of the kite, and holds the key on whose side
    it wants the kite, wherever the nose points.
    """

    def __init__(self, seed: int, place: bool = False) -> None:
        self._random, self._place = Random(seed), place
        self._hands = Reaction(self._random)
        self._way, self._change = self._random.randrange(len(WAYS)), 0.0
        self._key, self._look = 0.0, 0.0

    def key(self, motion: Motion) -> float:
        """The key that is held now: -1 the left one, 1 the right one, 0 none."""
        if motion.t >= self._look:
            self._look, self._key = motion.t + LOOK, self._decision(motion)
        return self._hands.after(self._key, motion.t)

    def _decision(self, motion: Motion) -> float:
        if motion.t >= self._change:
            self._change = motion.t + MIND * about_one(self._random)
            self._way = (self._way + 1) % len(WAYS)
        seen, way = sight(motion), WAYS[self._way]
        height, sinking = -motion.body.p_G_E.z, motion.body.v_G_E.z
        alarmed = height < ALARM * sinking * about_one(self._random)
        if self._place and not alarmed:
            off, enough = way * ASIDE - seen.azimuth, NEAR
        else:
            up = max(-pi / 4, min(pi / 4, -LEAN * seen.azimuth))
            wish = up if alarmed else way * SLANT or up
            off, enough = turned(wish - seen.heading), CLEARLY
        off *= about_one(self._random)
        if abs(off) < enough:
            return 0.0
        return RIGHT if off > 0 else LEFT
