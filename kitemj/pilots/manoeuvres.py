"""Pilots that look at the kite and move the stick: for lessons, shows and tests.

A pilot sees one motion and answers with a command; it knows nothing of models or clocks.
All steer by the nose: where it is to point follows from where the kite is, and the stick
follows the error, eased by the rate of turn. Written for the sets `sport` and `trainer` in 5 to
8 m/s.
"""

from math import hypot, pi, radians
from typing import Protocol

from kitemj.dynamics.motion import Motion
from kitemj.flight.live import Command
from kitemj.physics.parameters import Parameters
from kitemj.pilots.sight import Twist, sight, turned


class Pilot(Protocol):
    """Someone who steers."""

    def command(self, motion: Motion) -> Command:
        """Where the stick is now, for what is seen in `motion`."""


GAIN = 6.0
"""m/s of air for each rad of error: a fast kite turns more for the same pull."""
EASE = 2.0
"""m for each rad/s of turning."""


def steer(motion: Motion, error: float) -> Command:
    """The stick for a nose that is to turn right by `error` [rad]."""
    wish = (GAIN * error - EASE * sight(motion).turning) / max(motion.air.speed, 1.0)
    return Command(max(-1.0, min(1.0, wish)))


def turns(parameters: Parameters) -> bool:
    """Whether the kite turns to the hand that pulls; one that is `mirrored` drifts away from it."""
    return not parameters.stick.mirrored


class Hold:
    """Flies to the top of the window and stays there: nose up, leaning to the middle."""

    lean = 0.5
    """rad for each rad of azimuth, half a right angle at most."""

    def command(self, motion: Motion) -> Command:
        """Where the stick is now."""
        seen = sight(motion)
        wish = max(-pi / 4, min(pi / 4, -self.lean * seen.azimuth))
        return steer(motion, turned(wish - seen.heading))


class Loop:
    """A full loop to the right (`side` +1) or left (-1) at full stick, then back to the top."""

    def __init__(self, side: float = 1.0) -> None:
        self._side, self._twist, self._hold = side, Twist(), Hold()
        self.looped = False

    def command(self, motion: Motion) -> Command:
        """Full stick until the nose has nearly come round, then as `Hold`."""
        self.looped |= self._side * self._twist.look(motion) > ENOUGH
        return self._hold.command(motion) if self.looped else Command(self._side)


ENOUGH = 0.85
"""Of a turn: what is left comes by itself while the stick goes back."""


class Eight:
    """Lying figures of eight, upward at the sides: what one turn twists the other untwists.

    The kite crosses the middle `low` or above, level or a little downward, and turns up and
    back where it is `wide` from the middle.
    """

    def __init__(self, wide: float = radians(20.0), low: float = radians(32.0)) -> None:
        self._wide, self._low, self._side = wide, low, 1.0
        self.passes = 0

    def command(self, motion: Motion) -> Command:
        """Across to the other side."""
        seen = sight(motion)
        if self._side * seen.azimuth > self._wide:
            self._side, self.passes = -self._side, self.passes + 1
        dive = max(-DIVE, min(DIVE, 2.0 * (seen.elevation - self._low)))
        wish = self._side * (pi / 2 + dive)
        # a nose that has come from the other side turns through up, even from below
        return steer(motion, turned(wish - seen.heading, self._side * pi / 2))


DIVE = radians(35.0)
"""Below or above the horizontal, at most, on the way across."""


class Land:
    """Low to the edge of the window on one `side` (right +1), where the pull fades, and down.

    At the edge the nose points out of the window, which is into the wind, and the kite meets
    little more air than the wind; how far the nose is below the horizontal is how fast it
    sinks. A kite that rights itself hangs there: its nose is pressed down until it sinks. It
    touches with the tip of its lower wing.
    """

    def __init__(self, side: float = 1.0) -> None:
        self._side, self._at_edge, self._pressed, self._t = side, False, 0.0, 0.0

    def command(self, motion: Motion) -> Command:
        """To the edge, then down."""
        seen, v = sight(motion), motion.body.v_G_E
        out, still = self._side * seen.azimuth, hypot(v.x, v.y, v.z) < STILL
        self._at_edge |= out > EDGE or (out > ASIDE and still)
        if self._at_edge:
            more = PRESS * (SINK - v.z) * (motion.t - self._t)
            self._pressed = max(0.0, min(DEEPEST, self._pressed + more))
        self._t = motion.t
        below = 0.0 if self._at_edge else EDGE_HEIGHT
        sink = max(-0.5, min(0.35, 1.2 * (seen.elevation - below))) + self._pressed
        wish = self._side * (pi / 2 + sink)
        return steer(motion, turned(wish - seen.heading, self._side * pi / 4))


EDGE = radians(62.0)
"""Azimuth beyond which a kite of usual glide has left the strong wind behind."""
ASIDE, STILL = radians(30.0), 1.0
"""rad of azimuth, m/s: so far out and so slow, a kite of much drag is at its edge."""
EDGE_HEIGHT = radians(20.0)
"""Elevation of the way there."""
SINK, PRESS, DEEPEST = 1.0, 0.3, 1.2
"""m/s down at the edge; rad/s of the nose for each m/s that is missing, and rad at most."""
