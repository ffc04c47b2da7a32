"""The instruments over the picture: which are shown in each depth, and the place of each.

Red is the pilot's left (A₊), blue the pilot's right (A₋), as on the kite; letters and places
say so too.
"""

import numpy as np
import pygame

from kitemj.controls.actions import PANELS
from kitemj.drawing import head_up, strip_chart, wind_window
from kitemj.drawing.alarms import Alarm, alarm_at, loudness
from kitemj.drawing.colours import WHITE
from kitemj.drawing.flight_panels import (
    paint_air,
    paint_arrows,
    paint_flight,
    paint_model,
    window_title,
)
from kitemj.drawing.head_up import paint_chips, paint_head_up
from kitemj.drawing.knob import paint_knob
from kitemj.drawing.lesson_panel import beside, paint_lesson, paint_touch
from kitemj.drawing.panel import NAME, Panel, Place, box_of
from kitemj.drawing.readings import Readings
from kitemj.drawing.strip_chart import paint_chart
from kitemj.drawing.tensions import paint_tensions, scale_of
from kitemj.drawing.toast import paint_alarm, paint_message, told
from kitemj.drawing.wind_window import NO_TRAIL, WindWindow
from kitemj.dynamics.motion import Motion
from kitemj.physics.parameters import Parameters

