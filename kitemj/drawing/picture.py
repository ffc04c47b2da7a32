"""One frame: a main view, a small other view, and the instruments over both."""

from math import atan2, cos, radians, sin
from time import perf_counter

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.closing import Closing
from kitemj.controls.actions import DEPTHS, INSTRUMENTS, VIEWS
from kitemj.drawing.help_page import paint_help
from kitemj.drawing.history import TRAIL_STEP, Traces
from kitemj.drawing.instruments import Instruments
from kitemj.drawing.plates import paint_plate
from kitemj.drawing.readings import Readings
from kitemj.drawing.sky_path import paint_sky_path
from kitemj.drawing.tensions import scale_of
from kitemj.drawing.text import put, width
from kitemj.drawing.trail import BRIGHT, paint_trail, pull_colours, seen
from kitemj.drawing.wished import Wished
from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, norm, plus, times
from kitemj.physics.wind import wind_velocity
from kitemj.scene import views
from kitemj.scene.eye import Eye
from kitemj.scene.quality import HIGH, QualityChooser, quality_of
from kitemj.scene.renderer import Renderer
from kitemj.scene.scenery import RINGS, ring_step
from kitemj.scene.views import Camera

RING_LABELS = {"chase": 4.0, "pilot": 62.0, "side": -15.0, "top": 38.0}  # deg, right of downwind
LEAST = (320, 180)  # px
SOFTWARE_RATE, CARD_RATE = 30, 60  # frames/s, where the processor draws, and a graphics card
TRAIL = 5.0  # px of 720 rows
SHORT, SUBTLE = 2.5, 0.45  # s of the trail that a pilot sees, and its opacity
CLEAR = 0.5  # spans around the kite without a trail
LABEL = 15.0  # units, digits of what is written into the view


