"""One frame: a main view, a small other view, and the instruments over both."""

from math import atan2, cos, radians, sin

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.closing import Closing
from kitemj.controls.actions import INSTRUMENTS, VIEWS
from kitemj.drawing.help_page import paint_help
from kitemj.drawing.instruments import Instruments
from kitemj.drawing.readings import Readings
from kitemj.drawing.text import put, width
from kitemj.drawing.trail import paint_trail, seen
from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, norm, plus, times
from kitemj.physics.wind import wind_velocity
from kitemj.scene import views
from kitemj.scene.eye import Eye
from kitemj.scene.renderer import Renderer
from kitemj.scene.scenery import RINGS, ring_step
from kitemj.scene.views import Camera

RING_LABELS = {"chase": 4.0, "pilot": 62.0, "side": -15.0, "top": 38.0}  # deg, right of downwind
INSET = 0.3  # size of the small view in parts of a frame of 16:9
TRAIL = 3.0  # px of 720 rows
CLEAR = 0.5  # spans around the kite without a trail


class Picture(Closing):
    """Paints motions of one parameter set; raises `NoGraphics` where OpenGL is missing.

    A context manager. Any thread may paint, one at a time. `shown` holds the names among
    INSTRUMENTS of what is painted over the view; anyone may change it between frames.
    """

    def __init__(self, parameters: Parameters, width: int = 1280, height: int = 720) -> None:
        """Frames of `width` x `height` pixels; InputError below 320 x 180."""
        if width < 320 or height < 180:
            size = f"{width} x {height} pixels"
            raise InputError(f"a picture of {size} is too small, at least 320 x 180")
        self.parameters, self.width, self.height = parameters, width, height
        self.shown = set(INSTRUMENTS)
        self.eye = Eye(parameters)
        self._camera: Camera | None = None
        self._inset_camera: Camera | None = None
        self._renderer = Renderer(parameters, width, height)
        self._instruments = Instruments(parameters, width, height)

    def paint(
        self,
        motion: Motion,
        reference: Motion | None,
        readings: Readings,
        view: str | Camera = "pilot",
    ) -> NDArray[np.uint8]:
        """A new frame (height, width, 3), RGB, row 0 on top.

        motion: the kite
        reference: drawn translucent where it parts from the kite; None: there is none
        readings: what the instruments show besides
        view: a name of VIEWS, seen with `eye`; or the camera itself
        """
        if isinstance(view, str) and view not in VIEWS:
            raise InputError(f"there is no view {view!r}; there are: {', '.join(VIEWS)}")
        name = view if isinstance(view, str) else ""
        self._camera = self.eye.look(motion, view) if isinstance(view, str) else view
        self._inset_camera, forces = None, "forces" in self.shown
        self._renderer.render(motion, reference, self._camera, forces)
        if "inset" in self.shown:
            # the kite from near; all, if the main view is near
            other = "pilot" if self._camera.near else "chase"
            self._inset_camera = views.CAMERAS[other](self.parameters, motion)
            box = self._inset_rows()
            self._renderer.render(motion, reference, self._inset_camera, forces, box)
        frame = self._renderer.frame()
        self._letter(frame, motion, readings, name)
        return frame

    def pixel(self, p_E: Vector) -> tuple[float, float]:
        """(column, row) of the point `p_E` [m, E] in the main view of the last frame."""
        if self._camera is None:
            raise RuntimeError("pixel() needs a painted frame: call paint() first")
        place = views.pixel(self._camera, p_E, self.width, self.height)
        return place.column, place.row

    def _letter(
        self, frame: NDArray[np.uint8], motion: Motion, readings: Readings, view: str
    ) -> None:
        """Paints trail, labels and instruments into the frame itself."""
        assert self._camera is not None
        near = self._camera.near
        surface = pygame.image.frombuffer(frame.data, (self.width, self.height), "RGB")
        if readings.traces and "trail" in self.shown:
            self._trails(surface, readings.traces.trail, motion)
        if self._inset_camera:
            pygame.draw.rect(surface, (235, 238, 242), self._inset_rows().inflate(4, 4), 2)
        self._instruments.paint(surface, motion, readings, self.shown, near)
        if near and "forces" in self.shown:
            self._instruments.legend(surface)
        if "labels" in self.shown:
            self._labels(surface, motion, view)
        paint_help(surface, readings.help, self._instruments.u)

    def _trails(self, surface: pygame.Surface, trail: NDArray[np.float64], motion: Motion) -> None:
        """Paints the trail in both views, up to the kite's tail."""
        unit, inset = self._instruments.u, self._inset_rows()
        points = np.concatenate([trail, [motion.body.p_G_E]])
        # it has no depth: it must not be written across the kite
        away = np.linalg.norm(points - points[-1], axis=1)
        clear = away > CLEAR * self.parameters.kite.span
        whole = surface.get_rect()
        assert self._camera is not None
        if self._inset_camera:
            # the small view is a picture of its own: the large one's trail must not cross it
            kept = surface.subsurface(inset).copy()
        places, usable = seen(self._camera, points, whole)
        paint_trail(surface, places, usable & clear, whole, TRAIL * unit)
        if self._inset_camera:
            surface.blit(kept, inset)
            few = slice(None, None, -3)  # enough for a small picture
            places, usable = seen(self._inset_camera, points[few][::-1], inset)
            paint_trail(surface, places, usable & clear[few][::-1], inset, 2 * unit)

    def _labels(self, surface: pygame.Surface, motion: Motion, view: str) -> None:
        """Writes the wind's speed at its arrow, the rings' distances; where there is room."""
        assert self._camera is not None
        close = self._camera.near
        taken = self._instruments.taken + ([self._inset_rows()] if self._inset_camera else [])
        tail, tip = self._renderer.scene.wind_arrow(motion, close)
        aside, below, align = (0.0, 34.0, 0.5) if close else (-20.0, 0.0, 1.0)
        if view == "side":  # where the pilot stands beside the arrow's tail
            aside, below, align = 0.0, 34.0, 0.0
        v_E = wind_velocity(self.parameters.wind, motion.body.p_G_E, motion.t)
        wind = f"WIND {norm(v_E):.1f} m/s"
        if not self._label(surface, tail, wind, 20, (aside, below), align, taken):
            middle = times(0.5, plus(tail, tip))
            self._label(surface, middle, wind, 20, (44.0, 14.0), 0.0, taken)
        step = ring_step(self.parameters.lines.length)
        for k in range(1, RINGS + 1):
            place = times(k * step, self._ring_direction(view))
            self._label(surface, place, f"{k * step:g} m", 18, (0.0, -15.0), 0.5, taken)

    def _ring_direction(self, view: str) -> Vector:
        """The direction from O_E in which rings have their labels: beside what matters."""
        assert self._camera is not None
        free = view in ("chase", "orbit")
        ahead = self._camera.forward if free else views.downwind(self.parameters)
        bearing = atan2(ahead.y, ahead.x) + radians(RING_LABELS.get(view, 4.0))
        return Vector(cos(bearing), sin(bearing), 0.0)

    def _label(
        self,
        surface: pygame.Surface,
        p_E: Vector,
        text: str,
        size: float,
        offset: tuple[float, float],
        align: float,
        taken: list[pygame.Rect],
    ) -> bool:
        """Writes beside a point of the main view if nothing else is there; returns whether it did.

        surface: the frame
        p_E: m in E, the point
        text: one line
        size: units, the height of its digits
        offset: units to the right of the point and below it
        align: the part of the text's width that lies left of that place
        taken: px, boxes of other things; this one is added
        """
        assert self._camera is not None
        unit = self._instruments.u
        place = views.pixel(self._camera, p_E, self.width, self.height)
        column, row = place.column + offset[0] * unit, place.row + offset[1] * unit
        if place.depth <= 0 or not (abs(column) < 1e5 and abs(row) < 1e5):
            return False
        wide, tall = width(text, size * unit), round(1.3 * size * unit)
        box = pygame.Rect(round(column - align * wide), round(row - tall / 2), wide, tall)
        free = box.inflate(8 * unit, 0).collidelist(taken) < 0
        if not free or not surface.get_rect().contains(box):
            return False
        put(surface, text, column, row, size * unit, align=align)
        taken.append(box)
        return True

    def _inset_rows(self) -> pygame.Rect:
        """The box of the small view, in the frame's pixels."""
        unit = self._instruments.u
        w, h, margin = int(INSET * 1280 * unit), int(INSET * 720 * unit), int(12 * unit)
        return pygame.Rect(self.width - w - margin, margin, w, h)

    def close(self) -> None:
        """Gives the OpenGL context back; may be called twice."""
        self._renderer.close()