MARGIN, GAP = 12, 10
STRIP = 124  # height of the engineer's plates along the bottom
COLUMN = 292  # width of those at the sides
INSET_FOOT = 176  # where the small view ends
WINDOW_TOP, WINDOW_FOOT = 20, 4  # rows for the window's title and below its letters


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
        depth: str = "pilot",
        shown: set[str] | frozenset[str] = frozenset(PANELS),
    ) -> None:
        """Paints the instruments of a depth, and in each but "none" what must be said.

        surface: the frame
        motion: the kite
        readings: what is shown besides
        depth: a name of `actions.DEPTHS`
        shown: the engineer's panels, and "arrows" where the picture has any
        """
        self.taken, traces = [], readings.traces
        if depth == "none":
            return
        twist = traces.twist if traces else 0.0
        alarm = alarm_at(self.parameters, motion, twist) or (traces.alarm if traces else None)
        if readings.touch and readings.touch.gentle:
            alarm = None  # a kite that was landed is where it was meant to be
        if depth == "pilot":
            self._paint_head_up(surface, motion, readings)
        else:
            self._paint_panels(surface, motion, readings, alarm, set(shown))
        self._say(surface, readings, None if readings.touch else alarm, depth)

    def _paint_head_up(self, surface: pygame.Surface, motion: Motion, readings: Readings) -> None:
        panel = Panel(surface, self._boxes["head up"], self.u)
        panel.ground()
        paint_head_up(panel, self.parameters.limits, self._window, self._pulls, motion, readings)
        self.taken = [panel.box, *paint_chips(panel, readings)]

    def _paint_panels(
        self,
        surface: pygame.Surface,
        motion: Motion,
        readings: Readings,
        alarm: Alarm | None,
        shown: set[str],
    ) -> None:
        traces = readings.traces
        timed = readings.missed_ticks or (traces and np.isfinite(traces.lateness).any())
        # where nobody keeps time the chart has nothing to show
        for name in (*PANELS, "arrows"):
            if name in shown and (timed or name != "chart"):
                self._paint_panel(name, surface, motion, readings, loudness(alarm, name))
                self.taken.append(self.box(name))

    def _say(
        self, surface: pygame.Surface, readings: Readings, alarm: Alarm | None, depth: str
    ) -> None:
        """Paints the lesson at the foot, a touch of the ground high, alarm and message beside."""
        room, u, top = self.room(depth), self.u, depth == "engineer"

        def take(box: pygame.Rect) -> pygame.Rect:
            self.taken.append(box)
            return beside(room, box, u)

        lesson = readings.lesson
        if lesson and not (readings.touch and lesson.down):  # else the card has its advice
            room = take(paint_lesson(surface, room, u, lesson))
        if readings.touch:
            room = take(paint_touch(surface, room, u, readings.touch, lesson))
        if alarm := told(alarm):
            room = take(paint_alarm(surface, room, u, alarm, numbers=top, top=top))
        if readings.message and not (alarm and readings.message == alarm.departure.limit.sentence):
            take(paint_message(surface, room, u, readings.message, top))

    def box(self, name: str) -> pygame.Rect:
        """The box of a panel in the frame [px], painted or not."""
        return box_of(self._boxes[name], self.u)

    def room(self, depth: str) -> pygame.Rect:
        """The box where something may be said [px]: below the kite, between the instruments."""
        u, foot = self.u, MARGIN
        left, right = MARGIN, MARGIN + head_up.WIDTH + GAP
        if depth == "engineer":
            left = right = MARGIN + COLUMN + GAP
            foot = MARGIN + STRIP + GAP
        wide, tall = self.width - (left + right) * u, self.height - (foot + MARGIN) * u
        return pygame.Rect(round(left * u), round(MARGIN * u), round(wide), round(tall))

    def _layout(self) -> dict[str, Place]:
        """The place of each panel by name."""
        u = self.u
        wide, tall = self.width / u, self.height / u
        right, strip = wide - COLUMN - MARGIN, tall - STRIP - MARGIN
        third = (wide - 2 * MARGIN - 2 * GAP) / 3
        window = wind_window.HEIGHT + WINDOW_TOP + WINDOW_FOOT
        chart = INSET_FOOT + GAP + window + GAP
        places = {
            "flight": (MARGIN, MARGIN, COLUMN, 200),
            "air": (MARGIN, 222, COLUMN, 160),
            "arrows": (MARGIN, 392, COLUMN, 64),
            "window": (right, INSET_FOOT + GAP, COLUMN, window),
            "chart": (right, chart, COLUMN, strip_chart.HEIGHT),
            "lines": (MARGIN, strip, third, STRIP),
            "knob": (MARGIN + third + GAP, strip, third, STRIP),
            "model": (MARGIN + 2 * (third + GAP), strip, third, STRIP),
            "inset": (right, MARGIN, COLUMN, INSET_FOOT - MARGIN),
            "head up": (
                wide - head_up.WIDTH - MARGIN,
                tall - head_up.HEIGHT - MARGIN,
                head_up.WIDTH,
                head_up.HEIGHT,
            ),
        }
        return {name: (x * u, y * u, w, h) for name, (x, y, w, h) in places.items()}

    def _paint_panel(
        self, name: str, surface: pygame.Surface, motion: Motion, readings: Readings, alarm: int
    ) -> None:
        panel, traces = Panel(surface, self._boxes[name], self.u), readings.traces
        panel.ground(alarm)
        if name == "window":
            self._paint_window(panel, motion, readings)
        elif name == "chart":
            paint_chart(panel, traces, readings.missed_ticks, readings.lateness)
        elif name == "flight":
            paint_flight(panel, self.parameters, motion, readings, alarm)
        elif name == "air":
            paint_air(panel, self.parameters, motion, alarm)
        elif name == "lines":
            paint_tensions(panel, self.parameters, self._pulls, motion, alarm)
        elif name == "knob":
            wish, most = readings.delta_command, self.parameters.stick.delta
            paint_knob(panel, motion.control.delta, wish, most, readings.law)
        elif name == "arrows":
            paint_arrows(panel, self.parameters)
        else:
            paint_model(panel, self.parameters, readings, alarm)

    def _paint_window(self, panel: Panel, motion: Motion, readings: Readings) -> None:
        """Paints the wind window with its title, its sides and what its rim is."""
        below = Panel(panel.surface, (*panel.at(0, WINDOW_TOP), COLUMN, 0), panel.unit)
        trail = readings.traces.trail if readings.traces else NO_TRAIL
        self._window.paint(below, motion, trail, readings.wished)
        panel.text(window_title(readings), 14, 20)
        foot = WINDOW_TOP + wind_window.FOOT[1] + 20
        panel.text("L left", 14, foot, NAME, WHITE)
        panel.text("right R", panel.width - 14, foot, NAME, WHITE, 1)