class Picture(Closing):
    """Paints motions of one parameter set; raises `NoGraphics` where OpenGL is missing.

    A context manager. Any thread may paint, one at a time. `depth` is a name of DEPTHS; `shown`
    holds the names among INSTRUMENTS of what the engineer's has; `whole_trail`: whether a pilot
    sees all of the trail too. Anyone may change these between frames. `rate`: frames/s that suit
    the machine.
    """

    def __init__(
        self,
        parameters: Parameters,
        width: int = 1280,
        height: int = 720,
        quality: str = "high",
    ) -> None:
        """Frames of `width` x `height` pixels; InputError below 320 x 180.

        `quality`: a name of QUALITIES; "auto" lets the first second of frames choose
        """
        _check(width, height)
        self._quality = quality
        self.parameters, self.width, self.height = parameters, width, height
        self.depth, self.shown, self.whole_trail = DEPTHS[0], set(INSTRUMENTS), False
        self.eye = Eye(parameters)
        self._camera: Camera | None = None
        self._inset_camera: Camera | None = None
        first = HIGH if quality == "auto" else quality_of(quality)
        self._renderer = Renderer(parameters, width, height, first)
        self.rate = SOFTWARE_RATE if self._renderer.software else CARD_RATE
        self._chooser = QualityChooser(self.rate) if quality == "auto" else None
        self._instruments = Instruments(parameters, width, height)
        self._pulls = scale_of(parameters)

    def resize(self, width: int, height: int) -> None:
        """Makes the next frames `width` x `height` pixels large; InputError below 320 x 180."""
        _check(width, height)
        self.width, self.height, self._camera = width, height, None
        self._renderer.resize(width, height)
        self._instruments = Instruments(self.parameters, width, height)
        if self._chooser:  # another size is another cost
            self._chooser = QualityChooser(self.rate, self._chooser.name)

    @property
    def quality(self) -> str:
        """The name of the quality of the next frame."""
        return self._chooser.name if self._chooser else self._quality

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
        if self.depth not in DEPTHS:
            told = ", ".join(DEPTHS)
            raise InputError(f"there are no instruments {self.depth!r}; there are: {told}")
        name, begun = view if isinstance(view, str) else "", perf_counter()
        self._camera = self.eye.look(motion, view) if isinstance(view, str) else view
        shown = self.shown if self.depth == "engineer" else set()
        self._inset_camera, forces = None, "forces" in shown
        self._renderer.scene.rings = "labels" in shown
        self._renderer.render(motion, reference, self._camera, forces)
        if "inset" in shown:
            # the kite from near; all, if the main view is near
            other = "pilot" if self._camera.near else "chase"
            self._inset_camera = views.CAMERAS[other](self.parameters, motion)
            box = self._instruments.box("inset")
            self._renderer.render(motion, reference, self._inset_camera, forces, box)
        frame = self._renderer.frame()
        self._letter(frame, motion, readings, shown, name)
        if self._chooser:
            self._chooser.painted(perf_counter() - begun)
            self._renderer.quality = self._chooser.quality
        return frame

    def pixel(self, p_E: Vector) -> tuple[float, float]:
        """(column, row) of the point `p_E` [m, E] in the main view of the last frame."""
        if self._camera is None:
            raise RuntimeError("pixel() needs a painted frame: call paint() first")
        place = views.pixel(self._camera, p_E, self.width, self.height)
        return place.column, place.row

    def _letter(
        self,
        frame: NDArray[np.uint8],
        motion: Motion,
        readings: Readings,
        shown: set[str],
        view: str,
    ) -> None:
        """Paints trail, instruments, labels and help into the frame itself."""
        assert self._camera is not None
        surface = pygame.image.frombuffer(frame.data, (self.width, self.height), "RGB")
        if readings.wished:
            self._wish(surface, readings.wished, motion)
        if readings.traces and ("trail" in shown or self.depth == "pilot"):
            self._trails(surface, readings.traces, motion)
        if self._inset_camera:
            edge = self._instruments.box("inset").inflate(2, 2)
            pygame.draw.rect(surface, (235, 238, 242), edge, max(round(self._instruments.u), 1))
        arrows = {"arrows"} if self._camera.near and "forces" in shown else set()
        if readings.help:
            paint_help(surface, readings.help, self._instruments.u)
            return
        self._instruments.paint(surface, motion, readings, self.depth, shown | arrows)
        if "labels" in shown:
            self._labels(surface, motion, view)

    def _wish(self, surface: pygame.Surface, wished: Wished, motion: Motion) -> None:
        """Paints the path that is wished for in the main view, not in the small one."""
        assert self._camera is not None
        inset = self._instruments.box("inset")
        kept = surface.subsurface(inset).copy() if self._inset_camera else None
        paint_sky_path(surface, self._camera, self.parameters, wished, motion, self._instruments.u)
        if kept:
            surface.blit(kept, inset)

    def _trails(self, surface: pygame.Surface, traces: Traces, motion: Motion) -> None:
        """Paints the trail in both views, up to the kite's tail; a pilot's is short and faint."""
        unit, whole = self._instruments.u, surface.get_rect()
        quiet = self.depth == "pilot" and not self.whole_trail
        last = slice(-round(SHORT / TRAIL_STEP), None) if quiet else slice(None)
        points = np.concatenate([traces.trail[last], [motion.body.p_G_E]])
        colours = None
        if traces.pull is not None and len(traces.pull):
            pull = traces.pull[last]
            colours = pull_colours(np.append(pull, pull[-1]), self._pulls)
        # it has no depth: it must not be written across the kite
        away = np.linalg.norm(points - points[-1], axis=1)
        clear = away > CLEAR * self.parameters.kite.span
        assert self._camera is not None
        inset = self._instruments.box("inset")
        if self._inset_camera:
            # the small view is a picture of its own: the large one's trail must not cross it
            kept = surface.subsurface(inset).copy()
        places, usable = seen(self._camera, points, whole)
        bright = SUBTLE if quiet else BRIGHT
        paint_trail(surface, places, usable & clear, whole, TRAIL * unit, colours, bright)
        if self._inset_camera:
            surface.blit(kept, inset)
            few = slice(None, None, -3)  # enough for a small picture
            places, usable = seen(self._inset_camera, points[few][::-1], inset)
            hues = None if colours is None else colours[few][::-1]
            usable &= clear[few][::-1]
            paint_trail(surface, places, usable, inset, 2 * unit, hues)

    def _labels(self, surface: pygame.Surface, motion: Motion, view: str) -> None:
        """Writes the wind's speed and the rings' distances, where there is room."""
        assert self._camera is not None
        taken = [*self._instruments.taken]
        if self._inset_camera:
            taken.append(self._instruments.box("inset"))
        if "forces" in self.shown:
            self._label_wind(surface, motion, view, taken)
        step = ring_step(self.parameters.lines.length)
        for k in range(1, RINGS + 1):
            place = times(k * step, self._ring_direction(view))
            self._label(surface, place, f"{k * step:g} m", (0.0, -15.0), 0.5, taken)

    def _label_wind(
        self, surface: pygame.Surface, motion: Motion, view: str, taken: list[pygame.Rect]
    ) -> None:
        """Writes the wind's speed at its arrow, where there is room."""
        assert self._camera is not None
        close = self._camera.near
        tail, tip = self._renderer.scene.wind_arrow(motion, close)
        aside, align = (0.0, 34.0), 0.5 if close or view == "side" else 1.0
        if not close and view != "side":
            aside = (-20.0, 0.0)
        v_E = wind_velocity(self.parameters.wind, motion.body.p_G_E, motion.t)
        wind = f"wind {norm(v_E):.1f} m/s"
        if not self._label(surface, tail, wind, aside, align, taken):
            middle = times(0.5, plus(tail, tip))
            self._label(surface, middle, wind, (44.0, 14.0), 0.0, taken)

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
        offset: tuple[float, float],
        align: float,
        taken: list[pygame.Rect],
    ) -> bool:
        """Writes beside a point of the main view if nothing else is there; returns whether it did.

        surface: the frame
        p_E: m in E, the point
        text: one line
        offset: units to the right of the point and below it
        align: the part of the text's width that lies left of that place
        taken: px, boxes of other things; this one is added
        """
        assert self._camera is not None
        unit, size = self._instruments.u, LABEL * self._instruments.u
        place = views.pixel(self._camera, p_E, self.width, self.height)
        column, row = place.column + offset[0] * unit, place.row + offset[1] * unit
        if place.depth <= 0 or not (abs(column) < 1e5 and abs(row) < 1e5):
            return False
        wide, tall = width(text, size) + 1.2 * size, 1.9 * size
        box = pygame.Rect(column - align * wide, row - tall / 2, wide, tall)
        if box.collidelist(taken) >= 0 or not surface.get_rect().contains(box):
            return False
        paint_plate(surface, box, 0.6 * unit)
        put(surface, text, *box.center, size, align=0.5)
        taken.append(box)
        return True

    def close(self) -> None:
        """Gives the OpenGL context back; may be called twice."""
        self._renderer.close()


def _check(width: int, height: int) -> None:
    """Raises InputError for a picture in which nothing could be read."""
    if width < LEAST[0] or height < LEAST[1]:
        size = f"{width} x {height} pixels"
        raise InputError(f"a picture of {size} is too small, at least {LEAST[0]} x {LEAST[1]}")
