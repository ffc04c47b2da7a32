"""The tensions as bars up to the largest allowed; a slack line says so in place of its bar.

The bar grows with the square root of the tension: a line that is about to go slack and one
that is about to break are both seen. Marks stand at 1/16, 1/4, 9/16 and all of the ceiling.
"""

from math import sqrt

from kitemj.drawing.colours import BAD, CALL, INK, LEFT, RIGHT, TROUGH, WHITE
from kitemj.drawing.panel import LARGE, NOW, NUMBER, Panel
from kitemj.dynamics.motion import Motion
from kitemj.flight.limits import OVERLOAD, SLACK, Numbers
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import rig_of
from kitemj.physics.vectors import norm

BAR = 74.0  # where it begins
ROOM = 206.0  # how long it is
TOP, ROWS = 32.0, 80.0  # where the rows of lines begin, and how tall they are together
HANGS = 1e-3  # m that a line is longer than its distance


def paint_tensions(panel: Panel, parameters: Parameters, motion: Motion, alarm: int) -> None:
    """Paints the panel of tensions."""
    limits, ceiling = parameters.limits, parameters.limits.tension_max
    panel.text("LINES", 12, 20)
    panel.text(f"{ceiling / 4:.0f}", BAR + ROOM / 2, 20, align=0.5)
    panel.text(f"max {ceiling:.0f} N", BAR + ROOM - 44, 20)
    names = ("left", "right", *rig_of(parameters).lines[2:])
    pitch = ROWS / len(names)
    half = 0.325 * pitch  # of a bar's height
    for i, (name, line) in enumerate(zip(names, motion.lines, strict=True)):
        row, colour = TOP + (i + 0.5) * pitch, (LEFT, RIGHT, WHITE)[min(i, 2)]
        tension, hangs = line.tension_kite, line.length - norm(line.points[-1])
        slack = hangs > HANGS or not SLACK.kept(limits, Numbers((tension,)))
        over = not OVERLOAD.kept(limits, Numbers((tension,)))
        panel.text(name, 12, row, colour=WHITE if alarm == NOW else colour)
        panel.bar(BAR, row - half, ROOM, 2 * half, TROUGH)
        if slack:
            panel.bar(BAR, row - half, ROOM, 2 * half, CALL)
            panel.text(f"SLACK  {max(hangs, 0.0):.2f} m", BAR + ROOM / 2, row, 18, INK, 0.5)
        else:
            share = min(sqrt(max(tension, 0.0) / ceiling), 1.0)
            panel.bar(BAR, row - half, share * ROOM, 2 * half, BAD if over else colour)
        for quarter in (1, 2, 3, 4):
            tall = 2 * (half + 3) if quarter == 4 else 8
            panel.bar(BAR + quarter / 4 * ROOM - 1, row + half + 3 - tall, 2, tall, WHITE)
        value = f"{tension:.1f} N" if abs(tension) < 99.95 else f"{tension:.0f} N"
        colour, size = (CALL, LARGE - 2) if slack or over else (WHITE, NUMBER)
        panel.text(value, panel.width - 10, row, size if alarm == NOW else NUMBER, colour, 1)
