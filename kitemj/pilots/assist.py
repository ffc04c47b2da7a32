"""The assist: a pilot between the hand and the lines, who makes a stick ask for turns.

The stick asks for how fast the nose turns, all of it for a loop; with the hands off the nose
goes up and the kite back to the top of the window, as with the pilot `Hold`. Near the ground
it refuses a dive: where the kite, its nose turned up at once to whichever side is better, would
come out too low, it is turned up. Nothing else is kept from the hand, and nothing but the lines
is moved. A stick that is thrown about at full can still reach the ground.

Written for kites of 1 to 2 m on lines of 20 to 25 m, as the sets `sport` and `trainer`, in 5 to
8 m/s; the numbers are theirs, and no more exact than a pilot's.
"""

from math import cos, pi, sin

from kitemj.dynamics.motion import Motion
from kitemj.flight.live import Command
from kitemj.physics.vectors import Vector, norm, plus, times, unrotated
from kitemj.pilots.sight import LEFT, RIGHT, Sight, sight, turned

FULL = 2.5
"""rad/s that full stick asks for: a loop in 2.5 s."""
FORWARD, EASE = 4.5, 2.0
"""m; stick for each rad/s of the asked turn, and of what is missing of it, times the air's
speed [m/s]: at full stick a kite of 2 m flies circles of 4 to 6 m."""
LEVEL = 1.0
"""1/s; hands off, the nose turns up so much for each rad."""
LEAN, STEEP = 0.5, pi / 4
"""rad to the middle for each rad of azimuth, and at most."""
OFF = 0.2
"""Of the stick's way; up to there the hand takes over from hands off."""

CLEAR, FADE = 0.2, 0.5
"""s of flight: the height that is kept, and above it that over which the refusal fades."""
HARD = 6.0
"""rad/s that a refusal asks for, which is full stick."""
DEAD, LAG, RADIUS, MOST = 0.15, 0.5, 6.0, 3.0
"""s, s, m, rad/s: a full stick does nothing at first, then turns the nose by and by, on which
circle, how fast at most."""
DIVE = 0.35
"""1/m; of the square of the wind: what a kite gains straight down [m/s²]."""
KEEP = 1.0
"""m for each rad/s; by so much the side is better to which the nose turns already."""
STAY = 2.0
"""m; and by so much that of a refusal: who changes his mind in a dive turns neither way."""
HANDS = 1.5
"""rad/s of δ; how fast hands that pull the other way come over."""
STEP, LONG = 0.1, 2.5
"""s; of the look ahead."""


class Assist:
    """Flies what `hand` asks for, in -1..1, right positive; 0 is hands off."""

    def __init__(self) -> None:
        self.hand = 0.0
        self._refused = 0.0  # to which side the nose was turned up just now, if it was

    def command(self, motion: Motion) -> Command:
        """Where the stick is now, for what is seen in `motion`."""
        seen = sight(motion)
        speed = max(motion.air.speed, 1.0)
        low = {side: lowest(motion, seen, side) for side in (LEFT, RIGHT)}
        free = max(0.0, min(1.0, (max(low.values()) - CLEAR * speed) / (FADE * speed)))
        better = low[RIGHT] - low[LEFT] + KEEP * seen.turning + STAY * self._refused
        side = RIGHT if better > 0.0 else LEFT
        self._refused = side if free < 1.0 else 0.0
        off = max(0.0, 1.0 - abs(self.hand) / OFF)
        rate = FULL * self.hand + off * level(seen, side)
        rate = free * rate + (1.0 - free) * side * HARD * min(1.0, abs(seen.heading))
        push = FORWARD * rate + EASE * (rate - seen.turning)
        return Command(max(-1.0, min(1.0, push / speed)))


def level(seen: Sight, side: float) -> float:
    """The turn [rad/s] of a nose that goes up, leaning to the middle; from below by that `side`."""
    wish = max(-STEEP, min(STEEP, -LEAN * seen.azimuth))
    rate = LEVEL * turned(wish - seen.heading, side * pi / 2)
    return max(-FULL, min(FULL, rate))


def lowest(motion: Motion, seen: Sight, side: float) -> float:
    """The least height [m] of a kite whose nose is turned up to one `side` from now on."""
    height, speed = -motion.body.p_G_E.z, motion.air.speed
    heading, turning, least, left = seen.heading, seen.turning, height, LONG
    dead = DEAD + max(0.0, -side * motion.control.delta) / HANDS
    gain = DIVE * wind(motion) ** 2
    while left > 0.0 and not (cos(heading) > 0.0 and side * sin(heading) < 0.0 < side * turning):
        if left < LONG - dead:
            turning += (side * min(MOST, speed / RADIUS) - turning) * STEP / LAG
        heading += turning * STEP
        speed -= gain * cos(heading) * STEP
        height += speed * cos(heading) * STEP
        least, left = min(least, height), left - STEP
    return least


def wind(motion: Motion) -> float:
    """Its speed [m/s] at the kite."""
    (alpha, beta, speed), (_, R_BE, v_G_E, _) = motion.air, motion.body
    through = Vector(cos(alpha) * cos(beta), sin(beta), sin(alpha) * cos(beta))
    return norm(plus(v_G_E, times(-speed, unrotated(R_BE, through))))
