"""What a pilot looks at while flying: airspeed, time, the wind window, the pull of each line.

One plate in a corner. The left line's bar stands on the left, the right line's on the right, and
each has its letter; a bar ends at the largest pull that is allowed, or five times the airspeed
at rest, and its mark is the pull at rest.
"""

import pygame

from kitemj.drawing.colours import BAD, CALL, DIM, LEFT, RIGHT, TROUGH, WHITE, Colour
from kitemj.drawing.panel import Panel
from kitemj.drawing.readings import Readings
from kitemj.drawing.tensions import HANGS, Scale
from kitemj.drawing.wind_window import FOOT, NO_TRAIL, RADIUS, WindWindow
from kitemj.dynamics.motion import LineState, Motion
from kitemj.flight.limits import OVERLOAD, SLACK, Numbers
from kitemj.physics.parameters import Limits
from kitemj.physics.vectors import norm

WIDTH, HEIGHT = 288.0, 192.0
SMALLER = 0.78  # the wind window, of its own size
FLOOR = 156.0  # where it and the bars stand
TALL, THICK = SMALLER * RADIUS, 7.0  # of a bar
BESIDE = 22.0  # from the plate's edge to the middle of a bar
FASTER = 23.0  # digits of the airspeed
NAME = 16.0  # digits of all else
CHIP = 26.0  # the height of a word above the plate


def paint_head_up(
    panel: Panel,
    limits: Limits,
    window: WindWindow,
    scale: Scale,
    motion: Motion,
    readings: Readings,
) -> None:
    """Paints the plate's content.

    panel: the plate
    limits: of the set that flies
    window: paints the wind window
    scale: of the bars
    motion: the kite
    readings: the trail
    """
    minutes, seconds = divmod(int(motion.t), 60)
    speed = f"{motion.air.speed:.1f}"
    panel.text(speed, 16, 28, FASTER, WHITE, bold=True)
    panel.text("m/s", 22 + panel.wide(speed, FASTER, True), 32, NAME)
    panel.text(f"{minutes}:{seconds:02}", WIDTH - 16, 30, NAME + 2, WHITE, 1)
    x, y = panel.at(WIDTH / 2 - SMALLER * FOOT[0], FLOOR - SMALLER * FOOT[1])
    small = Panel(panel.surface, (x, y, 0, 0), SMALLER * panel.unit)
    trail = readings.traces.trail if readings.traces else NO_TRAIL
    window.paint(small, motion, trail, readings.wished)
    for side, line, colour in ((0, motion.lines[0], LEFT), (1, motion.lines[1], RIGHT)):
        _pull(panel, limits, scale, line, side, colour)


def _pull(
    panel: Panel, limits: Limits, scale: Scale, line: LineState, side: int, colour: Colour
) -> None:
    """Paints a line's bar with its letter and number.

    panel: the plate
    limits: of the set that flies
    scale: of the bar
    line: its state
    side: 0 is left, 1 right
    colour: of the bar
    """
    tension, letter = line.tension_kite, "LR"[side]
    slack = line.length - norm(line.points[-1]) > HANGS or not SLACK.kept(
        limits, Numbers((tension,))
    )
    over = not OVERLOAD.kept(limits, Numbers((tension,)))
    middle = BESIDE + side * (WIDTH - 2 * BESIDE)
    panel.bar(middle - THICK / 2, FLOOR - TALL, THICK, TALL, TROUGH)
    full = TALL * (1.0 if over else scale.share(tension))
    if not slack:
        panel.bar(middle - THICK / 2, FLOOR - full, THICK, full, BAD if over else colour)
    if scale.rest < scale.full:
        rest = FLOOR - TALL * scale.share(scale.rest)
        panel.bar(middle - THICK / 2 - 3, rest - 1, THICK + 6, 2, WHITE)
    edge = 16 + side * (WIDTH - 32)
    told = "slack" if slack else f"{tension:.0f} N"
    inwards = panel.wide(letter, NAME, True) + 8
    panel.text(letter, edge, FLOOR + 20, NAME, WHITE, side, True)
    place = edge + inwards * (1 - 2 * side)
    panel.text(told, place, FLOOR + 20, NAME, CALL if slack or over else DIM, side)


def chips(readings: Readings) -> list[str]:
    """Words that stand above the plate while they are true."""
    found = ["ASSIST"] if readings.assist else []
    if readings.wished:
        guided = readings.wished.guided
        found.append(f"AUTOPILOT: {guided.phase}" if guided else "AUTOPILOT")
    if readings.speed == 0.0:
        found.append("PAUSED")
    elif readings.speed != 1.0:
        found.append(f"×{readings.speed:.3g}")
    return found


def paint_chips(panel: Panel, readings: Readings) -> list[pygame.Rect]:
    """Paints them, from the right end of the plate `panel` to the left; their boxes [px]."""
    right, boxes = WIDTH, []
    for word in chips(readings):
        wide = panel.wide(word, NAME, True) + 22
        x, y = panel.at(right - wide, -CHIP - 8)
        chip = Panel(panel.surface, (x, y, wide, CHIP), panel.unit)
        chip.ground()
        chip.text(word, wide / 2, CHIP / 2, NAME, CALL, 0.5, True)
        right -= wide + 8
        boxes.append(chip.box)
    return boxes
