"""The instruments over the picture: the place of each, and which are shown.

Red is the pilot's left (A₊), blue the pilot's right (A₋), as on the kite.
"""

from math import degrees

import numpy as np
import pygame

from kitemj.controls.actions import PANELS
from kitemj.drawing import strip_chart, wind_window
from kitemj.drawing.alarms import Alarm, alarm_at, loudness, paint_banner
from kitemj.drawing.colours import CALL, DIM, GOOD, LEFT, RIGHT, TROUGH, WHITE
from kitemj.drawing.knob import paint_knob
from kitemj.drawing.lesson_panel import beside, paint_lesson, paint_touch
from kitemj.drawing.panel import LARGE, NAME, NOW, NUMBER, Panel, Place, box_of
from kitemj.drawing.readings import Readings
from kitemj.drawing.strip_chart import paint_chart
from kitemj.drawing.tensions import paint_tensions, scale_of
from kitemj.drawing.text import width
from kitemj.drawing.wind_window import WindWindow, bearing
from kitemj.dynamics.motion import Motion
from kitemj.flight.limits import SIDESLIP, STALL, TWIST, Numbers
from kitemj.physics.parameters import Parameters
from kitemj.scene.forces import newtons_per_metre

MARGIN = 12
STRIP = 118  # height of the strip along the bottom
INSET_FOOT = 240  # where the small view ends, in units
GAP_UNITS = ((1.0, "m"), (1e-3, "mm"), (1e-6, "µm"), (0.0, "nm"))  # from this on, in metres
NO_TRAIL = np.empty((0, 3))


