"""The lessons of a first flight: each watches the kite and says the one thing to do next.

A lesson knows nothing of crashes, restarts or the other lessons; `course.py` does.
"""

from math import asin, cos, degrees, pi, radians, sin
from typing import NamedTuple, Protocol

from kitemj.physics.vectors import norm
from kitemj.pilots.advice import MORE, Advice, completed, danger, stick, up
from kitemj.pilots.sight import LEFT, RIGHT, WORDS, Held, Observation


class Lesson(Protocol):
    """One attempt at one lesson."""

    def watch(self, look: Observation) -> Advice:
        """To be told of every tick or frame, in order."""


STEADY = 1.0
"""s; a nose that points up for so long does so not by accident."""


def back(look: Observation, praise: str) -> Advice:
    """After `praise`, how to turn the nose up again."""
    advice = completed(up(look), "until the nose points up", "the nose is coming up")
    return advice._replace(text=f"{praise} {advice.text}")


class Top:
    """Out to a side by a push, home to the top of the window, and held there."""

    def __init__(self, rest: float) -> None:
        """`rest` [rad]: the elevation of a kite that stands still at the top."""
        self._rest, self._held = rest, Held()
        self._side, self._out, self._home = RIGHT, False, False
        self._began = False  # near the middle: who begins aside has not flown there

    def watch(self, look: Observation) -> Advice:
        """Out, home, held."""
        azimuth = degrees(abs(look.sight.azimuth))
        high = look.sight.elevation > self._rest - radians(DEEP)
        self._began |= azimuth < NEAR
        if self._began and azimuth > OUT:
            self._out, self._home = True, False
        self._home |= self._out and azimuth < NEAR and high
        held = self._held.look(self._home and azimuth < NEAR and high, look.motion.t)
        way = min(azimuth / OUT, 1.0) if self._began else 0.0
        progress = 0.5 + 0.5 * min(held / HOLD, 1.0) if self._home else 0.4
        advice = danger(look) or self._advice(look, HOLD - held)
        return advice._replace(progress=progress if self._out else 0.3 * way)

    def _advice(self, look: Observation, left: float) -> Advice:
        if self._began and not self._out:
            name = WORDS[self._side]
            advice = stick(look, self._side * SLANT)
            return completed(advice, f"until the nose points {name}", f"it flies off {name}")
        climb = up(look)
        if self._home:
            rest = f"Hold it at the top: {max(left, 0.0):.0f} s more"
            text = f"{climb.text}: the nose must point up" if climb.push else rest
            return climb._replace(text=text)
        return completed(climb, "until the nose points up and to the middle", "the kite flies home")


OUT, NEAR, DEEP = 20.0, 15.0, 12.0
"""deg: of azimuth, out at the side, home; of elevation, too low for the top."""
SLANT = radians(80.0)
"""Of the nose on the way out."""
HOLD = 5.0
"""s."""


class Turn:
    """The nose to one side and off that way, then up again."""

    def __init__(self, side: float) -> None:
        self._side, self._held = side, Held()
        self._aside = self._spun = False

    def watch(self, look: Observation) -> Advice:
        """Turned, away from the middle, upright; what swings after a loop is no turn."""
        nose = self._side * degrees(look.turned) / NOSE
        away = self._side * degrees(look.sight.azimuth) / AWAY
        held = self._held.look(look.upright, look.motion.t)
        self._spun = abs(nose) > ROUND or (self._spun and held < STEADY)
        self._aside = not self._spun and (self._aside or min(nose, away) >= 1)
        parts = max(0.0, min(nose, 1.0)) + max(0.0, min(away, 1.0))
        progress = 0.6 + 0.4 * min(held / STEADY, 1.0) if self._aside else 0.3 * parts
        advice = danger(look) or (back(look, "Well turned.") if self._aside else self._off(look))
        return advice._replace(progress=progress)

    def _off(self, look: Observation) -> Advice:
        side, name = self._side, WORDS[self._side]
        advice = stick(look, side * AIM, side * pi / 4)
        if advice.push * side < 0:
            return advice._replace(text=f"{advice.text}: the nose has turned too far")
        return completed(advice, f"until the nose points {name}", f"the kite flies {name}")


