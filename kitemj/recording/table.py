"""The table of a recording: a row for each tick, in columns that explain themselves.

The first columns are those of every table of motions (`kitemj.flight.motion_table.COLUMNS`). A row
holds the instant at the end of its tick; the steering is that of the tick which ended there:
ℓ and δ at its start, and ℓ̈ and δ̈ that were constant in it. Row 0 of an episode is its start.
"""

from collections.abc import Mapping, Sequence
from math import inf, nan
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.motion import Motion
from kitemj.flight.guided_table import NUMBERS, PHASE, guided_numbers, phase_code
from kitemj.flight.limits import GROUND, RECORDED, Numbers
from kitemj.flight.live import Command, Episode, TickResult
from kitemj.flight.motion_table import columns_of, row
from kitemj.flight.pilot_settings import Guided
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import TWO_LINES, Rig, rig_of
from kitemj.physics.steering import Control

Columns = Mapping[str, NDArray[Any]]

ATTITUDE = tuple(f"R_BE_{row}{column}" for row in "xyz" for column in "xyz")
VELOCITY = ("vx_E_m_s", "vy_E_m_s", "vz_E_m_s")
RATES = ("omega_x_B_rad_s", "omega_y_B_rad_s", "omega_z_B_rad_s")
AFTER = (*ATTITUDE, *VELOCITY, *RATES, "airspeed_m_s")
"""What follows the columns of a table of motions; R_BE takes components in E to B, row by row."""

PLACE = ("leg", "tick", "parent", "start")
"""Which episode of the recording (each restart begins one), which tick in it; whole numbers.

`start` is the state of the header's at which the flight began. An episode that does not begin
at tick 0 goes on from that tick of the episode `parent`, an earlier one: somebody went back in
time. Its first row is that tick once more.
"""

STICK = ("stick_delta", "stick_ell", "stick_law")
"""The law is 0, 1 or 2 where the stick asks for δ, δ̇ or δ̈."""

STEERING = (
    "ell_m",
    "ell_dot_m_s",
    "ell_ddot_m_s2",
    "delta_rad",
    "delta_dot_rad_s",
    "delta_ddot_rad_s2",
)
REFERENCE = ("ref_x_E_m", "ref_y_E_m", "ref_z_E_m", *(f"ref_{name}" for name in ATTITUDE))
"""Where the reference was; not a number where it is not valid."""

HAND = "assist_hand"
"""What a person asked of the assist that moved the stick, -1..1; not a number where none did."""

TICK_NUMBERS = (*STICK, *STEERING, *REFERENCE, "gap_m", "lateness_s", HAND, *NUMBERS)
"""Of one tick, beside its motion."""
LIMITS = tuple(limit.name for limit in RECORDED)
"""Whether the instant is beyond this limit of validity; the order says which is told first."""

NOWHERE = (nan,) * len(REFERENCE)


def motion_columns(rig: Rig) -> tuple[str, ...]:
    """Of any model's motion."""
    return (*columns_of(rig), *AFTER)


def all_columns(rig: Rig) -> tuple[str, ...]:
    """Of a whole recording."""
    return (*motion_columns(rig), *PLACE, *TICK_NUMBERS, PHASE, *LIMITS)


MOTION, ALL = motion_columns(TWO_LINES), all_columns(TWO_LINES)


class Tick(NamedTuple):
    """What one tick leaves behind; `control` is that of its segment, `lateness` in s.

    `hand`: what was asked of the assist whose `command` this is; not a number: there was none.
    `guided`: what the autopilot told whose command it is; None: there was none.
    """

    episode: Episode
    tick: int
    control: Control
    command: Command
    result: TickResult
    lateness: float
    hand: float = nan
    guided: Guided | None = None


def motion_row(motion: Motion) -> list[float]:
    """One motion in the order of `motion_columns`."""
    _, R, v, omega = motion.body
    return [*row(motion), *R.x, *R.y, *R.z, *v, *omega, motion.air.speed]


def table(parameters: Parameters, ticks: Sequence[Tick]) -> Columns:
    """All columns of some ticks."""
    rig = rig_of(parameters)
    names, rows = (*motion_columns(rig), *TICK_NUMBERS), [_numbers(tick) for tick in ticks]
    numbers = np.array(rows, np.float64).reshape(len(rows), len(names)).T.copy()
    columns: dict[str, NDArray[Any]] = dict(zip(names, numbers, strict=True))
    places = [(tick.episode.number, tick.tick, *tick.episode[1:]) for tick in ticks]
    whole = np.array(places, np.int32).reshape(len(rows), len(PLACE)).T.copy()
    columns |= dict(zip(PLACE, whole, strict=True))
    columns[PHASE] = np.array([phase_code(tick.guided) for tick in ticks], np.int32)
    left = [tick.result.departure for tick in ticks]
    columns["ground"] = np.array([bool(each and each.limit is GROUND) for each in left], np.bool_)
    now = limit_numbers(columns)
    columns |= {limit.name: ~limit.kept(parameters.limits, now) for limit in RECORDED}
    return {name: columns[name] for name in all_columns(rig)}


def limit_numbers(columns: Columns) -> Numbers:
    """What limits are about; of the ground it is only known whether it was touched, if that."""
    tensions = [column for name, column in columns.items() if name.startswith("tension_")]
    alpha, beta = np.radians(columns["alpha_deg"]), np.radians(columns["beta_deg"])
    touched = np.asarray(columns.get("ground", np.zeros(len(alpha))), np.bool_)
    clearance = np.where(touched, 0.0, inf)
    return Numbers(tensions, alpha, beta, columns.get("airspeed_m_s", nan), clearance)


def _numbers(tick: Tick) -> list[float]:
    result, reference = tick.result, tick.result.reference
    where: Sequence[float] = NOWHERE
    if reference is not None:
        p, R = reference.body[:2]
        where = (*p, *R.x, *R.y, *R.z)
    gap = nan if result.gap is None else result.gap
    steering = (*tick.command, *tick.control)
    now = gap, tick.lateness, tick.hand, *guided_numbers(tick.guided)
    return [*motion_row(result.motion), *steering, *where, *now]
