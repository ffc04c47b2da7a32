"""The numbers over the picture: panels of text and bars, painted into the frame itself.

Red is the pilot's left (A₊), blue the pilot's right (A₋), as on the kite.
"""

from math import atan2, degrees, hypot
from typing import TYPE_CHECKING

import pygame

from kitemj.cockpit.lettering import Colour, put, width
from kitemj.cockpit.scene import newtons_per_metre
from kitemj.dynamics.motion import Motion, attachment_E
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import norm
from kitemj.physics.wind import wind_speed

if TYPE_CHECKING:
    from kitemj.cockpit.picture import Readings

WHITE: Colour = (255, 255, 255)
DIM: Colour = (205, 212, 220)
LEFT: Colour = (255, 84, 84)
RIGHT: Colour = (104, 156, 255)
GOOD: Colour = (120, 220, 120)
BAD: Colour = (255, 70, 60)
ALARM: Colour = (190, 30, 24)
CALL: Colour = (255, 214, 60)
SHADE: Colour = (70, 78, 90)  # what a panel multiplies the picture with
TROUGH: Colour = (40, 46, 54)
NUMBER, NAME = 23, 16  # px of digit height in a frame of 720 rows
MARGIN = 12
STRIP = 118  # height of the strip along the bottom
GAP_UNITS = ((1.0, "m"), (1e-3, "mm"), (1e-6, "µm"), (0.0, "nm"))  # from this on, in metres


