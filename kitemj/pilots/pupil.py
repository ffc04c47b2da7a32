"""A simulated pupil: what a beginner at the keys makes of a kite, by chance, for tests and tables.

Stands for people, and is no autopilot. It has two keys, left and right, and knows of them only
held and not held. What it does now is what it decided a reaction ago. It flies about: after
some seconds it wants the nose to the left, up, or to the right. It holds the key that turns the
nose there, the shorter way, while the nose is clearly off, and it does not foresee that the
nose turns on. When the kite dives towards the ground it wants the nose up. How far off the
nose is it judges wrongly by a factor that changes with every look; reactions differ as much.
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
CLEARLY = radians(25.0)
"""Off by less, no key is held."""
WAYS = (radians(-60.0), 0.0, radians(60.0), 0.0)
"""Where it wants the nose, in turn."""
MIND = 4.0
"""s until it wants something else."""
ALARM = 2.0
"""s to the ground, at the speed at which the kite sinks."""
LEAN = 0.5
"""rad to the middle for each rad of azimuth, when it wants the nose up."""


class Pupil:
    """A pupil of one `seed`; the same seed does the same with the same kite."""

    def __init__(self, seed: int) -> None:
        self._random = Random(seed)
        self._decided: deque[tuple[float, float]] = deque()  # when it is done, the key
        self._held, self._look = 0.0, 0.0
        self._way, self._change = self._random.randrange(len(WAYS)), 0.0

    def key(self, motion: Motion) -> float:
        """The key that is held now: -1 the left one, 1 the right one, 0 none."""
        if motion.t >= self._look:
            self._look = motion.t + LOOK
            done = motion.t + REACTION * self._about_one()
            self._decided.append((done, self._decision(motion)))
        while self._decided and self._decided[0][0] <= motion.t:
            self._held = self._decided.popleft()[1]
        return self._held

    def _decision(self, motion: Motion) -> float:
        if motion.t >= self._change:
            self._change = motion.t + MIND * self._about_one()
            self._way = (self._way + 1) % len(WAYS)
        seen, wish = sight(motion), WAYS[self._way]
        height, sinking = -motion.body.p_G_E.z, motion.body.v_G_E.z
        if not wish or height < ALARM * sinking * self._about_one():
            wish = max(-pi / 4, min(pi / 4, -LEAN * seen.azimuth))
        off = turned(wish - seen.heading) * self._about_one()
        if abs(off) < CLEARLY:
            return 0.0
        return RIGHT if off > 0 else LEFT

    def _about_one(self) -> float:
        return max(0.0, self._random.gauss(1.0, NOISE))
