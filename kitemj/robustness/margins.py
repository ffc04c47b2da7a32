"""The margins of a pilot on its path: at points, and over the lap."""

from dataclasses import dataclass
from math import degrees, log10, pi

import numpy as np

from kitemj.errors import InputError
from kitemj.flight.live import TICK
from kitemj.flight.pilot_settings import PilotSettings
from kitemj.flight.scenario import Scenario
from kitemj.pilots.sight import sight
from kitemj.robustness.floquet import (
    Floquet,
    delay_margin,
    disk_margin,
    gain_margins,
    multipliers,
    phase_margin,
)
from kitemj.robustness.frozen import Margins, margins_of, python_control
from kitemj.robustness.linear import Opened, opened
from kitemj.robustness.loop import Lap, Loop, flown_loop, steady_lap
from kitemj.robustness.verify import Trial, growth_flown, trials
from kitemj.tables import Table, Tabled

GAIN, PHASE = 6.0, 45.0
"""dB and deg that a loop should have."""
BESIDE = 0.1
"""Of a margin: so far below and above it a flight tries it."""
MOST_POINTS = 200
"""Of a lap; more are no plainer."""


@dataclass(frozen=True)
class LoopMargins(Tabled):
    """What is known of a loop; margins over the lap as factor, factor, deg, s and diameter.

    `frozen` at the ticks `at` of the lap; `flown`: factor by which a deviation grew in a flight
    just below and just above the gain and the delay that are told.
    """

    loop: Loop
    lap: Lap
    opened: Opened
    at: list[int]
    frozen: list[Margins]
    floquet: Floquet
    gain_down: float
    gain_up: float
    phase: float
    delay: float
    disk: float
    flown: list[tuple[str, float]]
    trials: list[Trial]

    @property
    def met(self) -> bool:
        """Whether the loop over a lap has 6 dB and 45° or more, and deviations die out."""
        up = 20 * log10(self.gain_up) if self.gain_up > 0 else 0.0
        return self.floquet.largest < 1.0 and up >= GAIN and self.phase >= PHASE

    @property
    def in_words(self) -> str:
        """One sentence."""
        says = "has" if self.met else "does not have"
        gain = min(min(m.gain_up, m.gain_down) for m in self.frozen)
        phase = min(m.phase for m in self.frozen)
        return (
            f"the loop over a lap {says} {GAIN:g} dB and {PHASE:g}°: gain x {self.gain_up:.3g} "
            f"({20 * log10(self.gain_up):.3g} dB), phase {self.phase:.3g}°, delay "
            f"{self.delay:.3g} s, disk {self.disk:.3g}; of a deviation "
            f"{self.floquet.largest:.2g} is left after a lap; frozen at points, the "
            f"least are {gain:.3g} dB and {phase:.3g}°"
        )

    def tables(self) -> list[Table]:
        """Points, lap, and the flights that tried it."""
        over = [
            ("largest multiplier", self.floquet.largest),
            ("multiplier of the place", abs(self.floquet.place)),
            ("gain up", self.gain_up),
            ("gain down", self.gain_down),
            ("phase_deg", self.phase),
            ("more delay_s", self.delay),
            ("disk", self.disk),
            ("period_s", self.lap.period),
        ]
        columns = ("flight", "rms_deg", "largest_deg", "laps", "flies", "ended")
        rows: list[tuple[float | str | bool, ...]] = [tuple(trial) for trial in self.trials]
        return [
            self._points(),
            Table("Over a lap", ("what", "value"), list(over)),
            Table("A deviation, flown", ("what", "grew by"), list(self.flown)),
            Table("Flown with a pilot who is told wrong", columns, rows),
        ]

    def _points(self) -> Table:
        columns = (
            *("azimuth_deg", "elevation_deg", "airspeed_m_s", "gain_dB", "phase_deg", "delay_s"),
            *("disk", "disk_gain_dB", "disk_phase_deg", "crossover_rad_s", "growth_per_s"),
        )
        rows: list[tuple[float | str | bool, ...]] = []
        for i, m in zip(self.at, self.frozen, strict=True):
            motion = self.lap.ticks[i].motion
            seen = sight(motion)
            at = degrees(seen.azimuth), degrees(seen.elevation), motion.air.speed
            gain = min(m.gain_up, m.gain_down)
            disk = m.disk, m.disk_gain, m.disk_phase
            rows.append((*at, gain, m.phase, m.delay, *disk, m.crossover, m.growth))
        return Table("Frozen at points of the lap", columns, rows)


def loop_margins(scenario: Scenario, settings: PilotSettings, points: int = 16) -> LoopMargins:
    """The margins of a pilot in a scenario's kite and steady wind; what it learns is learnt.

    Frozen at `points` of a lap. Raises InputError where the path is not followed.
    """
    if not 1 <= points <= MOST_POINTS:
        raise InputError(f"points must be from 1 to {MOST_POINTS}, got {points}")
    python_control()
    loop, x = flown_loop(scenario, settings)
    lap = steady_lap(loop, x)
    linear, n = opened(loop, lap), len(lap.wish)
    at = [i * n // points for i in range(points)]
    slowest = 2 * 2 * pi / lap.period
    frozen = []
    for i in at:
        A, B, C = linear.along_path(i)
        frozen.append(margins_of(A, B, -C, slowest=slowest))
    along = np.asarray((lap.x[1] - lap.x[0]) / TICK)
    down, up = gain_margins(linear, along)
    late = delay_margin(linear, along)
    found = multipliers(linear.closed, along)
    angle, disk = phase_margin(linear, along), disk_margin(linear, along)
    flown = _tried(loop, lap, up, late)
    told = trials(scenario, settings)
    return LoopMargins(
        loop, lap, linear, at, frozen, found, down, up, angle, late * TICK, disk, flown, told
    )


def _tried(loop: Loop, lap: Lap, up: float, late: float) -> list[tuple[str, float]]:
    found = [("as it is", growth_flown(loop, lap))]
    for part in (1 - BESIDE, 1 + BESIDE):
        if np.isfinite(up):
            grew = growth_flown(loop, lap, part * up)
            found.append((f"gain x {part * up:.3g}", grew))
    for part in (1 - BESIDE, 1 + BESIDE):
        if 0 < late < np.inf:
            ticks = round(part * late)
            grew = growth_flown(loop, lap, 1.0, ticks)
            found.append((f"{ticks * TICK:.2f} s later", grew))
    return found