NOSE, AWAY = 45.0, 15.0
"""deg; of the nose from up, of the kite from the middle."""
ROUND = 4.5
"""In parts of NOSE: more is no turn but a loop."""
AIM = radians(65.0)
"""Of the nose."""


class Loop:
    """All the way round to one side, then upright again."""

    def __init__(self, side: float) -> None:
        self._side, self._held, self._looped = side, Held(), False

    def watch(self, look: Observation) -> Advice:
        """Round, upright."""
        share = self._side * look.turned / (2 * pi)
        self._looped |= share > LOOPED
        held = self._held.look(self._looped and look.upright, look.motion.t)
        if self._looped:
            advice = danger(look) or back(look, "All the way round!")
            return advice._replace(progress=0.8 + 0.2 * min(held / STEADY, 1.0))
        progress = 0.8 * max(0.0, min(share / LOOPED, 1.0))
        return self._round(look, share)._replace(progress=progress)

    def _round(self, look: Observation, share: float) -> Advice:
        side, name = self._side, WORDS[self._side]
        if share > RELEASE:
            return Advice("Let go now: the rest of the loop comes by itself", 0.0)
        if share > STARTED:
            return Advice(f"Keep it {name}: the nose goes all the way round", side)
        if share < -STARTED:
            return Advice(f"That is the other way: push the stick {name}", MORE * side)
        if degrees(look.sight.elevation) < ROOM:
            climb = up(look)
            return climb._replace(text=f"A loop needs room. {climb.text}: climb first")
        return Advice(f"Push the stick fully {name} and keep it there", side)


LOOPED, RELEASE, STARTED = 0.9, 0.65, 0.1
"""Of a turn; who lets go a quarter of a second after being told to is round by then."""
ROOM = 40.0
"""deg of elevation that a loop begins above."""


class Crossing(NamedTuple):
    """Of the middle, at `t` [s], to which side; `twist` in turns of the nose to the right."""

    t: float
    side: float
    twist: float


class Eight:
    """Across the middle, back, and across again: what one turn twists the other untwists."""

    def __init__(self) -> None:
        self._side = 0.0  # of the middle, where it was last
        self._reach = 0.0  # deg; how far out since it crossed the middle
        self._crossings: list[Crossing] = []

    def watch(self, look: Observation) -> Advice:
        """Three crossings of the middle, well out in between, lines as they were."""
        # an azimuth would not do: near the top it is large for the least of a wiggle
        aside = degrees(asin(cos(look.sight.elevation) * sin(look.sight.azimuth)))
        side = RIGHT if aside > 0 else LEFT
        if self._side and side != self._side:
            self._cross(side, look)
        self._side, self._reach = side, max(self._reach, abs(aside))
        crossings = self._crossings
        untwisted = abs(crossings[-1].twist - crossings[0].twist) < 0.25 if crossings else False
        if len(crossings) == 3 and untwisted:
            return Advice("An eight", 0.0, 1.0)
        parts = len(crossings) + min(self._reach / WIDE, 1.0)
        advice = danger(look) if look.falling else None
        return (advice or self._advice(look))._replace(progress=min(parts / 4, 0.95))

    def _cross(self, side: float, look: Observation) -> None:
        new = Crossing(look.motion.t, side, look.twist)
        if self._reach < WIDE:
            self._crossings = []
        elif self._crossings and new.t - self._crossings[-1].t > LAZY:
            self._crossings = [new]
        else:
            self._crossings = [*self._crossings, new][-3:]
        self._reach = 0.0

    def _advice(self, look: Observation) -> Advice:
        back = self._reach > BACK
        outward = self._side if self._reach > STRAY else RIGHT
        way = -self._side if back else outward
        dive = 2.0 * (look.sight.elevation - radians(CROSSED))
        advice = stick(look, way * (pi / 2 + max(-DIVE, min(DIVE, dive))), way * pi / 2)
        name = WORDS[way]
        if len(self._crossings) == 3:
            text = f"That was a circle, not an eight. {advice.text}, back to the {name}"
            return advice._replace(text=text)
        if advice.push * way < 0:
            return advice._replace(text=f"{advice.text}: the nose has turned too far")
        over = "comes over the top and points" if back else "points"
        return completed(advice, f"until the nose {over} {name}", f"across to the {name}")