class Instruments:
    """Paints the panels for one parameter set into frames of `width` x `height` pixels."""

    def __init__(self, parameters: Parameters, width: int, height: int) -> None:
        """Sizes follow the height; a frame of 720 rows has them as they are written here."""
        self.parameters, self.width, self.height = parameters, width, height
        self.u = min(height / 720, width / 1280)

    def paint(self, surface: pygame.Surface, motion: Motion, readings: "Readings") -> None:
        """All panels; the surface is the frame."""
        self._flight(surface, motion, readings)
        self._air(surface, motion)
        top = self.height - STRIP * self.u
        self._shade(surface, 0, top, self.width, STRIP * self.u)
        third = self.width / 3
        self._tensions(surface, motion, 0.0, top, third)
        self._steering(surface, motion, readings, third, top, third)
        self._running(surface, readings, 2 * third, top, third)
        if readings.message:
            self._banner(surface, readings.message)

    def _flight(self, surface: pygame.Surface, motion: Motion, readings: "Readings") -> None:
        u, x, y = self.u, MARGIN * self.u, MARGIN * self.u
        G = motion.body.p_G_E
        self._shade(surface, x, y, 290 * u, 216 * u)
        put(surface, f"{motion.t:.1f} s", x + 14 * u, y + 28 * u, 28 * u)
        put(surface, f"speed ×{readings.speed:.3g}", x + 276 * u, y + 28 * u, NAME * u, DIM, 1)
        rows = (
            ("elevation", f"{degrees(atan2(-G.z, hypot(G.x, G.y))):.1f}°"),
            ("azimuth", _sided(degrees(atan2(G.y, -G.x)))),
            ("height", f"{-G.z:.1f} m"),
            ("airspeed", f"{motion.air.speed:.1f} m/s"),
        )
        for i, (name, value) in enumerate(rows):
            row = y + (72 + 38 * i) * u
            put(surface, name, x + 14 * u, row, NAME * u, DIM)
            put(surface, value, x + 276 * u, row, NUMBER * u, WHITE, 1)

    def _air(self, surface: pygame.Surface, motion: Motion) -> None:
        """α and β as marks between their limits."""
        u, x, y = self.u, MARGIN * self.u, 240 * self.u
        self._shade(surface, x, y, 290 * u, 124 * u)
        limits = self.parameters.limits
        for i, (name, angle, limit) in enumerate(
            (("α", motion.air.alpha, limits.alpha_stall), ("β", motion.air.beta, limits.beta_max))
        ):
            row, beyond = y + (26 + 60 * i) * u, abs(angle) > limit
            put(surface, name, x + 14 * u, row, NUMBER * u, DIM)
            put(
                surface,
                f"{degrees(angle):.1f}°",
                x + 150 * u,
                row,
                NUMBER * u,
                BAD if beyond else WHITE,
                1,
            )
            put(surface, f"max {degrees(limit):.0f}°", x + 276 * u, row, NAME * u, DIM, 1)
            left, wide = x + 14 * u, 262 * u
            self._bar(surface, left, row + 22 * u, wide, 10 * u, TROUGH)
            share = min(max(angle / limit, -1.0), 1.0)
            middle = left + wide / 2
            start, end = sorted((middle, middle + share * wide / 2))
            colour = BAD if beyond else GOOD
            self._bar(surface, start, row + 22 * u, max(end - start, 3 * u), 10 * u, colour)
            self._bar(surface, middle - u, row + 19 * u, 2 * u, 16 * u, WHITE)

    def _tensions(
        self, surface: pygame.Surface, motion: Motion, x: float, top: float, wide: float
    ) -> None:
        u, ceiling = self.u, self.parameters.limits.tension_max
        left, room = x + 90 * u, wide - 230 * u
        put(surface, "LINES", x + MARGIN * u, top + 20 * u, NAME * u, DIM)
        put(surface, f"max {ceiling:.0f} N", left + room, top + 20 * u, NAME * u, DIM, 1)
        rows = zip(("left", "right"), (LEFT, RIGHT), (1.0, -1.0), strict=True)
        for i, (name, colour, side) in enumerate(rows):
            row = top + (52 + 40 * i) * u
            tension, length = motion.tensions[i], motion.lengths[i]
            slack = length - norm(attachment_E(self.parameters, motion.body, side)) > 1e-3
            put(surface, name, x + MARGIN * u, row, NAME * u, colour)
            self._bar(surface, left, row - 12 * u, room, 24 * u, TROUGH)
            share = min(max(tension / ceiling, 0.0), 1.0)
            over = tension > ceiling
            self._bar(surface, left, row - 12 * u, share * room, 24 * u, BAD if over else colour)
            self._bar(surface, left + room - 2 * u, row - 15 * u, 3 * u, 30 * u, WHITE)
            value = (
                "SLACK" if slack else f"{tension:.1f} N" if tension < 999.5 else f"{tension:.0f} N"
            )
            put(
                surface,
                value,
                x + wide - 8 * u,
                row,
                NUMBER * u,
                CALL if slack else BAD if over else WHITE,
                1,
            )

    def _steering(
        self,
        surface: pygame.Surface,
        motion: Motion,
        readings: "Readings",
        x: float,
        top: float,
        wide: float,
    ) -> None:
        """δ as a bar from the middle towards the hand that pulls; the stick's wish as a mark."""
        u, limit, delta = self.u, self.parameters.stick.delta, motion.control.delta
        left, room = x + 30 * u, wide - 60 * u
        middle, row = x + wide / 2, top + 62 * u
        pulls = (
            "RIGHT hand pulls"
            if delta > 1e-4
            else "LEFT hand pulls"
            if delta < -1e-4
            else "hands level"
        )
        colour = RIGHT if delta > 0 else LEFT
        put(surface, pulls, middle, top + 24 * u, 19 * u, colour if abs(delta) > 1e-4 else DIM, 0.5)
        self._bar(surface, left, row - 10 * u, room, 20 * u, TROUGH)
        end = middle + _clipped(delta / limit) * room / 2
        self._bar(surface, min(middle, end), row - 10 * u, abs(end - middle), 20 * u, colour)
        self._bar(surface, middle - u, row - 15 * u, 2 * u, 30 * u, WHITE)
        mark = middle + _clipped(readings.delta_command / limit) * room / 2
        pygame.draw.polygon(
            surface,
            CALL,
            [(mark, row - 6 * u), (mark - 9 * u, row - 20 * u), (mark + 9 * u, row - 20 * u)],
        )
        put(surface, f"δ {degrees(delta):+.2f}°", middle, top + 97 * u, NUMBER * u, WHITE, 0.5)
        put(surface, f"-{degrees(limit):.1f}°", left, top + 97 * u, NAME * u, DIM)
        put(surface, f"+{degrees(limit):.1f}°", left + room, top + 97 * u, NAME * u, DIM, 1)

    def _running(
        self, surface: pygame.Surface, readings: "Readings", x: float, top: float, wide: float
    ) -> None:
        u, right = self.u, x + wide - MARGIN * self.u
        put(surface, readings.model, x + 24 * u, top + 24 * u, NUMBER * u, WHITE)
        if readings.stick:
            put(surface, readings.stick, right, top + 24 * u, 19 * u, DIM, 1)
        put(surface, "to reference", x + 24 * u, top + 60 * u, NAME * u, DIM)
        gap = "none" if readings.gap is None else _length(readings.gap)
        put(surface, gap, right, top + 60 * u, NUMBER * u, WHITE, 1)
        missed = readings.missed_ticks
        put(surface, "missed ticks", x + 24 * u, top + 96 * u, NAME * u, DIM)
        late = f"{missed}   late {1e3 * readings.lateness:.1f} ms" if missed else "0"
        put(surface, late, right, top + 96 * u, NUMBER * u, BAD if missed else WHITE, 1)

    def _banner(self, surface: pygame.Surface, message: str) -> None:
        u, size = self.u, NUMBER * self.u
        left, room = 312 * u, self.width - 324 * u
        size = min(size, size * (room - 40 * u) / max(width(message, size), 1))
        wide = width(message, size) + 40 * u
        middle = left + room / 2
        self._bar(surface, middle - wide / 2, 244 * u, wide, 46 * u, ALARM)
        put(surface, message, middle, 267 * u, size, WHITE, 0.5)

    def legend(self, surface: pygame.Surface, x: float, y: float) -> None:
        """What the arrows at the kite mean, from (`x`, `y`) px to the right."""
        u = self.u
        scale = f"1 m = {newtons_per_metre(self.parameters):g} N"
        names = (("air", CALL), ("weight", WHITE), ("left", LEFT), ("right", RIGHT), (scale, WHITE))
        room = sum(width(text, NAME * u) + 16 * u for text, _ in names) + 16 * u
        self._shade(surface, x - 16 * u, y - 16 * u, room, 32 * u)
        for text, colour in names:
            put(surface, text, x, y, NAME * u, colour)
            x += width(text, NAME * u) + 16 * u

    def covered(self, column: float, row: float) -> bool:
        """Whether a panel lies over this pixel."""
        u = self.u
        strip = row > self.height - (STRIP + 40) * u
        return strip or (column < (MARGIN + 300) * u and row < 375 * u)

    def wind_text(self, motion: Motion) -> str:
        """The wind's speed where the kite is."""
        speed = wind_speed(self.parameters.wind, -motion.body.p_G_E.z, motion.t)
        return f"WIND {speed:.1f} m/s"

    def _shade(self, surface: pygame.Surface, x: float, y: float, w: float, h: float) -> None:
        surface.fill(SHADE, _box(x, y, w, h), special_flags=pygame.BLEND_MULT)

    @staticmethod
    def _bar(
        surface: pygame.Surface, x: float, y: float, w: float, h: float, colour: Colour
    ) -> None:
        surface.fill(colour, _box(x, y, w, h))


def _box(x: float, y: float, w: float, h: float) -> pygame.Rect:
    return pygame.Rect(round(x), round(y), round(w), round(h))


def _clipped(share: float) -> float:
    return min(max(share, -1.0), 1.0)


def _sided(azimuth: float) -> str:
    """An azimuth [deg] from downwind; positive is +y_E, the pilot's left."""
    side = "left" if azimuth > 0.05 else "right" if azimuth < -0.05 else ""
    return f"{abs(azimuth):.1f}° {side}".rstrip()


def _length(metres: float) -> str:
    """A gap in the unit that suits it."""
    for least, unit in GAP_UNITS:
        if metres >= least:
            number = metres / (least or 1e-9)
            return f"{number:.0f} {unit}" if number >= 100 else f"{number:.3g} {unit}"
    return "no number"
