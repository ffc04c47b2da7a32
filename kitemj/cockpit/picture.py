"""One frame: a main view, a small other view, and the instruments over both."""

from math import atan2, cos, hypot, radians, sin
from types import TracebackType
from typing import Any, NamedTuple, Self

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.cockpit import views
from kitemj.cockpit.drawing_model import RINGS, ring_step
from kitemj.cockpit.gl import open_graphics
from kitemj.cockpit.instruments import STRIP, Instruments
from kitemj.cockpit.lettering import put
from kitemj.cockpit.scene import Scene
from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.mujoco_import import mujoco
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector, times

VIEWS: tuple[str, ...] = tuple(views.CAMERAS)
RING_LABELS = {"chase": 4.0, "pilot": 62.0, "side": -15.0}  # deg, to the right of straight ahead
INSET = 0.3  # width of the small view in frame widths


class Readings(NamedTuple):
    """Numbers shown that are not in the motion."""

    model: str = "mujoco"
    gap: float | None = None  # m, distance to the reference
    delta_command: float = 0.0  # rad, what the stick asks for
    missed_ticks: int = 0
    lateness: float = 0.0  # s, of the last tick
    stick: str = ""  # what steers: "gamepad", "keys", "programme"
    speed: float = 1.0  # simulated time over wall time
    message: str = ""  # one line that must be seen


class Picture:
    """Paints motions of one parameter set; raises `NoGraphics` where OpenGL is missing.

    A context manager. Any thread may paint, one at a time.
    """

    def __init__(self, parameters: Parameters, width: int = 1280, height: int = 720) -> None:
        """Frames of `width` x `height` pixels; InputError below 320 x 180."""
        if width < 320 or height < 180:
            raise InputError(
                f"a picture of {width} x {height} pixels is too small, at least 320 x 180"
            )
        self.parameters, self.width, self.height = parameters, width, height
        self._graphics = open_graphics(width, height)
        self._camera: views.Camera | None = None
        self._scene = Scene(parameters, width, height, self._graphics.software)
        with self._graphics.context.as_current():
            self._context: Any = mujoco.MjrContext(
                self._scene.model, mujoco.mjtFontScale.mjFONTSCALE_100
            )
            mujoco.mjr_setBuffer(int(mujoco.mjtFramebuffer.mjFB_OFFSCREEN), self._context)
        self._instruments = Instruments(parameters, width, height)
        self._pixels = np.empty((height, width, 3), np.uint8)

    def paint(
        self, motion: Motion, ghost: Motion | None, readings: Readings, view: str = "chase"
    ) -> NDArray[np.uint8]:
        """A new frame (height, width, 3), RGB, row 0 on top; `ghost` is drawn translucent."""
        if view not in views.CAMERAS:
            raise InputError(f"there is no view {view!r}; there are: {', '.join(VIEWS)}")
        self._camera = views.CAMERAS[view](self.parameters, motion)
        whole = mujoco.MjrRect(0, 0, self.width, self.height)
        with self._graphics.context.as_current():
            self._scene.fill(motion, ghost, self._camera, close=view == "chase")
            mujoco.mjr_render(whole, self._scene.mjv, self._context)
            self._render_inset(motion, ghost, view)
            mujoco.mjr_readPixels(self._pixels, None, whole, self._context)
        frame = np.ascontiguousarray(self._pixels[::-1])
        self._letter(frame, motion, readings, view)
        return frame

    def _letter(
        self, frame: NDArray[np.uint8], motion: Motion, readings: Readings, view: str
    ) -> None:
        """Labels of things in the picture, then the instruments, into the frame's own memory."""
        size = (self.width, self.height)
        surface = pygame.image.frombuffer(frame.data, size, "RGB")
        unit = self._instruments.u
        close = view == "chase"
        tail, _ = self._scene.wind_arrow(motion, close)
        aside, below, align = (0.0, 34.0, 0.5) if close else (-20.0, 0.0, 1.0)
        wind = self._instruments.wind_text(motion)
        self._label(surface, tail, wind, 20, (aside * unit, below * unit), align)
        step, last = ring_step(self.parameters.lines.length), None
        for k in range(1, RINGS + 1):
            place = times(k * step, self._ring_direction(view))
            column, row = self.pixel(place)
            if last is None or hypot(column - last[0], row - last[1]) > 30 * unit:
                self._label(surface, place, f"{k * step:g} m", 16, (0.0, -14 * unit), 0.5)
                last = (column, row)
        pygame.draw.rect(surface, (235, 238, 242), self._inset_rows().inflate(4, 4), 2)
        self._instruments.paint(surface, motion, readings)
        if close:
            self._instruments.legend(surface, 16 * unit, self.height - (STRIP + 18) * unit)

    def _ring_direction(self, view: str) -> Vector:
        """Where around O_E the rings have their labels: beside what matters."""
        assert self._camera is not None
        ahead = self._camera.forward if view == "chase" else views.downwind(self.parameters)
        bearing = atan2(ahead.y, ahead.x) + radians(RING_LABELS[view])
        return Vector(cos(bearing), sin(bearing), 0.0)

    def _label(
        self,
        surface: pygame.Surface,
        p_E: Vector,
        text: str,
        size: float,
        offset: tuple[float, float],
        align: float,
    ) -> None:
        """`text` beside where the point `p_E` [m, E] is in the main view, if it is there."""
        assert self._camera is not None
        place = views.pixel(self._camera, p_E, self.width, self.height)
        column, row = place.column + offset[0], place.row + offset[1]
        inside = 0 < column < self.width and 0 < row < self.height
        hidden = self._instruments.covered(column, row)
        hidden |= bool(self._inset_rows().inflate(60, 20).collidepoint(column, row))
        if place.depth > 0 and inside and not hidden:
            put(surface, text, column, row, size * self._instruments.u, align=align)

    def _inset_rows(self) -> pygame.Rect:
        """Where the small view is, in the frame's pixels."""
        w, h = int(INSET * self.width), int(INSET * self.height)
        margin = self.height // 60
        return pygame.Rect(self.width - w - margin, margin, w, h)

    def _render_inset(self, motion: Motion, ghost: Motion | None, view: str) -> None:
        other = "pilot" if view == "chase" else "chase"
        camera = views.CAMERAS[other](self.parameters, motion)
        self._scene.fill(motion, ghost, camera, close=other == "chase")
        rows = self._inset_rows()
        bottom = self.height - rows.bottom  # OpenGL counts rows from below
        corner = mujoco.MjrRect(rows.left, bottom, rows.width, rows.height)
        mujoco.mjr_render(corner, self._scene.mjv, self._context)

    def pixel(self, p_E: Vector) -> tuple[float, float]:
        """(column, row) of the point `p_E` [m, E] in the main view of the last frame."""
        if self._camera is None:
            raise RuntimeError("pixel() needs a painted frame: call paint() first")
        place = views.pixel(self._camera, p_E, self.width, self.height)
        return place.column, place.row

    def close(self) -> None:
        """Gives the OpenGL context back; may be called twice."""
        if self._context is not None:
            with self._graphics.context.as_current():
                self._context.free()
            self._context = None
            self._graphics.context.free()

    def __enter__(self) -> Self:
        """The picture itself."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Closes it."""
        self.close()