WIDE, BACK, STRAY = 11.0, 15.0, 2.0
"""deg from the middle, on the sky: less is a wiggle; where one turns; what is no side yet."""
CROSSED = 38.0
"""deg of elevation at which the middle is crossed."""
DIVE = radians(25.0)
"""Of the nose below or above the horizontal on the way across."""
LAZY = 15.0
"""s between crossings; who takes longer has drifted."""


class Landing:
    """Softly to the ground, which is only to be had at the edge of the window."""

    def __init__(self) -> None:
        self._side, self._flew = RIGHT, False
        self._hangs, self._pressed, self._t = False, 0.0, 0.0

    def watch(self, look: Observation) -> Advice:
        """A touch that breaks nothing, after a flight: a kite found lying has not landed."""
        if look.touch and look.touch.harmless and self._flew:
            return Advice("Landed", 0.0, 1.0)
        self._flew |= look.touch is None
        if look.assist:
            return Advice("The assist lets no kite land. Switch it off: press H", 0.0)
        azimuth, elevation = degrees(look.sight.azimuth), degrees(look.sight.elevation)
        if self._side * azimuth < -OUT:  # the other edge is nearer
            self._side = -self._side
        way, high = self._side * azimuth / EDGE, min(max(elevation / EDGE, 0.0), 1.0)
        still = self._side * azimuth > OUT and norm(look.motion.body.v_G_E) < STILL
        self._hangs = (self._hangs or still) and self._side * azimuth > OUT
        self._press(look)
        if way < 1 and not self._hangs:
            return self._out(look)._replace(progress=0.6 * min(max(way, 0.0), 1.0))
        return self._down(look)._replace(progress=0.95 - 0.35 * high)

    def _press(self, look: Observation) -> None:
        """A kite that rights itself hangs at the edge: its nose is pressed down until it sinks."""
        since, self._t = look.motion.t - self._t, look.motion.t
        more = PRESS * (SINKING - look.motion.body.v_G_E.z) * since
        self._pressed = max(0.0, min(DEEPEST, self._pressed + more)) if self._hangs else 0.0

    def _out(self, look: Observation) -> Advice:
        if look.falling:
            climb = up(look)
            return climb._replace(text=f"Not so steep! {climb.text}, until the nose points up")
        name, advice = WORDS[self._side], self._sinking(look, WAY)
        if advice.push * self._side < 0:
            return advice._replace(text=f"{advice.text}: the nose is too low")
        return completed(advice, f"until the nose points {name}", f"it flies {name}, to the edge")

    def _down(self, look: Observation) -> Advice:
        advice = self._sinking(look, 0.0)
        if advice.push:
            lower = advice.push * self._side > 0
            why = "the nose a little lower" if lower else "raise the nose, it sinks too fast"
            return advice._replace(text=f"{advice.text}: {why}")
        return advice._replace(text="Let go: at the edge it sinks softly by itself")

    def _sinking(self, look: Observation, to: float) -> Advice:
        """Out of the window, the nose as far below the horizontal as it is above `to` [deg]."""
        below = 0.6 * (look.sight.elevation - radians(to))
        below = max(-CLIMB, min(SINK, below)) + self._pressed
        return stick(look, self._side * (pi / 2 + below), self._side * pi / 4)


EDGE, WAY = 64.0, 28.0
"""deg: azimuth beyond which the pull fades; elevation of the way there."""
SINK, CLIMB = 0.2, 0.5
"""rad; of the nose below and above the horizontal, at most. Steeper is no landing any more."""
STILL = 1.0
"""m/s; a kite of much drag hangs at its edge."""
SINKING, PRESS, DEEPEST = 1.0, 0.15, 0.6
"""m/s down at the edge; rad/s of the nose for each m/s that is missing, and rad at most."""
