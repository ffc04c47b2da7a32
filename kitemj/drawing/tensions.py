"""The tensions as bars that a pilot flies by; a slack line says so in place of its bar.

A bar grows with the square root of the tension, as the airspeed does: a line that is about to go
slack is seen as well as one that pulls hard. Its marks are the pull at rest and that at twice,
three times, ... the airspeed; the largest tension allowed has one where a flight may come near.
"""

from math import inf, sqrt
from typing import NamedTuple

from kitemj.drawing.colours import BAD, CALL, INK, LEFT, RIGHT, TROUGH, WHITE
from kitemj.drawing.panel import EDGE, GAP, LARGE, NAME, NUMBER, Panel
from kitemj.drawing.plates import NOW
from kitemj.dynamics.motion import Motion
from kitemj.flight.equilibrium import pull_at_rest
from kitemj.flight.limits import OVERLOAD, SLACK, Numbers
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import rig_of
from kitemj.physics.vectors import norm

BAR = 74.0  # where it begins
ROOM = 206.0  # how long it is
TOP, ROWS = 34.0, 66.0  # where the rows of lines begin, and how tall they are together
HANGS = 1e-3  # m that a line is longer than its distance
FASTEST = 5
"""Times the airspeed at rest: where a bar ends. No kite with L/D below 5 comes to fly faster."""
HEAD, FEET = 20.0, 112.0  # rows of the title and of what is written under the marks
LETTERS = 9  # of a line's name, at most


class Scale(NamedTuple):
    """The scale of the bars: pull at rest (infinite: it cannot rest) and at a bar's end [N]."""

    rest: float
    full: float

    def share(self, tension: float) -> float:
        """The part of the bar, 0..1, that `tension` [N] fills."""
        return min(sqrt(max(tension, 0.0) / self.full), 1.0)


def scale_of(parameters: Parameters) -> Scale:
    """The scale for a set in its own wind; up to the largest tension allowed, or less."""
    rest = pull_at_rest(parameters) or inf
    return Scale(rest, min(FASTEST**2 * rest, parameters.limits.tension_max))


def paint_tensions(
    panel: Panel, parameters: Parameters, scale: Scale, motion: Motion, alarm: int
) -> None:
    """Paints the panel of tensions."""
    _title(panel, scale, parameters.limits.tension_max)
    names = ("left", "right", *rig_of(parameters).lines[2:])
    pitch = ROWS / len(names)
    half = 0.325 * pitch  # of a bar's height
    for i, (name, line) in enumerate(zip(names, motion.lines, strict=True)):
        row, colour = TOP + (i + 0.5) * pitch, (LEFT, RIGHT, WHITE)[min(i, 2)]
        tension, hangs = line.tension_kite, line.length - norm(line.points[-1])
        slack = hangs > HANGS or not SLACK.kept(parameters.limits, Numbers((tension,)))
        over = not OVERLOAD.kept(parameters.limits, Numbers((tension,)))
        _name(panel, name, row)
        panel.bar(BAR, row - half, ROOM, 2 * half, TROUGH)
        if slack:
            panel.bar(BAR, row - half, ROOM, 2 * half, CALL)
            panel.text(f"SLACK  {max(hangs, 0.0):.2f} m", BAR + ROOM / 2, row, NAME, INK, 0.5)
        else:
            share = scale.share(tension)
            panel.bar(BAR, row - half, share * ROOM, 2 * half, BAD if over else colour)
            _marks(panel, scale, parameters.limits.tension_max, row, half)
        beyond = slack or over
        most, colour = LARGE if beyond and alarm == NOW else NUMBER, CALL if beyond else WHITE
        size = panel.fitting(newtons(tension), most, panel.width - BAR - ROOM - EDGE - GAP)
        panel.text(newtons(tension), panel.width - EDGE, row, size, colour, 1)


def _title(panel: Panel, scale: Scale, most: float) -> None:
    """Writes what the bars are, and the pull at rest under its mark."""
    panel.text(f"lines' pull, at most {most:.0f} N", EDGE, HEAD)
    if scale.rest < scale.full:
        rest = f"rest {scale.rest:.{2 if scale.rest < 9.5 else 3}g} N"
        panel.text(rest, BAR + scale.share(scale.rest) * ROOM, FEET, align=0.5)


def _marks(panel: Panel, scale: Scale, most: float, row: float, half: float) -> None:
    """Marks rest, twice, three times, ... its airspeed, and `most`; tall ones rest and `most`."""
    pulls = [times**2 * scale.rest for times in range(1, FASTEST + 1)]
    for pull in (*(pull for pull in pulls if pull < most), most):
        tall = 2 * (half + 3) if pull in (scale.rest, most) else 8
        if pull <= scale.full:
            x = BAR + scale.share(pull) * ROOM - 1
            panel.bar(x, row + half + 3 - tall, 2, tall, WHITE)


def _name(panel: Panel, name: str, row: float) -> None:
    """Writes a line's name into the room before its bar; a long one is smaller, and cut."""
    shown = name if len(name) <= LETTERS else f"{name[: LETTERS - 1]}…"
    panel.text(shown, EDGE, row, panel.fitting(shown, NAME, BAR - EDGE - 6), WHITE)


def newtons(tension: float) -> str:
    """A tension [N] as text."""
    return f"{tension:.1f} N" if abs(tension) < 99.95 else f"{tension:.0f} N"
