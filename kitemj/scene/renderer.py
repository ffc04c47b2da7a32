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
from kitemj.scene.quality import FILM, HIGH, Quality
from kitemj.scene.scene import Scene
from kitemj.scene.views import Camera

LEAST_ROWS = 420  # px, below which a kite far away would be lost between the lines


class Renderer(Closing):
    """Frames of `width` x `height` pixels of one parameter set; `scene` is what is in them.

    A context manager. `software`: whether the processor draws. `quality` may be set between
    frames; texels and samples stay those of the first. Any thread may render, one at a time.
    Raises `NoGraphics` where OpenGL is missing.
    """

    def __init__(
        self, parameters: Parameters, width: int, height: int, quality: Quality = HIGH
    ) -> None:
        self.width, self.height, self.quality = width, height, quality
        self._graphics = open_graphics(width, height)
        self.software = self._graphics.software
        if not self.software:
            quality = quality._replace(samples=FILM.samples)  # it costs nothing there
        self._sampled = quality.samples > 0
        self.scene = Scene(parameters, width, height, quality)
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
        rows = (self._scaled(side) for side in (box.left, bottom, box.width, box.height))
        self.scene.surroundings.show_details(self.quality.details)
        with self._graphics.context.as_current():
            self.scene.fill(motion, reference, camera, forces, self._scaled(box.height))
            self.scene.upload(self._context)
            mujoco.mjr_render(mujoco.MjrRect(*rows), self.scene.mjv, self._context)

    def frame(self) -> NDArray[np.uint8]:
        """A copy of what was rendered (height, width, 3), RGB, row 0 on top."""
        wide, tall = self._scaled(self.width), self._scaled(self.height)
        pixels = self._pixels.ravel()[: 3 * wide * tall].reshape(tall, wide, 3)
        with self._graphics.context.as_current():
            mujoco.mjr_readPixels(pixels, None, mujoco.MjrRect(0, 0, wide, tall), self._context)
        upright = np.ascontiguousarray(pixels[::-1])
        if self._sampled:  # there Mesa's software leaves these black
            upright[:, 0], upright[-1] = upright[:, 1], upright[-2]
        if (wide, tall) == (self.width, self.height):
            return upright
        frame = np.empty((self.height, self.width, 3), np.uint8)
        small = pygame.image.frombuffer(upright.data, (wide, tall), "RGB")
        whole = pygame.image.frombuffer(frame.data, (self.width, self.height), "RGB")
        pygame.transform.smoothscale(small, (self.width, self.height), whole)
        return frame

    def _scaled(self, side: int) -> int:
        """A length [px] of the frame in what is rendered, which may be smaller."""
        scale = max(self.quality.scale, min(LEAST_ROWS / self.height, 1.0))
        return round(scale * side)

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
