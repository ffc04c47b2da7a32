"""Renders motions with MuJoCo's renderer, on a screen or without one."""

from typing import Any

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.closing import Closing
from kitemj.dynamics.motion import Motion
from kitemj.mujoco_import import mujoco
from kitemj.physics.parameters import Parameters
from kitemj.scene.gl import open_graphics
from kitemj.scene.quality import HIGH
from kitemj.scene.scene import Scene
from kitemj.scene.views import Camera


class Renderer(Closing):
    """Frames of `width` x `height` pixels of one parameter set; `scene` is what is in them.

    A context manager. Any thread may render, one at a time. Raises `NoGraphics` where OpenGL is
    missing.
    """

    def __init__(self, parameters: Parameters, width: int, height: int) -> None:
        self.width, self.height = width, height
        self._graphics = open_graphics(width, height)
        self.scene = Scene(parameters, width, height, HIGH)
        with self._graphics.context.as_current():
            font = mujoco.mjtFontScale.mjFONTSCALE_100
            self._context: Any = mujoco.MjrContext(self.scene.model, font)
            mujoco.mjr_setBuffer(int(mujoco.mjtFramebuffer.mjFB_OFFSCREEN), self._context)
        self._pixels = np.empty((height, width, 3), np.uint8)

    def render(
        self,
        motion: Motion,
        reference: Motion | None,
        camera: Camera,
        forces: bool = True,
        box: pygame.Rect | None = None,
    ) -> None:
        """Renders into the frame.

        motion: the kite
        reference: drawn translucent where it parts from the kite; None: there is none
        camera: from where it is seen
        forces: whether a near view has arrows of force
        box: px, the part of the frame to render into; None: all of it
        """
        box = box or pygame.Rect(0, 0, self.width, self.height)
        bottom = self.height - box.bottom  # OpenGL counts rows from below
        rows = mujoco.MjrRect(box.left, bottom, box.width, box.height)
        with self._graphics.context.as_current():
            self.scene.fill(motion, reference, camera, forces)
            self.scene.upload(self._context)
            mujoco.mjr_render(rows, self.scene.mjv, self._context)

    def frame(self) -> NDArray[np.uint8]:
        """A copy of what was rendered (height, width, 3), RGB, row 0 on top."""
        whole = mujoco.MjrRect(0, 0, self.width, self.height)
        with self._graphics.context.as_current():
            mujoco.mjr_readPixels(self._pixels, None, whole, self._context)
        return np.ascontiguousarray(self._pixels[::-1])

    def resize(self, width: int, height: int) -> None:
        """Makes the next frames `width` x `height` pixels large."""
        with self._graphics.context.as_current():
            mujoco.mjr_resizeOffscreen(width, height, self._context)
        self.width, self.height = width, height
        self._pixels = np.empty((height, width, 3), np.uint8)

    def close(self) -> None:
        """Gives the OpenGL context back; may be called twice."""
        if self._context is not None:
            with self._graphics.context.as_current():
                self._context.free()
            self._context = None
            self._graphics.context.free()
