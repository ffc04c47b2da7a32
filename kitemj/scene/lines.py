"""Lines from the hands to the kite, slack ones too, and the bridle at their end."""

from collections.abc import Sequence
from itertools import accumulate, chain, pairwise, repeat
from math import sqrt

import numpy as np

from kitemj.dynamics.motion import LineState, Motion, attachment_E
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, minus, norm, plus, times, unrotated
from kitemj.scene.cloth import BLUE, DARK, RED, Cloth, Colour
from kitemj.scene.figure import Hands
from kitemj.scene.strokes import Strokes

COLOURS = (RED, BLUE)  # of the first lines, the pilot's left and right; others: DARK
EDGE = 2  # px by which the dark line below is wider: one of the two is seen against anything
EDGE_SHADE = 0.3
DETAIL = 80.0  # px of span from which thin things are drawn
SAG_PIECES = 16
SLACK = 1e-4  # m, a line longer than its distance by more hangs


def add_lines(
    strokes: Strokes,
    motion: Motion,
    hands: Hands,
    width: float,
    colour: Colour | None = None,
) -> None:
    """Draws all lines from the hands on, `width` px wide, in their own colours or in `colour`."""
    between = times(0.5, plus(*hands))
    starts, colours = chain(hands, repeat(between)), chain(COLOURS, repeat(DARK))
    for line, start, own in zip(motion.lines, starts, colours, strict=False):
        points = drawn(line, start)
        if colour is None:
            red, green, blue = own
            edge = EDGE_SHADE * red, EDGE_SHADE * green, EDGE_SHADE * blue
            strokes.line(points, width + EDGE, edge)
        strokes.line(points, width, colour or own)


def add_bridle(
    strokes: Strokes, parameters: Parameters, motion: Motion, cloth: Cloth, seen: float
) -> None:
    """Draws the bridle's legs, from the attachments to the sail, and the rods of its frame.

    Not where they would hide the sail: `seen` is its span in px.
    """
    if seen < DETAIL:
        return
    body = motion.body
    to_E = np.array(body.R_BE)
    strokes.lines(cloth.rods @ to_E + body.p_G_E, 1.0 if seen < 2 * DETAIL else 2.0, DARK)
    left, right = (attachment_E(parameters, body, side) for side in (1.0, -1.0))
    ends = cloth.bridle @ to_E + body.p_G_E
    knots = np.where(cloth.bridle[:, 1:2] > 0, left, right)
    strokes.lines(np.stack([knots, ends], axis=1), 1.0, DARK)


def drawn(line: LineState, start: Vector) -> list[Vector]:
    """Points [m, E] of a line that begins at `start`; what that is off O_E fades to the kite."""
    points: Sequence[Vector] = line.points
    if len(points) == 2 and line.length > norm(points[-1]) + SLACK:
        points = hanging(points[-1], line.length)
    ways = list(accumulate((norm(minus(b, a)) for a, b in pairwise(points)), initial=0.0))
    return [
        plus(p, times(1 - way / (ways[-1] or 1.0), start))
        for p, way in zip(points, ways, strict=True)
    ]


def hanging(end: Vector, length: float) -> list[Vector]:
    """Points [m, E] of a slack line of `length` [m] from O_E to `end`, not below the ground.

    A parabola in place of the catenary. Its depth below the middle of a level line of
    span d is sqrt(3/8 d (L - d)); a slope lets it hang deeper, to a limit for the eye.
    """
    distance = norm(end)
    level = max(sqrt(end.x * end.x + end.y * end.y) / distance, 0.25)
    depth = sqrt(max(0.375 * distance * (length - distance), 0.0)) / level
    shares = [i / SAG_PIECES for i in range(SAG_PIECES + 1)]
    heights = [min(s * end.z + 4 * depth * s * (1 - s), 0.0) for s in shares]
    return [Vector(s * end.x, s * end.y, z) for s, z in zip(shares, heights, strict=True)]


def from_body(motion: Motion, p_B: Vector) -> Vector:
    """A point of the kite [m, E]."""
    return plus(motion.body.p_G_E, unrotated(motion.body.R_BE, p_B))
