"""The knob: δ as a dial, the stick's wish beside it, the limits, and which hand pulls."""

from math import cos, degrees, radians, sin

from kitemj.drawing.colours import CALL, DIM, LEFT, RIGHT, TROUGH, WHITE
from kitemj.drawing.panel import LARGE, NAME, Panel
from kitemj.physics.shaping import StickLaw

SWEEP = 135.0  # deg from the top to a limit; to the right for the right hand
HUB = (76.0, 64.0)
OUTER, INNER = 50.0, 35.0
ASKS = {StickLaw.RATE: "rate", StickLaw.ACCELERATION: "accel."}
LEVEL = 1e-4  # rad, hands nearer than this are level


def paint_knob(
    panel: Panel, delta: float, wish: float, limit: float, law: StickLaw = StickLaw.ANGLE
) -> None:
    """Paints the knob; δ, what the stick asks for and the limit of both in rad.

    Under another `law` the stick asks for as large a part of that limit.
    """
    colour = RIGHT if delta > LEVEL else LEFT if delta < -LEVEL else DIM
    hand = (
        "RIGHT hand pulls"
        if delta > LEVEL
        else "LEFT hand pulls"
        if delta < -LEVEL
        else "hands level"
    )
    actual, asked = (min(max(angle / limit, -1.0), 1.0) for angle in (delta, wish))
    panel.polygon(_band(-1.0, 1.0), TROUGH)
    if abs(actual) > 1e-3:
        panel.polygon(_band(min(0.0, actual), max(0.0, actual)), colour)
    for share in (-1.0, 0.0, 1.0):
        panel.line([_at(share, INNER - 2), _at(share, OUTER + 4)], DIM, 2)
    panel.line([_at(actual, 8.0), _at(actual, OUTER)], WHITE, 4)
    panel.dot(*HUB, 8, WHITE)
    tip, a, b = _at(asked, INNER - 1), _at(asked, OUTER + 7, -9.0), _at(asked, OUTER + 7, 9.0)
    panel.polygon([tip, a, b], CALL)
    for share, letter in ((-1.0, "L"), (1.0, "R")):
        panel.text(letter, *_at(share, OUTER + 16), NAME, WHITE, 0.5)
    x = HUB[0] + OUTER + 26
    panel.text(hand, x, 22, NAME, WHITE)
    panel.text(f"δ {degrees(delta):+.2f}°", x, 54, LARGE, WHITE)
    if law is StickLaw.ANGLE:
        panel.text(f"asked {degrees(wish):+.1f}°", x, 84, NAME, CALL)
    else:
        panel.text(f"asked {wish / limit:+.0%} {ASKS[law]}", x, 84, NAME, CALL)
    panel.text(f"at most ±{degrees(limit):.1f}°", x, 108)


def _at(share: float, radius: float, turned: float = 0.0) -> tuple[float, float]:
    """A point of the dial at `share` -1..1 of the way from the top to a limit."""
    turn = radians(SWEEP * share + turned)
    return HUB[0] + radius * sin(turn), HUB[1] - radius * cos(turn)


def _band(start: float, end: float) -> list[tuple[float, float]]:
    """The ring between two shares, as a polygon."""
    steps = max(round(24 * (end - start)), 2)
    shares = [start + (end - start) * i / steps for i in range(steps + 1)]
    return [_at(s, OUTER) for s in shares] + [_at(s, INNER) for s in reversed(shares)]