class Instruments:
    """Paints the panels for one parameter set into frames of `width` x `height` pixels."""

    def __init__(self, parameters: Parameters, width: int, height: int) -> None:
        """Sizes follow the height; a frame of 720 rows has them as they are written here."""
        self.parameters, self.width, self.height = parameters, width, height
        self.u = min(height / 720, width / 1280)
        self._window, self._pulls = WindWindow(parameters), scale_of(parameters)
        self._boxes = self._layout()
        self.taken: list[pygame.Rect] = []
        """The boxes of all that is painted in the last frame [px]."""

    def paint(
        self,
        surface: pygame.Surface,
        motion: Motion,
        readings: Readings,
        shown: set[str],
        near: bool = True,
    ) -> None:
        """Paints the panels named in `shown`, and what must be seen; the surface is the frame.

        From `near` the kite is low in the frame, else high: the banner is where it is not.
        """
        traces = readings.traces
        timed = readings.missed_ticks or (traces and np.isfinite(traces.lateness).any())
        # where nobody keeps time the chart has nothing to show
        names = [name for name in PANELS if name in shown and (timed or name != "chart")]
        twist = traces.twist if traces else 0.0
        alarm = alarm_at(self.parameters, motion, twist) or (traces.alarm if traces else None)
        if readings.touch and readings.touch.gentle:
            alarm = None  # a kite that was landed is where it was meant to be
        # the panel that alarms comes last, so that its frame lies over its neighbours
        for name in sorted(names, key=lambda name: loudness(alarm, name)):
            self._paint_panel(name, surface, motion, readings, loudness(alarm, name))
        self.taken = [self.box(name) for name in names]
        self._say(surface, readings, None if readings.touch else alarm, near)

    def _say(
        self, surface: pygame.Surface, readings: Readings, alarm: Alarm | None, near: bool
    ) -> None:
        """Paints lesson, touch of the ground, message and alarm, as there is room."""
        room, u = self._room(near), self.u
        if readings.lesson:
            self.taken.append(paint_lesson(surface, room, u, readings.lesson, near))
            room = beside(room, self.taken[-1], u)
        self.taken.append(paint_banner(surface, room, u, alarm, readings.message, near))
        if readings.touch:
            if readings.message:
                room = beside(room, self.taken[-1], u)
            self.taken.append(paint_touch(surface, room, u, readings.touch))

    def box(self, name: str) -> pygame.Rect:
        """The box of a panel in the frame [px], painted or not."""
        return box_of(self._boxes[name], self.u)

    def _room(self, near: bool) -> pygame.Rect:
        """The box where the banner may be [px]: between the panels, above or below."""
        u = self.u
        left, right = (318, 410) if near else (440, 316)
        wide, tall = self.width - (left + right) * u, self.height - (STRIP + 10 + MARGIN) * u
        return pygame.Rect(round(left * u), round(MARGIN * u), round(wide), round(tall))

    def _layout(self) -> dict[str, Place]:
        """The place of each panel by name."""
        u, left, top = self.u, MARGIN * self.u, self.height - STRIP * self.u
        right, third = self.width - (292 + MARGIN) * u, self.width / 3
        chart = INSET_FOOT + wind_window.HEIGHT + MARGIN
        return {
            "flight": (left, MARGIN * u, 290, 216),
            "air": (left, 240 * u, 290, 132),
            "window": (right, INSET_FOOT * u, wind_window.WIDTH, wind_window.HEIGHT),
            "chart": (right, chart * u, strip_chart.WIDTH, strip_chart.HEIGHT),
            "lines": (0.0, top, third / u, STRIP),
            "knob": (third, top, third / u, STRIP),
            "model": (2 * third, top, third / u, STRIP),
        }

    def _paint_panel(
        self, name: str, surface: pygame.Surface, motion: Motion, readings: Readings, alarm: int
    ) -> None:
        panel, traces = Panel(surface, self._boxes[name], self.u), readings.traces
        panel.ground(alarm)
        if name == "window":
            self._window.paint(panel, motion, traces.trail if traces else NO_TRAIL)
        elif name == "chart":
            paint_chart(panel, traces, readings.missed_ticks, readings.lateness)
        elif name == "flight":
            self._flight(panel, motion, readings, alarm)
        elif name == "air":
            self._air(panel, motion, alarm)
        elif name == "lines":
            paint_tensions(panel, self.parameters, self._pulls, motion, alarm)
        elif name == "knob":
            wish, most = readings.delta_command, self.parameters.stick.delta
            paint_knob(panel, motion.control.delta, wish, most, readings.law)
        else:
            self._model(panel, readings, alarm)

    def _flight(self, panel: Panel, motion: Motion, readings: Readings, alarm: int) -> None:
        azimuth, elevation = bearing(self.parameters, motion.body.p_G_E)
        right = panel.width - 14
        panel.text(f"{motion.t:.1f} s", 14, 28, 28, WHITE)
        panel.text(f"speed ×{readings.speed:.3g}", right, 28, align=1)
        rows = (
            ("elevation", f"{elevation:.1f}°"),
            ("azimuth", _sided(azimuth)),
            ("height", f"{-motion.body.p_G_E.z:.1f} m"),
            ("airspeed", f"{motion.air.speed:.1f} m/s"),
        )
        for i, (name, value) in enumerate(rows):
            grave = alarm == NOW and name == "height"
            panel.text(name, 14, 72 + 38 * i, colour=WHITE if alarm == NOW else DIM)
            size, colour = (LARGE, CALL) if grave else (NUMBER, WHITE)
            panel.text(value, right, 72 + 38 * i, size, colour, 1)

    def _air(self, panel: Panel, motion: Motion, alarm: int) -> None:
        """Paints α and β as marks between their limits."""
        limits, air = self.parameters.limits, motion.air
        alpha = ("α", air.alpha, limits.alpha_stall, STALL)
        beta = ("β", air.beta, limits.beta_max, SIDESLIP)
        left, wide = 14.0, panel.width - 28
        for i, (name, angle, most, limit) in enumerate((alpha, beta)):
            row, middle = 26 + 64 * i, left + wide / 2
            beyond = not limit.kept(limits, Numbers((), *air))
            panel.text(name, left, row, NUMBER, WHITE if alarm == NOW else DIM)
            size, colour = (LARGE - 2, CALL) if beyond else (NUMBER, WHITE)
            panel.text(f"{degrees(angle):.1f}°", 162, row, size, colour, 1)
            panel.text(f"max {degrees(most):.0f}°", panel.width - 14, row, align=1)
            panel.bar(left, row + 22, wide, 11, TROUGH)
            share = min(max(angle / most, -1.0), 1.0)
            start, end = sorted((middle, middle + share * wide / 2))
            panel.bar(start, row + 22, max(end - start, 3), 11, CALL if beyond else GOOD)
            panel.bar(middle - 1, row + 19, 2, 17, WHITE)

    def _model(self, panel: Panel, readings: Readings, alarm: int) -> None:
        """Paints the model, who steers, how far the reference is, how the lines are twisted."""
        right, name = panel.width - MARGIN, WHITE if alarm == NOW else DIM
        panel.text(readings.model, 24, 24, NUMBER, WHITE)
        panel.text(readings.stick, right, 24, colour=name, align=1)
        panel.text("to reference", 24, 60, colour=name)
        gap = "none" if readings.gap is None else _length(readings.gap)
        panel.text(gap, right, 60, NUMBER, WHITE, 1)
        panel.text("line twist", 24, 96, colour=name)
        twist = readings.traces.twist if readings.traces else 0.0
        turns = round(degrees(twist) / 360)
        size, colour = NUMBER, (RIGHT if turns > 0 else LEFT) if turns else WHITE
        if not TWIST.kept(self.parameters.limits, Numbers(twist=twist)):
            size, colour = LARGE, CALL
        told = f"{abs(turns)} {'right' if turns > 0 else 'left'}" if turns else "0"
        panel.text(told, right, 96, size, colour, 1)

    def legend(self, surface: pygame.Surface) -> None:
        """Paints what the arrows at the kite mean, above the strip along the bottom."""
        u, scale = self.u, f"1 m = {newtons_per_metre(self.parameters):g} N"
        names = (("air", CALL), ("weight", WHITE), ("left", LEFT), ("right", RIGHT), (scale, WHITE))
        room = sum(width(text, NAME * u) / u + 16 for text, _ in names) + 16
        foot = self.height - STRIP * u
        panel, x = Panel(surface, (0.0, foot - 36 * u, room, 36), u), 16.0
        panel.ground()
        self.taken.append(panel.box)
        for text, colour in names:
            panel.text(text, x, 18, NAME, colour)
            x += width(text, NAME * u) / u + 16


def _sided(azimuth: float) -> str:
    """An azimuth [deg] from downwind as text; positive is +y_E, the pilot's left."""
    side = "left" if azimuth > 0.05 else "right" if azimuth < -0.05 else ""
    digits = 0 if abs(azimuth) >= 9.95 else 1
    return f"{abs(azimuth):.{digits}f}° {side}".rstrip()


def _length(metres: float) -> str:
    """A length [m] as text, in the unit that suits it."""
    if 0.0 < metres < 1e-10:
        return "< 0.1 nm"
    for least, unit in GAP_UNITS:
        if metres >= least:
            number = metres / (least or 1e-9)
            return f"{number:.0f} {unit}" if number >= 100 else f"{number:.3g} {unit}"
    return "no number"
